// Scenarios: passing, failing, and mistakes in them; the files around them.
#include "fake_controller.h"
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

const ProgramSymbols *const kPrograms[] = {&kFake, &kOctal, &kController};

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
  EXPECT_EQ(error(R"({"steps": [{"interrupts": ["I0"]}]})"), "step 0: the program has no interrupt routines");
  EXPECT_EQ(error(R"({"steps": [7]})"), "step 0: 7 is no object");
  EXPECT_EQ(error(R"({"calendar": "yesterday", "steps": []})"),
            "step 0: 'yesterday' is no date and time from 1980 to 2079 such as 1998-11-30T11:50:20");
  EXPECT_EQ(error(R"({"name": "x"})"), "'steps' is missing or no array");
  EXPECT_EQ(error(R"({"steps": [{"interupts": ["I0"]}]})"), "step 0: unknown key 'interupts'");
  EXPECT_EQ(error(R"({"program": 3, "steps": []})"), "program 3 of 3 does not exist");
  EXPECT_EQ(error(R"({"clock_ms": -1, "steps": []})"), "'clock_ms' is a number from 0 to 3600000, not -1");
  EXPECT_EQ(error("3"), "3 is no object");
}

TEST(Scenario, TextsArriveOnSerialLinesAtTheirTime) {
  EXPECT_EQ(
      run(R"({"program": 2, "clock_ms": 10, "serial": [{"port": 0, "rx_hex": "43 0a", "at_ms": 20}, {"rx_hex": "41", "at_ms": 10},
                                                             {"port": 1, "rx_hex": "4444"}],
    "steps": [
    {"expect": {"D0": 0}, "serial_sent": [{"port": 0, "hex": ""}]},
    {"expect": {"D0": 1, "D1": 65}},
    {"expect": {"D0": 3, "D1": 10}, "serial_sent": [{"port": 0, "hex": "42 44 0B"}]},
    {"expect": {"D0": 3}, "serial_sent": [{"hex": ""}]}]})")["failures"],
      Json::array());
}

TEST(Scenario, OtherBytesThanExpectedAreAFailure) {
  EXPECT_EQ(
      run(R"({"program": 2, "serial": [{"rx_hex": "FE FF"}], "steps": [{"scans": 2, "serial_sent": [{"port": 0, "hex": "ff"}]}]})")
          ["failures"],
      Json::parse(R"([{"step": 0, "scan": 2, "device": "serial port 0", "expected": "FF", "got": "FF 00"}])"));
}

TEST(Scenario, PotentiometersAndOptionCardsHavePositions) {
  EXPECT_EQ(run(R"({"program": 2, "potentiometers": {"1": 1023, "0": 7}, "expansion_card": {"0": 300}, "steps": [
    {"expect": {"D2": 1023, "D3": 300}}, {"power_cycle": true, "expect": {"D2": 1023}}]})")["failures"],
            Json::array());
}

TEST(Scenario, ControllersWithoutConnectionsTakeThemInSilence) {
  EXPECT_EQ(
      run(R"({"serial": [{"rx_hex": "41"}], "potentiometers": {"0": 1}, "expansion_card": {}, "steps": [{"expect": {"D0": 0}}]})")
          ["passed"],
      true);
}

TEST(Scenario, PulsesAndInterruptsComeBeforeTheScans) {
  EXPECT_EQ(run(R"({"program": 2, "steps": [
    {"pulses": {"X5": 25, "X0": 1}, "interrupts": ["I001", "I610"], "scans": 3, "expect": {"CN235": 25, "C235:u": 25, "D4": 0, "D5": 52, "D6": 610}},
    {"set": {"X5": 1}, "expect": {"CN235": 25}, "why": "set changes the image for the scan only"},
    {"pulses": {"X5": 2}, "expect": {"CN235": 27}}]})")["failures"],
            Json::array());
}

TEST(Scenario, MistakesInConnectionsAreSaid) {
  auto of = [](const std::string &keys, const char *step = "{}") {
    return error((R"({"program": 2, )" + keys + R"("steps": [)" + step + "]}").c_str());
  };
  EXPECT_EQ(of(R"("serial": {}, )"), "step 0: {} is no array of serial texts");
  EXPECT_EQ(of(R"("serial": [{"port": 0}], )"), "step 0: 'rx_hex' is missing in {\"port\":0}");
  EXPECT_EQ(of(R"("serial": [{"rx_hex": "4"}], )"), "step 0: \"4\" are no bytes such as \"41 0D\"");
  EXPECT_EQ(of(R"("serial": [{"rx_hex": "4 1"}], )"), "step 0: \"4 1\" are no bytes such as \"41 0D\"");
  EXPECT_EQ(of(R"("serial": [{"rx_hex": 41}], )"), "step 0: 41 are no bytes such as \"41 0D\"");
  EXPECT_EQ(of(R"("serial": [{"rx_hex": "41", "after": 1}], )"), "step 0: unknown key 'after'");
  EXPECT_EQ(of(R"("serial": [{"rx_hex": "41", "port": 16}], )"), "step 0: 16 is no port");
  EXPECT_EQ(of(R"("potentiometers": [5], )"), "step 0: 'potentiometers' is an object such as {\"0\": 512}, not [5]");
  EXPECT_EQ(of(R"("potentiometers": {"0": 1024}, )"),
            "step 0: 'potentiometers' has numbers with positions from 0 to 1023, not \"0\": 1024");
  EXPECT_EQ(of(R"("expansion_card": {"a": 1}, )"),
            "step 0: 'expansion_card' has numbers with positions from 0 to 1023, not \"a\": 1");
  EXPECT_EQ(of("", R"({"interrupts": "I001"})"), "step 0: 'interrupts' is an array of pointers, not \"I001\"");
  EXPECT_EQ(of("", R"({"interrupts": ["X1"]})"), "step 0: \"X1\" is no interrupt pointer such as \"I001\"");
  EXPECT_EQ(of("", R"({"pulses": {"X0": -1}})"), "step 0: X0: -1 is no number of pulses from 0 to 10000000");
  EXPECT_EQ(of("", R"({"pulses": {"Y0": 1}})"), "step 0: Y0: only an input terminal gets pulses");
  EXPECT_EQ(error(R"({"steps": [{"pulses": {"X0": 1}}]})"), "step 0: X0: the program looks at its inputs in scans only");
  EXPECT_EQ(of("", R"({"serial_sent": [{"rx_hex": "41"}]})"), "step 0: unknown key 'rx_hex'");
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
  EXPECT_EQ(results()[0]["error"], "step 0: 'X18' is no device of octal: X counts in octal");
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
