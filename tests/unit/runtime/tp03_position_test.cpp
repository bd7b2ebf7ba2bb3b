// F57 PLSY, F58 PWM, F59 PLSR, F156 ZRN, F157 PLSV, F158 DRVI, F159 DRVA from drive to end.
#include "ladder/image.h"
#include "ladder/numbered.h"
#include "ladder/tp03/ops/position.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <limits>

using namespace ladder;
using namespace ladder::tp03;

namespace {

struct Quiet : Io {};

/// As much of a system as these instructions see.
struct Machine {
  Numbered<Bits<512>, 8000> M;
  Numbered<Words<512>, 8000> D;
  Pulses pulses;
  Quiet quiet;
  Io &io() noexcept { return quiet; }
  void set_complete(bit state) noexcept { M[8029] = state; }
};

struct PositionTest : testing::Test {
  Bits<256> Y;
  Machine sys;
  bit direction{};

  void pass(std::uint32_t ms = 10) { sys.pulses.advance(ms * 1000, sys.M, sys.D, sys.quiet); }
  auto y(unsigned number) { return Y.run(number); }
  dword position(unsigned channel = 0) { return sys.D.pair(8140 + 2 * channel); }
  bit busy(unsigned channel = 0) { return sys.M[8147 + channel]; }
  bit complete() { return sys.M[8029]; }
};

constexpr Fault kNone = Fault::None, kRange = Fault::Range;

}  // namespace

TEST_F(PositionTest, PulseTrainRunsToItsEnd) {
  PulseTrain plsy;
  EXPECT_EQ(plsy.run(off, 1000, 25, y(0), sys), kNone);
  EXPECT_EQ(busy(), off);
  EXPECT_EQ(plsy.run(on, 1000, 25, y(0), sys), kNone);
  EXPECT_EQ(busy(), on);
  EXPECT_EQ(Y[0], on);
  pass();
  EXPECT_EQ(plsy.run(on, 1000, 3, y(0), sys), kNone) << "the count is that of the drive";
  pass();
  EXPECT_EQ(plsy.run(on, 1000, 25, y(0), sys), kNone);
  EXPECT_EQ(complete(), off);
  EXPECT_EQ(position(), 20);
  pass();
  EXPECT_EQ(busy(), off);
  EXPECT_EQ(plsy.run(on, 1000, 25, y(0), sys), kNone);
  EXPECT_EQ(complete(), on);
  EXPECT_EQ(position(), 25);
  pass(1000);
  EXPECT_EQ(plsy.run(on, 1000, 25, y(0), sys), kNone);
  EXPECT_EQ(complete(), on) << "once for each drive";
  EXPECT_EQ(position(), 25);
  EXPECT_EQ(plsy.run(off, 1000, 25, y(0), sys), kNone);
  EXPECT_EQ(complete(), off);
  EXPECT_EQ(plsy.run(on, 1000, 25, y(0), sys), kNone);
  EXPECT_EQ(busy(), on) << "driven again";
}

TEST_F(PositionTest, PulseTrainFollowsItsFrequencyAndRefusesWrongOnes) {
  PulseTrain plsy;
  EXPECT_EQ(plsy.run(on, 0, 0, y(0), sys), kRange);
  EXPECT_EQ(plsy.run(on, -1, 0, y(0), sys), kRange);
  EXPECT_EQ(plsy.run(on, 1, -1, y(0), sys), kRange);
  EXPECT_EQ(plsy.run(on, 1000, 0, y(2), sys), kRange) << "only Y0 and Y1";
  EXPECT_EQ(busy(), off);
  sys.M[8029] = on;
  EXPECT_EQ(plsy.run(on, 0, 0, y(0), sys), kRange);
  EXPECT_EQ(complete(), on) << "an error leaves the flags";
  EXPECT_EQ(plsy.run(on, 1000, 0, y(0), sys), kNone);
  pass();
  EXPECT_EQ(position(), 10);
  EXPECT_EQ(plsy.run(on, 200, 0, y(0), sys), kNone);
  pass();
  EXPECT_EQ(position(), 12);
  EXPECT_EQ(plsy.run(on, 0, 0, y(0), sys), kRange);
  pass();
  EXPECT_EQ(position(), 14) << "the last frequency stays";
  EXPECT_EQ(plsy.run(off, 0, 0, y(0), sys), kNone);
  EXPECT_EQ(busy(), off);
  EXPECT_EQ(Y[0], off);
  DPulseTrain wide;
  pass();
  EXPECT_EQ(wide.run(on, 100001, 0, y(0), sys), kRange);
  EXPECT_EQ(wide.run(on, 100000, std::numeric_limits<dword>::max(), y(0), sys), kNone);
}

TEST_F(PositionTest, AnOutputDrivesOneInstruction) {
  PulseTrain first, second, other;
  EXPECT_EQ(first.run(on, 1000, 0, y(0), sys), kNone);
  EXPECT_EQ(second.run(on, 1000, 0, y(0), sys), kRange);
  EXPECT_EQ(other.run(on, 1000, 0, y(1), sys), kNone) << "the other output is free";
  pass();
  EXPECT_EQ(first.run(off, 1000, 0, y(0), sys), kNone);
  pass();
  EXPECT_EQ(second.run(on, 1000, 0, y(0), sys), kRange) << "refused until its condition was OFF";
  EXPECT_EQ(second.run(off, 1000, 0, y(0), sys), kNone);
  pass();
  EXPECT_EQ(second.run(on, 1000, 0, y(0), sys), kNone);
  EXPECT_EQ(busy(), on);
  EXPECT_EQ(first.run(off, 1000, 0, y(0), sys), kNone);
  EXPECT_EQ(busy(), on) << "the output is not its own any more";
}

TEST_F(PositionTest, ADriveTooEarlyIsInErrorForAScan) {
  PulseTrain first, second;
  EXPECT_EQ(first.run(on, 1000, 0, y(0), sys), kNone);
  pass();
  EXPECT_EQ(first.run(off, 1000, 0, y(0), sys), kNone);
  EXPECT_EQ(second.run(on, 1000, 0, y(0), sys), kRange) << "stopped in this scan";
  EXPECT_EQ(busy(), off);
  pass();
  EXPECT_EQ(second.run(on, 1000, 0, y(0), sys), kNone);
  EXPECT_EQ(busy(), on);
}

TEST_F(PositionTest, StopRelays) {
  PulseTrain plsy;
  EXPECT_EQ(plsy.run(on, 1000, 0, y(0), sys), kNone);
  sys.M[8145] = on;
  EXPECT_EQ(plsy.run(on, 1000, 0, y(0), sys), kNone);
  EXPECT_EQ(busy(), off);
  EXPECT_EQ(complete(), off);
  sys.M[8145] = off;
  pass();
  EXPECT_EQ(plsy.run(on, 1000, 0, y(0), sys), kNone);
  EXPECT_EQ(busy(), off) << "not before the next drive";
  EXPECT_EQ(plsy.run(off, 1000, 0, y(0), sys), kNone);
  sys.M[8145] = on;
  EXPECT_EQ(plsy.run(on, 1000, 0, y(0), sys), kNone);
  EXPECT_EQ(busy(), off) << "nothing starts";
  PulseTrain skipped;
  EXPECT_EQ(skipped.run(on, 1000, 0, y(1), sys), kNone);
  sys.M[8146] = on;
  pass();
  EXPECT_EQ(busy(1), off) << "also where the instruction is not executed";
  sys.M[8146] = off;
  EXPECT_EQ(skipped.run(on, 1000, 0, y(1), sys), kNone);
  EXPECT_EQ(busy(1), off);
}

TEST_F(PositionTest, StopAndRunBeginsAnew) {
  PulseTrain plsy;
  EXPECT_EQ(plsy.run(on, 1000, 10, y(0), sys), kNone);
  pass();
  EXPECT_EQ(plsy.run(on, 1000, 10, y(0), sys), kNone);
  EXPECT_EQ(complete(), on);
  sys.pulses.restart();
  pass(0);
  EXPECT_EQ(plsy.run(on, 1000, 10, y(0), sys), kNone);
  EXPECT_EQ(busy(), on);
  EXPECT_EQ(complete(), off);
}

TEST_F(PositionTest, PulseWidth) {
  PulseWidth pwm;
  for (const auto &[width, period] : {std::pair<word, word>{60, 50}, {-1, 50}, {0, 0}, {0, 3001}})
    EXPECT_EQ(pwm.run(on, width, period, y(0), sys), kRange) << width << "/" << period;
  EXPECT_EQ(Y[0], off);
  EXPECT_EQ(pwm.run(on, 20, 50, y(0), sys), kNone);
  EXPECT_EQ(Y[0], on);
  EXPECT_EQ(busy(), off);
  pass(20);
  EXPECT_EQ(pwm.run(on, 20, 50, y(0), sys), kNone);
  EXPECT_EQ(Y[0], off);
  EXPECT_EQ(pwm.run(on, 30, 50, y(1), sys), kNone);
  EXPECT_EQ(Y[0], on) << "a wider one acts at once, another output with the next drive";
  EXPECT_EQ(Y[1], off);
  EXPECT_EQ(pwm.run(on, 60, 50, y(0), sys), kRange);
  pass(10);
  EXPECT_EQ(Y[0], off) << "30/50 goes on";
  PulseTrain plsy;
  EXPECT_EQ(plsy.run(on, 1000, 0, y(0), sys), kRange) << "in use";
  EXPECT_EQ(pwm.run(on, 50, 50, y(0), sys), kNone);
  pass(49);
  EXPECT_EQ(Y[0], on);
  EXPECT_EQ(pwm.run(off, 50, 50, y(0), sys), kNone);
  EXPECT_EQ(Y[0], off);
}

TEST_F(PositionTest, PulseRamp) {
  PulseRamp plsr;
  EXPECT_EQ(plsr.run(on, 1000, 109, 100, y(0), sys), kRange);
  EXPECT_EQ(plsr.run(on, 1000, 1000, -1, y(0), sys), kRange);
  EXPECT_EQ(plsr.run(on, 1000, 1000, 5001, y(0), sys), kRange);
  EXPECT_EQ(plsr.run(on, 1000, 1000, 500, y(0), sys), kNone);
  EXPECT_EQ(sys.pulses[0].frequency(), 100U);
  pass(51);
  EXPECT_EQ(sys.pulses[0].frequency(), 200U);
  EXPECT_EQ(plsr.run(on, 9, 110, 0, y(0), sys), kNone) << "operands are those of the drive";
  // 225 pulses in 450 ms on both sides, 550 at 1000 Hz.
  pass(1398);
  EXPECT_EQ(busy(), on);
  pass(1);
  EXPECT_EQ(plsr.run(on, 1000, 1000, 500, y(0), sys), kNone);
  EXPECT_EQ(complete(), on);
  EXPECT_EQ(position(), 1000);
  EXPECT_EQ(plsr.run(off, 1000, 1000, 500, y(0), sys), kNone);
  pass();
  EXPECT_EQ(plsr.run(on, 1000, 1000, 500, y(0), sys), kNone);
  pass();
  EXPECT_EQ(plsr.run(off, 1000, 1000, 500, y(0), sys), kNone);
  EXPECT_EQ(busy(), off) << "OFF stops without a ramp";
}

TEST_F(PositionTest, PulseRampBringsFrequenciesIntoTheRange) {
  DPulseRamp plsr;
  EXPECT_EQ(plsr.run(on, 200000, 1000000, 0, y(0), sys), kNone);
  EXPECT_EQ(sys.pulses[0].frequency(), 100000U);
  EXPECT_EQ(plsr.run(off, 200000, 1000000, 0, y(0), sys), kNone);
  pass();
  EXPECT_EQ(plsr.run(on, -5, 1000000, 5000, y(0), sys), kNone);
  EXPECT_EQ(sys.pulses[0].frequency(), 10U);
}

TEST_F(PositionTest, HomeReturn) {
  HomeReturn zrn;
  sys.D.pair(8140) = 5000;
  EXPECT_EQ(zrn.run(on, Y, 9, 100, off, y(0), sys), kRange);
  EXPECT_EQ(zrn.run(on, Y, 1000, 9, off, y(0), sys), kRange);
  EXPECT_EQ(zrn.run(on, Y, 1000, 100, off, y(0), sys), kNone);
  pass();
  EXPECT_EQ(position(), 4990) << "backwards";
  EXPECT_EQ(zrn.run(on, Y, 1000, 100, on, y(0), sys), kNone);
  pass();
  EXPECT_EQ(position(), 4989) << "creeps";
  EXPECT_EQ(zrn.run(on, Y, 1000, 100, on, y(0), sys), kNone);
  sys.M[8140] = on;
  EXPECT_EQ(zrn.run(on, Y, 1000, 100, off, y(0), sys), kNone);
  EXPECT_EQ(position(), 0);
  EXPECT_EQ(complete(), on);
  EXPECT_EQ(busy(), off);
  EXPECT_EQ(Y[2], on) << "the clear signal";
  pass();
  EXPECT_EQ(Y[2], on);
  EXPECT_EQ(zrn.run(on, Y, 1000, 100, on, y(0), sys), kNone);
  EXPECT_EQ(zrn.run(on, Y, 1000, 100, off, y(0), sys), kNone);
  EXPECT_EQ(complete(), on);
  pass();
  EXPECT_EQ(Y[2], off);
  EXPECT_EQ(zrn.run(off, Y, 1000, 100, off, y(0), sys), kNone);
  EXPECT_EQ(zrn.run(on, Y, 1000, 100, on, y(0), sys), kNone);
  EXPECT_EQ(sys.pulses[0].frequency(), 100U) << "a drive at the near point";
  EXPECT_EQ(zrn.run(off, Y, 1000, 100, on, y(0), sys), kNone);
  EXPECT_EQ(busy(), off);
  EXPECT_EQ(complete(), off);
}

TEST_F(PositionTest, HomeReturnOfTheOtherOutput) {
  DHomeReturn zrn;
  sys.M[8140] = on;
  EXPECT_EQ(zrn.run(on, Y, 100000, 32767, on, y(1), sys), kNone);
  EXPECT_EQ(zrn.run(on, Y, 100000, 32767, off, y(1), sys), kNone);
  EXPECT_EQ(Y[3], on);
  EXPECT_EQ(Y[2], off);
  EXPECT_EQ(zrn.run(off, Y, 100000, 32768, off, y(1), sys), kNone);
  pass(20);
  EXPECT_EQ(Y[3], off);
  EXPECT_EQ(zrn.run(on, Y, 100000, 32768, off, y(1), sys), kRange);
}

TEST_F(PositionTest, VariablePulses) {
  VariablePulses plsv;
  EXPECT_EQ(plsv.run(on, 1000, y(0), direction, sys), kNone);
  EXPECT_EQ(direction, on);
  pass();
  EXPECT_EQ(position(), 10);
  EXPECT_EQ(plsv.run(on, 0, y(0), direction, sys), kNone);
  EXPECT_EQ(busy(), off);
  EXPECT_EQ(direction, on);
  pass();
  EXPECT_EQ(plsv.run(on, -32768, y(0), direction, sys), kNone);
  EXPECT_EQ(direction, off);
  EXPECT_EQ(busy(), on);
  pass(1000);
  EXPECT_EQ(position(), 10 - 32768);
  direction = on;
  EXPECT_EQ(plsv.run(off, -32768, y(0), direction, sys), kNone);
  EXPECT_EQ(direction, on);
  EXPECT_EQ(busy(), off);
  DVariablePulses wide;
  pass();
  EXPECT_EQ(wide.run(on, 100001, y(0), direction, sys), kRange);
  EXPECT_EQ(wide.run(on, std::numeric_limits<dword>::min(), y(0), direction, sys), kRange);
  EXPECT_EQ(wide.run(on, -100000, y(0), direction, sys), kNone);
  EXPECT_EQ(direction, off);
}

TEST_F(PositionTest, WholeRoot) {
  EXPECT_EQ(whole_root(0), 0U);
  EXPECT_EQ(whole_root(99), 9U);
  EXPECT_EQ(whole_root(100), 10U);
  EXPECT_EQ(whole_root(0xFFFFFFFFU), 0xFFFFU);
}

TEST_F(PositionTest, SettingsOfMoves) {
  MoveSettings settings = MoveSettings::of(sys.D);
  EXPECT_EQ(settings.top, 100000U);
  EXPECT_EQ(settings.time_ms, 100U);
  EXPECT_EQ(settings.lowest(), 707U);
  sys.D[8145] = 200;
  sys.D.pair(8146) = 1000;
  sys.D[8148] = 10;
  settings = MoveSettings::of(sys.D);
  EXPECT_EQ(settings.base, 100U) << "at most a tenth";
  EXPECT_EQ(settings.time_ms, 50U);
  EXPECT_EQ(settings.lowest(), 100U);
  EXPECT_EQ(settings.ramp(1000).frequency(1), 100U);
  EXPECT_EQ(settings.ramp(1000).frequency(100), 1000U);
  EXPECT_EQ(settings.ramp(1000).pulses(100), 24U) << "45 ms at 550 Hz";
  EXPECT_FALSE(settings.ramp(100).exists());
}

TEST_F(PositionTest, RelativeMove) {
  RelativeMove drvi;
  sys.D.pair(8140) = 1000;
  EXPECT_EQ(drvi.run(on, 500, 9, y(0), direction, sys), kRange);
  sys.D.pair(8146) = 999;
  EXPECT_EQ(drvi.run(on, 500, 1000, y(0), direction, sys), kRange) << "above the highest speed";
  EXPECT_EQ(direction, off);
  sys.D.pair(8146) = 100000;
  EXPECT_EQ(drvi.run(on, 500, 1000, y(0), direction, sys), kNone);
  EXPECT_EQ(direction, on);
  EXPECT_EQ(busy(), on);
  pass();
  EXPECT_EQ(sys.pulses[0].frequency(), 1000U);
  EXPECT_EQ(drvi.run(on, -9, 1000, y(0), direction, sys), kNone);
  pass(600);
  EXPECT_EQ(drvi.run(on, 500, 1000, y(0), direction, sys), kNone);
  EXPECT_EQ(position(), 1500);
  EXPECT_EQ(complete(), on);
  EXPECT_EQ(drvi.run(off, 500, 1000, y(0), direction, sys), kNone);
  EXPECT_EQ(complete(), off);
  pass();
  EXPECT_EQ(drvi.run(on, -32768, 20, y(0), direction, sys), kNone);
  EXPECT_EQ(direction, off);
  EXPECT_EQ(sys.pulses[0].frequency(), 707U) << "raised";
  EXPECT_EQ(drvi.run(off, -32768, 20, y(0), direction, sys), kNone);
  EXPECT_EQ(busy(), off) << "no ramp to slow down on";
  EXPECT_EQ(drvi.run(on, 0, 20, y(0), direction, sys), kRange) << "too early";
  pass();
  EXPECT_EQ(drvi.run(on, 0, 20, y(0), direction, sys), kNone);
  EXPECT_EQ(complete(), on) << "nothing to move";
  EXPECT_EQ(busy(), off);
}

TEST_F(PositionTest, MovesSlowDownWhenTheConditionGoesOff) {
  DRelativeMove drvi;
  sys.D.pair(8146) = 100000;
  sys.D[8148] = 1000;
  EXPECT_EQ(drvi.run(on, 10000000, 100000, y(0), direction, sys), kNone);
  pass(2000);
  const dword before = position();
  EXPECT_EQ(drvi.run(off, 10000000, 100000, y(0), direction, sys), kNone);
  EXPECT_EQ(busy(), on);
  EXPECT_EQ(drvi.run(on, 10000000, 100000, y(0), direction, sys), kRange) << "not accepted";
  pass(900);
  EXPECT_EQ(busy(), on);
  EXPECT_EQ(drvi.run(on, 10000000, 100000, y(0), direction, sys), kRange);
  pass(110);
  EXPECT_EQ(busy(), off);
  EXPECT_NEAR(position() - before, 50000, 1000);
  EXPECT_EQ(drvi.run(on, 10000000, 100000, y(0), direction, sys), kRange) << "before the condition was OFF";
  EXPECT_EQ(drvi.run(off, 10000000, 100000, y(0), direction, sys), kNone);
  EXPECT_EQ(complete(), off);
}

TEST_F(PositionTest, AbsoluteMove) {
  AbsoluteMove drva;
  sys.D.pair(8142) = 1000;
  EXPECT_EQ(drva.run(on, 400, 1000, y(2), direction, sys), kRange);
  direction = on;
  EXPECT_EQ(drva.run(on, 400, 1000, y(1), direction, sys), kNone);
  EXPECT_EQ(direction, off);
  EXPECT_EQ(busy(1), on);
  pass(10000);
  EXPECT_EQ(drva.run(on, 400, 1000, y(1), direction, sys), kNone);
  EXPECT_EQ(complete(), on);
  EXPECT_EQ(position(1), 400);
  EXPECT_EQ(drva.run(off, 400, 1000, y(1), direction, sys), kNone);
  pass();
  EXPECT_EQ(drva.run(on, 400, 1000, y(1), direction, sys), kNone);
  EXPECT_EQ(complete(), on) << "already there";
}

TEST_F(PositionTest, AbsoluteMovesReachEverywhere) {
  DAbsoluteMove drva;
  sys.D.pair(8140) = std::numeric_limits<dword>::min();
  EXPECT_EQ(drva.run(on, std::numeric_limits<dword>::max(), 100000, y(0), direction, sys), kNone);
  EXPECT_EQ(direction, on);
  for (int i = 0; i < 43; ++i)
    pass(1000000);
  EXPECT_EQ(drva.run(on, 0, 100000, y(0), direction, sys), kNone);
  EXPECT_EQ(position(), std::numeric_limits<dword>::max());
  EXPECT_EQ(complete(), on);
}
