// Comparison, BCD, arithmetic and roots of the TP03: results and flags.
#include "ladder/image.h"
#include "ladder/numbered.h"
#include "ladder/tp03/ops/arith.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace ladder;
using tp03::Fault;

namespace {

constexpr dword kMin = std::numeric_limits<dword>::min();
constexpr dword kMax = std::numeric_limits<dword>::max();

struct FakeSystem {
  Numbered<Bits<512>, 8000> M;

  void set_flags(bool zero, bool borrow, bool carry) noexcept {
    M[8020] = bit(zero);
    M[8021] = bit(borrow);
    M[8022] = bit(carry);
  }
  void expect_flags(bool zero, bool borrow, bool carry) const {
    EXPECT_EQ(bit(M[8020]), bit(zero)) << "zero";
    EXPECT_EQ(bit(M[8021]), bit(borrow)) << "borrow";
    EXPECT_EQ(bit(M[8022]), bit(carry)) << "carry";
  }
};

void expect_sum(word a, word b) {
  SCOPED_TRACE(testing::Message() << a << ' ' << b);
  FakeSystem sys;
  for (const bool minus : {false, true}) {
    const dword full = minus ? a - b : a + b;
    const word stored = minus ? tp03::sub(a, b, sys) : tp03::add(a, b, sys);
    ASSERT_EQ(stored, to_word(static_cast<std::uint32_t>(full)));
    sys.expect_flags(stored == 0, full<-32768, full> 32767);
  }
}

void expect_wide_sum(dword a, dword b) {
  SCOPED_TRACE(testing::Message() << a << ' ' << b);
  FakeSystem sys;
  for (const bool minus : {false, true}) {
    const qword full = minus ? qword{a} - b : qword{a} + b;
    const dword stored = minus ? tp03::dsub(a, b, sys) : tp03::dadd(a, b, sys);
    ASSERT_EQ(stored, to_dword(static_cast<std::uint32_t>(full)));
    sys.expect_flags(stored == 0, full<kMin, full> kMax);
  }
}

template <class Run> unsigned three(Run run) {
  return unsigned{run.get(0).value()} | unsigned{run.get(1).value()} << 1 | unsigned{run.get(2).value()} << 2;
}

}  // namespace

TEST(Tp03Arith, SumsOfWordsAndTheirFlags) {
  for (const int a : {-32768, -32767, -2, -1, 0, 1, 2, 16384, 32766, 32767})
    for (const int b : {-32768, -32767, -2, -1, 0, 1, 2, 16384, 32766, 32767})
      expect_sum(static_cast<word>(a), static_cast<word>(b));
  std::mt19937 random(20);
  for (int i = 0; i < 20000; ++i)
    expect_sum(to_word(static_cast<std::uint32_t>(random())), to_word(static_cast<std::uint32_t>(random())));
}

TEST(Tp03Arith, SumsOfDoubleWordsAndTheirFlags) {
  for (const dword a : {kMin, kMin + 1, -1, 0, 1, 1 << 30, kMax - 1, kMax})
    for (const dword b : {kMin, kMin + 1, -1, 0, 1, 1 << 30, kMax - 1, kMax})
      expect_wide_sum(a, b);
  std::mt19937 random(21);
  for (int i = 0; i < 20000; ++i)
    expect_wide_sum(to_dword(static_cast<std::uint32_t>(random())), to_dword(static_cast<std::uint32_t>(random())));
}

TEST(Tp03Arith, CompareIntoThreeBits) {
  FakeSystem sys;
  Bits<8> M;
  for (unsigned before = 0; before < 8; ++before)
    for (const dword a : {kMin, -1, 0, 1, kMax})
      for (const dword b : {kMin, -1, 0, 1, kMax}) {
        M.digits<1>(2) = before;
        const unsigned expected = a > b ? 1 : a == b ? 2 : 4;
        ASSERT_EQ(tp03::dcmp(a, b, M.run(2), sys), Fault::None);
        EXPECT_EQ(three(M.run(2)), expected);
        M.digits<1>(2) = before;
        const word x = a > 1 ? word{32767} : a < -1 ? word{-32768} : static_cast<word>(a);
        const word y = b > 1 ? word{32767} : b < -1 ? word{-32768} : static_cast<word>(b);
        ASSERT_EQ(tp03::cmp(x, y, M.run(2), sys), Fault::None);
        EXPECT_EQ(three(M.run(2)), expected);
      }
  EXPECT_EQ(bit(M[1]), off);
  EXPECT_EQ(bit(M[5]), off);
}

TEST(Tp03Arith, CompareWithAZone) {
  FakeSystem sys;
  Bits<8> M;
  for (dword low = -3; low <= 3; ++low)
    for (dword high = -3; high <= 3; ++high)
      for (dword value = -4; value <= 4; ++value) {
        const dword top = high < low ? low : high;
        const unsigned expected = value < low ? 1 : value <= top ? 2 : 4;
        ASSERT_EQ(tp03::dzcp(low, high, value, M.run(0), sys), Fault::None);
        EXPECT_EQ(three(M.run(0)), expected) << low << ' ' << high << ' ' << value;
        ASSERT_EQ(tp03::zcp(static_cast<word>(low), static_cast<word>(high), static_cast<word>(value), M.run(3), sys), Fault::None);
        EXPECT_EQ(three(M.run(3)), expected) << low << ' ' << high << ' ' << value;
      }
  ASSERT_EQ(tp03::dzcp(kMin, kMax, kMin, M.run(0), sys), Fault::None);
  EXPECT_EQ(three(M.run(0)), 2u);
}

TEST(Tp03Arith, ThreeBitsMustExist) {
  FakeSystem sys;
  Bits<8> M;
  EXPECT_EQ(tp03::cmp(1, 2, M.run(5), sys), Fault::None);
  EXPECT_EQ(tp03::cmp(2, 1, M.run(6), sys), Fault::Range);
  EXPECT_EQ(tp03::dcmp(2, 1, M.run(7), sys), Fault::Range);
  EXPECT_EQ(tp03::zcp(1, 2, 0, M.run(6), sys), Fault::Range);
  EXPECT_EQ(tp03::dzcp(1, 2, 0, M.run(6), sys), Fault::Range);
  EXPECT_EQ(bit(M[6]), off);
  EXPECT_EQ(bit(M[7]), on);
}

TEST(Tp03Arith, BcdOfAllWords) {
  FakeSystem sys;
  for (int value = -32768; value <= 32767; ++value) {
    word out = 77;
    const bool good = value >= 0 && value <= 9999;
    ASSERT_EQ(tp03::bcd(static_cast<word>(value), out, sys), good ? Fault::None : Fault::Range);
    if (!good) {
      ASSERT_EQ(out, 77) << value;
    } else {
      const int digits = value / 1000 << 12 | value / 100 % 10 << 8 | value / 10 % 10 << 4 | value % 10;
      ASSERT_EQ(out, to_word(static_cast<std::uint32_t>(digits))) << value;
      word back = 0;
      ASSERT_EQ(tp03::bin(out, back, sys), Fault::None);
      ASSERT_EQ(back, value);
    }
  }
}

TEST(Tp03Arith, BinRefusesDigitsAboveNine) {
  FakeSystem sys;
  for (unsigned place = 0; place < 8; ++place)
    for (std::uint32_t digit = 10; digit < 16; ++digit) {
      dword out = 5;
      EXPECT_EQ(tp03::dbin(to_dword(digit << 4 * place), out, sys), Fault::Range);
      EXPECT_EQ(out, 5);
    }
  dword out = 0;
  EXPECT_EQ(tp03::dbin(to_dword(0x99999999U), out, sys), Fault::None);
  EXPECT_EQ(out, 99999999);
  EXPECT_EQ(tp03::dbcd(99999999, out, sys), Fault::None);
  EXPECT_EQ(out, to_dword(0x99999999U));
  EXPECT_EQ(tp03::dbcd(100000000, out, sys), Fault::Range);
  EXPECT_EQ(tp03::dbcd(-1, out, sys), Fault::Range);
  EXPECT_EQ(out, to_dword(0x99999999U));
}

TEST(Tp03Arith, Division) {
  FakeSystem sys;
  word q = 9, r = 8;
  EXPECT_EQ(tp03::div(20, 0, q, r, sys), Fault::Range);
  EXPECT_EQ(q, 9);
  EXPECT_EQ(r, 8);
  for (const int a : {-32768, -7, -6, 0, 6, 7, 32767})
    for (const int b : {-32768, -3, -1, 1, 2, 3, 32767}) {
      ASSERT_EQ(tp03::div(static_cast<word>(a), static_cast<word>(b), q, r, sys), Fault::None);
      EXPECT_EQ(q, to_word(static_cast<std::uint32_t>(a / b))) << a << ' ' << b;
      EXPECT_EQ(r, a % b) << a << ' ' << b;
    }
  Bits<32> Y;
  ASSERT_EQ(tp03::div(100, 7, Y.digits<2>(0), sys), Fault::None);
  EXPECT_EQ(Y.dword<8>(0), 14);
  EXPECT_EQ(tp03::div(100, 0, Y.digits<2>(0), sys), Fault::Range);
  Words<4> D;
  ASSERT_EQ(tp03::ddiv(1000003, -1000, D.pair(0), D.pair(2), sys), Fault::None);
  EXPECT_EQ(D.pair(0), -1000);
  EXPECT_EQ(D.pair(2), 3);
  ASSERT_EQ(tp03::ddiv(kMin, -1, D.pair(0), D.pair(2), sys), Fault::None);
  EXPECT_EQ(D.pair(0), kMin);
  EXPECT_EQ(D.pair(2), 0);
  EXPECT_EQ(tp03::ddiv(1, 0, D.pair(0), D.pair(2), sys), Fault::Range);
  ASSERT_EQ(tp03::ddiv(7, 2, Y.digits<8>(0), sys), Fault::None);
  EXPECT_EQ(Y.dword<8>(0), 3);
}

TEST(Tp03Arith, RootsOfAllWords) {
  for (int value = 0; value <= 32767; ++value) {
    FakeSystem sys;
    sys.set_flags(value % 2 != 0, value % 3 != 0, true);
    word root = -1;
    ASSERT_EQ(tp03::sqr(static_cast<word>(value), root, sys), Fault::None);
    ASSERT_TRUE(root * root <= value && (root + 1) * (root + 1) > value) << value;
    sys.expect_flags(value == 0, root * root != value, true);
  }
}

TEST(Tp03Arith, RootsOfDoubleWords) {
  std::mt19937 random(48);
  for (int i = 0; i < 50000; ++i) {
    FakeSystem sys;
    dword value = to_dword(static_cast<std::uint32_t>(random()) >> 1);
    if (i < 4)
      value = kMax - i;
    else if (i % 4 == 0)
      value = static_cast<dword>(std::sqrt(value)) * static_cast<dword>(std::sqrt(value));
    dword root = -1;
    ASSERT_EQ(tp03::dsqr(value, root, sys), Fault::None);
    ASSERT_TRUE(qword{root} * root <= value && (qword{root} + 1) * (qword{root} + 1) > value) << value;
    sys.expect_flags(root == 0, qword{root} * root != value, false);
  }
}

TEST(Tp03Arith, NoRootOfNegativeNumbers) {
  FakeSystem sys;
  sys.set_flags(true, true, false);
  word root = 5;
  EXPECT_EQ(tp03::sqr(-4, root, sys), Fault::Range);
  EXPECT_EQ(root, 5);
  dword wide = 6;
  EXPECT_EQ(tp03::dsqr(kMin, wide, sys), Fault::Range);
  EXPECT_EQ(wide, 6);
  sys.expect_flags(true, true, false);
}

TEST(Tp03Arith, SharedWithOtherFamilies) {
  EXPECT_EQ(tp03::inc(32767), -32768);
  EXPECT_EQ(tp03::ddec(kMin), kMax);
  EXPECT_EQ(tp03::neg(-32768), -32768);
  EXPECT_EQ(tp03::mul(-300, 300), -90000);
  EXPECT_EQ(tp03::dmul(100000, 100000), qword{10000000000});
  EXPECT_EQ(tp03::word_xor(0x0FF5, 0x3C3C), 0x33C9);
  EXPECT_EQ(tp03::dword_and(-1, kMin), kMin);
}
