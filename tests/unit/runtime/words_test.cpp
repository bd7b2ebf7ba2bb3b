// Word images and their wider and narrower operands.
#include "ladder/words.h"
#include "printing.h"

#include <gtest/gtest.h>

using namespace ladder;

TEST(Words, PairIsLowWordFirst) {
  Words<8> D;
  D.pair(3) = 0x12345678;
  EXPECT_EQ(D[3], 0x5678);
  EXPECT_EQ(D[4], 0x1234);
  EXPECT_EQ(D.pair(3), 0x12345678);
  D.pair(3) = -2;
  EXPECT_EQ(D[3], -2);
  EXPECT_EQ(D[4], -1);
  EXPECT_EQ(D.pair(3), -2);
}

TEST(Words, PairDoesNotExtendTheSignOfItsLowWord) {
  Words<2> D;
  D[0] = -1;
  EXPECT_EQ(D.pair(0), 65535);
}

TEST(Words, PairsMayOverlap) {
  Words<4> D;
  D.pair(0) = 0x00020001;
  D.pair(1) = D.pair(0);
  EXPECT_EQ(D[0], 1);
  EXPECT_EQ(D[1], 1);
  EXPECT_EQ(D[2], 2);
}

TEST(Words, QuadIsLowWordFirst) {
  Words<8> D;
  D.quad(2) = 0x7FFF000200030004;
  EXPECT_EQ(D[2], 4);
  EXPECT_EQ(D[3], 3);
  EXPECT_EQ(D[4], 2);
  EXPECT_EQ(D[5], 0x7FFF);
  EXPECT_EQ(D.quad(2), 0x7FFF000200030004);
  D.quad(3) = D.quad(2);
  EXPECT_EQ(D.quad(3), 0x7FFF000200030004);
  D.quad(0) = -1;
  EXPECT_EQ(D.quad(0), -1);
}

TEST(Words, NumbersCrossFromOneClassIntoTheNext) {
  Words<4> D;
  Words<4> W;
  pair(D[3], W[0]) = 70000;
  EXPECT_EQ(D[3], to_word(70000));
  EXPECT_EQ(W[0], 1);
  EXPECT_EQ(pair(D[3], W[0]), 70000);
  quad(D[2], D[3], W[0], W[1]) = qword{-70109427840};
  EXPECT_EQ(quad(D[2], D[3], W[0], W[1]), qword{-70109427840});
  EXPECT_EQ(W[2], 0);
}

TEST(Words, BitOfAWordIsAState) {
  Words<2> D;
  D.bit(1, 15) = on;
  EXPECT_EQ(D[1], -32768);
  D.bit(1, 0) |= on;
  EXPECT_EQ(D[1], -32767);
  D.bit(1, 15) &= off;
  EXPECT_EQ(D[1], 1);
  D.bit(0, 5) = D.bit(1, 0);
  EXPECT_EQ(D[0], 32);
  EXPECT_EQ(D.bit(0, 5) & !D.bit(0, 4), on);
  D.bit(0, 5) ^= on;
  EXPECT_EQ(D[0], 0);
}

TEST(Gap, ReadsZeroAndKeepsNothing) {
  Gap gap;
  Words<1> W;
  W[0] = 7;
  pair(W[0], gap.discard()) = 0x00050006;
  EXPECT_EQ(W[0], 6);
  EXPECT_EQ(pair(W[0], gap.discard()), 6);
}
