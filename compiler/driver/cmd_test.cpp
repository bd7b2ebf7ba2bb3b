// ladderc test FILE...
#include "driver/scenario.h"
#include "toolchain/toolchain.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/raw_ostream.h"

#include <fmt/format.h>

#include <thread>

namespace ladderc::driver {

namespace cl = llvm::cl;

static cl::list<std::string> kFiles(cl::Positional, cl::desc("FILE..."), cl::OneOrMore, cl::sub(kTest));
static cl::opt<std::string> kJsonFile("json", cl::desc("Write the results as JSON"), cl::value_desc("FILE"), cl::sub(kTest));
static cl::opt<std::string> kJunitFile("junit", cl::desc("Write the results as JUnit XML"), cl::value_desc("FILE"), cl::sub(kTest));
static cl::opt<std::string> kFilter("filter", cl::desc("Only scenarios whose name contains this"), cl::value_desc("TEXT"), cl::sub(kTest));
static cl::opt<unsigned> kJobs("jobs", cl::desc("C++ compilers side by side (default: cores)"), cl::value_desc("N"), cl::init(0), cl::sub(kTest));
static cl::opt<bool> kVerbose("verbose", cl::desc("Name the scenarios that pass too"), cl::sub(kTest));

namespace {

/// Folders stand for the .json files in them; NAME-parameters.json beside NAME.il are the parameters of a list.
std::vector<std::string> files_of(const std::string &path) {
  if (!llvm::sys::fs::is_directory(path))
    return {path};
  std::vector<std::string> files;
  std::error_code ec;
  for (llvm::sys::fs::recursive_directory_iterator it(path, ec), end; it != end && !ec; it.increment(ec))
    if (llvm::sys::path::extension(it->path()) == ".json" && !llvm::sys::path::stem(it->path()).ends_with("-parameters"))
      files.push_back(it->path());
  llvm::sort(files);
  return files;
}

void print_results(const std::vector<Scenario> &scenarios, const std::vector<ScenarioResult> &results) {
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    if (results[i].passed) {
      if (kVerbose)
        llvm::outs() << "passed: " << scenarios[i].name << "\n";
      continue;
    }
    llvm::outs() << "FAILED: " << scenarios[i].name << " (" << scenarios[i].file << ")\n";
    if (!scenarios[i].source.empty())
      llvm::outs() << "  manual: " << scenarios[i].source << "\n";
    for (const std::string &message : results[i].messages)
      llvm::outs() << "  " << message << "\n";
  }
}

}  // namespace

int run_test(llvm::StringRef) {
  BatchOptions options;
  if (!read_common_options(options.common))
    return kExitUsage;
  options.jobs = kJobs ? unsigned(kJobs) : std::max(1u, std::thread::hardware_concurrency());
  std::vector<Scenario> scenarios;
  for (const std::string &path : kFiles)
    for (const std::string &file : files_of(path))
      if (const auto problem = read_scenarios(file, scenarios))
        return usage_error(*problem);
  if (!kFilter.empty())
    llvm::erase_if(scenarios, [](const Scenario &s) { return s.name.find(kFilter) == std::string::npos; });
  if (scenarios.empty())
    return usage_error("no scenario to run");
  std::vector<ScenarioResult> results;
  if (const auto problem = run_scenarios(scenarios, options, results))
    return usage_error(*problem);
  print_results(scenarios, results);
  for (const auto &[file, text] : {std::pair<std::string, std::string>{kJsonFile, json_report(scenarios, results)},
                                   {kJunitFile, junit_report(scenarios, results)}})
    if (!file.empty())
      if (const auto problem = toolchain::write_file(file, text))
        return usage_error(*problem);
  const auto failed = llvm::count_if(results, [](const ScenarioResult &r) { return !r.passed; });
  llvm::outs() << fmt::format("{} passed, {} failed\n", results.size() - static_cast<std::size_t>(failed), failed);
  return failed ? kExitErrors : 0;
}

}  // namespace ladderc::driver
