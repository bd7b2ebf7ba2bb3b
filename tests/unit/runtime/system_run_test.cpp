// Power-on, RUN and STOP, and the relays and registers of the scan itself.
#include "plant.h"

#include <gtest/gtest.h>

using namespace ladder;
using plant::Plant;

TEST(SystemRun, IsStoppedBeforePowerOn) {
  melsec_qs::System<> sys;
  EXPECT_FALSE(sys.running());
  EXPECT_FALSE(sys.begin_scan(0));
  EXPECT_EQ(sys.status().mode, Mode::Stop);
}

TEST(SystemRun, PowerOnWritesInitialValues) {
  Plant p;
  EXPECT_TRUE(p.sys.running());
  EXPECT_EQ(p.sd(290), 6144);
  EXPECT_EQ(p.sd(293), 0);
  EXPECT_EQ(p.sd(300), 16);
  EXPECT_EQ(p.sd(304), 1536);
  EXPECT_EQ(p.sd(414), 30);
  EXPECT_EQ(p.sm(203), off);
  EXPECT_EQ(p.sm(400), on);
  EXPECT_EQ(p.sm(401), off);
  EXPECT_EQ(p.sm(402), on);
  EXPECT_EQ(p.sm(403), off);
  EXPECT_EQ(p.sm(660), on);
  EXPECT_EQ(p.sm(0), off);
  EXPECT_EQ(p.sd(0), 0);
}

TEST(SystemRun, PowerOnClearsWhatWasThere) {
  Plant p;
  p.scans(3);
  p.sys.SM[1000] = on;
  p.sys.SD[1000] = 5;
  p.sys.operation_error(4100, 7);
  p.sys.power_on(plant::kParameters);
  EXPECT_TRUE(p.sys.running());
  EXPECT_EQ(p.sm(0), off);
  EXPECT_EQ(p.sm(1), off);
  EXPECT_EQ(p.sm(56), off);
  EXPECT_EQ(p.sd(0), 0);
  EXPECT_EQ(p.sm(1000), off);
  EXPECT_EQ(p.sd(1000), 0);
  EXPECT_EQ(p.sys.status().error, 0);
  EXPECT_EQ(p.sys.status().scans, 0u);
}

TEST(SystemRun, FirstScanRelays) {
  Plant p;
  ASSERT_TRUE(p.sys.begin_scan(0));
  EXPECT_EQ(p.sm(402), on);
  EXPECT_EQ(p.sm(403), off);
  p.sys.end_scan();
  ASSERT_TRUE(p.sys.begin_scan(10000));
  EXPECT_EQ(p.sm(402), off);
  EXPECT_EQ(p.sm(403), on);
}

TEST(SystemRun, ConstantRelaysCannotBeKeptFromTheirState) {
  Plant p;
  p.scan();
  p.sys.SM[400] = off;
  p.sys.SM[401] = on;
  p.scan();
  EXPECT_EQ(p.sm(400), on);
  EXPECT_EQ(p.sm(401), off);
}

TEST(SystemRun, StopHoldsTheProgramAndRunStartsItAgain) {
  Plant p;
  p.scans(5);
  EXPECT_EQ(p.sd(420), 5);
  EXPECT_EQ(p.sys.status().scans, 5u);
  p.sys.set_mode(Mode::Stop);
  EXPECT_EQ(p.sm(203), on);
  EXPECT_FALSE(p.scan());
  EXPECT_EQ(p.sd(420), 5);
  EXPECT_EQ(p.sys.status().mode, Mode::Stop);
  EXPECT_FALSE(p.sys.status().running);
  p.sys.SM[1000] = on;
  p.sys.set_mode(Mode::Run);
  EXPECT_EQ(p.sm(203), off);
  EXPECT_EQ(p.sm(402), on);
  EXPECT_EQ(p.sm(403), off);
  EXPECT_EQ(p.sd(420), 0);
  EXPECT_EQ(p.sm(1000), on) << "devices survive the switch";
  EXPECT_TRUE(p.scan());
  EXPECT_EQ(p.sm(402), off);
}

TEST(SystemRun, RunInRunChangesNothing) {
  Plant p;
  p.scans(2);
  p.sys.set_mode(Mode::Run);
  EXPECT_EQ(p.sm(402), off);
  EXPECT_EQ(p.sd(420), 2);
}

TEST(SystemRun, ScanCounterWrapsToNegative) {
  Plant p;
  p.sys.SD[420] = 32767;
  p.scan();
  EXPECT_EQ(p.sd(420), -32768);
  p.sys.SD[420] = -1;
  p.scan();
  EXPECT_EQ(p.sd(420), 0);
}

TEST(SystemRun, LargerAndSmallerSpecialAreas) {
  melsec_qs::System<2000, 5120> large;
  large.power_on(plant::kParameters);
  large.SM[1999] = on;
  large.SD[5119] = 3;
  ASSERT_TRUE(large.begin_scan(0));
  large.end_scan();
  EXPECT_EQ(large.SD[5119], 3);
  melsec_qs::System<723, 528> small;
  small.power_on(plant::kParameters);
  ASSERT_TRUE(small.begin_scan(0));
  small.end_scan();
  EXPECT_EQ(small.SD[420], 1);
}

TEST(SystemRun, TwoSystemsShareNothing) {
  Plant a, b;
  a.scans(3);
  a.sys.operation_error(4100, 1);
  EXPECT_EQ(b.sd(420), 0);
  EXPECT_TRUE(b.sys.running());
}
