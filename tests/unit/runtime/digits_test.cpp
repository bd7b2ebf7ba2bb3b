// Digits: the fast ways agree with the plain loop, and images agree with their points.
#include "ladder/image.h"
#include "ladder/timer.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

using namespace ladder;

namespace {

constexpr unsigned kPoints = 100;

template <unsigned Count> void expect_wide_like_plain(std::mt19937 &random) {
  for (int round = 0; round < 2000; ++round) {
    bit points[40], plain[40], wide[40];
    for (unsigned i = 0; i < 40; ++i)
      plain[i] = wide[i] = points[i] = bit::lowest_of(static_cast<std::uint32_t>(random()));
    const unsigned first = static_cast<unsigned>(random()) % (40 - Count + 1);
    ASSERT_EQ(detail::gather_wide<Count>(points + first), detail::gather_plain<Count>(points + first));
    const std::uint32_t pattern = static_cast<std::uint32_t>(random());
    detail::scatter_plain<Count>(plain + first, pattern);
    detail::scatter_wide<Count>(wide + first, pattern);
    for (unsigned i = 0; i < 40; ++i)
      ASSERT_EQ(plain[i], wide[i]) << "point " << i << " of " << Count << " from " << first;
  }
}

template <unsigned K, class Image> void expect_digits_like_points(std::mt19937 &random) {
  for (unsigned first = 0; first + 4 * K <= kPoints; ++first) {
    Image image;
    bit before[kPoints];
    for (unsigned i = 0; i < kPoints; ++i)
      image[i] = before[i] = bit::lowest_of(static_cast<std::uint32_t>(random()));
    std::uint32_t expected = 0;
    for (unsigned i = 0; i < 4 * K; ++i)
      expected |= std::uint32_t{before[first + i].value()} << i;
    ASSERT_EQ(image.template dword<K>(first), to_dword(expected)) << "K" << K << " from " << first;
    if constexpr (K <= 4) {
      ASSERT_EQ(image.template word<K>(first), to_word(expected)) << "K" << K << " from " << first;
    }

    const std::uint32_t pattern = static_cast<std::uint32_t>(random());
    image.template digits<K>(first) = to_dword(pattern);
    for (unsigned i = 0; i < kPoints; ++i) {
      const bool inside = i >= first && i < first + 4 * K;
      ASSERT_EQ(static_cast<bit>(image[i]), inside ? bit::lowest_of(pattern >> (i - first)) : before[i])
          << "point " << i << ", K" << K << " from " << first;
    }
  }
}

template <class Image> void expect_all_digits_like_points() {
  std::mt19937 random(4711);
  expect_digits_like_points<1, Image>(random);
  expect_digits_like_points<2, Image>(random);
  expect_digits_like_points<3, Image>(random);
  expect_digits_like_points<4, Image>(random);
  expect_digits_like_points<5, Image>(random);
  expect_digits_like_points<6, Image>(random);
  expect_digits_like_points<7, Image>(random);
  expect_digits_like_points<8, Image>(random);
}

}  // namespace

TEST(Digits, WideWaysEqualThePlainLoop) {
  if (!detail::kLittleEndian)
    GTEST_SKIP() << "the wide ways are for little-endian hosts";
  std::mt19937 random(42);
  expect_wide_like_plain<4>(random);
  expect_wide_like_plain<8>(random);
  expect_wide_like_plain<12>(random);
  expect_wide_like_plain<16>(random);
  expect_wide_like_plain<20>(random);
  expect_wide_like_plain<24>(random);
  expect_wide_like_plain<28>(random);
  expect_wide_like_plain<32>(random);
}

TEST(Digits, EveryPatternOfEightPointsIsRead) {
  if (!detail::kLittleEndian)
    GTEST_SKIP() << "the wide ways are for little-endian hosts";
  for (std::uint32_t pattern = 0; pattern < 256; ++pattern) {
    bit points[8];
    detail::scatter_eight(points, pattern);
    EXPECT_EQ(detail::gather_plain<8>(points), pattern);
    EXPECT_EQ(detail::gather_eight(points), pattern);
    EXPECT_EQ(detail::gather_four(points), pattern & 0xF);
  }
}

TEST(Digits, ByteImageAgreesWithItsPoints) {
  expect_all_digits_like_points<Bits<kPoints, false>>();
}
TEST(Digits, PackedImageAgreesWithItsPoints) {
  expect_all_digits_like_points<Bits<kPoints, true>>();
}

TEST(Digits, FourDigitsAreSignedInAWordAndNotInADoubleWord) {
  Bits<32> X;
  X[15] = on;
  EXPECT_EQ(X.word<4>(0), -32768);
  EXPECT_EQ(X.dword<4>(0), 32768);
  EXPECT_EQ(X.word<3>(4), 0x800);
  X[31] = on;
  EXPECT_EQ(X.dword<8>(0), to_dword(0x80008000U));
}

TEST(Digits, TakeTheLowBitsOfAnyInteger) {
  Bits<40> Y;
  Y.digits<1>(3) = word{-1};
  EXPECT_EQ(Y.dword<3>(0), 0x78);
  Y.digits<8>(0) = qword{0x1234567890};
  EXPECT_EQ(Y.dword<8>(0), 0x34567890);
  Y.digits<2>(8) = 0x1FF;
  EXPECT_EQ(Y.dword<8>(0), 0x3456FF90);
}

TEST(Digits, AreAssignedFromDigits) {
  Bits<40> X, Y;
  X.digits<2>(5) = 0xA5;
  Y.digits<2>(9) = X.digits<2>(5);
  EXPECT_EQ(Y.word<2>(9), 0xA5);
  EXPECT_EQ(Y.digits<2>(9).word(), 0xA5);
}

TEST(Digits, TakeAPairOfWords) {
  Words<2> words;
  words[0] = 0x1234;
  words[1] = 0x0FED;
  Bits<40> image;
  image.digits<8>(3) = words.pair(0);
  EXPECT_EQ(image.dword<8>(3), 0x0FED1234);
  image.digits<5>(8) = words.pair(0);
  EXPECT_EQ(image.dword<5>(8), 0xD1234);
}

TEST(DigitRun, CrossesFromOneImageIntoTheNext) {
  Bits<34> Y;
  Bits<8> M;
  digits_of(Y[32], Y[33], M[0], M[1]) = 0b0110;
  EXPECT_FALSE(Y[32]);
  EXPECT_TRUE(Y[33]);
  EXPECT_TRUE(M[0]);
  EXPECT_FALSE(M[1]);
  EXPECT_EQ(digits_of(Y[32], Y[33], M[0], M[1]).word(), 6);
  EXPECT_EQ(digits_of(Y[33], Y[32], M[1], M[0], Y[0], Y[1], M[2], M[3]).dword(), 0b1001);
}

TEST(DigitRun, SixteenPointsAreSigned) {
  Bits<8> A;
  Bits<16> B;
  auto run = [&] {
    return digits_of(A[0], A[1], A[2], A[3], A[4], A[5], A[6], A[7], B[0], B[1], B[2], B[3], B[4], B[5], B[6], B[7]);
  };
  run() = word{-2};
  EXPECT_EQ(run().word(), -2);
  EXPECT_EQ(run().dword(), 0xFFFE);
  EXPECT_EQ(A.word<2>(0), 0xFE);
  EXPECT_EQ(B.word<4>(0), 0xFF);
}

TEST(DigitRun, TakesStatesOfTimersBesideImages) {
  Bits<3> V;
  Timer timer;
  digits_of(V[0], V[1], V[2], timer.contact) = 8;
  EXPECT_EQ(timer.contact, on);
  EXPECT_EQ(digits_of(V[0], V[1], V[2], timer.contact).word(), 8);
}
