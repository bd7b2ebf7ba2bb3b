// Scenarios: passing, failing, and mistakes in them; the files around them.
#include "fake_program.h"

#include "hosted/scenario.h"

#include "ladder/hosted/device_name.h"
#include "ladder/hosted/scenario_main.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace ladder::hosted::test {
namespace {

const ProgramSymbols *const kPrograms[] = {&kFake, &kOctal};

Json run(const char *scenario) {
  return run_scenario(Json::parse(scenario), kPrograms);
}

std::string error(const char *scenario) {
  Json result = run(scenario);
  EXPECT_EQ(result["passed"], false);
  return result.contains("error") ? result["error"].get<std::string>() : "no error";
}

TEST(Scenario, PassesWhenEveryExpectationHolds) {
  Json result = run(R"({"program": 0, "name": "follow", "clock_ms": 10, "steps": [
    {"set": {"X0": 1, "X1": 1}, "expect": {"Y0": 1, "D0": 1, "D1": 0}, "why": "the clock starts at 0"},
    {"scans": 3, "expect": {"Y0": 1, "D0": 4, "D1": 30, "T0": 1, "TN0": 4, "TC0": 1}},
    {"set": {"X0": 0}, "expect": {"Y0": 0, "D2:f": 1.5}}]})");
  EXPECT_EQ(result, Json::parse(R"({"name": "follow", "passed": true, "failures": []})"));
}

TEST(Scenario, GoesOnBehindAFailure) {
  Json result = run(R"({"name": "wrong", "steps": [
    {"set": {"X0": 1}, "scans": 2, "expect": {"Y0": 0, "D0": 0}},
    {"expect": {"Y0": 1}},
    {"set": {"D5": -2}, "expect": {"D5": "0x00FE", "D2:f": 1.25}}]})");
  EXPECT_EQ(result, Json::parse(R"({"name": "wrong", "passed": false, "failures": [
    {"step": 0, "scan": 2, "device": "Y0", "expected": 0, "got": 1},
    {"step": 2, "scan": 4, "device": "D5", "expected": "0x00FE", "got": "0xFFFE"},
    {"step": 2, "scan": 4, "device": "D2:f", "expected": 1.25, "got": 1.5}]})"));
}

TEST(Scenario, ReadsAllValueForms) {
  EXPECT_EQ(run(R"({"name": "", "steps": [
    {"set": {"D4:d": -70000, "D6:u": 4000000000, "W0": "0x9876", "W2:f": 0.1, "K2X8": 165, "D3.F": 1, "X1": true}, "scans": 0,
     "expect": {"D4:d": -70000, "D4": "0xEE90", "D6:u": 4000000000, "D6:d": -294967296, "W0": -26506, "W2:f": 0.1,
                "W2:f": "0x3DCCCCCD", "X8": 1, "X9": 0, "K2X8": "0xA5", "D3.F": 1, "X1": true}}]})")["failures"],
            Json::array());
}

TEST(Scenario, FloatsAreComparedWithinATolerance) {
  EXPECT_EQ(run(R"({"steps": [{"expect": {"D2:f": 1.5000001}}]})")["passed"], true);
  EXPECT_EQ(run(R"({"steps": [{"expect": {"D2:f": 1.50001}}]})")["passed"], false);
  EXPECT_EQ(run(R"({"steps": [{"expect": {"D2:f": 1.6}, "tolerance": 0.1}]})")["passed"], true);
  EXPECT_EQ(run(R"({"steps": [{"set": {"W0": 0}, "expect": {"W0:f": 0.0}}]})")["passed"], true);
}

TEST(Scenario, InputsStayAsSetAndOtherDevicesDoNot) {
  EXPECT_EQ(run(R"({"steps": [{"scans": 2, "expect": {"Y1": 1}}, {"set": {"X5": 0}, "scans": 2, "expect": {"Y1": 0}},
                              {"set": {"Y0": 1}, "expect": {"Y0": 0}}]})")["failures"],
            Json::array());
}

TEST(Scenario, LaterDevicesOfAStepOverwriteEarlierOnes) {
  EXPECT_EQ(run(R"({"steps": [{"set": {"K1X0": 15, "X0": 0}, "expect": {"K1X0": 14}, "scans": 0},
                              {"set": {"X0": 0, "K1X0": 15}, "expect": {"K1X0": 15}, "scans": 0}]})")["failures"],
            Json::array());
}

TEST(Scenario, StopsRestartsAndLosesPower) {
  EXPECT_EQ(run(R"({"clock_ms": 1, "steps": [
    {"set": {"X1": 1, "D9": 5}, "scans": 2, "expect": {"D0": 2}},
    {"mode": "stop", "scans": 3, "expect": {"D0": 2}},
    {"mode": "run", "expect": {"D0": 3, "D1": 5}},
    {"power_cycle": true, "expect": {"D0": 1, "D9": 5}}]})")["failures"],
            Json::array());
}

TEST(Scenario, ComparesAlsoBehindAStopOfTheCpu) {
  EXPECT_EQ(run(R"({"steps": [{"set": {"X1": 1, "X2": 1}, "scans": 5, "expect": {"D0": 1}}, {"expect": {"D0": 2}}]})")["failures"],
            Json::parse(R"([{"step": 1, "scan": 6, "device": "D0", "expected": 2, "got": 1}])"));
}

TEST(Scenario, SetsTheCalendar) {
  EXPECT_EQ(run(R"({"calendar": "1998-11-30T11:50:20", "steps": [{"expect": {"D8": 1}}]})")["failures"], Json::array());
  Calendar calendar = parse_calendar("2024-02-29T23:59:58");
  EXPECT_EQ(calendar.year, 2024);
  EXPECT_EQ(calendar.month, 2);
  EXPECT_EQ(calendar.day, 29);
  EXPECT_EQ(calendar.hour, 23);
  EXPECT_EQ(calendar.minute, 59);
  EXPECT_EQ(calendar.second, 58);
  EXPECT_EQ(calendar.weekday, 4);
  for (const char *text : {"2023-02-29T00:00:00", "2024-13-01T00:00:00", "1979-01-01T00:00:00", "2024-01-01 00:00:00", "2024-01-01",
                           "2024-01-01T24:00:00", "2024-01-xxT00:00:00"})
    EXPECT_THROW(parse_calendar(text), DeviceError) << text;
}

TEST(Scenario, MistakesEndItWithAnErrorAndKeepEarlierFailures) {
  Json result = run(R"({"name": "bad", "steps": [{"expect": {"Y0": 1}}, {"set": {"X1Z": 1}}]})");
  EXPECT_EQ(result["error"], "step 1: 'X1Z' is no device of melsec-qs");
  EXPECT_EQ(result["failures"].size(), 1u);
  EXPECT_EQ(error(R"({"steps": [{"expect": {"D9000": 1}}]})"), "step 0: 'D9000' lies beyond D6143");
  EXPECT_EQ(error(R"({"steps": [{"set": {"D0": 40000}}]})"), "step 0: D0: 40000 does not fit: the values are -32768 to 32767");
  EXPECT_EQ(error(R"({"steps": [{"expect": {"Y0": 2}}]})"), "step 0: Y0: 2 does not fit: the values are 0 to 1");
  EXPECT_EQ(error(R"({"steps": [{"set": {"D0:u": 18446744073709551615}}]})"), "step 0: D0:u: 18446744073709551615 does not fit");
  EXPECT_EQ(error(R"({"steps": [{"set": {"D0": [1]}}]})"),
            "step 0: D0: [1] is no value: write a number or a bit pattern such as \"0x12AB\"");
  EXPECT_EQ(error(R"({"steps": [{"set": {"D0": "12"}}]})"), "step 0: D0: '12' is no bit pattern such as 0x12AB");
  EXPECT_EQ(error(R"({"steps": [{"scans": -1}]})"), "step 0: 'scans' is a whole number from 0 on, not -1");
  EXPECT_EQ(error(R"({"steps": [{"mode": "pause"}]})"), "step 0: 'mode' is \"run\" or \"stop\", not \"pause\"");
  EXPECT_EQ(error(R"({"steps": [{"interrupts": ["I0"]}]})"), "step 0: unknown key 'interrupts'");
  EXPECT_EQ(error(R"({"steps": [7]})"), "step 0: 7 is no object");
  EXPECT_EQ(error(R"({"calendar": "yesterday", "steps": []})"),
            "step 0: 'yesterday' is no date and time from 1980 to 2079 such as 1998-11-30T11:50:20");
  EXPECT_EQ(error(R"({"name": "x"})"), "'steps' is missing or no array");
  EXPECT_EQ(error(R"({"program": 2, "steps": []})"), "program 2 of 2 does not exist");
  EXPECT_EQ(error(R"({"clock_ms": -1, "steps": []})"), "'clock_ms' is a number from 0 to 3600000, not -1");
  EXPECT_EQ(error("3"), "3 is no object");
}

class ScenarioFiles : public testing::Test {
protected:
  int run_files(const std::string &steps) {
    std::ofstream(steps_) << steps;
    return main_with({"exe", steps_, results_});
  }
  int main_with(std::vector<std::string> words) {
    std::vector<char *> argv;
    for (std::string &word : words)
      argv.push_back(word.data());
    char *text = nullptr;
    std::size_t size = 0;
    std::FILE *err = open_memstream(&text, &size);
    int code = scenario_main(static_cast<int>(argv.size()), argv.data(), kPrograms, err);
    std::fclose(err);
    err_.assign(text, size);
    std::free(text);
    return code;
  }
  Json results() const {
    std::ifstream file(results_);
    return Json::parse(std::string{std::istreambuf_iterator<char>(file), {}});
  }
  void TearDown() override {
    std::remove(steps_.c_str());
    std::remove(results_.c_str());
  }

  std::string base_ =
      testing::TempDir() + "hosted_" + testing::UnitTest::GetInstance()->current_test_info()->name() + std::to_string(::getpid());
  std::string steps_ = base_ + "_steps.json", results_ = base_ + "_results.json", err_;
};

TEST_F(ScenarioFiles, OneResultForEachScenarioOnItsProgram) {
  EXPECT_EQ(run_files(R"([{"program": 0, "name": "a", "steps": [{"set": {"X1F": 1}, "expect": {"X1F": 1}}]},
                          {"program": 1, "name": "b", "steps": [{"set": {"X17": 1}, "expect": {"X17": 1}}]}])"),
            0);
  EXPECT_EQ(results(), Json::parse(R"([{"name":"a","passed":true,"failures":[]},{"name":"b","passed":true,"failures":[]}])"));
  EXPECT_EQ(run_files(R"([{"program": 1, "name": "c", "steps": [{"set": {"X18": 1}}]}])"), 1);
  EXPECT_EQ(results()[0]["error"], "step 0: 'X18' is no device of tp03: X counts in octal");
  EXPECT_EQ(run_files("[]"), 0);
  EXPECT_EQ(results(), Json::array());
}

TEST_F(ScenarioFiles, UnusableFilesExitWith2) {
  EXPECT_EQ(run_files("[{]"), 2);
  EXPECT_THAT(err_, testing::HasSubstr("parse error at line 1, column 3"));
  EXPECT_EQ(run_files("{}"), 2);
  EXPECT_EQ(err_, steps_ + ": not an array of scenarios\n");
  EXPECT_EQ(main_with({"exe", steps_ + ".none", results_}), 2);
  EXPECT_EQ(err_, steps_ + ".none: cannot be opened\n");
  std::ofstream(steps_) << "[]";
  EXPECT_EQ(main_with({"exe", steps_, "/nowhere/results.json"}), 2);
  EXPECT_EQ(err_, "/nowhere/results.json: cannot be written\n");
  EXPECT_EQ(main_with({"exe", steps_}), 2);
  EXPECT_EQ(err_, "usage: exe STEPS.json RESULTS.json\n");
}

TEST_F(ScenarioFiles, AThousandScenariosTakeWellUnderASecond) {
  std::string all = "[";
  for (int i = 0; i < 1000; ++i)
    all += std::string(i == 0 ? "" : ",") + R"({"program": 0, "name": "n", "steps": [
      {"set": {"X0": 1, "X1": 1}, "scans": 20, "expect": {"Y0": 1, "D0": 20}}, {"set": {"X0": 0}, "expect": {"Y0": 0, "D0": 21}}]})";
  auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(run_files(all + "]"), 0);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << "a generous limit: sanitizers and busy machines";
  EXPECT_EQ(results().size(), 1000u);
}

}  // namespace
}  // namespace ladder::hosted::test
