// The system side of the TP03: RUN and STOP, clocks, errors, what END shows.
#include "tp03_plant.h"

#include <gtest/gtest.h>

#include <type_traits>

using namespace ladder;
using tp03::Fault;
using tp03_plant::Plant;

static_assert(std::is_trivially_destructible<tp03::System>::value, "firmware has no exit");

namespace {

void expect_calendar(const Plant &p, const word (&fields)[7]) {
  for (unsigned i = 0; i < 7; ++i)
    EXPECT_EQ(p.d(8013 + i), fields[i]) << "D" << 8013 + i;
}

}  // namespace

TEST(Tp03System, StartsInRun) {
  Plant p;
  EXPECT_TRUE(p.sys.running());
  EXPECT_EQ(p.d(8000), 200);
  EXPECT_EQ(p.d(8177), 7);
  EXPECT_EQ(p.d(8377), 4);
  EXPECT_EQ(p.d(8124), 2);
  EXPECT_EQ(p.d(8325), 3);
  EXPECT_EQ(p.m(8004), off);
}

TEST(Tp03System, FirstScan) {
  Plant p;
  for (int round = 0; round < 2; ++round) {
    bool executed = false;
    p.scan([&] {
      executed = true;
      EXPECT_EQ(p.m(8000), on);
      EXPECT_EQ(p.m(8001), off);
      EXPECT_EQ(p.m(8002), on);
      EXPECT_EQ(p.m(8003), off);
      EXPECT_EQ(p.sys.elapsed_us(), 0u);
    });
    EXPECT_TRUE(executed);
    p.scan([&] {
      EXPECT_EQ(p.m(8000), on);
      EXPECT_EQ(p.m(8001), off);
      EXPECT_EQ(p.m(8002), off);
      EXPECT_EQ(p.m(8003), on);
      EXPECT_EQ(p.sys.elapsed_us(), 10000u);
    });
    p.sys.set_mode(Mode::Stop);
    EXPECT_FALSE(p.idle(3));
    EXPECT_EQ(p.m(8000), off);
    EXPECT_EQ(p.m(8001), on);
    EXPECT_EQ(p.m(8002), off);
    EXPECT_EQ(p.m(8003), on);
    p.sys.set_mode(Mode::Run);
  }
}

TEST(Tp03System, PFormsDoNotActInTheFirstScan) {
  Plant p;
  bit memory{};
  p.scan([&] { EXPECT_EQ(p.sys.pulse(memory, on), off); });
  p.scan([&] { EXPECT_EQ(p.sys.pulse(memory, on), off); });
  p.scan([&] { EXPECT_EQ(p.sys.pulse(memory, off), off); });
  p.scan([&] { EXPECT_EQ(p.sys.pulse(memory, on), on); });
}

TEST(Tp03System, SpecialDevicesSurviveStop) {
  Plant p;
  p.idle(2);
  p.sys.D[8000] = 300;
  p.sys.M[8200] = on;
  p.sys.check(Fault::Range, 5);
  p.sys.set_mode(Mode::Stop);
  EXPECT_EQ(p.d(8067), 6706);
  p.sys.set_mode(Mode::Run);
  EXPECT_EQ(p.d(8067), 0);
  EXPECT_EQ(p.m(8067), off);
  EXPECT_EQ(p.d(8000), 300);
  EXPECT_EQ(p.m(8200), on);
  p.sys.power_on({{0, 0, 0}});
  EXPECT_EQ(p.d(8000), 200);
  EXPECT_EQ(p.m(8200), off);
}

TEST(Tp03System, StatusCountsScans) {
  Plant p;
  p.idle(5);
  EXPECT_EQ(p.sys.status().scans, 5u);
  EXPECT_EQ(p.sys.status().error, 0);
  p.sys.set_mode(Mode::Stop);
  EXPECT_EQ(p.sys.status().mode, Mode::Stop);
  EXPECT_FALSE(p.sys.status().running);
}

TEST(Tp03System, ClockRelaysHalfAndHalfInStopToo) {
  Plant p;
  for (Micros t = 0; t < 130000000; t += 2500) {
    if (t == 65000000)
      p.sys.set_mode(Mode::Stop);
    p.idle(1, 2500);
    ASSERT_EQ(p.m(8011), bit(t % 10000 >= 5000)) << t;
    ASSERT_EQ(p.m(8012), bit(t % 100000 >= 50000)) << t;
    ASSERT_EQ(p.m(8013), bit(t % 1000000 >= 500000)) << t;
    ASSERT_EQ(p.m(8014), bit(t % 60000000 >= 30000000)) << t;
  }
}

TEST(Tp03System, TheHostsClockMayWrap) {
  Plant p;
  p.now = 0xFFFFFFFFU - 4999;
  p.idle(2);
  EXPECT_EQ(p.sys.elapsed_us(), 10000u);
  EXPECT_EQ(p.d(8010), 100);
  EXPECT_EQ(p.sys.now_us(), 10000u);
}

TEST(Tp03System, ScanTimesInTenthsOfMilliseconds) {
  Plant p;
  p.idle(1, 23678);
  EXPECT_EQ(p.d(8010), 0);
  p.idle(1, 5000);
  EXPECT_EQ(p.d(8010), 236);
  p.idle(1, 40000);
  p.idle();
  EXPECT_EQ(p.d(8010), 400);
  EXPECT_EQ(p.d(8011), 50);
  EXPECT_EQ(p.d(8012), 400);
  p.now += 4000000000U;
  p.idle();
  EXPECT_EQ(p.d(8012), 32767);
  p.sys.set_mode(Mode::Stop);
  p.sys.set_mode(Mode::Run);
  p.idle(2, 7000);
  EXPECT_EQ(p.d(8011), 70);
  EXPECT_EQ(p.d(8012), 70);
}

TEST(Tp03System, CalendarRuns) {
  Plant p;
  EXPECT_TRUE(p.sys.set_calendar({2024, 2, 28, 23, 59, 58, 0}));
  p.idle();
  expect_calendar(p, {58, 59, 23, 28, 2, 2024, 3});
  p.now += 2000000;
  p.idle();
  expect_calendar(p, {0, 0, 0, 29, 2, 2024, 4});
  p.sys.set_mode(Mode::Stop);
  p.now += 3600U * 1000000U;
  p.idle();
  expect_calendar(p, {0, 0, 1, 29, 2, 2024, 4});
  p.sys.power_on({{0, 0, 0}});
  EXPECT_EQ(p.d(8018), 2024) << "as if from a battery";
}

TEST(Tp03System, CalendarFrom2000To2099) {
  Plant p;
  EXPECT_FALSE(p.sys.set_calendar({1999, 12, 31, 0, 0, 0, 0}));
  EXPECT_FALSE(p.sys.set_calendar({2100, 1, 1, 0, 0, 0, 0}));
  EXPECT_FALSE(p.sys.set_calendar({2023, 2, 29, 0, 0, 0, 0}));
  EXPECT_FALSE(p.sys.set_calendar({2098, 2, 29, 0, 0, 0, 0}));
  EXPECT_FALSE(p.sys.set_calendar({2024, 1, 1, 24, 0, 0, 0}));
  p.idle();
  expect_calendar(p, {0, 0, 0, 1, 1, 2000, 6});
  const std::uint16_t years[][2] = {{2079, 2080}, {2080, 2081}, {2098, 2099}, {2099, 2000}};
  const word weekdays[] = {1, 3, 4, 6};
  for (unsigned i = 0; i < 4; ++i) {
    EXPECT_TRUE(p.sys.set_calendar({years[i][0], 12, 31, 23, 59, 59, 0}));
    p.now += 990000;
    p.idle();
    expect_calendar(p, {0, 0, 0, 1, 1, static_cast<word>(years[i][1]), weekdays[i]});
  }
  EXPECT_TRUE(p.sys.set_calendar({2096, 2, 29, 12, 0, 0, 0}));
}

TEST(Tp03System, ClockRegistersCannotBeWritten) {
  Plant p;
  p.sys.set_calendar({2024, 5, 6, 7, 8, 9, 0});
  p.scan([&] { p.sys.D[8015] = 20; });
  EXPECT_EQ(p.d(8015), 7);
  p.sys.D[8015] = 20;
  p.idle();
  EXPECT_EQ(p.d(8015), 7);
}

TEST(Tp03System, SettingTheClockWithM8015) {
  Plant p;
  p.sys.set_calendar({2024, 5, 6, 7, 8, 9, 0});
  p.scan([&] {
    p.sys.M[8015] = on;
    p.sys.D[8013] = 30;
    p.sys.D[8019] = 5;
  });
  p.idle(10, 1000000);
  EXPECT_EQ(p.d(8013), 30);
  EXPECT_EQ(p.d(8014), 8) << "the clock stands";
  p.sys.D[8018] = 2030;
  p.scan([&] { p.sys.M[8015] = off; }, 1000000);
  expect_calendar(p, {30, 8, 7, 6, 5, 2030, 1});
  p.idle(2, 1000000);
  EXPECT_EQ(p.d(8013), 32);
}

TEST(Tp03System, AnImpossibleDateIsNotTaken) {
  const word wrong[][2] = {{8016, 31}, {8016, 0},  {8017, 13},   {8017, 2 + 256}, {8013, 60},
                           {8014, -1}, {8015, 24}, {8018, 1999}, {8018, 2100},    {8018, -1}};
  for (const auto &[number, value] : wrong) {
    Plant p;
    p.sys.set_calendar({2024, 6, 6, 7, 8, 9, 0});
    p.sys.M[8015] = on;
    p.idle();
    p.sys.D[static_cast<unsigned>(number)] = value;
    p.sys.M[8015] = off;
    p.idle();
    expect_calendar(p, {9, 8, 7, 6, 6, 2024, 4});
  }
}

TEST(Tp03System, OperationErrorOfAPlace) {
  Plant p;
  p.idle();
  p.sys.check(Fault::Range, 10);
  EXPECT_EQ(p.m(8067), on);
  EXPECT_EQ(p.m(8004), on);
  EXPECT_EQ(p.d(8067), 6706);
  EXPECT_EQ(p.sys.status().error, 6706);
  EXPECT_EQ(p.sys.status().step, 10u);
  EXPECT_TRUE(p.sys.running());
  p.sys.check(Fault::None, 20);
  EXPECT_EQ(p.m(8067), on) << "another place";
  p.sys.check(Fault::Operand, 20);
  EXPECT_EQ(p.d(8067), 6705);
  p.sys.check(Fault::None, 10);
  EXPECT_EQ(p.m(8067), on);
  p.sys.check(Fault::None, 20);
  EXPECT_EQ(p.m(8067), off);
  EXPECT_EQ(p.m(8004), off);
  EXPECT_EQ(p.d(8067), 6705) << "stays";
}

TEST(Tp03System, IndexOutOfRange) {
  Plant p;
  EXPECT_TRUE(p.sys.in_range(true, 3));
  EXPECT_FALSE(p.sys.in_range(false, 3, off));
  EXPECT_EQ(p.m(8067), off) << "not executed";
  EXPECT_FALSE(p.sys.in_range(false, 3));
  EXPECT_EQ(p.d(8067), 6706);
  EXPECT_TRUE(p.sys.in_range(true, 3, off));
  EXPECT_EQ(p.m(8067), on);
  EXPECT_TRUE(p.sys.in_range(true, 3));
  EXPECT_EQ(p.m(8067), off);
}

TEST(Tp03System, ErrorsOfTheHostShowInM8004) {
  Plant p;
  p.idle();
  p.sys.M[8063] = on;
  p.idle();
  EXPECT_EQ(p.m(8004), on);
  p.sys.M[8063] = off;
  p.idle();
  EXPECT_EQ(p.m(8004), off);
}

TEST(Tp03System, WatchdogStopsUntilPowerComesOn) {
  Plant p;
  p.idle(2);
  EXPECT_TRUE(p.sys.outputs_enabled());
  p.sys.watchdog_error();
  EXPECT_FALSE(p.sys.running());
  EXPECT_FALSE(p.sys.outputs_enabled());
  EXPECT_EQ(p.m(8061), on);
  EXPECT_EQ(p.d(8061), 6105);
  EXPECT_EQ(p.m(8000), off);
  EXPECT_EQ(p.m(8004), on);
  p.sys.set_mode(Mode::Stop);
  p.sys.set_mode(Mode::Run);
  EXPECT_FALSE(p.idle());
  EXPECT_EQ(p.sys.status().error, 6105);
  p.sys.power_on({{0, 0, 0}});
  EXPECT_TRUE(p.idle());
  EXPECT_EQ(p.m(8061), off);
}

TEST(Tp03System, OutputsDisabledByM8034) {
  Plant p;
  p.sys.M[8034] = on;
  EXPECT_FALSE(p.sys.outputs_enabled());
}

TEST(Tp03System, EndlessJumpsBackStopTheScan) {
  Plant p;
  for (int scan = 0; scan < 3; ++scan)
    p.scan([&] {
      for (int i = 0; i < 50000; ++i)
        ASSERT_TRUE(p.sys.may_jump_back());
    });
  long jumps = 0;
  ASSERT_TRUE(p.sys.begin_scan(p.now));
  while (p.sys.may_jump_back())
    ++jumps;
  EXPECT_LE(jumps, 1000000);
  p.sys.end_scan();
  EXPECT_FALSE(p.sys.running());
  EXPECT_EQ(p.m(8000), off);
  EXPECT_EQ(p.d(8061), 6105);
}

TEST(Tp03System, LoopsPassOnceAtLeast) {
  EXPECT_EQ(tp03::System::passes(3), 3);
  EXPECT_EQ(tp03::System::passes(0), 1);
  EXPECT_EQ(tp03::System::passes(-32768), 1);
  EXPECT_EQ(tp03::System::passes(32767), 32767);
}

TEST(Tp03System, TransfersAreInhibitedByM8040) {
  Plant p;
  EXPECT_EQ(p.sys.transfer(on), on);
  p.sys.M[8040] = on;
  EXPECT_EQ(p.sys.transfer(on), off);
}

TEST(Tp03System, ActiveStatesAreShown) {
  Plant p;
  for (const unsigned state : {7U, 20U, 35U, 899U, 900U})
    p.S[state] = on;
  p.idle();
  EXPECT_EQ(p.m(8046), off);
  EXPECT_EQ(p.d(8040), 0);
  p.sys.M[8047] = on;
  p.idle();
  EXPECT_EQ(p.m(8046), on);
  EXPECT_EQ(p.d(8040), 7);
  EXPECT_EQ(p.d(8041), 20);
  EXPECT_EQ(p.d(8042), 35);
  EXPECT_EQ(p.d(8043), 899);
  EXPECT_EQ(p.d(8044), 0);
  for (unsigned state = 100; state < 110; ++state)
    p.S[state] = on;
  p.S[7] = off;
  p.idle();
  EXPECT_EQ(p.d(8040), 20);
  EXPECT_EQ(p.d(8047), 105);
  p.S.clear(0, 899);
  p.idle();
  EXPECT_EQ(p.m(8046), off);
  EXPECT_EQ(p.d(8040), 0);
}

TEST(Tp03System, LowestAnnunciatorIsShown) {
  Plant p;
  p.S[905] = on;
  p.S[899] = on;
  p.S[1000] = on;
  p.idle();
  EXPECT_EQ(p.m(8048), off);
  p.sys.M[8049] = on;
  p.idle();
  EXPECT_EQ(p.m(8048), on);
  EXPECT_EQ(p.d(8049), 905);
  p.S[901] = on;
  p.S[999] = on;
  p.idle();
  EXPECT_EQ(p.d(8049), 901);
  p.S.clear(900, 998);
  p.idle();
  EXPECT_EQ(p.d(8049), 999);
  p.S[999] = off;
  p.idle();
  EXPECT_EQ(p.m(8048), off);
  EXPECT_EQ(p.d(8049), 0);
}

TEST(Tp03System, SmallImagesOfStatesAreEnough) {
  tp03::System sys;
  sys.power_on({{0, 0, 0}});
  sys.M[8047] = on;
  sys.M[8049] = on;
  Bits<21> few;
  few[20] = on;
  sys.show_states(few);
  EXPECT_EQ(sys.D[8040], 20);
  EXPECT_EQ(bit(sys.M[8048]), off);
}

TEST(Tp03System, NothingIsConnectedAtFirst) {
  Plant p;
  EXPECT_EQ(p.sys.io().read_serial(0), -1);
  EXPECT_EQ(p.sys.io().input(0), -1);
  EXPECT_EQ(p.sys.io().potentiometer(0), 0);
}

TEST(Tp03System, MemorySwitches) {
  Plant p;
  EXPECT_FALSE(p.sys.clears_unlatched() || p.sys.clears_latched() || p.sys.holds_memory());
  p.sys.M[8031] = on;
  EXPECT_TRUE(p.sys.clears_unlatched());
  p.sys.M[8032] = on;
  EXPECT_TRUE(p.sys.clears_latched());
  p.sys.M[8033] = on;
  EXPECT_TRUE(p.sys.holds_memory());
}

TEST(Tp03System, IndexedLabelsMustExist) {
  Plant p;
  p.sys.no_such_label(7);
  EXPECT_EQ(p.d(8067), 6706);
  EXPECT_EQ(p.sys.status().step, 7u);
}
