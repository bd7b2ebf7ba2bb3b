// The files of a scenario run. One result stands on one line, so that two result files can be compared line by line.
#include "ladder/hosted/scenario_main.h"

#include "hosted/scenario.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>

namespace ladder::hosted {
namespace {

enum ExitCode : int { kPassed = 0, kFailed = 1, kUsage = 2 };

}  // namespace

int scenario_main(int argc, char **argv, std::span<const ProgramSymbols *const> programs, std::FILE *err) {
  if (argc != 3) {
    fmt::print(err, "usage: {} STEPS.json RESULTS.json\n", argc > 0 ? argv[0] : "scenarios");
    return kUsage;
  }
  std::ifstream input(argv[1]);
  if (!input) {
    fmt::print(err, "{}: cannot be opened\n", argv[1]);
    return kUsage;
  }
  std::string text{std::istreambuf_iterator<char>(input), {}};
  Json scenarios;
  try {
    scenarios = Json::parse(text);
  } catch (const Json::parse_error &error) {
    fmt::print(err, "{}: {}\n", argv[1], error.what());
    return kUsage;
  }
  if (!scenarios.is_array()) {
    fmt::print(err, "{}: not an array of scenarios\n", argv[1]);
    return kUsage;
  }
  std::ofstream output(argv[2]);
  bool passed = true;
  const char *separator = "[\n";
  for (const Json &scenario : scenarios) {
    Json result = run_scenario(scenario, programs);
    passed = passed && result["passed"] == true;
    output << separator << result.dump(-1, ' ', false, Json::error_handler_t::replace);
    separator = ",\n";
  }
  output << (scenarios.empty() ? "[]\n" : "\n]\n");
  output.close();
  if (!output) {
    fmt::print(err, "{}: cannot be written\n", argv[2]);
    return kUsage;
  }
  return passed ? kPassed : kFailed;
}

}  // namespace ladder::hosted
