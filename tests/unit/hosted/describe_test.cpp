// What the types of device images say about their layout.
#include "ladder/describe.h"

#include "ladder/tp03/counter.h"
#include "ladder/tp03/timer.h"

#include <gtest/gtest.h>

namespace ladder::hosted::test {
namespace {

struct Images {
  Bits<12, false> X;
  Bits<70, true> packed;
  Numbered<Bits<512, true>, 8000> special_packed;
  Numbered<Bits<512, false>, 8000> special;
  Words<9> D;
  Numbered<Words<512>, 8000> special_D;
  ladder::Timers<4> T;
  ladder::Counters<5> C;
  tp03::Timers<6> wide_T;
  tp03::Counters<7> wide_C;
  Numbered<tp03::LongCounters<56>, 200> C32;
};

template <class Image> void expect_image(Shape shape, std::uint32_t first, std::uint32_t count, std::uint32_t stride) {
  EXPECT_EQ(shape_of<Image>(), shape);
  EXPECT_EQ(first_of<Image>(), first);
  EXPECT_EQ(count_of<Image>(), count);
  EXPECT_EQ(stride_of<Image>(), stride);
}

TEST(Describe, ShapesFirstNumbersAndStridesComeFromTheType) {
  expect_image<decltype(Images::X)>(Shape::Bits, 0, 12, 1);
  expect_image<decltype(Images::packed)>(Shape::PackedBits, 0, 70, 0);
  expect_image<decltype(Images::special_packed)>(Shape::PackedBits, 8000, 512, 0);
  expect_image<decltype(Images::special)>(Shape::Bits, 8000, 512, 1);
  expect_image<decltype(Images::D)>(Shape::Words, 0, 9, 2);
  expect_image<decltype(Images::special_D)>(Shape::Words, 8000, 512, 2);
  expect_image<decltype(Images::T)>(Shape::Timers, 0, 4, 4);
  expect_image<decltype(Images::C)>(Shape::Counters, 0, 5, 4);
  expect_image<decltype(Images::wide_T)>(Shape::Timers, 0, 6, sizeof(tp03::Timer));
  expect_image<decltype(Images::wide_C)>(Shape::Counters, 0, 7, sizeof(tp03::Counter));
  expect_image<decltype(Images::C32)>(Shape::LongCounters, 200, 56, sizeof(tp03::LongCounter));
}

TEST(Describe, ConstAndReferencesDoNotMatter) {
  expect_image<const decltype(Images::C32) &>(Shape::LongCounters, 200, 56, sizeof(tp03::LongCounter));
  expect_image<const decltype(Images::D)>(Shape::Words, 0, 9, 2);
}

}  // namespace
}  // namespace ladder::hosted::test
