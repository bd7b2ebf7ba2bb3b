// Counters of the TP03: 16 bits upwards, 32 bits in both directions.
#include "tp03_plant.h"

#include <gtest/gtest.h>

#include <limits>

using namespace ladder;
using tp03::Counter;
using tp03::LongCounter;
using tp03_plant::Plant;

namespace {

struct NoSystem {};

void pulse(Counter &c, word set) {
  c.count_up(off, set, NoSystem{});
  c.count_up(on, set, NoSystem{});
}

constexpr dword kLeast = std::numeric_limits<dword>::min(), kMost = std::numeric_limits<dword>::max();

}  // namespace

TEST(Tp03Counter, StandsAtTheSetValue) {
  Counter c;
  pulse(c, 2);
  EXPECT_EQ(c.value, 1);
  EXPECT_EQ(c.contact, off);
  pulse(c, 2);
  EXPECT_EQ(c.value, 2);
  EXPECT_EQ(c.contact, on);
  pulse(c, 2);
  EXPECT_EQ(c.value, 2);
}

TEST(Tp03Counter, ZeroActsAsOne) {
  for (const word set : {word{0}, word{1}, word{-7}, word{-32768}}) {
    Counter c;
    c.count_up(off, set, NoSystem{});
    EXPECT_EQ(c.contact, off);
    c.count_up(on, set, NoSystem{});
    EXPECT_EQ(c.contact, on) << set;
    EXPECT_EQ(c.value, 1) << set;
  }
}

TEST(Tp03Counter, ValueAboveTheSetValueBecomesIt) {
  Counter c;
  c.value = 50;
  c.count_up(off, 10, NoSystem{});
  EXPECT_EQ(c.contact, off);
  EXPECT_EQ(c.value, 50);
  c.count_up(on, 10, NoSystem{});
  EXPECT_EQ(c.contact, on);
  EXPECT_EQ(c.value, 10);
}

TEST(Tp03Counter, LargestSetValue) {
  Counter c;
  c.value = 32765;
  pulse(c, 32767);
  EXPECT_EQ(c.contact, off);
  pulse(c, 32767);
  EXPECT_EQ(c.contact, on);
  pulse(c, 32767);
  EXPECT_EQ(c.value, 32767);
}

TEST(Tp03Counter, ResetHoldsAsLongAsItIsDriven) {
  Counter c;
  pulse(c, 1);
  c.drive_reset(on, NoSystem{});
  EXPECT_EQ(c.value, 0);
  EXPECT_EQ(c.contact, off);
  pulse(c, 1);
  EXPECT_EQ(c.value, 0);
  EXPECT_EQ(c.contact, off);
  c.drive_reset(off, NoSystem{});
  pulse(c, 1);
  EXPECT_EQ(c.contact, on);
}

TEST(Tp03LongCounter, ContactFollowsTheDirection) {
  Plant p;
  LongCounter &c = p.C32[200];
  c.value = -7;
  auto count = [&] { p.sys.count(c, 200, on, -5); };
  count();
  EXPECT_EQ(c.value, -6);
  EXPECT_EQ(c.contact, off);
  count();
  EXPECT_EQ(c.contact, on) << "-6 to -5";
  count();
  EXPECT_EQ(c.value, -4);
  EXPECT_EQ(c.contact, on);
  p.sys.M[8200] = on;
  count();
  EXPECT_EQ(c.value, -5);
  EXPECT_EQ(c.contact, on);
  count();
  EXPECT_EQ(c.value, -6);
  EXPECT_EQ(c.contact, off) << "-5 to -6";
  p.sys.count(c, 200, off, -5);
  EXPECT_EQ(c.value, -6);
}

TEST(Tp03LongCounter, DirectionRelayOfEachNumber) {
  Plant p;
  p.sys.M[8234] = on;
  p.sys.count(p.C32[233], 233, on, 10);
  p.sys.count(p.C32[234], 234, on, 10);
  EXPECT_EQ(p.C32[233].value, 1);
  EXPECT_EQ(p.C32[234].value, -1);
}

TEST(Tp03LongCounter, TheValueIsARing) {
  Plant p;
  LongCounter &c = p.C32[220];
  c.value = kMost;
  p.sys.count(c, 220, on, 10);
  EXPECT_EQ(c.value, kLeast);
  p.sys.M[8220] = on;
  p.sys.count(c, 220, on, 10);
  EXPECT_EQ(c.value, kMost);
  EXPECT_EQ(c.contact, off);
}

TEST(Tp03LongCounter, WrittenAboveTheSetValueGoesOn) {
  Plant p;
  LongCounter &c = p.C32[200];
  c.value = 100;
  p.sys.count(c, 200, on, 10);
  EXPECT_EQ(c.value, 101);
  EXPECT_EQ(c.contact, off);
  c.drive_reset(on, p.sys);
  p.sys.count(c, 200, on, 10);
  EXPECT_EQ(c.value, 0);
}
