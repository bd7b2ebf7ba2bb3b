// Reading scenario files: what a scenario can say, and that nothing misspelt is lost.
#include "driver/scenario.h"
#include "scratch.h"

#include <gmock/gmock.h>

namespace ladderc::test {
namespace {

using driver::Scenario;
using testing::HasSubstr;

std::vector<Scenario> read(const std::string &text) {
  const Scratch scratch;
  std::vector<Scenario> scenarios;
  if (const auto problem = driver::read_scenarios(scratch.write("s.json", text), scenarios))
    ADD_FAILURE() << *problem;
  return scenarios;
}
std::string problem_of(const std::string &text) {
  const Scratch scratch;
  std::vector<Scenario> scenarios;
  return driver::read_scenarios(scratch.write("s.json", text), scenarios).value_or("");
}

TEST(ScenarioFile, OneScenarioOrAnArray) {
  EXPECT_EQ(read(R"({"name": "a", "program": ["LD X0", "OUT Y0", "END"], "steps": [{}]})").size(), 1u);
  const auto two = read(R"([{"name": "a", "program": ["END"], "steps": [{}]}, {"name": "b", "program": ["END"], "steps": [{}]}])");
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[1].name, "b");
}

TEST(ScenarioFile, FieldsAndTheirDefaults) {
  const Scenario s = read(R"({"name": "a", "program": ["LD X0", "OUT Y0", "END"], "steps": [{"set": {"X1": 1, "X0": 1}}]})").at(0);
  EXPECT_EQ(s.list, "LD X0\nOUT Y0\nEND\n");
  EXPECT_EQ(s.family, "melsec-qs");
  EXPECT_EQ(s.clock_ms, 10.0);
  EXPECT_EQ(s.steps[0]["set"].dump(), R"({"X1":1,"X0":1})") << "devices are set in the order written";
}

TEST(ScenarioFile, ParametersCarryTheProgramNameAndTheCalendar) {
  const Scenario s = read(R"({"name": "a", "program": ["END"], "program_name": "SUB1", "clock_ms": 2.5,
                              "parameters": {"calendar": "1998-11-30T11:50:20", "ST_points": 4}, "steps": [{}]})")
                         .at(0);
  EXPECT_THAT(s.parameters, HasSubstr(R"("program_name":"SUB1")"));
  EXPECT_EQ(s.calendar, "1998-11-30T11:50:20");
  EXPECT_EQ(s.clock_ms, 2.5);
}

TEST(ScenarioFile, WhatIsConnectedIsNoParameterOfTheProgram) {
  const Scenario s = read(R"({"name": "a", "program": ["END"], "steps": [{"pulses": {"X0": 2}, "interrupts": ["I001"],
                                                                          "serial_sent": [{"port": 0, "hex": "41"}]}],
                              "parameters": {"serial": [{"port": 0, "rx_hex": "41", "at_ms": 5}], "expansion_card": {"1": 7},
                                             "potentiometers": {"0": 512}, "ST_points": 4}})")
                         .at(0);
  EXPECT_EQ(s.parameters, R"({"ST_points":4})");
  EXPECT_EQ(s.connected.dump(),
            R"({"serial":[{"port":0,"rx_hex":"41","at_ms":5}],"potentiometers":{"0":512},"expansion_card":{"1":7}})");
  EXPECT_EQ(read(R"({"name": "a", "program": ["END"], "steps": [{}]})").at(0).connected.dump(), "{}");
}

TEST(ScenarioFile, ExpectedMessages) {
  const Scenario s = read(R"({"name": "a", "program": ["END"], "diagnostics": [{"line": 3, "about": "x", "code": 4004},
                              {"severity": "warning", "code": "2500"}]})")
                         .at(0);
  ASSERT_EQ(s.diagnostics.size(), 2u);
  EXPECT_EQ(s.diagnostics[0].line, 3u);
  EXPECT_EQ(s.diagnostics[0].code, "4004");
  EXPECT_EQ(s.diagnostics[0].severity, "error");
  EXPECT_EQ(s.diagnostics[1].code, "2500");
}

TEST(ScenarioFile, AListBesideTheFile) {
  const Scratch scratch;
  scratch.write("press.il", "LD X0\nOUT Y3\nEND\n");
  std::vector<Scenario> scenarios;
  ASSERT_EQ(driver::read_scenarios(scratch.write("s.json", R"({"name": "a", "list": "press.il", "steps": [{}]})"), scenarios),
            std::nullopt);
  EXPECT_EQ(scenarios[0].list, "LD X0\nOUT Y3\nEND\n");
  EXPECT_EQ(scenarios[0].list_name, scratch.path("press.il"));
}

TEST(ScenarioFile, WhatIsWrongIsSaid) {
  EXPECT_THAT(problem_of("{"), HasSubstr("parse error"));
  EXPECT_THAT(problem_of("5"), HasSubstr("a scenario is an object"));
  EXPECT_THAT(problem_of(R"({"program": ["END"]})"), HasSubstr("a scenario without 'name'"));
  EXPECT_THAT(problem_of(R"({"name": "a", "steps": [{}]})"), HasSubstr("a: neither 'program' nor 'list'"));
  EXPECT_THAT(problem_of(R"({"name": "a", "program": ["END"]})"), HasSubstr("it would test nothing"));
  EXPECT_THAT(problem_of(R"({"name": "a", "program": ["END"], "steps": {}})"), HasSubstr("'steps' is no array"));
  EXPECT_THAT(problem_of(R"({"name": "a", "program": ["END"], "step": [{}]})"), HasSubstr("a: the key 'step' is not known"));
  EXPECT_THAT(problem_of(R"({"name": "a", "program": ["END"], "steps": [{"expects": {}}]})"),
              HasSubstr("a step has the key 'expects'"));
  EXPECT_THAT(problem_of(R"({"name": "a", "list": "none.il", "steps": [{}]})"), HasSubstr("cannot read"));
  EXPECT_THAT(problem_of(R"({"name": "a", "program": [5], "steps": [{}]})"), HasSubstr("type must be string"));
  std::vector<Scenario> none;
  EXPECT_THAT(driver::read_scenarios("/nowhere/s.json", none).value_or(""), HasSubstr("cannot read '/nowhere/s.json'"));
}

}  // namespace
}  // namespace ladderc::test
