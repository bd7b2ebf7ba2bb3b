// Scenario files: programs with the behaviour that they must show. docs/scenarios.md describes the format for users.
#pragma once

#include "driver/compilation.h"

#include "llvm/ADT/StringRef.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ladderc::driver {

struct ExpectedDiagnostic {
  unsigned line = 0;     ///< 1-based, 0: anywhere
  std::string severity;  ///< "error" or "warning"
  std::string code;      ///< what the controller reports, or empty
  std::string about;
};

struct Scenario {
  std::string file;  ///< where it stands
  std::string name;
  std::string family, model;
  std::string source;      ///< place in the manual
  std::string list_name;   ///< for messages: the .il file, or the scenario's own
  std::string list;        ///< the program as text
  std::string parameters;  ///< JSON object
  double clock_ms = 10;
  std::string calendar;
  /// `serial`, `potentiometers` and `expansion_card` out of the parameters: what the runner connects to the controller.
  nlohmann::ordered_json connected = nlohmann::ordered_json::object();
  nlohmann::ordered_json steps;
  std::vector<ExpectedDiagnostic> diagnostics;
  bool optional = false;
};

/// Reads a scenario file (one object or an array). Returns an error text, or nothing.
[[nodiscard]] std::optional<std::string> read_scenarios(llvm::StringRef path, std::vector<Scenario> &scenarios);

struct ScenarioResult {
  bool passed = true;
  std::vector<std::string> messages;  ///< lines for a person
  /// Values that were not as expected: {"step", "scan", "device", "expected", "got"}, values as in the scenario.
  nlohmann::ordered_json failures = nlohmann::ordered_json::array();
  void fail(std::string text) {
    passed = false;
    messages.push_back(std::move(text));
  }
};

struct BatchOptions {
  CommonOptions common;
  unsigned jobs = 2;
  bool verbose = false;
};

/// Runs all scenarios: those with messages are checked here, the programs of the others are built in few compiler calls and run.
/// Returns an error text where that failed as a whole. `results` gets one entry a scenario.
[[nodiscard]] std::optional<std::string> run_scenarios(const std::vector<Scenario> &scenarios, const BatchOptions &options,
                                                       std::vector<ScenarioResult> &results);

std::string json_report(const std::vector<Scenario> &scenarios, const std::vector<ScenarioResult> &results);
std::string junit_report(const std::vector<Scenario> &scenarios, const std::vector<ScenarioResult> &results);

}  // namespace ladderc::driver
