// ladderc bench LIST: how long a scan takes, here and on the real CPU.
#include "driver/native.h"
#include "driver/plc_time.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Program.h"
#include "llvm/Support/raw_ostream.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ladderc::driver {

namespace cl = llvm::cl;

static cl::opt<std::string> kList(cl::Positional, cl::desc("LIST"), cl::Required, cl::sub(kBench));
static cl::opt<std::string> kScans("scans", cl::desc("Scans to measure"), cl::value_desc("N"), cl::sub(kBench));
static cl::opt<std::string> kStimulus("stimulus", cl::desc("random:SEED moves the inputs in every scan; none (default random:1)"),
                                      cl::value_desc("HOW"), cl::init("random:1"), cl::sub(kBench));
static cl::opt<bool> kJson("json", cl::desc("As JSON"), cl::sub(kBench));

namespace {

/// Runs the program with --bench and reads its JSON.
std::optional<nlohmann::json> measure(const std::string &program, std::string &error) {
  llvm::SmallString<128> output;
  if (const std::error_code ec = llvm::sys::fs::createTemporaryFile("ladderc-bench", "json", output)) {
    error = ec.message();
    return std::nullopt;
  }
  std::vector<std::string> command = {program, "--bench", "--json", "--stimulus", kStimulus};
  if (!kScans.empty())
    command.insert(command.end(), {"--scans", kScans});
  const std::vector<llvm::StringRef> arguments(command.begin(), command.end());
  const std::optional<llvm::StringRef> redirects[] = {std::nullopt, llvm::StringRef(output), std::nullopt};
  const int code = llvm::sys::ExecuteAndWait(program, arguments, std::nullopt, redirects, 0, 0, &error);
  auto text = llvm::MemoryBuffer::getFile(output);
  llvm::sys::fs::remove(output);
  if (code != 0 || !text) {
    if (error.empty())
      error = fmt::format("the program ended with exit code {}", code);
    return std::nullopt;
  }
  nlohmann::json result = nlohmann::json::parse((*text)->getBuffer().begin(), (*text)->getBuffer().end(), nullptr, false);
  if (result.is_object())
    return result;
  error = "the program's answer cannot be read";
  return std::nullopt;
}

}  // namespace

int run_bench(llvm::StringRef) {
  Compilation c;
  bool done;
  if (const int code = compile_list(c, kList, done); code || done)
    return code;
  const std::string program = build_native(c, "", false);
  if (program.empty())
    return kExitUsage;
  if (c.options.stats)
    c.print_stats(llvm::errs());
  std::string error;
  const auto measured = measure(program, error);
  if (!measured)
    return usage_error(error);

  nlohmann::ordered_json result = *measured;
  const PlcTime real = plc_time(c.program);
  const std::size_t instructions = c.program.list.instructions.size();
  const double median = result.value("median", 0.0);
  result["list"] = c.sources[c.program.list.file].name().str();
  result["instructions"] = instructions;
  result["ns_per_instruction"] = median / static_cast<double>(std::max<std::size_t>(1, instructions));
  result["real_cpu"] = {{"model", c.program.model.str()},
                        {"instructions_us", real.instructions_us},
                        {"end_us", real.end_us},
                        {"scan_us", real.total_us()},
                        {"ratio", median > 0 ? real.total_us() * 1000 / median : 0.0},
                        {"without_time", real.unknown}};
  if (kJson) {
    llvm::outs() << result.dump(1) << "\n";
    return 0;
  }
  llvm::outs() << fmt::format("{}: {} instructions, {} rungs\n", c.sources[c.program.list.file].name().str(), instructions, c.program.rungs);
  llvm::outs() << fmt::format("scan        min {:.1f} ns, median {:.1f} ns, max {:.1f} ns over {} scans\n", result.value("min", 0.0), median,
                              result.value("max", 0.0), result.value("scans", 0));
  llvm::outs() << fmt::format("instruction {:.3f} ns\n", result["ns_per_instruction"].get<double>());
  llvm::outs() << fmt::format("{:<11} {:.1f} us a scan by the manual ({:.1f} us instructions, {:.1f} us END and I/O): {:.0f} times as long\n",
                              c.program.model.str(), real.total_us(), real.instructions_us, real.end_us, result["real_cpu"]["ratio"].get<double>());
  if (real.unknown)
    llvm::outs() << fmt::format("            {} instructions have no time in the manual\n", real.unknown);
  return 0;
}

}  // namespace ladderc::driver
