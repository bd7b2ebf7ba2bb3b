// Comparison, arithmetic and logic at the edges of their ranges.
#include "ladder/image.h"
#include "ladder/ops/arith.h"
#include "ladder/ops/compare.h"
#include "ladder/ops/logic.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <limits>

using namespace ladder;
using namespace ladder::ops;

namespace {
constexpr dword kMin = std::numeric_limits<dword>::min();
constexpr dword kMax = std::numeric_limits<dword>::max();
}  // namespace

TEST(Compare, IsSigned) {
  EXPECT_EQ(greater(word{1}, word{-1}), on);
  EXPECT_EQ(less(kMin, kMax), on);
  EXPECT_EQ(equal(word{-1}, 65535), off) << "a word widens with its sign";
  for (const dword a : {kMin, -1, 0, 1, kMax}) {
    for (const dword b : {kMin, -1, 0, 1, kMax}) {
      EXPECT_EQ(equal(a, b), bit(a == b));
      EXPECT_EQ(not_equal(a, b), bit(a != b));
      EXPECT_EQ(greater(a, b), bit(a > b));
      EXPECT_EQ(less_equal(a, b), bit(a <= b));
      EXPECT_EQ(less(a, b), bit(a < b));
      EXPECT_EQ(greater_equal(a, b), bit(a >= b));
    }
  }
}

TEST(Arith, WordsWrap) {
  EXPECT_EQ(add(32767, 2), -32767);
  EXPECT_EQ(add(-32768, -2), 32766);
  EXPECT_EQ(sub(-32768, 2), 32766);
  EXPECT_EQ(sub(32767, -2), -32767);
  EXPECT_EQ(inc(32767), -32768);
  EXPECT_EQ(dec(-32768), 32767);
  EXPECT_EQ(neg(-32768), -32768);
  EXPECT_EQ(neg(5), -5);
}

TEST(Arith, DoubleWordsWrap) {
  EXPECT_EQ(dadd(kMax, 2), kMin + 1);
  EXPECT_EQ(dadd(kMin, -2), kMax - 1);
  EXPECT_EQ(dsub(kMin, 2), kMax - 1);
  EXPECT_EQ(dsub(kMax, -2), kMin + 1);
  EXPECT_EQ(dinc(kMax), kMin);
  EXPECT_EQ(ddec(0), -1);
  EXPECT_EQ(ddec(kMin), kMax);
  EXPECT_EQ(dneg(kMin), kMin);
  EXPECT_EQ(dneg(7), -7);
}

TEST(Arith, ProductsAreWhole) {
  EXPECT_EQ(mul(-32768, -32768), 0x40000000);
  EXPECT_EQ(mul(-32768, 32767), -1073709056);
  EXPECT_EQ(dmul(567890, 123456), 70109427840);
  EXPECT_EQ(dmul(kMin, kMin), qword{1} << 62);
}

TEST(Arith, QuotientTowardsZeroRemainderLikeTheDividend) {
  for (const word a : {word{7}, word{-7}}) {
    for (const word b : {word{2}, word{-2}}) {
      word q = 0, r = 0;
      ASSERT_TRUE(div(a, b, q, r));
      EXPECT_EQ(q, a / b);
      EXPECT_EQ(r, a % b);
    }
  }
  word q = 0, r = 5;
  ASSERT_TRUE(div(-32768, -1, q, r));
  EXPECT_EQ(q, -32768);
  EXPECT_EQ(r, 0);
}

TEST(Arith, DoubleWordDivision) {
  Words<4> D;
  ASSERT_TRUE(ddiv(-100000, 7, D.pair(0), D.pair(2)));
  EXPECT_EQ(D.pair(0), -14285);
  EXPECT_EQ(D.pair(2), -5);
  ASSERT_TRUE(ddiv(kMin, -1, D.pair(0), D.pair(2)));
  EXPECT_EQ(D.pair(0), kMin);
  EXPECT_EQ(D.pair(2), 0);
  ASSERT_TRUE(ddiv(kMin, -1, D.pair(2)));
  EXPECT_EQ(D.pair(2), kMin);
  ASSERT_TRUE(ddiv(9, -1, D.pair(2)));
  EXPECT_EQ(D.pair(2), -9);
}

TEST(Arith, DivisionByZeroWritesNothing) {
  Words<4> D;
  Bits<32> Y;
  D.pair(0) = 11;
  D.pair(2) = 22;
  Y.digits<8>(0) = 33;
  EXPECT_FALSE(div(1, 0, D[0], D[1]));
  EXPECT_FALSE(div(1, 0, Y.digits<4>(0)));
  EXPECT_FALSE(ddiv(1, 0, D.pair(0), D.pair(2)));
  EXPECT_FALSE(ddiv(1, 0, Y.digits<8>(0)));
  EXPECT_EQ(D.pair(0), 11);
  EXPECT_EQ(D.pair(2), 22);
  EXPECT_EQ(Y.dword<8>(0), 33);
}

TEST(Arith, DivisionReadsBeforeItWrites) {
  Words<2> D;
  D[0] = 17;
  D[1] = 5;
  ASSERT_TRUE(div(D[0], D[1], D[0], D[1]));
  EXPECT_EQ(D[0], 3);
  EXPECT_EQ(D[1], 2);
}

TEST(Arith, QuotientAloneIntoDigits) {
  Bits<16> Y;
  Y.digits<4>(0) = -1;
  ASSERT_TRUE(div(100, 7, Y.digits<2>(4)));
  EXPECT_EQ(Y.word<4>(0), to_word(0xF0EF));
}

TEST(Logic, Words) {
  EXPECT_EQ(word_and(0x0FF0, 0x00FF), 0x00F0);
  EXPECT_EQ(word_or(0x0FF0, 0x00FF), 0x0FFF);
  EXPECT_EQ(word_xor(0x0FF0, 0x00FF), 0x0F0F);
  EXPECT_EQ(word_xnor(0x0FF0, 0x00FF), to_word(0xF0F0));
  EXPECT_EQ(word_and(-1, -32768), -32768);
  EXPECT_EQ(complement(0x000F), to_word(0xFFF0));
}

TEST(Logic, DoubleWords) {
  EXPECT_EQ(dword_and(-1, kMin), kMin);
  EXPECT_EQ(dword_or(kMin, 1), kMin + 1);
  EXPECT_EQ(dword_xor(-1, kMax), kMin);
  EXPECT_EQ(dword_xnor(0x00FF00FF, 0x0F0F0F0F), to_dword(0xF00FF00F));
  EXPECT_EQ(dcomplement(0), -1);
}
