// Images tell how they lie in memory.
#include "ladder/describe.h"

#include <gtest/gtest.h>

using namespace ladder;

TEST(Describe, ShapeAndCountFollowFromTheType) {
  static_assert(shape_of<Bits<7>>() == (kPackedBits ? Shape::PackedBits : Shape::Bits));
  static_assert(shape_of<const Bits<7, true> &>() == Shape::PackedBits);
  static_assert(shape_of<Words<3>>() == Shape::Words);
  static_assert(shape_of<Timers<3>>() == Shape::Timers);
  static_assert(shape_of<Counters<3>>() == Shape::Counters);
  EXPECT_EQ(count_of<Bits<7>>(), 7u);
  EXPECT_EQ(count_of<Words<3> &>(), 3u);
  EXPECT_EQ(count_of<Timers<4>>(), 4u);
  EXPECT_EQ(count_of<Counters<5>>(), 5u);
}

TEST(Describe, ImagesAreNothingButTheirPoints) {
  EXPECT_EQ(sizeof(Words<3>), 6u);
  EXPECT_EQ(sizeof(Timers<3>), 12u);
  EXPECT_EQ(sizeof(Counters<3>), 12u);
}
