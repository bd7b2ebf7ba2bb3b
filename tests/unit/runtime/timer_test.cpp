// Timers: each rule of their execution.
#include "ladder/timer.h"
#include "printing.h"

#include <gtest/gtest.h>

using namespace ladder;

namespace {

struct Ticks {
  word low, high;
  word low_ticks() const { return low; }
  word high_ticks() const { return high; }
};

constexpr Ticks kOne{1, 10};

}  // namespace

TEST(Timer, ClosesAtTheSetValueAndStandsStill) {
  Timers<2> T;
  for (int i = 1; i < 5; ++i) {
    T[1].on_delay_low(on, 5, kOne);
    EXPECT_EQ(T[1].value, i);
    EXPECT_EQ(T[1].contact, off);
    EXPECT_EQ(T[1].coil, on);
  }
  T[1].on_delay_low(on, 5, kOne);
  EXPECT_EQ(T[1].contact, on);
  EXPECT_EQ(T[1].value, 5);
  T[1].on_delay_low(on, 5, kOne);
  EXPECT_EQ(T[1].value, 5);
}

TEST(Timer, HighSpeedTakesHighSpeedTicks) {
  Timer t;
  t.on_delay_high(on, 25, kOne);
  EXPECT_EQ(t.value, 10);
  t.on_delay_high(on, 25, kOne);
  t.on_delay_high(on, 25, kOne);
  EXPECT_EQ(t.value, 25) << "held at the set value, not at the sum of the ticks";
  EXPECT_EQ(t.contact, on);
}

TEST(Timer, FirstExecutionAddsAlready) {
  Timer t;
  t.on_delay_low(off, 1, kOne);
  t.on_delay_low(on, 1, kOne);
  EXPECT_EQ(t.contact, on);
}

TEST(Timer, EveryExecutionOfAScanAdds) {
  Timer t;
  t.on_delay_low(on, 100, kOne);
  t.on_delay_low(on, 100, kOne);
  EXPECT_EQ(t.value, 2);
}

TEST(Timer, OffClearsEverything) {
  Timer t;
  t.on_delay_low(on, 1, kOne);
  t.on_delay_low(off, 1, kOne);
  EXPECT_EQ(t.value, 0);
  EXPECT_EQ(t.contact, off);
  EXPECT_EQ(t.coil, off);
}

TEST(Timer, NothingMovesWithoutTicks) {
  Timer t;
  t.on_delay_low(on, 1, Ticks{0, 0});
  EXPECT_EQ(t.value, 0);
  EXPECT_EQ(t.contact, off);
}

TEST(Timer, SetValueZeroClosesAtOnce) {
  Timer t;
  t.on_delay_low(on, 0, Ticks{0, 0});
  EXPECT_EQ(t.contact, on);
  EXPECT_EQ(t.value, 0);
}

TEST(Timer, NegativeSetValueActsAsZero) {
  Timer t;
  t.on_delay_low(on, -5, kOne);
  EXPECT_EQ(t.contact, on);
  EXPECT_EQ(t.value, 0);
}

TEST(Timer, RaisedSetValueDoesNotOpenTheContact) {
  Timer t;
  t.on_delay_low(on, 1, kOne);
  t.on_delay_low(on, 100, kOne);
  EXPECT_EQ(t.contact, on);
  EXPECT_EQ(t.value, 1);
}

TEST(Timer, LoweredSetValueCloses) {
  Timer t;
  t.on_delay_high(on, 100, kOne);
  t.on_delay_high(on, 100, kOne);
  t.on_delay_high(on, 5, kOne);
  EXPECT_EQ(t.contact, on);
  EXPECT_EQ(t.value, 5);
}

TEST(Timer, DoesNotOverflow) {
  Timer t;
  t.on_delay_low(on, 32767, Ticks{32767, 0});
  EXPECT_EQ(t.value, 32767);
  EXPECT_EQ(t.contact, on);
  t.reset();
  t.value = 32760;
  t.on_delay_low(on, 32767, Ticks{32767, 0});
  EXPECT_EQ(t.value, 32767);
  EXPECT_EQ(t.contact, on);
}

TEST(RetentiveTimer, AccumulatesOverOff) {
  Timer t;
  t.retentive_low(on, 3, kOne);
  t.retentive_low(on, 3, kOne);
  t.retentive_low(off, 3, kOne);
  EXPECT_EQ(t.value, 2);
  EXPECT_EQ(t.coil, off);
  EXPECT_EQ(t.contact, off);
  t.retentive_low(on, 3, kOne);
  EXPECT_EQ(t.contact, on);
  t.retentive_low(off, 3, kOne);
  EXPECT_EQ(t.contact, on);
  EXPECT_EQ(t.value, 3);
  t.reset();
  EXPECT_EQ(t.value, 0);
  EXPECT_EQ(t.contact, off);
  EXPECT_EQ(t.coil, off);
}

TEST(RetentiveTimer, HighSpeedTakesHighSpeedTicks) {
  Timer t;
  t.retentive_high(on, 300, kOne);
  EXPECT_EQ(t.value, 10);
}

TEST(RetentiveTimer, CountsOnAfterResetWithConditionOn) {
  Timer t;
  t.retentive_low(on, 3, kOne);
  t.reset();
  t.retentive_low(on, 3, kOne);
  EXPECT_EQ(t.value, 1);
}

TEST(Timers, ChainInFiringOrderClosesInOneScan) {
  Timers<3> T;
  T[0].on_delay_low(on, 1, kOne);
  T[1].on_delay_low(T[0].contact, 1, kOne);
  T[2].on_delay_low(T[1].contact, 1, kOne);
  EXPECT_EQ(T[2].contact, on);
}
