// F88 PID: the equations against a response worked out by hand, its timing, errors and alarms. Loops with a process are in
// tp03_pid_loop_test.cpp.
#include "ladder/image.h"
#include "ladder/tp03/ops/pid.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

using namespace ladder;
using tp03::Fault;

namespace {

struct FakeSystem {
  std::uint32_t now = 0, scan = 100'000;
  bit first{};
  bool routine = false;
  std::uint32_t now_us() const { return now; }
  std::uint32_t elapsed_us() const { return scan; }
  bit first_scan() const { return first; }
  bool routine_running() const { return routine; }
};

/// PID D0 D1 D100 D150 with the parameters in the order of their registers; reverse action, Ts 1 s, nothing but Kp 100 %.
struct Loop {
  Words<200> D;
  FakeSystem sys;
  tp03::Pid pid;

  Loop() { set({1000, 1, 0, 100, 0, 0, 0}); }
  void set(const std::vector<int> &parameters) {
    for (unsigned i = 0; i < parameters.size(); ++i)
      D[100 + i] = static_cast<word>(parameters[i]);
  }
  Fault run(bool condition = true) { return pid.run(bit(condition), D[0], D[1], D.block(100), D[150], D[150], sys); }
  /// Scans until the next sample; the output.
  word sample() {
    for (int i = 0; i < 10; ++i) {
      sys.now += sys.scan;
      fault = run();
    }
    return D[150];
  }
  Fault fault = Fault::None;
};

}  // namespace

TEST(Tp03Pid, AnswersAStepAsTheEquationsSay) {
  Loop loop;
  loop.set({1000, 1, 0, 200, 100, 50, 200});  // Kp 2, TI 10 s, aD 0.5, TD 2 s: TD / (Ts + aD TD) = 1, aD TD / (Ts + aD TD) = 0.5
  loop.D[0] = loop.D[1] = 1000;
  EXPECT_EQ(loop.run(), Fault::None);
  EXPECT_EQ(loop.sample(), 0);
  loop.D[1] = 900;
  EXPECT_EQ(loop.sample(), 420) << "2 (100 + 10 + 100)";
  EXPECT_EQ(loop.sample(), 340) << "2 (0 + 10 - 50): the derivative part turns";
  EXPECT_EQ(loop.sample(), 310) << "2 (10 - 25)";
  EXPECT_EQ(loop.sample(), 305) << "2 (10 - 12.5)";
  EXPECT_EQ(loop.sample(), 313) << "2 (10 - 6.25): 312.5";
  EXPECT_EQ(loop.sample(), 326) << "2 (10 - 3.125): 326.25";
}

TEST(Tp03Pid, ForwardActionIsTheMirrorImage) {
  Loop loop;
  loop.set({1000, 0, 0, 200, 100, 50, 200});
  loop.D[0] = loop.D[1] = 1000;
  loop.run();
  loop.D[1] = 1100;
  EXPECT_EQ(loop.sample(), 420);
  EXPECT_EQ(loop.sample(), 340);
  EXPECT_EQ(loop.sample(), 310);
}

TEST(Tp03Pid, FiltersTheMeasuredValue) {
  Loop loop;
  loop.set({1000, 0, 50, 100, 0, 0, 0});
  loop.run();
  loop.D[1] = 100;
  EXPECT_EQ(loop.sample(), 50);
  EXPECT_EQ(loop.sample(), 75);
  EXPECT_EQ(loop.sample(), 88) << "87.5";
  EXPECT_EQ(loop.sample(), 94) << "93.75: no fraction is lost";
}

TEST(Tp03Pid, FractionsAddUp) {
  Loop loop;
  loop.set({1000, 1, 0, 1, 100, 0, 0});
  loop.D[0] = 1;
  loop.run();
  for (int i = 0; i < 1000; ++i)
    loop.sample();
  EXPECT_EQ(loop.D[150], 1) << "1000 samples of 0.01 x 0.1";
}

TEST(Tp03Pid, NegativeOutputsRoundToTheNearest) {
  Loop loop;
  loop.D[3 + 100] = 50;
  loop.run();
  loop.D[1] = 3;
  EXPECT_EQ(loop.sample(), -2) << "-1.5";
  loop.D[1] = 5;
  EXPECT_EQ(loop.sample(), -3) << "-2.5";
}

TEST(Tp03Pid, StartsWithoutAJump) {
  Loop loop;
  loop.D[0] = 500;
  loop.D[150] = 123;
  loop.run();
  EXPECT_EQ(loop.sample(), 123) << "the deviation was there before";
  loop.D[1] = 100;
  EXPECT_EQ(loop.run(false), Fault::None);
  loop.sys.now += 5'000'000;
  loop.run(false);
  EXPECT_EQ(loop.D[150], 123) << "OFF";
  loop.run();
  EXPECT_EQ(loop.sample(), 123) << "the history begins anew";
}

TEST(Tp03Pid, GoesOnFromWhatTheProgramWrites) {
  Loop loop;
  loop.run();
  loop.D[0] = 10;
  EXPECT_EQ(loop.sample(), 10);
  loop.D[150] = 1000;
  loop.D[0] = 15;
  EXPECT_EQ(loop.sample(), 1005);
}

TEST(Tp03Pid, TheFirstScanStartsAnew) {
  Loop loop;
  loop.run();
  loop.sys.now = 2'000'000'000;
  loop.sys.first = on;
  loop.D[0] = 70;
  loop.run();
  loop.sys.first = off;
  EXPECT_EQ(loop.sample(), 0);
}

TEST(Tp03Pid, SamplesKeepToTheirGrid) {
  Loop loop;
  loop.D[100] = 250;  // two and a half scans
  loop.run();
  std::vector<int> scans;
  for (int scan = 1; scan <= 10; ++scan) {
    loop.sys.now += loop.sys.scan;
    ++loop.D[0];
    const word before = loop.D[150];
    loop.run();
    if (loop.D[150] != before)
      scans.push_back(scan);
  }
  EXPECT_EQ(scans, (std::vector<int>{3, 5, 8, 10}));
}

TEST(Tp03Pid, AMissedGridStartsAnew) {
  Loop loop;
  loop.run();
  loop.sys.now += 10'000'000;  // skipped by a jump
  loop.D[0] = 5;
  loop.run();
  EXPECT_EQ(loop.D[150], 5);
  loop.sys.now += 900'000;
  loop.D[0] = 6;
  loop.run();
  EXPECT_EQ(loop.D[150], 5) << "one sample for all that passed";
  loop.sys.now += 100'000;
  loop.run();
  EXPECT_EQ(loop.D[150], 6);
}

TEST(Tp03Pid, TheClockMayWrapAround) {
  Loop loop;
  loop.sys.now = 0xFFFFFFFFU - 300'000;
  loop.run();
  loop.D[0] = 5;
  EXPECT_EQ(loop.sample(), 5);
}

TEST(Tp03Pid, SamplingWithinAScanTakesTheScanTime) {
  Loop loop;
  loop.set({50, 1, 0, 100, 10, 0, 0});  // TI 1 s
  loop.D[0] = 100;
  EXPECT_EQ(loop.run(), Fault::None) << "the start does not calculate";
  loop.sys.now += loop.sys.scan;
  EXPECT_EQ(loop.run(), Fault::SamplingBelowScan);
  EXPECT_EQ(loop.D[150], 10) << "Ts is 0.1 s";
  EXPECT_EQ(loop.run(), Fault::SamplingBelowScan);
  EXPECT_EQ(loop.D[150], 10) << "a second look in the same scan";
  loop.D[100] = 200;
  loop.sys.now += loop.sys.scan;
  EXPECT_EQ(loop.run(), Fault::SamplingBelowScan) << "until the next calculation";
  loop.sys.now += loop.sys.scan;
  EXPECT_EQ(loop.run(), Fault::None);
  EXPECT_EQ(loop.D[150], 30);
}

TEST(Tp03Pid, ATimerInterruptMakesUpForALongScan) {
  Loop loop;
  loop.set({10, 1, 0, 100, 1, 0, 0});  // TI 0.1 s
  loop.D[0] = 100;
  loop.sys.routine = true;
  loop.run();
  loop.sys.now += loop.sys.scan;
  for (int served = 1; served <= 10; ++served) {
    EXPECT_EQ(loop.run(), Fault::None) << "the scan time does not matter";
    EXPECT_EQ(loop.D[150], 10 * served);
  }
  loop.run();
  EXPECT_EQ(loop.D[150], 100) << "all samples of this scan are made";
}

TEST(Tp03Pid, ParametersOutOfRangeStopIt) {
  const struct {
    unsigned place;
    int low, high;  // of the range
    Fault fault;
  } ranges[] = {{0, 1, 32767, Fault::SamplingTime}, {2, 0, 99, Fault::InputFilter},     {3, 1, 32767, Fault::ProportionalGain},
                {4, 0, 32767, Fault::IntegralTime}, {5, 0, 100, Fault::DerivativeGain}, {6, 0, 32767, Fault::DerivativeTime}};
  for (const auto &range : ranges) {
    for (const int bad : {range.low - 1, range.high + 1}) {
      if (bad > 32767)
        continue;
      Loop loop;
      loop.run();
      loop.D[100 + range.place] = static_cast<word>(bad);
      loop.D[0] = 10;
      loop.sample();
      EXPECT_EQ(loop.fault, range.fault) << range.place << ": " << bad;
      EXPECT_EQ(loop.D[150], 0);
      EXPECT_EQ(loop.run(false), Fault::None) << "OFF ends the error";
    }
    for (const int good : {range.low, range.high}) {
      Loop loop;
      loop.sys.scan = 1;
      loop.D[100 + range.place] = static_cast<word>(good);
      EXPECT_EQ(loop.run(), Fault::None) << range.place << ": " << good;
    }
  }
}

TEST(Tp03Pid, ErrorEndsWithoutAJump) {
  Loop loop;
  loop.run();
  loop.D[103] = 0;
  loop.D[0] = 300;
  loop.sample();
  EXPECT_EQ(loop.fault, Fault::ProportionalGain);
  loop.D[103] = 100;
  EXPECT_EQ(loop.sample(), 0);
  EXPECT_EQ(loop.fault, Fault::None);
}

TEST(Tp03Pid, LimitsAndAlarmsAreChecked) {
  const struct {
    int action, rise, fall, upper, lower;
  } bad[] = {{2, -1, 0, 0, 0}, {2, 0, -1, 0, 0}, {4, 0, 0, -1, 0}, {4, 0, 0, 0, -1}, {32, 0, 0, 9, 10}};
  for (const auto &each : bad) {
    Loop loop;
    for (unsigned i = 0; i < 4; ++i)
      loop.D[120 + i] = static_cast<word>(i == 0 ? each.rise : i == 1 ? each.fall : i == 2 ? each.upper : each.lower);
    EXPECT_EQ(loop.run(), Fault::None) << "not in use";
    loop.D[101] = static_cast<word>(each.action);
    EXPECT_EQ(loop.run(), Fault::Range) << each.action;
  }
}

TEST(Tp03Pid, LimitsHoldTheSumItself) {
  Loop loop;
  loop.set({1000, 33, 0, 100, 10, 0, 0});
  loop.D[122] = 2000;
  loop.D[123] = -500;
  loop.D[0] = 1000;
  loop.run();
  for (int i = 0; i < 1000; ++i)
    loop.sample();
  EXPECT_EQ(loop.D[150], 2000);
  EXPECT_EQ(loop.fault, Fault::None);
  loop.D[0] = -1;
  EXPECT_EQ(loop.sample(), 998) << "not wound up: 2000 - 1001 - 1";
  for (int i = 0; i < 2000; ++i)
    loop.sample();
  EXPECT_EQ(loop.D[150], -500);
}

TEST(Tp03Pid, OverflowsAreReportedAndLimited) {
  Loop deviation;
  deviation.run();
  deviation.D[0] = 32767;
  deviation.D[1] = -20000;
  EXPECT_EQ(deviation.sample(), 32767);
  EXPECT_EQ(deviation.fault, tp03::pid::kDeviationOverflow);
  EXPECT_EQ(deviation.sample(), 32767);
  EXPECT_EQ(deviation.fault, tp03::pid::kDeviationOverflow);
  deviation.D[1] = 32767;
  EXPECT_EQ(deviation.sample(), 0);
  EXPECT_EQ(deviation.fault, tp03::pid::kChangeOverflow);

  Loop integral;
  integral.set({1000, 1, 0, 1, 1, 0, 0});
  integral.D[0] = 4000;
  integral.run();
  EXPECT_EQ(integral.sample(), 328) << "1 s / 0.1 s x 4000 counts as 32767";
  EXPECT_EQ(integral.fault, tp03::pid::kIntegralOverflow);

  Loop derivative;
  derivative.set({1000, 0, 0, 1, 0, 0, 500});
  derivative.run();
  derivative.D[1] = 7000;
  derivative.sample();
  EXPECT_EQ(derivative.fault, tp03::pid::kDerivativeOverflow);

  Loop gain;
  gain.set({1, 0, 0, 1, 0, 0, 32767});
  gain.sys.scan = 500;
  gain.run();
  gain.D[1] = 1;
  gain.sys.now += 1000;
  gain.fault = gain.run();
  EXPECT_EQ(gain.fault, tp03::pid::kDerivativeGainOverflow);

  Loop output;
  output.D[103] = 32767;
  output.run();
  output.D[0] = -200;
  EXPECT_EQ(output.sample(), -32768);
  EXPECT_EQ(output.fault, tp03::pid::kOutputOverflow);
}

TEST(Tp03Pid, AlarmsOfTheInput) {
  Loop loop;
  loop.D[101] = 3;
  loop.D[120] = 50;
  loop.D[121] = 30;
  loop.run();
  const auto alarms_at = [&](word measured) {
    loop.D[1] = measured;
    loop.sample();
    return loop.D[124];
  };
  EXPECT_EQ(alarms_at(50), 0);
  EXPECT_EQ(alarms_at(101), 1) << "a rise of 51";
  EXPECT_EQ(alarms_at(101), 0);
  EXPECT_EQ(alarms_at(71), 0);
  EXPECT_EQ(alarms_at(40), 2) << "a fall of 31";
}

TEST(Tp03Pid, AlarmsOfTheOutput) {
  Loop loop;
  loop.D[101] = 5;
  loop.D[122] = 50;
  loop.D[123] = 30;
  loop.run();
  const auto alarms_at = [&](word set_value) {
    loop.D[0] = set_value;
    loop.sample();
    return loop.D[124];
  };
  EXPECT_EQ(alarms_at(50), 0);
  EXPECT_EQ(alarms_at(101), 4);
  EXPECT_EQ(alarms_at(70), 8);
  loop.D[101] = 1;
  loop.D[124] = 99;
  EXPECT_EQ(alarms_at(70), 99) << "registers that are not in use";
  loop.D[101] = 37;
  EXPECT_EQ(alarms_at(50), 0) << "limits exclude the alarm";
}
