// Block transfers: ranges, overlap, digits, timer values.
#include "ladder/counter.h"
#include "ladder/image.h"
#include "ladder/ops/move.h"
#include "ladder/timer.h"
#include "printing.h"

#include <gtest/gtest.h>

using namespace ladder;
using namespace ladder::ops;

namespace {

Words<10> counted() {
  Words<10> D;
  for (unsigned i = 0; i < 10; ++i)
    D[i] = static_cast<word>(i);
  return D;
}

}  // namespace

TEST(BlockMove, OverlapUpwards) {
  Words<10> D = counted();
  ASSERT_TRUE(bmov(D.block(0), D.block(2), 6));
  for (unsigned i = 0; i < 10; ++i)
    EXPECT_EQ(D[i], i < 2 || i >= 8 ? static_cast<word>(i) : static_cast<word>(i - 2)) << i;
}

TEST(BlockMove, OverlapDownwards) {
  Words<10> D = counted();
  ASSERT_TRUE(bmov(D.block(2), D.block(0), 6));
  for (unsigned i = 0; i < 10; ++i)
    EXPECT_EQ(D[i], i < 6 ? static_cast<word>(i + 2) : static_cast<word>(i)) << i;
}

TEST(BlockMove, EndsAtTheEndOfTheClass) {
  Words<10> D = counted();
  Words<4> W;
  EXPECT_TRUE(bmov(D.block(6), W.block(0), 4));
  EXPECT_EQ(W[3], 9);
  W.clear();
  EXPECT_FALSE(bmov(D.block(7), W.block(0), 4)) << "source too short";
  EXPECT_FALSE(bmov(D.block(0), W.block(1), 4)) << "destination too short";
  for (unsigned i = 0; i < 4; ++i)
    EXPECT_EQ(W[i], 0);
}

TEST(BlockMove, NoWordsIsNoOperation) {
  Words<10> D = counted();
  EXPECT_TRUE(bmov(D.block(0), D.block(9), 0));
  EXPECT_TRUE(fmov(5, D.block(9), 0));
  EXPECT_EQ(D[9], 9);
}

TEST(BlockMove, NegativeCountIsAnError) {
  Words<10> D = counted();
  EXPECT_FALSE(bmov(D.block(0), D.block(9), -1));
  EXPECT_FALSE(fmov(5, D.block(9), -32768));
  EXPECT_EQ(D[9], 9);
}

TEST(BlockMove, WordsIntoConsecutiveDigitGroups) {
  Words<10> D;
  D[0] = 0x1234;
  D[1] = 0x5678;
  D[2] = to_word(0x9ABC);
  Bits<40> Y;
  ASSERT_TRUE(bmov(D.block(0), Y.digit_block<1>(3), 3));
  EXPECT_EQ(Y.dword<8>(0), 0xC84 << 3);
}

TEST(BlockMove, DigitGroupsIntoWordsAreZeroExtended) {
  Bits<40> X;
  X.digits<8>(1) = to_dword(0x87654321U);
  Words<10> D = counted();
  ASSERT_TRUE(bmov(X.digit_block<2>(1), D.block(0), 4));
  EXPECT_EQ(D[0], 0x21);
  EXPECT_EQ(D[1], 0x43);
  EXPECT_EQ(D[2], 0x65);
  EXPECT_EQ(D[3], 0x87);
  EXPECT_EQ(D[4], 4);
}

TEST(BlockMove, DigitBlockCountsWholeGroups) {
  Bits<40> X;
  Words<40> D;
  EXPECT_EQ(X.digit_block<2>(1).points(), 4u);
  EXPECT_EQ(X.digit_block<2>(0).points(), 5u);
  EXPECT_EQ(X.digit_block<4>(39).points(), 0u);
  EXPECT_FALSE(bmov(X.digit_block<2>(1), D.block(0), 5));
  EXPECT_TRUE(bmov(X.digit_block<2>(0), D.block(0), 5));
}

TEST(BlockMove, OverlappingDigits) {
  for (unsigned first = 0; first < 12; ++first) {
    Bits<40> M;
    M.digits<6>(first) = 0xABCDEF;
    ASSERT_TRUE(bmov(M.digit_block<2>(first), M.digit_block<2>(6), 3));
    EXPECT_EQ(M.dword<6>(6), 0xABCDEF) << first;
  }
}

TEST(BlockMove, CurrentValuesOfTimersAndCounters) {
  Timers<4> T;
  Counters<2> C;
  Words<10> D = counted();
  T[1].contact = on;
  ASSERT_TRUE(bmov(D.block(5), T.block(1), 3));
  EXPECT_EQ(T[1].value, 5);
  EXPECT_EQ(T[3].value, 7);
  EXPECT_EQ(T[1].contact, on);
  EXPECT_FALSE(bmov(D.block(5), T.block(1), 4));
  ASSERT_TRUE(bmov(T.block(1), T.block(2), 2)) << "overlap";
  EXPECT_EQ(T[2].value, 5);
  EXPECT_EQ(T[3].value, 6);
  ASSERT_TRUE(bmov(T.block(2), C.block(0), 2));
  EXPECT_EQ(C[1].value, 6);
}

TEST(Fill, WordsAndDigits) {
  Words<10> D = counted();
  ASSERT_TRUE(fmov(-7, D.block(8), 2));
  EXPECT_EQ(D[7], 7);
  EXPECT_EQ(D[8], -7);
  EXPECT_EQ(D[9], -7);
  EXPECT_FALSE(fmov(1, D.block(8), 3));
  EXPECT_EQ(D[8], -7);
  Bits<40> Y;
  ASSERT_TRUE(fmov(0x1235, Y.digit_block<1>(4), 4));
  EXPECT_EQ(Y.dword<8>(0), 0x55550);
}
