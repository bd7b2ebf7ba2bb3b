// Time: ticks, scan times, clock relays, calendar.
#include "plant.h"

#include <gtest/gtest.h>

using namespace ladder;
using plant::Plant;

TEST(SystemClock, FirstScanHasNoTicks) {
  Plant p;
  p.now = 123456789;
  p.scan(250000);
  EXPECT_EQ(p.sys.low_ticks(), 0);
  EXPECT_EQ(p.sys.high_ticks(), 0);
  p.scan(50000);
  EXPECT_EQ(p.sys.low_ticks(), 2);
  EXPECT_EQ(p.sys.high_ticks(), 25);
  p.scan(1000);
  EXPECT_EQ(p.sys.low_ticks(), 1) << "50 ms were carried over";
  EXPECT_EQ(p.sys.high_ticks(), 5);
}

TEST(SystemClock, TimerRunsThreeSecondsAtAnyScanTime) {
  for (const Micros scan_us : {1700U, 10000U, 33333U, 100000U, 250000U}) {
    Plant p;
    Timer t;
    Micros elapsed = 0;
    for (; elapsed < 5000000; elapsed += scan_us) {
      ASSERT_TRUE(p.sys.begin_scan(elapsed));
      t.on_delay_low(on, 30, p.sys);
      p.sys.end_scan();
      if (t.contact)
        break;
    }
    EXPECT_GE(elapsed, 3000000u) << scan_us;
    EXPECT_LT(elapsed, 3000000u + scan_us) << scan_us;
  }
}

TEST(SystemClock, TheHostsClockMayWrap) {
  Plant p;
  p.now = 0xFFFFFFFFU - 4999;
  p.scan(10000);
  p.scan(10000);
  EXPECT_EQ(p.sys.high_ticks(), 1);
  EXPECT_EQ(p.sd(520), 10);
  p.scan(10000);
  EXPECT_EQ(p.sys.high_ticks(), 1);
}

TEST(SystemClock, LongSimulationOverManyWraps) {
  Plant p;
  for (int i = 0; i <= 20 * 3600; ++i)
    p.scan(1000000);
  EXPECT_EQ(p.sd(412), to_word(20 * 3600));
  p.sys.SM[213] = on;
  p.scan();
  EXPECT_EQ(p.hex(211), 0x0120U) << "1 January, 20 hours";
}

TEST(SystemClock, TimeInStopIsNoScanTime) {
  Plant p;
  p.scans(2);
  p.sys.set_mode(Mode::Stop);
  p.now += 5000000;
  p.sys.set_mode(Mode::Run);
  p.scan();
  EXPECT_EQ(p.sys.low_ticks(), 0);
  EXPECT_EQ(p.sd(520), 0);
  p.scan();
  EXPECT_EQ(p.sys.high_ticks(), 1);
  EXPECT_EQ(p.sd(520), 10);
  EXPECT_EQ(p.sd(526), 10);
}

TEST(SystemClock, ScanTimesInMillisecondsAndSteps) {
  Plant p;
  p.scan(23678);
  EXPECT_EQ(p.sd(520), 0);
  EXPECT_EQ(p.sd(524), 0);
  p.scan(5000);
  EXPECT_EQ(p.sd(520), 23);
  EXPECT_EQ(p.sd(521), 600);
  p.scan(40900);
  p.scan(10000);
  EXPECT_EQ(p.sd(520), 40);
  EXPECT_EQ(p.sd(521), 900);
  EXPECT_EQ(p.sd(524), 5);
  EXPECT_EQ(p.sd(525), 0);
  EXPECT_EQ(p.sd(526), 40);
  EXPECT_EQ(p.sd(527), 900);
}

TEST(SystemClock, ScanTimeEndsAtTheRegistersRange) {
  Plant p;
  p.scan(4000000000U);
  p.scan();
  EXPECT_EQ(p.sd(520), 6553);
  EXPECT_EQ(p.sd(521), 900);
}

TEST(SystemClock, ClockRelaysHalfAndHalf) {
  Plant p;
  for (Micros t = 0; t < 10000000; t += 10000) {
    p.scan(10000);
    ASSERT_EQ(p.sm(410), bit(t % 100000 >= 50000)) << t;
    ASSERT_EQ(p.sm(411), bit(t % 200000 >= 100000)) << t;
    ASSERT_EQ(p.sm(412), bit(t % 1000000 >= 500000)) << t;
    ASSERT_EQ(p.sm(413), bit(t % 2000000 >= 1000000)) << t;
    ASSERT_EQ(p.sd(412), static_cast<word>(t / 1000000)) << t;
  }
}

TEST(SystemClock, FlickerIntervalIsThePrograms) {
  Plant p;
  p.sys.SD[414] = 2;
  for (Micros t = 0; t < 20000000; t += 500000) {
    p.scan(500000);
    ASSERT_EQ(p.sm(414), bit(t / 2000000 % 2 == 1)) << t;
  }
}

TEST(SystemClock, FlickerDefaultsToThirtySeconds) {
  Plant p;
  p.scans(30, 1000000);
  EXPECT_EQ(p.sm(414), off);
  p.scan(1000000);
  EXPECT_EQ(p.sm(414), on);
}

TEST(SystemClock, SecondsCountInRunOnlyAndRelaysInStopToo) {
  Plant p;
  p.scans(3, 1000000);
  EXPECT_EQ(p.sd(412), 2);
  p.sys.set_mode(Mode::Stop);
  p.scan(500000);
  EXPECT_EQ(p.sd(412), 2);
  p.scan();
  EXPECT_EQ(p.sm(412), on);
}

TEST(SystemClock, SecondCounterWraps) {
  Plant p;
  p.scan(1000000);
  p.sys.SD[412] = 32767;
  p.scan();
  EXPECT_EQ(p.sd(412), -32768);
}

TEST(SystemClock, CalendarIsShownOnRequest) {
  Plant p;
  ASSERT_TRUE(p.sys.set_calendar({2006, 9, 25, 10, 35, 48, 0}));
  p.scan();
  EXPECT_EQ(p.sd(210), 0);
  p.sys.SM[213] = on;
  p.scan();
  EXPECT_EQ(p.hex(210), 0x0609U);
  EXPECT_EQ(p.hex(211), 0x2510U);
  EXPECT_EQ(p.hex(212), 0x3548U);
  EXPECT_EQ(p.hex(213), 0x2001U) << "Monday";
  p.scans(100);
  EXPECT_EQ(p.hex(212), 0x3549U);
  p.sys.SM[213] = off;
  p.scans(100);
  EXPECT_EQ(p.hex(212), 0x3549U);
}

TEST(SystemClock, RequestOfTheProgramIsServedInTheSameScan) {
  Plant p;
  ASSERT_TRUE(p.sys.set_calendar({2024, 2, 28, 23, 59, 59, 0}));
  ASSERT_TRUE(p.sys.begin_scan(0));
  p.sys.SM[213] = on;
  p.sys.end_scan();
  EXPECT_EQ(p.hex(210), 0x2402U);
  ASSERT_TRUE(p.sys.begin_scan(1000000));
  EXPECT_EQ(p.hex(211), 0x2900U);
}

TEST(SystemClock, CalendarRunsInStopAndOverReset) {
  Plant p;
  ASSERT_TRUE(p.sys.set_calendar({2024, 12, 31, 23, 59, 58, 0}));
  p.scan(1000000);
  p.sys.set_mode(Mode::Stop);
  p.scan(1000000);
  p.scan(1000000);
  p.sys.power_on(plant::kParameters);
  p.sys.SM[213] = on;
  p.scan();
  EXPECT_EQ(p.hex(210), 0x2501U);
  EXPECT_EQ(p.hex(211), 0x0100U);
}

TEST(SystemClock, RefusesATimeItCannotHold) {
  Plant p;
  EXPECT_FALSE(p.sys.set_calendar({2023, 2, 29, 0, 0, 0, 0}));
  p.sys.SM[213] = on;
  p.scan();
  EXPECT_EQ(p.hex(210), 0x0001U) << "still January 2000";
  EXPECT_EQ(p.hex(213), 0x2006U);
}

TEST(SystemClock, UnitsOfZeroAreTheDefaults) {
  melsec_qs::Parameters parameters = plant::kParameters;
  parameters.low_unit_us = 0;
  parameters.high_unit_us = 0;
  melsec_qs::System<> sys;
  sys.power_on(parameters);
  ASSERT_TRUE(sys.begin_scan(0));
  sys.end_scan();
  ASSERT_TRUE(sys.begin_scan(100000));
  EXPECT_EQ(sys.low_ticks(), 1);
  EXPECT_EQ(sys.high_ticks(), 10);
}
