// Reading scenario files.
#include "driver/scenario.h"

#include "source/decode.h"

#include "llvm/ADT/SmallString.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Path.h"

#include <fmt/format.h>

namespace ladderc::driver {

namespace {

using json = nlohmann::ordered_json;  // devices are set in the order written

/// What can be said in a scenario. Anything else is a misspelling or belongs to something that is not there yet.
constexpr llvm::StringLiteral kKeys[] = {"name",         "family",       "model", "source", "basis",    "program", "list",
                                         "program_name", "program_type", "clock_ms", "parameters", "steps", "diagnostics", "notes",
                                         "pair",         "optional",     "simulation"};
constexpr llvm::StringLiteral kStepKeys[] = {"set",         "scans",  "expect",     "tolerance", "why", "mode",
                                             "power_cycle", "pulses", "interrupts", "serial_sent"};
/// What is connected to the controller. It stands among the parameters and is no parameter of a program.
constexpr const char *kConnectedKeys[] = {"serial", "potentiometers", "expansion_card"};

constexpr int kMaxDepth = 64;

std::string text_of(const json &object, const char *key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<std::string> read_program(const json &object, llvm::StringRef path, Scenario &s) {
  if (object.contains("program")) {
    s.list_name = path.str();
    for (const json &line : object["program"])
      s.list += line.get<std::string>() + "\n";
    return std::nullopt;
  }
  if (!object.contains("list"))
    return "neither 'program' nor 'list'";
  llvm::SmallString<256> list(llvm::sys::path::parent_path(path));
  llvm::sys::path::append(list, text_of(object, "list"));
  auto file = llvm::MemoryBuffer::getFile(list);
  if (!file)
    return fmt::format("cannot read '{}': {}", list.c_str(), file.getError().message());
  s.list_name = list.str().str();
  s.list = decode((*file)->getBuffer()).text;
  return std::nullopt;
}

std::optional<std::string> read_steps(const json &object, Scenario &s) {
  s.steps = object.value("steps", json::array());
  if (!s.steps.is_array())
    return "'steps' is no array";
  for (const json &step : s.steps)
    for (const auto &[key, value] : step.items())
      if (!llvm::is_contained(kStepKeys, llvm::StringRef(key)))
        return fmt::format("a step has the key '{}', which ladderc does not know", key);
  for (const json &d : object.value("diagnostics", json::array())) {
    ExpectedDiagnostic expected;
    expected.line = d.value("line", 0u);
    expected.severity = d.value("severity", "error");
    expected.code = d.contains("code") && d["code"].is_number() ? std::to_string(d["code"].get<int>()) : text_of(d, "code");
    expected.about = text_of(d, "about");
    s.diagnostics.push_back(std::move(expected));
  }
  if (s.steps.empty() && s.diagnostics.empty())
    return "neither steps nor diagnostics: it would test nothing";
  return std::nullopt;
}

std::optional<std::string> read_scenario(const json &object, llvm::StringRef path, Scenario &s) {
  if (!object.is_object())
    return "a scenario is an object";
  s.file = path.str();
  s.name = text_of(object, "name");
  if (s.name.empty())
    return "a scenario without 'name'";
  for (const auto &[key, value] : object.items())
    if (!llvm::is_contained(kKeys, llvm::StringRef(key)))
      return fmt::format("{}: the key '{}' is not known", s.name, key);
  s.family = object.value("family", "melsec-qs");
  s.model = text_of(object, "model");
  s.source = text_of(object, "source");
  s.clock_ms = object.value("clock_ms", 10.0);
  s.optional = object.value("optional", false);
  json parameters = object.value("parameters", json::object());
  if (object.contains("program_name"))
    parameters["program_name"] = object["program_name"];
  s.calendar = text_of(parameters, "calendar");
  for (const char *key : kConnectedKeys) {
    if (const auto found = parameters.find(key); found != parameters.end()) {
      s.connected[key] = *found;
      parameters.erase(key);
    }
  }
  s.parameters = parameters.dump();
  std::optional<std::string> problem = read_program(object, path, s);
  if (!problem)
    problem = read_steps(object, s);
  if (problem)
    return s.name + ": " + *problem;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> read_scenarios(llvm::StringRef path, std::vector<Scenario> &scenarios) {
  auto file = llvm::MemoryBuffer::getFile(path);
  if (!file)
    return fmt::format("cannot read '{}': {}", path.str(), file.getError().message());
  try {
    // Values are copied and printed recursively: what is nested without end must not end the stack.
    bool too_deep = false;
    const auto limit_depth = [&](int depth, json::parse_event_t, json &) {
      too_deep |= depth > kMaxDepth;
      return depth <= kMaxDepth;
    };
    const json document = json::parse((*file)->getBuffer().begin(), (*file)->getBuffer().end(), limit_depth);
    if (too_deep)
      return fmt::format("{}: nested deeper than {} levels", path.str(), kMaxDepth);
    const json list = document.is_array() ? document : json::array({document});
    for (const json &object : list) {
      Scenario s;
      if (const auto problem = read_scenario(object, path, s))
        return fmt::format("{}: {}", path.str(), *problem);
      scenarios.push_back(std::move(s));
    }
  } catch (const json::exception &e) {
    return fmt::format("{}: {}", path.str(), e.what());
  }
  return std::nullopt;
}

}  // namespace ladderc::driver
