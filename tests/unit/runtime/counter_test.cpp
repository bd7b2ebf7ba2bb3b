// Counters: each rule of their execution.
#include "ladder/counter.h"
#include "printing.h"

#include <gtest/gtest.h>

using namespace ladder;

namespace {

struct NoClock {};

void pulse(Counter &c, word preset) {
  c.count_up(off, preset, NoClock{});
  c.count_up(on, preset, NoClock{});
}

}  // namespace

TEST(Counter, CountsRisingEdges) {
  Counters<1> C;
  C[0].count_up(on, 2, NoClock{});
  EXPECT_EQ(C[0].value, 1) << "ON at the first execution is an edge";
  EXPECT_EQ(C[0].coil, on);
  C[0].count_up(on, 2, NoClock{});
  EXPECT_EQ(C[0].value, 1);
  EXPECT_EQ(C[0].contact, off);
  pulse(C[0], 2);
  EXPECT_EQ(C[0].value, 2);
  EXPECT_EQ(C[0].contact, on);
}

TEST(Counter, OffKeepsValueAndContact) {
  Counter c;
  pulse(c, 1);
  c.count_up(off, 1);
  EXPECT_EQ(c.coil, off);
  EXPECT_EQ(c.value, 1);
  EXPECT_EQ(c.contact, on);
}

TEST(Counter, FreezesAfterCountUp) {
  Counter c;
  pulse(c, 1);
  pulse(c, 5);
  EXPECT_EQ(c.value, 1);
  EXPECT_EQ(c.contact, on);
}

TEST(Counter, SetValueZeroAndBelowActAsOne) {
  for (const word preset : {word{0}, word{-7}}) {
    Counter c;
    c.count_up(off, preset);
    EXPECT_EQ(c.contact, off);
    c.count_up(on, preset);
    EXPECT_EQ(c.contact, on);
    EXPECT_EQ(c.value, 1);
  }
}

TEST(Counter, ResetWithConditionOnCountsAgain) {
  Counter c;
  pulse(c, 3);
  c.reset();
  EXPECT_EQ(c.value, 0);
  EXPECT_EQ(c.coil, off);
  EXPECT_EQ(c.contact, off);
  c.count_up(on, 3);
  EXPECT_EQ(c.value, 1);
}

TEST(Counter, LoweredSetValueClosesAtTheNextEdge) {
  Counter c;
  pulse(c, 10);
  pulse(c, 10);
  c.count_up(on, 1);
  EXPECT_EQ(c.contact, off);
  pulse(c, 1);
  EXPECT_EQ(c.contact, on);
}

TEST(Counter, DoesNotOverflow) {
  Counter c;
  c.value = 32767;
  pulse(c, 32767);
  EXPECT_EQ(c.value, 32767);
  EXPECT_EQ(c.contact, on);
}
