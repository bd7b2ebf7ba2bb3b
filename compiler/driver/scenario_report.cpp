// Reports of a scenario run for machines: JSON and JUnit.
#include "driver/scenario.h"

#include <fmt/format.h>

namespace ladderc::driver {

namespace {

std::string xml(llvm::StringRef text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '&':
      out += "&amp;";
      break;
    case '"':
      out += "&quot;";
      break;
    default:
      // XML has no way to write other control characters.
      out += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
    }
  }
  return out;
}

}  // namespace

std::string json_report(const std::vector<Scenario> &scenarios, const std::vector<ScenarioResult> &results) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    nlohmann::ordered_json entry;
    entry["name"] = scenarios[i].name;
    entry["file"] = scenarios[i].file;
    entry["family"] = scenarios[i].family;
    entry["source"] = scenarios[i].source;
    entry["passed"] = results[i].passed;
    if (!results[i].passed)
      entry["messages"] = results[i].messages;
    if (!results[i].failures.empty())
      entry["failures"] = results[i].failures;
    all.push_back(std::move(entry));
  }
  return all.dump(1) + "\n";
}

std::string junit_report(const std::vector<Scenario> &scenarios, const std::vector<ScenarioResult> &results) {
  std::size_t failed = 0;
  std::string cases;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    cases += fmt::format("  <testcase classname=\"{}\" name=\"{}\"", xml(scenarios[i].file), xml(scenarios[i].name));
    if (results[i].passed) {
      cases += "/>\n";
      continue;
    }
    ++failed;
    std::string text;
    for (const std::string &message : results[i].messages)
      text += message + "\n";
    cases += fmt::format(">\n    <failure message=\"{}\">{}</failure>\n  </testcase>\n",
                         xml(results[i].messages.empty() ? "" : results[i].messages.front()), xml(text));
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"ladderc\" tests=\"{}\" failures=\"{}\">\n{}</testsuite>\n",
      scenarios.size(), failed, cases);
}

}  // namespace ladderc::driver
