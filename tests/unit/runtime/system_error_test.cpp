// Errors: what stops the CPU, what it leaves in SM and SD, and how it is cleared.
#include "plant.h"

#include <gtest/gtest.h>

using namespace ladder;
using plant::Plant;

namespace {

/// The program writes the code and switches SM50 on for a scan.
void clear_error(Plant &p, word code) {
  p.sys.SD[50] = code;
  p.sys.SM[50] = on;
  p.scan();
  p.sys.SM[50] = off;
  p.scan();
}

}  // namespace

TEST(SystemError, OperationErrorStopsAndTellsWhere) {
  Plant p;
  ASSERT_TRUE(p.sys.set_calendar({2006, 9, 25, 10, 35, 48, 0}));
  ASSERT_TRUE(p.sys.begin_scan(0));
  EXPECT_FALSE(p.sys.operation_error(4100, 70000));
  EXPECT_FALSE(p.sys.running());
  EXPECT_EQ(p.sm(0), on);
  EXPECT_EQ(p.sm(1), on);
  EXPECT_EQ(p.sm(5), on);
  EXPECT_EQ(p.sm(16), off);
  EXPECT_EQ(p.sm(56), on);
  EXPECT_EQ(p.sd(0), 4100);
  EXPECT_EQ(p.hex(1), 0x0609U);
  EXPECT_EQ(p.hex(2), 0x2510U);
  EXPECT_EQ(p.hex(3), 0x3548U);
  EXPECT_EQ(p.hex(4), 0x0004U);
  EXPECT_EQ(p.hex(5), 0x494DU) << "MI, the first character in the low byte";
  EXPECT_EQ(p.hex(6), 0x4558U) << "XE";
  EXPECT_EQ(p.hex(7), 0x2052U) << "R and a blank";
  EXPECT_EQ(p.hex(8), 0x2020U);
  EXPECT_EQ(p.hex(9), 0x512EU) << ".Q";
  EXPECT_EQ(p.hex(10), 0x4750U) << "PG";
  EXPECT_EQ(p.sd(11), 0);
  EXPECT_EQ(p.sd(13), 0);
  EXPECT_EQ(p.hex(14), 70000U & 0xFFFFU);
  EXPECT_EQ(p.sd(15), 1);
  EXPECT_EQ(p.sd(16), 0);
  EXPECT_EQ(p.sd(27), 1);
  const Status status = p.sys.status();
  EXPECT_EQ(status.mode, Mode::Run);
  EXPECT_FALSE(status.running);
  EXPECT_EQ(status.error, 4100);
  EXPECT_EQ(status.step, 70000u);
}

TEST(SystemError, StopErrorLastsUntilPowerOn) {
  Plant p;
  p.sys.operation_error(4101, 3);
  EXPECT_FALSE(p.scan());
  p.sys.set_mode(Mode::Stop);
  EXPECT_EQ(p.sm(203), on);
  p.sys.set_mode(Mode::Run);
  EXPECT_EQ(p.sm(203), off);
  EXPECT_FALSE(p.sys.running());
  EXPECT_FALSE(p.scan());
  EXPECT_EQ(p.sd(0), 4101);
  p.sys.power_on(plant::kParameters);
  EXPECT_TRUE(p.scan());
}

TEST(SystemError, AbortLeavesTheErrorRelayOff) {
  Plant p;
  EXPECT_FALSE(p.sys.abort(1234, 1));
  EXPECT_FALSE(p.sys.running());
  EXPECT_EQ(p.sm(0), on);
  EXPECT_EQ(p.sm(1), off);
  EXPECT_EQ(p.sm(5), on);
  EXPECT_EQ(p.sm(16), on);
  EXPECT_EQ(p.sm(56), off);
  EXPECT_EQ(p.sd(0), 4700);
  EXPECT_EQ(p.hex(4), 0x0B04U);
  EXPECT_EQ(p.sd(14), 1);
  EXPECT_EQ(p.sd(15), 0);
  EXPECT_EQ(p.sd(16), 1234);
  for (unsigned i = 17; i <= 26; ++i)
    EXPECT_EQ(p.sd(i), 0) << i;
  EXPECT_EQ(p.sys.status().error, 4700);
}

TEST(SystemError, WatchdogStopsWithBothTimes) {
  Plant p;
  p.scan();
  p.sys.watchdog_error(250300);
  EXPECT_FALSE(p.sys.running());
  EXPECT_EQ(p.sm(1), on);
  EXPECT_EQ(p.sm(56), off);
  EXPECT_EQ(p.sd(0), 5001);
  EXPECT_EQ(p.hex(4), 0x0303U);
  EXPECT_EQ(p.sd(5), 0);
  EXPECT_EQ(p.sd(6), 200);
  EXPECT_EQ(p.sd(16), 300);
  EXPECT_EQ(p.sd(17), 250);
}

TEST(SystemError, WatchdogWithoutMeasuredTime) {
  Plant p;
  p.sys.watchdog_error();
  EXPECT_EQ(p.sd(17), 200);
}

TEST(SystemError, ScanTimeErrorGoesOnAndIsCleared) {
  Plant p;
  p.scan();
  p.sys.scan_time_error(25500);
  EXPECT_TRUE(p.scan());
  EXPECT_EQ(p.sm(0), on);
  EXPECT_EQ(p.sm(1), on);
  EXPECT_EQ(p.sd(0), 5010);
  EXPECT_EQ(p.sd(6), 20);
  EXPECT_EQ(p.sd(17), 25);
  EXPECT_EQ(p.sd(81), 1 << 4);
  clear_error(p, 9000);
  EXPECT_EQ(p.sd(0), 5010) << "another error was named";
  clear_error(p, 5019);
  EXPECT_EQ(p.sm(0), off);
  EXPECT_EQ(p.sm(1), off);
  EXPECT_EQ(p.sm(5), off);
  EXPECT_EQ(p.sm(16), off);
  for (unsigned i = 0; i <= 27; ++i)
    EXPECT_EQ(p.sd(i), 0) << i;
  EXPECT_EQ(p.sd(81), 0);
  EXPECT_EQ(p.sys.status().error, 0);
}

TEST(SystemError, ResetActsOnTheRisingCommandOnly) {
  Plant p;
  p.sys.SM[50] = on;
  p.sys.SD[50] = 5010;
  p.scan();
  p.sys.scan_time_error(25000);
  p.scan();
  EXPECT_EQ(p.sm(0), on) << "the command was ON before";
  p.sys.SM[50] = off;
  p.scan();
  p.sys.SM[50] = on;
  p.scan();
  EXPECT_EQ(p.sm(0), off);
}

TEST(SystemError, StopErrorIsNotReplacedByAScanTimeError) {
  Plant p;
  p.sys.operation_error(4100, 9);
  p.sys.scan_time_error(30000);
  EXPECT_EQ(p.sd(0), 4100);
  EXPECT_EQ(p.sd(14), 9);
}
