// Comparison contacts of the TP03: the functions of both widths, under the names that its programs call.
#include "ladder/image.h"
#include "ladder/tp03/ops/compare.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <limits>

using namespace ladder;

namespace {

constexpr dword kMin = std::numeric_limits<dword>::min();
constexpr dword kMax = std::numeric_limits<dword>::max();

void expect_order(dword a, dword b) {
  EXPECT_EQ(tp03::equal(a, b), bit(a == b)) << a << ' ' << b;
  EXPECT_EQ(tp03::not_equal(a, b), bit(a != b)) << a << ' ' << b;
  EXPECT_EQ(tp03::greater(a, b), bit(a > b)) << a << ' ' << b;
  EXPECT_EQ(tp03::less(a, b), bit(a < b)) << a << ' ' << b;
  EXPECT_EQ(tp03::greater_equal(a, b), bit(a >= b)) << a << ' ' << b;
  EXPECT_EQ(tp03::less_equal(a, b), bit(a <= b)) << a << ' ' << b;
}

}  // namespace

TEST(Tp03Compare, DoubleWords) {
  for (const dword a : {kMin, kMin + 1, -65536, -1, 0, 1, 65535, 65536, kMax - 1, kMax})
    for (const dword b : {kMin, kMin + 1, -65536, -1, 0, 1, 65535, 65536, kMax - 1, kMax})
      expect_order(a, b);
}

TEST(Tp03Compare, WordsWidenWithTheirSign) {
  Words<2> D;
  for (const word a : {word{-32768}, word{-1}, word{0}, word{1}, word{32767}})
    for (const word b : {word{-32768}, word{-1}, word{0}, word{1}, word{32767}}) {
      D[0] = a;
      D[1] = b;
      EXPECT_EQ(tp03::less(D[0], D[1]), bit(a < b));
      EXPECT_EQ(tp03::greater_equal(D[0], D[1]), bit(a >= b));
      EXPECT_EQ(tp03::equal(D[0], D[1]), bit(a == b));
    }
}

TEST(Tp03Compare, NarrowDigitsArePositive) {
  Bits<32> X;
  X.digits<3>(0) = 0xFFF;
  EXPECT_EQ(tp03::greater(X.word<3>(0), 4094), on);
  X.digits<4>(0) = 0xFFFF;
  EXPECT_EQ(tp03::equal(X.word<4>(0), -1), on);
  EXPECT_EQ(tp03::equal(X.dword<4>(0), 65535), on);
}
