// The command line: what is understood, and that nothing is understood by half.
#include "hosted/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ladder::hosted::test {
namespace {

Options parse(std::vector<const char *> words) {
  words.insert(words.begin(), "plant");
  return parse_options(static_cast<int>(words.size()), words.data());
}

std::string message(std::vector<const char *> words) {
  try {
    parse(std::move(words));
  } catch (const UsageError &error) {
    return error.what();
  }
  return "accepted";
}

std::string duration_message(std::string_view text) {
  try {
    return std::to_string(parse_duration(text));
  } catch (const UsageError &error) {
    return error.what();
  }
}

TEST(Duration, TakesThreeUnitsAndFractions) {
  EXPECT_EQ(parse_duration("500us"), 500u);
  EXPECT_EQ(parse_duration("10ms"), 10'000u);
  EXPECT_EQ(parse_duration("0.5ms"), 500u);
  EXPECT_EQ(parse_duration("1s"), 1'000'000u);
  EXPECT_EQ(parse_duration("3600s"), 3'600'000'000u);
}

TEST(Duration, RefusesTheRest) {
  for (const char *text : {"10", "ms", "", "10 ms", "10min", "-1ms", "1e3us", "tenms"})
    EXPECT_EQ(duration_message(text),
              std::string("'") + text +
                  (text == std::string("-1ms") ? "' is not between 1us and 3600s" : "' is no time: write 500us, 10ms or 1s"));
  EXPECT_EQ(duration_message("0ms"), "'0ms' is not between 1us and 3600s");
  EXPECT_EQ(duration_message("3601s"), "'3601s' is not between 1us and 3600s");
}

TEST(Options, ValuesFollowAsWordOrBehindEquals) {
  EXPECT_EQ(parse({"--scans", "5"}).scans, 5u);
  EXPECT_EQ(parse({"--scans=5"}).scans, 5u);
  EXPECT_EQ(parse({"--scan-time", "2ms", "--virtual"}).scan_time, 2000u);
  EXPECT_EQ(parse({"--virtual"}).pace, Pace::Virtual);
  EXPECT_EQ(parse({"--free-running"}).pace, Pace::FreeRunning);
  EXPECT_FALSE(parse({}).pace.has_value());
  EXPECT_TRUE(parse({"-h"}).help);
}

TEST(Options, SettingsAreListsWithScans) {
  Options options = parse({"--set", "X0=1,D0:f=1.5@7", "--set=X1=0"});
  ASSERT_EQ(options.settings.size(), 3u);
  EXPECT_EQ(options.settings[0].device, "X0");
  EXPECT_EQ(options.settings[0].value, "1");
  EXPECT_EQ(options.settings[0].scan, 1u);
  EXPECT_EQ(options.settings[1].device, "D0:f");
  EXPECT_EQ(options.settings[1].value, "1.5");
  EXPECT_EQ(options.settings[1].scan, 7u);
  EXPECT_EQ(options.settings[2].device, "X1");
}

TEST(Options, WatchedDevicesAreLists) {
  EXPECT_THAT(parse({"--watch", "Y0,D0:d", "--watch", "T0"}).watched, testing::ElementsAre("Y0", "D0:d", "T0"));
}

TEST(Options, StimulusHasThreeKinds) {
  EXPECT_EQ(parse({"--stimulus", "random:42"}).stimulus.seed, 42u);
  EXPECT_EQ(parse({"--stimulus", "random:42"}).stimulus.pattern, StimulusKind::Random);
  EXPECT_EQ(parse({"--stimulus=toggle"}).stimulus.pattern, StimulusKind::Toggle);
  EXPECT_EQ(parse({"--stimulus=toggle", "--stimulus=none"}).stimulus.pattern, StimulusKind::None);
}

TEST(Options, WrongOnesAreExplained) {
  EXPECT_EQ(message({"--sacns"}), "unknown option '--sacns'");
  EXPECT_EQ(message({"X0=1"}), "'X0=1' is no option");
  EXPECT_EQ(message({"--"}), "'--' is no option");
  EXPECT_EQ(message({"--scans"}), "--scans needs a value: --scans N");
  EXPECT_EQ(message({"--scans", "0"}), "--scans takes a whole number from 1 on, not '0'");
  EXPECT_EQ(message({"--scans", "5x"}), "--scans takes a whole number from 1 on, not '5x'");
  EXPECT_EQ(message({"--virtual=1"}), "--virtual takes no value");
  EXPECT_EQ(message({"--set", "X0"}), "--set takes DEVICE=VALUE or DEVICE=VALUE@SCAN, not 'X0'");
  EXPECT_EQ(message({"--set", "X0@1=1"}), "--set takes DEVICE=VALUE or DEVICE=VALUE@SCAN, not 'X0@1=1'");
  EXPECT_EQ(message({"--set", "X0=1@0"}), "the scan behind '@' takes a whole number from 1 on, not '0'");
  EXPECT_EQ(message({"--set", "X0=1,"}), "--set has an empty entry in 'X0=1,'");
  EXPECT_EQ(message({"--watch", ""}), "--watch has an empty entry in ''");
  EXPECT_EQ(message({"--stimulus", "noise"}), "--stimulus takes random:SEED, toggle or none, not 'noise'");
  EXPECT_EQ(message({"--stimulus", "random:"}), "--stimulus=random:SEED takes a whole number from 0 on, not ''");
}

TEST(Options, SerialPortsHaveADeviceEach) {
  Options options = parse({"--serial", "0=/dev/ttyUSB0", "--serial=2=/dev/a=b"});
  ASSERT_EQ(options.serial.size(), 2u);
  EXPECT_EQ(options.serial[0].port, 0u);
  EXPECT_EQ(options.serial[0].path, "/dev/ttyUSB0");
  EXPECT_EQ(options.serial[1].port, 2u);
  EXPECT_EQ(options.serial[1].path, "/dev/a=b");
  EXPECT_EQ(message({"--serial", "/dev/ttyUSB0"}), "--serial takes PORT=DEVICE such as 0=/dev/ttyUSB0, not '/dev/ttyUSB0'");
  EXPECT_EQ(message({"--serial", "0="}), "--serial takes PORT=DEVICE such as 0=/dev/ttyUSB0, not '0='");
  EXPECT_EQ(message({"--serial", "A=x"}), "the port of --serial takes a whole number from 0 on, not 'A'");
  EXPECT_EQ(message({"--serial", "16=x"}), "--serial has the ports 0 to 15, not 16");
  EXPECT_EQ(message({"--serial", "1=x", "--serial", "1=y"}), "--serial has two devices for port 1");
}

TEST(Options, TheCalendarStartsWithATime) {
  EXPECT_EQ(parse({}).clock, "");
  EXPECT_EQ(parse({"--clock", "system"}).clock, "system");
  EXPECT_EQ(parse({"--virtual", "--clock", "1998-11-30T11:50:20"}).clock, "1998-11-30T11:50:20");
}

TEST(Options, WhatWouldBeIgnoredTogetherIsRefused) {
  EXPECT_EQ(message({"--virtual", "--free-running"}), "--free-running and --virtual exclude each other");
  EXPECT_EQ(message({"--free-running", "--scan-time", "1ms"}), "--free-running has no scan time");
  EXPECT_EQ(message({"--bench", "--free-running"}), "--bench has a clock of its own; leave out --free-running");
  EXPECT_EQ(message({"--bench", "--watch", "Y0"}), "--bench watches no devices");
  EXPECT_EQ(message({"--bench", "--quiet"}), "--bench prints nothing but statistics; leave out --quiet");
  EXPECT_EQ(message({"--bench", "--set", "X0=1@2"}), "--bench counts no scans; leave out '@' in --set");
  EXPECT_EQ(message({"--bench", "--serial", "0=x"}), "--bench talks to nobody; leave out --serial");
  EXPECT_EQ(message({"--virtual", "--clock", "system"}), "in virtual time every run is the same; leave out --clock system");
  EXPECT_EQ(message({"--bench", "--clock=system"}), "in virtual time every run is the same; leave out --clock system");
  EXPECT_EQ(message({"--bench", "--virtual", "--json", "--set", "X0=1"}), "accepted");
}

TEST(Options, HelpNamesEveryOptionAndTheExitCodes) {
  EXPECT_EQ(help_text("plant"), R"(usage: plant [options]

Runs the compiled program on this computer.

  --scans N                     end after N scans; without it the program runs until it is interrupted
  --scan-time TIME              a scan every TIME, in us, ms or s (default 10ms); the step of the
                                clock with --virtual and --bench
  --free-running                scan as fast as possible, on the real clock
  --virtual                     scan as fast as possible; the program's clock moves by the scan time
                                from scan to scan, so that every run is the same
  --set DEV=VALUE[@SCAN],...    write a device before the first scan, or before scan SCAN; an input
                                stays as set. X0=1  D0=-5  D0=0x1234  D0:d=70000  D0:f=1.5
  --watch DEV,...               print a device whenever a scan changed it, and all of them at the end
  --stimulus KIND               give every input a new value before each scan: random:SEED, toggle or
                                none (default); --set inputs stay as set
  --serial PORT=DEVICE          connect a serial port of the program (0 is the built-in one) to a device
                                such as /dev/ttyUSB0; can be repeated
  --clock TIME                  start the calendar with the time of this computer (system) or with
                                1998-11-30T11:50:20
  --bench                       measure the time of a scan and print it as JSON, in nanoseconds; with
                                no --scans for about half a second
  --json                        print watched changes and statistics as JSON, one object a line
  --quiet                       print no statistics
  --help                        print this text

Exit code: 0 done, or ended by SIGINT or SIGTERM; 2 wrong options; 3 the CPU stopped on an error.
)");
}

}  // namespace
}  // namespace ladder::hosted::test
