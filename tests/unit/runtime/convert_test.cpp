// BCD and binary: every 16-bit value, and double words digit by digit.
#include "ladder/image.h"
#include "ladder/ops/convert.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <random>

using namespace ladder;
using namespace ladder::ops;

namespace {

/// Digit by digit.
std::uint32_t plain_bcd(std::uint32_t value) {
  std::uint32_t digits = 0;
  for (unsigned place = 0; place < 32; place += 4, value /= 10)
    digits |= value % 10 << place;
  return digits;
}

bool has_only_decimal_digits(std::uint32_t digits) {
  for (; digits != 0; digits >>= 4) {
    if (digits % 16 > 9)
      return false;
  }
  return true;
}

}  // namespace

TEST(Convert, BcdOfEveryWord) {
  for (int value = -32768; value <= 32767; ++value) {
    word result = 0x5555;
    const bool good = value >= 0 && value <= 9999;
    ASSERT_EQ(bcd(static_cast<word>(value), result), good) << value;
    ASSERT_EQ(pattern_of(result), good ? plain_bcd(static_cast<std::uint32_t>(value)) : 0x5555U) << value;
  }
}

TEST(Convert, BinOfEveryWord) {
  for (std::uint32_t pattern = 0; pattern <= 0xFFFF; ++pattern) {
    word result = -1;
    const bool good = has_only_decimal_digits(pattern);
    ASSERT_EQ(bin(to_word(pattern), result), good) << pattern;
    if (good) {
      ASSERT_EQ(plain_bcd(static_cast<std::uint32_t>(result)), pattern);
    } else {
      ASSERT_EQ(result, -1) << pattern;
    }
  }
}

TEST(Convert, DoubleWordsThereAndBack) {
  std::mt19937 random(99);
  Words<4> D;
  for (int round = 0; round < 200000; ++round) {
    const std::uint32_t value = static_cast<std::uint32_t>(random()) % 100000000U;
    ASSERT_TRUE(dbcd(to_dword(value), D.pair(0)));
    ASSERT_EQ(pattern_of(static_cast<dword>(D.pair(0))), plain_bcd(value));
    ASSERT_TRUE(dbin(D.pair(0), D.pair(2)));
    ASSERT_EQ(D.pair(2), to_dword(value));
  }
}

TEST(Convert, DoubleWordLimits) {
  dword result = 7;
  EXPECT_TRUE(dbcd(99999999, result));
  EXPECT_EQ(result, to_dword(0x99999999U));
  EXPECT_TRUE(dbin(result, result));
  EXPECT_EQ(result, 99999999);
  EXPECT_FALSE(dbcd(100000000, result));
  EXPECT_FALSE(dbcd(-1, result));
  EXPECT_EQ(result, 99999999);
}

TEST(Convert, EveryBadDigitOfADoubleWordIsSeen) {
  for (unsigned place = 0; place < 32; place += 4) {
    for (std::uint32_t digit = 0; digit < 16; ++digit) {
      dword result = -3;
      EXPECT_EQ(dbin(to_dword((0x99999999U & ~(0xFU << place)) | digit << place), result), digit < 10);
      EXPECT_EQ(result == -3, digit >= 10);
    }
  }
}

TEST(Convert, WritesDigitsOnly) {
  Bits<16> Y;
  Y.digits<4>(0) = -1;
  ASSERT_TRUE(bcd(1234, Y.digits<2>(0)));
  EXPECT_EQ(Y.word<4>(0), to_word(0xFF34));
}
