// ladderc run LIST [options of the program]
//
// The options of a built program (--scans, --set, --watch ...) are declared here by name so that they can stand anywhere, and handed on as
// they are: what they mean and their errors are the hosted runtime's.
#include "driver/native.h"

#include "llvm/Support/raw_ostream.h"

#include <fmt/format.h>

namespace ladderc::driver {

namespace cl = llvm::cl;

static cl::opt<std::string> kList(cl::Positional, cl::desc("LIST"), cl::Required, cl::sub(kRun));
static cl::OptionCategory kProgram("Running");
static cl::list<std::string> kSet("set", cl::desc("Set devices before the first scan, or with @N before scan N"), cl::value_desc("X0=1[@N],..."), cl::cat(kProgram), cl::sub(kRun));
static cl::list<std::string> kWatch("watch", cl::desc("Show these devices whenever they change"), cl::value_desc("Y0,D0"), cl::cat(kProgram), cl::sub(kRun));
static cl::opt<std::string> kScans("scans", cl::desc("Stop after N scans (default: until Ctrl-C)"), cl::value_desc("N"), cl::cat(kProgram), cl::sub(kRun));
static cl::opt<std::string> kScanTime("scan-time", cl::desc("One scan every 10ms, 500us ... (default 10ms)"), cl::value_desc("TIME"), cl::cat(kProgram), cl::sub(kRun));
static cl::opt<bool> kFreeRunning("free-running", cl::desc("Scan as fast as the machine can"), cl::cat(kProgram), cl::sub(kRun));
static cl::opt<bool> kVirtual("virtual", cl::desc("Let the clock advance by the scan time in each scan, without waiting"), cl::cat(kProgram), cl::sub(kRun));
static cl::opt<std::string> kStimulus("stimulus", cl::desc("Move the inputs: random:SEED, toggle or none"), cl::value_desc("HOW"), cl::cat(kProgram), cl::sub(kRun));
static cl::list<std::string> kSerial("serial", cl::desc("Connect a serial port of the controller to one of this machine"), cl::value_desc("0=/dev/ttyUSB0"), cl::cat(kProgram), cl::sub(kRun));
static cl::opt<std::string> kClock("clock", cl::desc("Set the controller's clock: system, or a date and time"), cl::value_desc("WHEN"), cl::cat(kProgram), cl::sub(kRun));
static cl::opt<bool> kJson("json", cl::desc("Statistics as JSON"), cl::cat(kProgram), cl::sub(kRun));
static cl::opt<bool> kQuiet("quiet", cl::desc("No statistics"), cl::cat(kProgram), cl::sub(kRun));

static std::vector<std::string> program_arguments() {
  std::vector<std::string> arguments;
  auto add = [&](const char *name, const std::string &value) {
    if (!value.empty())
      arguments.insert(arguments.end(), {name, value});
  };
  for (const std::string &value : kSet)
    add("--set", value);
  for (const std::string &value : kWatch)
    add("--watch", value);
  add("--scans", kScans);
  add("--scan-time", kScanTime);
  add("--stimulus", kStimulus);
  for (const std::string &value : kSerial)
    add("--serial", value);
  add("--clock", kClock);
  for (const auto &[name, given] : {std::pair<const char *, bool>{"--free-running", kFreeRunning}, {"--virtual", kVirtual}, {"--json", kJson}, {"--quiet", kQuiet}})
    if (given)
      arguments.emplace_back(name);
  return arguments;
}

int run_run(llvm::StringRef) {
  Compilation c;
  bool done;
  if (const int code = compile_list(c, kList, done); code || done)
    return code;
  const std::string program = build_native(c, "", false);
  if (program.empty())
    return kExitUsage;
  if (c.options.stats)
    c.print_stats(llvm::errs());
  // Not a child: whoever stops ladderc stops the program.
  return usage_error(fmt::format("{}: {}", program, toolchain::become(program, program_arguments())));
}

}  // namespace ladderc::driver
