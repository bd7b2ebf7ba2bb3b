// Timers of the TP03: where they advance, where they switch, which keep time by themselves.
#include "tp03_plant.h"

#include <gtest/gtest.h>

using namespace ladder;
using tp03::Timer;
using tp03_plant::Plant;

TEST(Tp03Timer, CountsFromTheExecutionThatFindsTheCoilNewlyOn) {
  Plant p;
  bit coil{};
  auto program = [&] { p.T[200].on_delay_10ms(coil, 3, p.sys); };
  p.scan(program);
  coil = on;
  p.scan(program);
  EXPECT_EQ(p.T[200].value, 0);
  EXPECT_EQ(p.T[200].coil, on);
  p.scan(program);
  EXPECT_EQ(p.T[200].value, 1);
  p.scan(program);
  EXPECT_EQ(p.T[200].contact, off);
  p.scan(program);
  EXPECT_EQ(p.T[200].value, 3);
  EXPECT_EQ(p.T[200].contact, on);
  p.scan(program);
  EXPECT_EQ(p.T[200].value, 3) << "the value stands at the set value";
  coil = off;
  p.scan(program);
  EXPECT_EQ(p.T[200].value, 0);
  EXPECT_EQ(p.T[200].contact, off);
  EXPECT_EQ(p.T[200].coil, off);
}

TEST(Tp03Timer, ExactAtAnyScanTime) {
  for (const Micros scan_us : {700U, 1000U, 3333U, 10000U, 33000U, 250000U}) {
    Plant p;
    auto program = [&] {
      p.T[0].on_delay_100ms(on, 20, p.sys);
      p.T[200].on_delay_10ms(on, 123, p.sys);
      p.T[256].on_delay_1ms(on, 1500, p.sys);
    };
    for (Micros t = 0; t < 3000000; t += scan_us) {
      p.scan(program, scan_us);
      ASSERT_EQ(p.T[0].contact, bit(t >= 2000000)) << scan_us << ' ' << t;
      ASSERT_EQ(p.T[200].contact, bit(t >= 1230000)) << scan_us << ' ' << t;
      ASSERT_EQ(p.T[256].contact, bit(t >= 1500000)) << scan_us << ' ' << t;
      ASSERT_EQ(p.T[200].value, static_cast<word>(t < 1230000 ? t / 10000 : 123)) << scan_us << ' ' << t;
    }
  }
}

TEST(Tp03Timer, SetValueOfZeroSwitchesInTheNextScan) {
  for (const word set : {word{0}, word{-5}, word{-32768}}) {
    Plant p;
    auto program = [&] {
      p.T[0].on_delay_100ms(on, set, p.sys);
      p.T[246].accumulate_1ms(on, set, p.sys);
      p.T[250].accumulate_100ms(on, set, p.sys);
    };
    p.scan(program);
    EXPECT_EQ(p.T[0].contact | p.T[246].contact | p.T[250].contact, off) << set;
    p.scan(program);
    EXPECT_EQ(p.T[0].contact & p.T[246].contact & p.T[250].contact, on) << set;
    EXPECT_EQ(p.T[0].value, 0);
  }
}

TEST(Tp03Timer, SecondExecutionInAScanDoesNotAdvance) {
  Plant p;
  auto twice = [&] {
    for (int i = 0; i < 2; ++i) {
      p.T[200].on_delay_10ms(on, 5, p.sys);
      p.T[201].on_delay_10ms(on, 0, p.sys);
      p.T[246].accumulate_1ms(on, 0, p.sys);
    }
  };
  p.scan(twice);
  EXPECT_EQ(p.T[201].contact | p.T[246].contact, off);
  p.scan(twice);
  EXPECT_EQ(p.T[200].value, 1);
  EXPECT_EQ(p.T[201].contact & p.T[246].contact, on);
  for (int i = 0; i < 3; ++i)
    p.scan(twice);
  EXPECT_EQ(p.T[200].contact, off);
  p.scan(twice);
  EXPECT_EQ(p.T[200].contact, on);
}

TEST(Tp03Timer, SkippedTimersStandStill) {
  Plant p;
  auto program = [&] { p.T[200].on_delay_10ms(on, 5, p.sys); };
  p.scan(program);
  p.scan(program);
  p.scan(program);
  EXPECT_EQ(p.T[200].value, 2);
  p.idle(100);
  EXPECT_EQ(p.T[200].value, 2);
  p.scan(program);
  EXPECT_EQ(p.T[200].value, 2) << "the time in which it was skipped does not count";
  p.scan(program);
  p.scan(program);
  EXPECT_EQ(p.T[200].value, 4);
  EXPECT_EQ(p.T[200].contact, off);
  p.scan(program);
  EXPECT_EQ(p.T[200].contact, on);
}

TEST(Tp03Timer, AccumulatesOverPauses) {
  Plant p;
  bit coil = on;
  auto program = [&] { p.T[250].accumulate_100ms(coil, 3, p.sys); };
  for (int i = 0; i < 3; ++i)
    p.scan(program, 100000);
  EXPECT_EQ(p.T[250].value, 2);
  coil = off;
  for (int i = 0; i < 10; ++i)
    p.scan(program, 100000);
  EXPECT_EQ(p.T[250].value, 2);
  coil = on;
  p.scan(program, 100000);
  EXPECT_EQ(p.T[250].contact, off);
  p.scan(program, 100000);
  EXPECT_EQ(p.T[250].contact, on);
  coil = off;
  p.scan(program, 100000);
  EXPECT_EQ(p.T[250].contact, on) << "only RST clears it";
  p.T[250].reset();
  EXPECT_EQ(p.T[250].contact, off);
  EXPECT_EQ(p.T[250].value, 0);
}

TEST(Tp03Timer, ResetWithTheCoilOnStartsAnew) {
  Plant p;
  auto program = [&] { p.T[250].accumulate_100ms(on, 3, p.sys); };
  for (int i = 0; i < 3; ++i)
    p.scan(program, 150000);
  p.T[250].reset();
  p.scan(program, 100000);
  EXPECT_EQ(p.T[250].value, 0);
  p.scan(program, 100000);
  EXPECT_EQ(p.T[250].value, 1);
}

TEST(Tp03Timer, OneMillisecondTimersCountInTheBackground) {
  Plant p;
  auto program = [&] { p.T[246].accumulate_1ms(on, 25, p.sys); };
  p.scan(program);
  p.idle(5);
  EXPECT_EQ(p.T[246].value, 25) << "the value stands at the set value";
  EXPECT_EQ(p.T[246].contact, off) << "switches where the coil is executed";
  p.scan(program);
  EXPECT_EQ(p.T[246].contact, on);
  Plant q;
  q.T[247].accumulate_1ms(on, 25, q.sys);
  q.T[247].accumulate_1ms(off, 25, q.sys);
  q.idle(5);
  EXPECT_EQ(q.T[247].value, 0) << "coil OFF";
}

TEST(Tp03Timer, RoutineTimersGoOnAtEnd) {
  Plant p;
  auto program = [&] {
    for (const unsigned number : {0U, 192U, 199U})
      p.T[number].on_delay_100ms(on, 3, p.sys);
  };
  p.scan(program, 100000);
  EXPECT_EQ(p.T[192].value, 0);
  p.idle(1, 100000);
  EXPECT_EQ(p.T[192].value, 1);
  p.scan(program, 100000);
  EXPECT_EQ(p.T[192].value, 2) << "neither twice nor not at all";
  p.idle(1, 100000);
  EXPECT_EQ(p.T[192].contact & p.T[199].contact, on) << "switches at END";
  EXPECT_EQ(p.T[0].value, 0);
  p.scan([&] { p.T[192].on_delay_100ms(off, 3, p.sys); }, 100000);
  EXPECT_EQ(p.T[192].contact, off);
  p.idle(10, 100000);
  EXPECT_EQ(p.T[192].value, 0);
}

TEST(Tp03Timer, WhatTheProgramWritesCounts) {
  Plant p;
  word set = 100;
  auto program = [&] { p.T[200].on_delay_10ms(on, set, p.sys); };
  p.scan(program);
  p.T[200].value = 98;
  p.scan(program);
  EXPECT_EQ(p.T[200].value, 99);
  p.T[200].value = 500;
  p.scan(program, 1000);
  EXPECT_EQ(p.T[200].contact, on);
  EXPECT_EQ(p.T[200].value, 100) << "not beyond the set value";
  p.T[200].reset();
  p.scan(program);
  p.T[200].value = -3;
  p.scan(program);
  EXPECT_EQ(p.T[200].value, -2);
  EXPECT_EQ(p.T[200].contact, off);
}

TEST(Tp03Timer, LongestTimes) {
  Plant p;
  auto program = [&] {
    p.T[0].on_delay_100ms(on, 32767, p.sys);
    p.T[256].on_delay_1ms(on, 32767, p.sys);
  };
  p.scan(program);
  p.scan(program, 4000000000U);
  p.scan(program, 4294967295U);
  EXPECT_EQ(p.T[256].contact, on);
  EXPECT_EQ(p.T[0].value, 32767);
}

TEST(Tp03Timer, TimeInStopIsNobodys) {
  Plant p;
  auto program = [&] { p.T[250].accumulate_100ms(on, 100, p.sys); };
  p.scan(program, 100000);
  p.scan(program, 100000);
  p.sys.set_mode(Mode::Stop);
  p.idle(10, 1000000);
  p.sys.set_mode(Mode::Run);
  p.scan(program, 100000);
  EXPECT_EQ(p.T[250].value, 1);
  p.scan(program, 100000);
  EXPECT_EQ(p.T[250].value, 2);
}
