// The pulse outputs of the TP03: counting in time, ramps, widths, and what hosts hear of them.
#include "ladder/image.h"
#include "ladder/numbered.h"
#include "ladder/tp03/pulses.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace ladder;
using namespace ladder::tp03;

namespace {

struct Listener : Io {
  std::vector<std::string> heard;
  void pulse_output(unsigned channel, std::uint32_t frequency, std::uint32_t left, bool forward) noexcept override {
    heard.push_back("Y" + std::to_string(channel) + (forward ? " +" : " -") + std::to_string(frequency) + " left " +
                    std::to_string(left));
  }
  void width_output(unsigned channel, std::uint16_t on_ms, std::uint16_t period_ms) noexcept override {
    heard.push_back("Y" + std::to_string(channel) + " " + std::to_string(on_ms) + "/" + std::to_string(period_ms));
  }
};

struct PulsesTest : testing::Test {
  Bits<256> Y;
  Numbered<Bits<512>, 8000> M;
  Numbered<Words<512>, 8000> D;
  Listener io;
  Pulses pulses;

  void pass(std::uint32_t us) { pulses.advance(us, M, D, io); }
  dword position(unsigned channel) { return D.pair(8140 + 2 * channel); }
  /// Microseconds until the channel stops, in steps of that many.
  std::uint64_t time_to_stop(unsigned channel, std::uint32_t step_us) {
    std::uint64_t sum = 0;
    while (pulses[channel].in_use() && sum < 1000000000U) {
      pass(step_us);
      sum += step_us;
    }
    return sum;
  }
};

}  // namespace

TEST(SpeedRamp, RisesInEqualSteps) {
  const SpeedRamp ramp(100, 1000, 1000000, 10);
  EXPECT_EQ(ramp.frequency(1), 100U);
  EXPECT_EQ(ramp.frequency(5), 500U);
  EXPECT_EQ(ramp.frequency(10), 1000U);
  EXPECT_EQ(ramp.pulses(0), 0U);
  EXPECT_EQ(ramp.pulses(1), 10U) << "a tenth of a second at 100 Hz";
  EXPECT_EQ(ramp.pulses(2), 30U);
  EXPECT_EQ(ramp.pulses(10), 550U);
  EXPECT_EQ(ramp.level_at(0), 1U);
  EXPECT_EQ(ramp.level_at(9), 1U);
  EXPECT_EQ(ramp.level_at(10), 2U);
  EXPECT_EQ(ramp.level_at(449), 9U);
  EXPECT_EQ(ramp.level_at(450), 10U);
  EXPECT_EQ(ramp.level_at(4000000000U), 10U);
}

TEST(SpeedRamp, OfNoTimeIsAtTheTop) {
  const SpeedRamp ramp(10, 100, 0, 10);
  EXPECT_EQ(ramp.pulses(10), 0U);
  EXPECT_EQ(ramp.level_at(0), 10U);
}

TEST(SpeedRamp, LargestNumbersFit) {
  const SpeedRamp ramp(10000, 100000, 5000000, 100);
  EXPECT_EQ(ramp.pulses(100), 275000U) << "the area of the trapezium";
}

TEST_F(PulsesTest, CountsWithoutLosingParts) {
  const std::uint32_t ticket = pulses[0].start({333, 0, true, {}}, Y.run(0));
  for (int scan = 0; scan < 1000; ++scan)
    pass(1001);
  EXPECT_EQ(position(0), 333) << "1.001 s at 333 Hz";
  EXPECT_TRUE(pulses[0].running(ticket));
  EXPECT_EQ(M[8147], on);
  EXPECT_EQ(M[8148], off);
}

TEST_F(PulsesTest, LevelIsOnForHalfOfAPulse) {
  pulses[0].start({10, 0, true, {}}, Y.run(0));
  EXPECT_EQ(Y[0], on) << "at once";
  pass(49999);
  EXPECT_EQ(Y[0], on);
  pass(1);
  EXPECT_EQ(Y[0], off);
  pass(49999);
  EXPECT_EQ(Y[0], off);
  EXPECT_EQ(position(0), 0);
  pass(1);
  EXPECT_EQ(Y[0], on);
  EXPECT_EQ(position(0), 1);
}

TEST_F(PulsesTest, StopsBehindTheLastPulse) {
  const std::uint32_t ticket = pulses[1].start({1000, 7, true, {}}, Y.run(1));
  pulses.show(1, M, io);
  pass(6999);
  EXPECT_TRUE(pulses[1].running(ticket));
  EXPECT_FALSE(pulses[1].finished(ticket));
  EXPECT_EQ(position(1), 6);
  pass(50000);
  EXPECT_FALSE(pulses[1].running(ticket));
  EXPECT_TRUE(pulses[1].finished(ticket));
  EXPECT_FALSE(pulses[1].finished(ticket - 1)) << "another run";
  EXPECT_EQ(position(1), 7);
  EXPECT_EQ(Y[1], off);
  EXPECT_EQ(M[8148], off);
  EXPECT_FALSE(pulses[1].rested());
  pass(0);
  EXPECT_TRUE(pulses[1].rested());
  EXPECT_EQ(io.heard, (std::vector<std::string>{"Y1 +1000 left 7", "Y1 +0 left 0"}));
}

TEST_F(PulsesTest, ChangesOfFrequencyKeepThePartOfAPulse) {
  pulses[0].start({100, 0, true, {}}, Y.run(0));
  pass(5000);  // half a pulse
  pulses[0].change(1000, true);
  pass(500);
  EXPECT_EQ(position(0), 1);
  pulses[0].change(0, true);
  pulses.show(0, M, io);
  EXPECT_EQ(M[8147], off) << "frequency 0";
  EXPECT_TRUE(pulses[0].in_use());
  pass(1000000);
  EXPECT_EQ(position(0), 1);
  pulses[0].change(1000, false);
  pass(3000);
  EXPECT_EQ(position(0), -2);
}

TEST_F(PulsesTest, PositionsWrapAround) {
  D.pair(8140) = -2147483647 - 1;
  pulses[0].start({1000, 1, false, {}}, Y.run(0));
  pass(1000);
  EXPECT_EQ(position(0), 2147483647);
}

TEST_F(PulsesTest, RampsEndAtTheLastPulseWhateverTheScan) {
  for (const std::uint32_t scan : {50U, 777U, 10000U, 10000000U}) {
    D.pair(8140) = 0;
    const std::uint32_t ticket = pulses[0].start({1000, 2000, true, SpeedRamp(100, 1000, 1000000, 10)}, Y.run(0));
    const std::uint64_t time = time_to_stop(0, scan);
    EXPECT_TRUE(pulses[0].finished(ticket));
    EXPECT_EQ(position(0), 2000) << scan;
    // Nine steps of 0.1 s on both sides, 450 pulses each, and 1100 pulses at the top.
    EXPECT_GE(time, 2900000U) << scan;
    EXPECT_LE(time, 2900000U + 100 + scan) << scan;
  }
}

TEST_F(PulsesTest, ShortRunsTurnInTheMiddle) {
  pulses[0].start({1000, 121, true, SpeedRamp(100, 1000, 1000000, 10)}, Y.run(0));
  std::uint32_t fastest = 0;
  std::vector<std::uint32_t> speeds;
  while (pulses[0].in_use()) {
    if (speeds.empty() || speeds.back() != pulses[0].frequency())
      speeds.push_back(pulses[0].frequency());
    fastest = fastest < pulses[0].frequency() ? pulses[0].frequency() : fastest;
    pass(1000);
  }
  EXPECT_EQ(position(0), 121);
  EXPECT_EQ(speeds, (std::vector<std::uint32_t>{100, 200, 300, 400, 300, 200, 100}));
}

TEST_F(PulsesTest, SlowingDownFollowsTheRamp) {
  const std::uint32_t ticket = pulses[0].start({1000, 100000, true, SpeedRamp(100, 1000, 1000000, 10)}, Y.run(0));
  pass(2000000);
  const dword before = position(0);
  EXPECT_EQ(pulses[0].frequency(), 1000U);
  pulses[0].slow_down();
  EXPECT_EQ(pulses[0].frequency(), 900U);
  EXPECT_TRUE(pulses[0].in_use());
  time_to_stop(0, 10000);
  EXPECT_EQ(position(0) - before, 450);
  EXPECT_FALSE(pulses[0].finished(ticket)) << "not completed";
  pulses[0].start({1000, 100000, true, SpeedRamp(100, 1000, 1000000, 10)}, Y.run(0));
  pulses[0].slow_down();
  EXPECT_FALSE(pulses[0].in_use()) << "at the first level";
  pulses[0].start({1000, 100000, true, {}}, Y.run(0));
  pulses[0].slow_down();
  EXPECT_FALSE(pulses[0].in_use()) << "without a ramp";
}

TEST_F(PulsesTest, HostsHearOfEveryChangeOfSpeed) {
  pulses[0].start({1000, 121, false, SpeedRamp(500, 1000, 100000, 2)}, Y.run(0));
  pulses.show(0, M, io);
  pulses.show(0, M, io);
  time_to_stop(0, 10000);
  ASSERT_EQ(io.heard.size(), 4U);
  EXPECT_EQ(io.heard[0], "Y0 -500 left 121");
  EXPECT_EQ(io.heard[1].substr(0, 8), "Y0 -1000");
  EXPECT_EQ(io.heard[2].substr(0, 7), "Y0 -500");
  EXPECT_EQ(io.heard[3], "Y0 -0 left 0");
}

TEST_F(PulsesTest, WidthsAreOfThePeriod) {
  const std::uint32_t ticket = pulses[0].start_width(30, 100, Y.run(0));
  pulses.show(0, M, io);
  EXPECT_EQ(Y[0], on);
  EXPECT_EQ(M[8147], off);
  EXPECT_TRUE(pulses[0].width_modulated());
  pass(29999);
  EXPECT_EQ(Y[0], on);
  pass(1);
  EXPECT_EQ(Y[0], off);
  pass(70000);
  EXPECT_EQ(Y[0], on);
  pass(340000);
  EXPECT_EQ(Y[0], off) << "40 ms into the fifth period";
  pulses[0].change_width(50, 60);
  pulses.show(0, M, io);
  EXPECT_EQ(Y[0], on);
  M[8145] = on;
  pass(0);
  EXPECT_TRUE(pulses[0].running(ticket)) << "M8145 stops pulses only";
  pulses[0].stop();
  pulses.show(0, M, io);
  EXPECT_EQ(Y[0], off);
  EXPECT_EQ(position(0), 0);
  EXPECT_EQ(io.heard, (std::vector<std::string>{"Y0 30/100", "Y0 50/60", "Y0 50/0"}));
}

TEST_F(PulsesTest, StopRelaysAndRestartStop) {
  pulses[0].start({1000, 0, true, {}}, Y.run(0));
  pulses[1].start({1000, 0, true, {}}, Y.run(1));
  M[8146] = on;
  pass(10000);
  EXPECT_EQ(position(1), 10) << "of the time before";
  EXPECT_FALSE(pulses[1].in_use());
  EXPECT_EQ(M[8148], off);
  EXPECT_EQ(M[8147], on);
  const std::uint32_t epoch = pulses.epoch();
  pulses.restart();
  EXPECT_NE(pulses.epoch(), epoch);
  EXPECT_FALSE(pulses[0].in_use());
  EXPECT_EQ(Y[0], off);
  pass(0);
  EXPECT_EQ(M[8147], off);
  EXPECT_EQ(io.heard.back(), "Y0 +0 left 0");
}

TEST_F(PulsesTest, TheClearSignalLastsTwentyMilliseconds) {
  pulses.clear_servo(0, Y.run(2));
  EXPECT_EQ(Y[2], on);
  pass(19999);
  EXPECT_EQ(Y[2], on);
  pass(1);
  EXPECT_EQ(Y[2], off);
  Y[2] = on;
  pass(10000);
  EXPECT_EQ(Y[2], on) << "the output is the program's again";
}
