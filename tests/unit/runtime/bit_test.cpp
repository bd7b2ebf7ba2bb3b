// States and images of states.
#include "ladder/bits.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace ladder;

TEST(Bit, CombinesLikeStates) {
  for (const bool a : {false, true}) {
    for (const bool b : {false, true}) {
      EXPECT_EQ(bit(a) & bit(b), bit(a && b));
      EXPECT_EQ(bit(a) | bit(b), bit(a || b));
      EXPECT_EQ(bit(a) ^ bit(b), bit(a != b));
    }
    EXPECT_EQ(!bit(a), bit(!a));
  }
}

TEST(Bit, IsAConstantExpression) {
  static_assert(static_cast<bool>((on | off) & !off));
  static_assert(!static_cast<bool>(bit{}));
  static_assert(bit::lowest_of(2) == off && bit::lowest_of(3) == on);
  SUCCEED();
}

TEST(Bit, ZeroedMemoryIsOff) {
  alignas(Bits<70>) unsigned char memory[sizeof(Bits<70>)];
  std::memset(memory, 0, sizeof memory);
  Bits<70> image;
  std::memcpy(static_cast<void *>(&image), memory, sizeof image);
  for (unsigned i = 0; i < 70; ++i)
    EXPECT_EQ(static_cast<bit>(image[i]), off) << i;
}

TEST(Bits, HasTheShapeOfItsImage) {
  EXPECT_EQ(sizeof(Bits<70, false>), 70u);
  EXPECT_EQ(sizeof(Bits<70, true>), 12u);
  EXPECT_EQ(sizeof(Bits<70>), kPackedBits ? 12u : 70u);
}

TEST(Bits, KeepsEveryPointForItself) {
  Bits<70> image;
  for (unsigned i = 0; i < 70; ++i) {
    image[i] = on;
    for (unsigned j = 0; j < 70; ++j)
      ASSERT_EQ(static_cast<bit>(image[j]), bit(i == j)) << i << " " << j;
    image[i] = off;
  }
}

TEST(Bits, PointsTakePartInExpressions) {
  Bits<40> X, Y;
  X[0] = on;
  Y[5] = (X[0] | Y[5]) & !X[1];
  EXPECT_EQ(static_cast<bit>(Y[5]), on);
  X[0] = off;
  Y[5] = (X[0] | Y[5]) & !X[1];
  EXPECT_EQ(static_cast<bit>(Y[5]), on);
  X[1] = on;
  Y[5] = (X[0] | Y[5]) & !X[1];
  EXPECT_EQ(static_cast<bit>(Y[5]), off);
}

TEST(Bits, PointsAreAssignedFromPoints) {
  Bits<40> X, Y;
  X[33] = on;
  Y[2] = X[33];
  EXPECT_EQ(static_cast<bit>(Y[2]), on);
  X[33] = off;
  EXPECT_EQ(static_cast<bit>(Y[2]), on);
}

TEST(Bits, CompoundAssignmentsSetAndReset) {
  Bits<40> M;
  M[35] |= on;
  EXPECT_TRUE(M[35]);
  M[35] &= !bit(false);
  EXPECT_TRUE(M[35]);
  M[35] &= !on;
  EXPECT_FALSE(M[35]);
  M[35] ^= on;
  EXPECT_TRUE(M[35]);
  M.clear();
  EXPECT_FALSE(M[35]);
}
