// The executable's behaviour: watch lines, statistics, messages and exit codes.
#include "captured_run.h"
#include "fake_controller.h"

#include "ladder/hosted/clock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>

namespace ladder::hosted::test {
namespace {

using nlohmann::json;
using testing::MatchesRegex;

TEST(ProgramMain, WatchPrintsEachChangeWithScanAndTime) {
  CapturedRun result = run({"--virtual", "--scans", "5", "--quiet", "--watch", "Y0,D0,T0", "--set", "X1=1,X0=1@3"});
  EXPECT_EQ(result.exit, 0);
  EXPECT_EQ(result.out, "scan 1, 0.000 s: D0=1\n"
                        "scan 2, 0.010 s: D0=2\n"
                        "scan 3, 0.020 s: Y0=1\n"
                        "scan 3, 0.020 s: D0=3\n"
                        "scan 3, 0.020 s: T0=1\n"
                        "scan 4, 0.030 s: D0=4\n"
                        "scan 5, 0.040 s: D0=5\n");
  EXPECT_EQ(result.err, "");
}

TEST(ProgramMain, SettingsActBeforeTheirScanInAnyOrder) {
  CapturedRun result = run({"--virtual", "--scans=6", "--quiet", "--watch=Y0", "--set=X0=0@5,X0=1@2", "--set=X0=1@6"});
  EXPECT_EQ(result.out, "scan 2, 0.010 s: Y0=1\nscan 5, 0.040 s: Y0=0\nscan 6, 0.050 s: Y0=1\n");
}

TEST(ProgramMain, TheVirtualClockMovesByTheScanTime) {
  CapturedRun result = run({"--virtual", "--scan-time", "250us", "--scans", "9", "--quiet", "--watch", "D1"});
  EXPECT_EQ(result.out, "scan 5, 0.001 s: D1=1\nscan 9, 0.002 s: D1=2\n");
}

TEST(ProgramMain, StatisticsNameScansTimesAndFinalValues) {
  CapturedRun result = run({"--virtual", "--scans", "100", "--set", "X1=1@100,D5=-7", "--watch", "D0,D2:f,D5,D6143"});
  EXPECT_EQ(result.exit, 0);
  EXPECT_THAT(
      result.out,
      MatchesRegex("scan 1, 0.000 s: D2:f=1.5\n"
                   "scan 1, 0.000 s: D5=-7\n"
                   "scan 100, 0.990 s: D0=1\n"
                   "fake: 100 scans in 1.000 s\n"
                   "  scan time: min [0-9.]+ [num]s, median [0-9.]+ [num]s, max [0-9.]+ [num]s; [0-9.]+ [nu]s per instruction "
                   "\\(10 instructions\\)\n"
                   "  D0=1\n  D2:f=1.5\n  D5=-7\n  D6143=0\n"));
}

TEST(ProgramMain, JsonHasOneObjectALine) {
  CapturedRun result = run({"--virtual", "--scans", "2", "--json", "--watch", "Y0,D2:f", "--set", "X0=1@2"});
  std::vector<json> lines;
  for (std::size_t start = 0; start < result.out.size();) {
    std::size_t end = result.out.find('\n', start);
    lines.push_back(json::parse(result.out.substr(start, end - start)));
    start = end + 1;
  }
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], json::parse(R"({"scan":1,"time_us":0,"device":"D2:f","value":1.5})"));
  EXPECT_EQ(lines[1], json::parse(R"({"scan":2,"time_us":10000,"device":"Y0","value":1})"));
  const json &statistics = lines[2];
  EXPECT_EQ(statistics["program"], "fake");
  EXPECT_EQ(statistics["scans"], 2);
  EXPECT_EQ(statistics["time_us"], 20000);
  EXPECT_EQ(statistics["devices"], json::parse(R"({"Y0":1,"D2:f":1.5})"));
  EXPECT_EQ(statistics["instructions"], 10);
  EXPECT_EQ(statistics["error"], nullptr);
  EXPECT_LE(statistics["scan_ns"]["min"], statistics["scan_ns"]["median"]);
  EXPECT_LE(statistics["scan_ns"]["median"], statistics["scan_ns"]["max"]);
  EXPECT_DOUBLE_EQ(statistics["ns_per_instruction"].get<double>(), statistics["scan_ns"]["median"].get<double>() / 10);
}

TEST(ProgramMain, AStoppedCpuIsExplainedAndExitsWith3) {
  CapturedRun result = run({"--virtual", "--scans", "100", "--quiet", "--set", "X2=1@17"});
  EXPECT_EQ(result.exit, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "fake.il:12: error: the CPU stopped in scan 17 with error 4100 OPERATION ERROR\n"
                        "   12 | BIN D0 D1\n"
                        "  = at: step 8\n");
}

TEST(ProgramMain, JsonStatisticsCarryTheError) {
  CapturedRun result = run({"--virtual", "--scans", "100", "--json", "--set", "X2=1"});
  EXPECT_EQ(result.exit, 3);
  EXPECT_EQ(json::parse(result.out)["error"], json::parse(R"({"code":4100,"name":"OPERATION ERROR","stopped":true,"step":8,
      "file":"fake.il","line":12,"text":"BIN D0 D1"})"));
}

TEST(ProgramMain, AnErrorThatDoesNotStopIsAWarning) {
  CapturedRun result = run({"--virtual", "--scans", "3", "--quiet", "--set", "X3=1"});
  EXPECT_EQ(result.exit, 0);
  EXPECT_EQ(result.err, "fake.il:15: warning: the CPU reported error 9000 F****\n   15 | SET F3\n  = at: step 12\n");
}

TEST(ProgramMain, AProgramMayStopTheCpu) {
  CapturedRun result = run({"--virtual", "--scans", "9", "--quiet", "--set", "X6=1@2"});
  EXPECT_EQ(result.exit, 0);
  EXPECT_EQ(result.err, "fake.il: the program stopped the CPU in scan 2\n");
}

TEST(ProgramMain, TheWatchdogSeesALongScan) {
  CapturedRun result = run({"--free-running", "--scans", "50", "--quiet", "--set", "X4=1"});
  EXPECT_EQ(result.exit, 3);
  EXPECT_EQ(result.err, "fake.il: error: the CPU stopped in scan 1 with error 5001 WDT ERROR\n");
}

TEST(ProgramMain, VirtualTimeHasNoWatchdog) {
  CapturedRun result = run({"--virtual", "--scans", "2", "--quiet", "--set", "X4=1"});
  EXPECT_EQ(result.exit, 0);
  EXPECT_EQ(result.err, "");
}

TEST(ProgramMain, TimedScansFollowTheRealClock) {
  auto start = std::chrono::steady_clock::now();
  CapturedRun result = run({"--scan-time", "5ms", "--scans", "5", "--json", "--watch", "D1"});
  EXPECT_EQ(result.exit, 0);
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(20));
  std::string statistics = result.out.substr(result.out.rfind('\n', result.out.size() - 2) + 1);
  EXPECT_GE(json::parse(statistics)["devices"]["D1"], 20) << "the clock of the fifth scan in ms";
}

TEST(ProgramMain, BenchIsOneJsonObject) {
  CapturedRun result = run({"--bench", "--scans", "1000", "--stimulus", "random:3", "--set", "X2=0,X4=0,X6=0"});
  EXPECT_EQ(result.exit, 0);
  json bench = json::parse(result.out);
  EXPECT_EQ(bench["program"], "fake");
  EXPECT_EQ(bench["unit"], "ns");
  EXPECT_EQ(bench["scans"], 1000);
  EXPECT_GT(bench["min"], 0);
  EXPECT_LE(bench["min"], bench["median"]);
  EXPECT_LE(bench["median"], bench["max"]);
  EXPECT_LE(bench["min"], bench["mean"]);
  EXPECT_LE(bench["mean"], bench["max"]);
  EXPECT_GT(bench["warm_up_scans"], 0);
  EXPECT_LE(bench["batch"], 1000);
  EXPECT_GT(bench["stimulus"], 0);
  EXPECT_DOUBLE_EQ(bench["ns_per_instruction"].get<double>(), bench["median"].get<double>() / 10);
}

TEST(ProgramMain, BenchOfAStoppedCpuPrintsNoTimes) {
  CapturedRun result = run({"--bench", "--scans", "10", "--set", "X2=1"});
  EXPECT_EQ(result.exit, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, testing::HasSubstr("error 4100 OPERATION ERROR"));
}

TEST(ProgramMain, RandomRunsRepeat) {
  std::vector<std::string> words = {"--virtual", "--scans",    "50",        "--quiet", "--watch",
                                    "Y0,D0",     "--stimulus", "random:11", "--set",   "X2=0,X3=0,X4=0,X6=0"};
  CapturedRun first = run(words);
  EXPECT_GT(first.out.size(), 500u);
  EXPECT_EQ(first.out, run(words).out);
  words[7] = "random:12";
  EXPECT_NE(first.out, run(words).out);
}

TEST(ProgramMain, TheCalendarStartsAsAsked) {
  CapturedRun controller =
      run({"--virtual", "--scans", "1", "--json", "--watch", "D7,D8000", "--clock", "1998-11-30T11:50:20"}, kController);
  EXPECT_EQ(json::parse(controller.out)["devices"], json::parse(R"({"D7":50,"D8000":1998})"));
  CapturedRun wrong = run({"--clock", "noon"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_EQ(wrong.err, "fake: 'noon' is no date and time from 1980 to 2079 such as 1998-11-30T11:50:20\n");
}

TEST(ProgramMain, TheCalendarOfThisComputer) {
  const int before = system_calendar().minute;
  CapturedRun result =
      run({"--scan-time", "1ms", "--scans", "1", "--json", "--watch", "D7,D8000", "--clock", "system"}, kController);
  const json devices = json::parse(result.out)["devices"];
  EXPECT_GE(devices["D8000"], 2024);
  EXPECT_THAT(devices["D7"].get<int>(), testing::AnyOf(before, int{system_calendar().minute}));
}

TEST(ProgramMain, WrongOptionsExitWith2AndSayWhy) {
  CapturedRun option = run({"--sacns"});
  EXPECT_EQ(option.exit, 2);
  EXPECT_EQ(option.out, "");
  EXPECT_EQ(option.err, "fake: unknown option '--sacns'; --help lists the options\n");
  CapturedRun device = run({"--watch", "D9000"});
  EXPECT_EQ(device.exit, 2);
  EXPECT_EQ(device.err, "fake: 'D9000' lies beyond D6143\n");
  CapturedRun value = run({"--set", "D0=40000"});
  EXPECT_EQ(value.exit, 2);
  EXPECT_EQ(value.err, "fake: D0: 40000 does not fit: the values are -32768 to 32767\n");
}

TEST(ProgramMain, HelpGoesToStdout) {
  CapturedRun result = run({"--help"});
  EXPECT_EQ(result.exit, 0);
  EXPECT_THAT(result.out, testing::StartsWith("usage: fake [options]\n"));
  EXPECT_EQ(result.err, "");
}

}  // namespace
}  // namespace ladder::hosted::test
