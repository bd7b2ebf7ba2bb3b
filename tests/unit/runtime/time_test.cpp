// What becomes of elapsed time.
#include "ladder/melsec_qs/time.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <random>

using namespace ladder;
using namespace ladder::melsec_qs;

TEST(TickCounter, CarriesTheRest) {
  TickCounter counter;
  counter.restart(10000);
  counter.advance(9999);
  EXPECT_EQ(counter.ticks(), 0);
  counter.advance(1);
  EXPECT_EQ(counter.ticks(), 1);
  counter.advance(25000);
  EXPECT_EQ(counter.ticks(), 2);
  counter.advance(5000);
  EXPECT_EQ(counter.ticks(), 1);
}

TEST(TickCounter, LosesNoTime) {
  std::mt19937 random(5);
  for (const std::uint32_t unit : {100U, 10000U, 100000U, 1000000U}) {
    TickCounter counter;
    counter.restart(unit);
    std::uint64_t elapsed = 0, ticks = 0;
    for (int i = 0; i < 10000; ++i) {
      const std::uint32_t step = static_cast<std::uint32_t>(random()) % 300000U;
      elapsed += step;
      counter.advance(step);
      ticks += static_cast<std::uint64_t>(counter.ticks());
      ASSERT_EQ(ticks, elapsed / unit);
    }
  }
}

TEST(TickCounter, SaturatesAtWhatATimerHolds) {
  TickCounter counter;
  counter.restart(100);
  counter.advance(0xFFFFFFFFU);
  EXPECT_EQ(counter.ticks(), 32767);
  counter.restart(100);
  counter.advance(3276699);
  EXPECT_EQ(counter.ticks(), 32766);
}

TEST(SecondCounter, LosesNoTime) {
  std::mt19937 random(6);
  SecondCounter counter;
  std::uint64_t elapsed = 0, seconds = 0;
  for (int i = 0; i < 10000; ++i) {
    const std::uint32_t step = static_cast<std::uint32_t>(random()) % 3000000U;
    elapsed += step;
    seconds += counter.advance(step);
    ASSERT_EQ(seconds, elapsed / 1000000);
    ASSERT_EQ(counter.rest_us(), elapsed % 1000000);
  }
  counter.restart();
  EXPECT_EQ(counter.advance(0xFFFFFFFFU), 4294u);
}

TEST(Flicker, ChangesEveryNSeconds) {
  Flicker flicker;
  for (int second = 1; second <= 30; ++second) {
    flicker.second_passed(3);
    EXPECT_EQ(flicker.state(), bit(second / 3 % 2 == 1)) << second;
  }
}

TEST(Flicker, StandsStillWithoutAnInterval) {
  Flicker flicker;
  flicker.second_passed(1);
  flicker.second_passed(0);
  flicker.second_passed(-1);
  EXPECT_EQ(flicker.state(), on);
}
