// Transfers of the TP03, against plain models.
#include "ladder/image.h"
#include "ladder/numbered.h"
#include "ladder/tp03/counter.h"
#include "ladder/tp03/ops/move.h"
#include "ladder/tp03/timer.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

using namespace ladder;
using tp03::Fault;

namespace {

struct FakeSystem {
  Numbered<Bits<512>, 8000> M;
};

template <unsigned N> void count(Words<N> &D) {
  for (unsigned i = 0; i < N; ++i)
    D[i] = static_cast<word>(100 + i);
}

using Random = std::mt19937;
unsigned below(Random &random, unsigned limit) {
  return static_cast<unsigned>(random()) % limit;
}

/// Digits of a number, the lowest first.
std::array<unsigned, 4> digits_of_number(unsigned value, unsigned base) {
  std::array<unsigned, 4> digits{};
  for (unsigned &digit : digits) {
    digit = value % base;
    value /= base;
  }
  return digits;
}
unsigned number_of(const std::array<unsigned, 4> &digits, unsigned base) {
  return digits[0] + base * (digits[1] + base * (digits[2] + base * digits[3]));
}

}  // namespace

TEST(Tp03Move, DigitsAgainstAModel) {
  for (const bool binary : {false, true}) {
    FakeSystem sys;
    sys.M[8168] = bit(binary);
    const unsigned base = binary ? 16 : 10;
    for (const unsigned source : {0U, 1234U, 9876U, 9999U, 40305U})
      for (const unsigned target : {0U, 5678U, 9999U, 65535U})
        for (word m1 = 0; m1 <= 5; ++m1)
          for (word m2 = 0; m2 <= 5; ++m2)
            for (word n = 0; n <= 5; ++n) {
              word out = to_word(target);
              const Fault fault = tp03::smov(to_word(source), m1, m2, out, n, out, sys);
              const bool good = m1 >= 1 && m1 <= 4 && n >= 1 && n <= 4 && m2 >= 1 && m2 <= m1 && m2 <= n &&
                                (binary || (source <= 9999 && target <= 9999));
              ASSERT_EQ(fault, good ? Fault::None : Fault::Range) << source << ' ' << m1 << ' ' << m2 << ' ' << target << ' ' << n;
              auto expected = digits_of_number(target, base);
              const auto from = digits_of_number(source, base);
              for (unsigned k = 0; good && k < static_cast<unsigned>(m2); ++k)
                expected[static_cast<unsigned>(n) - 1 - k] = from[static_cast<unsigned>(m1) - 1 - k];
              ASSERT_EQ(out, to_word(good ? number_of(expected, base) : target));
            }
  }
}

TEST(Tp03Move, NegativeNumbersHaveNoDecimalDigits) {
  FakeSystem sys;
  word out = 1;
  EXPECT_EQ(tp03::smov(-1, 4, 2, out, 3, out, sys), Fault::Range);
  out = -1;
  EXPECT_EQ(tp03::smov(1, 4, 2, out, 3, out, sys), Fault::Range);
  EXPECT_EQ(out, -1);
}

TEST(Tp03Move, BlocksAgainstAModel) {
  Random random(15);
  for (int round = 0; round < 3000; ++round) {
    FakeSystem sys;
    const bool reversed = below(random, 2) != 0;
    sys.M[8024] = bit(reversed);
    Words<24> D;
    std::vector<word> model(24);
    for (unsigned i = 0; i < 24; ++i)
      model[i] = D[i] = to_word(below(random, 65536));
    const unsigned s = below(random, 24), d = below(random, 24), n = 1 + below(random, 30);
    ASSERT_EQ(tp03::bmov(D.block(s), D.block(d), static_cast<word>(n), sys), Fault::None);
    const std::vector<word> before = model;
    const unsigned from = reversed ? d : s, to = reversed ? s : d;
    for (unsigned i = 0; i < n && from + i < 24 && to + i < 24; ++i)
      model[to + i] = before[from + i];
    for (unsigned i = 0; i < 24; ++i)
      ASSERT_EQ(D[i], model[i]) << s << ' ' << d << ' ' << n << ' ' << i;
  }
}

TEST(Tp03Move, DigitBlocksOfDifferentLengthOverlap) {
  Random random(16);
  for (int round = 0; round < 2000; ++round) {
    FakeSystem sys;
    Bits<96> M, before;
    for (unsigned i = 0; i < 96; ++i)
      before[i] = M[i] = bit(below(random, 2) != 0);
    const unsigned s = below(random, 60), d = below(random, 60);
    const auto n = static_cast<word>(1 + below(random, 8));
    ASSERT_EQ(tp03::bmov(M.digit_block<1>(s), M.digit_block<2>(d), n, sys), Fault::None);
    Bits<96> model = before;
    for (unsigned i = 0;
         i < static_cast<unsigned>(n) && i < before.digit_block<1>(s).points() && i < model.digit_block<2>(d).points(); ++i)
      model.digits<2>(d + 8 * i) = before.word<1>(s + 4 * i);
    for (unsigned i = 0; i < 96; ++i)
      ASSERT_EQ(bit(M[i]), bit(model[i])) << s << ' ' << d << ' ' << n << ' ' << i;
  }
}

TEST(Tp03Move, BlocksBetweenDigitsAndWords) {
  FakeSystem sys;
  Bits<64> M;
  Words<8> D;
  D[0] = 0x1239;
  D[1] = 0x4565;
  ASSERT_EQ(tp03::bmov(D.block(0), M.digit_block<1>(4), 2, sys), Fault::None);
  EXPECT_EQ(M.dword<4>(0), 0x0590);
  sys.M[8024] = on;
  ASSERT_EQ(tp03::bmov(D.block(4), M.digit_block<1>(4), 2, sys), Fault::None);
  EXPECT_EQ(D[4], 9);
  EXPECT_EQ(D[5], 5);
}

TEST(Tp03Move, CurrentValuesInBlocks) {
  FakeSystem sys;
  tp03::Timers<4> T;
  tp03::Counters<4> C;
  T[1].value = 11;
  T[2].value = 12;
  T[2].contact = on;
  ASSERT_EQ(tp03::bmov(T.block(1), C.block(2), 9, sys), Fault::None);
  EXPECT_EQ(C[2].value, 11);
  EXPECT_EQ(C[3].value, 12);
  EXPECT_EQ(C[3].contact, off);
}

TEST(Tp03Move, BlockLength) {
  FakeSystem sys;
  Words<600> D;
  count(D);
  for (const word n : {word{0}, word{-1}, word{513}, word{-32768}, word{32767}}) {
    EXPECT_EQ(tp03::bmov(D.block(0), D.block(1), n, sys), Fault::Range) << n;
    EXPECT_EQ(tp03::fmov(5, D.block(0), n, sys), Fault::Range) << n;
    EXPECT_EQ(tp03::dfmov(5, D.dblock(0), n, sys), Fault::Range) << n;
  }
  EXPECT_EQ(D[0], 100);
  EXPECT_EQ(tp03::fmov(5, D.block(0), 512, sys), Fault::None);
  EXPECT_EQ(D[511], 5);
  EXPECT_EQ(D[512], 612);
}

TEST(Tp03Move, InputsAreNotWritten) {
  FakeSystem sys;
  Bits<16> X;
  X.digits<4>(0) = 0x1234;
  Words<4> D;
  ASSERT_EQ(tp03::bmov_inputs(X.digit_block<2>(0), D.block(0), 3, sys), Fault::None);
  EXPECT_EQ(D[0], 0x34);
  EXPECT_EQ(D[1], 0x12);
  EXPECT_EQ(D[2], 0);
  sys.M[8024] = on;
  D[0] = 7;
  EXPECT_EQ(tp03::bmov_inputs(X.digit_block<2>(0), D.block(0), 2, sys), Fault::Operand);
  EXPECT_EQ(tp03::bmov_inputs(X.digit_block<2>(0), D.block(0), 0, sys), Fault::Range);
  EXPECT_EQ(X.word<4>(0), 0x1234);
  EXPECT_EQ(D[0], 7);
}

TEST(Tp03Move, FillStopsAtTheEnd) {
  FakeSystem sys;
  Words<10> D;
  ASSERT_EQ(tp03::fmov(-7, D.block(8), 5, sys), Fault::None);
  EXPECT_EQ(D[7], 0);
  EXPECT_EQ(D[8], -7);
  EXPECT_EQ(D[9], -7);
  ASSERT_EQ(tp03::dfmov(70000, D.dblock(5), 4, sys), Fault::None);
  EXPECT_EQ(D.pair(5), 70000);
  EXPECT_EQ(D.pair(7), 70000);
  EXPECT_EQ(D[9], -7) << "half a pair is left out";
  Bits<20> Y;
  ASSERT_EQ(tp03::fmov(0x1235, Y.digit_block<1>(3), 9, sys), Fault::None);
  EXPECT_EQ(Y.dword<5>(0), 0x55555 << 3 & 0xFFFFF & ~(1 << 19));
  ASSERT_EQ(tp03::dfmov(to_dword(0x87654321U), Y.digit_dblock<5>(0), 2, sys), Fault::None);
  EXPECT_EQ(Y.dword<5>(0), 0x54321);
  tp03::LongCounters<4> C;
  ASSERT_EQ(tp03::dfmov(-100000, C.dblock(2), 9, sys), Fault::None);
  EXPECT_EQ(C[1].value, 0);
  EXPECT_EQ(C[2].value, -100000);
  EXPECT_EQ(C[3].value, -100000);
}

TEST(Tp03Move, FillsIndexRegisterPairs) {
  FakeSystem sys;
  Words<16> V, Z;
  ASSERT_EQ(tp03::dfmov_indexes(V, 70000, Z.block(14), 3, sys), Fault::None);
  EXPECT_EQ(V[13], 0);
  EXPECT_EQ(Z[14], 4464);
  EXPECT_EQ(V[14], 1);
  EXPECT_EQ(Z[15], 4464);
  EXPECT_EQ(V[15], 1);
  EXPECT_EQ(tp03::dfmov_indexes(V, 5, Z.block(0), 513, sys), Fault::Range);
  EXPECT_EQ(Z[0], 0);
}

TEST(Tp03Move, Bytes) {
  EXPECT_EQ(tp03::swap(0x1234), 0x3412);
  EXPECT_EQ(tp03::swap(to_word(0x80FF)), to_word(0xFF80));
  EXPECT_EQ(tp03::dswap(0x12345678), 0x34127856);
  EXPECT_EQ(tp03::dswap(to_dword(0xFF00AA55U)), to_dword(0x00FF55AAU));
}

TEST(Tp03Move, Exchange) {
  FakeSystem sys;
  Words<4> D;
  count(D);
  ASSERT_EQ(tp03::xch(D[0], D[1], D[0], D[1], sys), Fault::None);
  EXPECT_EQ(D[0], 101);
  EXPECT_EQ(D[1], 100);
  ASSERT_EQ(tp03::dxch(D.pair(0), D.pair(2), D.pair(0), D.pair(2), sys), Fault::None);
  EXPECT_EQ(D[0], 102);
  EXPECT_EQ(D[3], 100);
  Bits<16> M;
  M.digits<2>(0) = 0x12;
  ASSERT_EQ(tp03::xch(M.word<2>(0), M.word<2>(8), M.digits<2>(0), M.digits<2>(8), sys), Fault::None);
  EXPECT_EQ(M.word<4>(0), 0x1200);
}

TEST(Tp03Move, ExchangeOfBytesNeedsOneDevice) {
  FakeSystem sys;
  sys.M[8160] = on;
  Words<8> D;
  Bits<64> M;
  // Whatever the contents are, the same ones in both places too.
  for (const word value : {word{0}, word{0x1234}, word{-1}, word{0x5555}}) {
    for (unsigned i = 0; i < 8; ++i)
      D[i] = value;
    M.digits<8>(0) = to_dword(pattern_of(value) * 0x10001U);
    M.digits<8>(32) = to_dword(pattern_of(value) * 0x10001U);
    EXPECT_EQ(tp03::xch(D[0], D[1], D[0], D[1], sys), Fault::Operand);
    EXPECT_EQ(tp03::xch(D[0], M.word<4>(0), D[0], M.digits<4>(0), sys), Fault::Operand);
    EXPECT_EQ(tp03::dxch(D.pair(0), D.pair(1), D.pair(0), D.pair(1), sys), Fault::Operand);
    EXPECT_EQ(tp03::dxch(D.pair(0), D.pair(2), D.pair(0), D.pair(2), sys), Fault::Operand);
    for (unsigned second = 1; second < 40; ++second)
      EXPECT_EQ(tp03::xch(M.word<4>(0), M.word<4>(second), M.digits<4>(0), M.digits<4>(second), sys), Fault::Operand) << second;
    EXPECT_EQ(tp03::xch(M.word<4>(0), M.word<2>(0), M.digits<4>(0), M.digits<2>(0), sys), Fault::Operand);
    EXPECT_EQ(D[0], value);
    EXPECT_EQ(M.word<4>(0), value);
    EXPECT_EQ(tp03::xch(D[0], D[0], D[0], D[0], sys), Fault::None);
    EXPECT_EQ(D[0], tp03::swap(value));
    EXPECT_EQ(tp03::dxch(D.pair(2), D.pair(2), D.pair(2), D.pair(2), sys), Fault::None);
    EXPECT_EQ(D[2], tp03::swap(value));
    EXPECT_EQ(D[3], tp03::swap(value));
    EXPECT_EQ(tp03::xch(M.word<4>(0), M.word<4>(0), M.digits<4>(0), M.digits<4>(0), sys), Fault::None);
    EXPECT_EQ(M.word<4>(0), tp03::swap(value));
    EXPECT_EQ(M.word<4>(16), value);
  }
}

TEST(Tp03Move, OctalBitsToRelays) {
  FakeSystem sys;
  Bits<64> X;
  Bits<100> M;
  X.digits<4>(8) = to_word(0x9A5B);
  M[8] = M[9] = M[18] = on;
  ASSERT_EQ(tp03::prun_xm(X.digit_block<4>(8), M.digit_block<4>(0), sys), Fault::None);
  for (unsigned i = 0; i < 16; ++i)
    EXPECT_EQ(bit(M[i / 8 * 10 + i % 8]), bit(X[8 + i])) << i;
  EXPECT_EQ(bit(M[8]), on);
  EXPECT_EQ(bit(M[9]), on);
  EXPECT_EQ(bit(M[18]), on);
  EXPECT_EQ(bit(M[19]), off);
  Bits<64> Y;
  ASSERT_EQ(tp03::prun_my(M.digit_block<4>(0), Y.digit_block<4>(16), sys), Fault::None);
  EXPECT_EQ(Y.word<4>(16), to_word(0x9A5B));
  ASSERT_EQ(tp03::prun_xy(X.digit_block<3>(8), Y.digit_block<3>(32), sys), Fault::None);
  EXPECT_EQ(Y.word<4>(32), 0x0A5B);
  ASSERT_EQ(tp03::prun_mm(M.digit_block<4>(0), M.digit_block<4>(10), sys), Fault::None) << "read as a whole first";
  EXPECT_EQ(M.word<2>(0), 0x5B);
  EXPECT_EQ(M.word<2>(10), 0x5B);
  EXPECT_EQ(M.word<2>(20), 0x9A);
}

TEST(Tp03Move, WideOctalBits) {
  FakeSystem sys;
  Bits<64> X;
  Bits<100> M;
  X.digits<8>(0) = to_dword(0x89ABCDEFU);
  ASSERT_EQ(tp03::dprun_xm(X.digit_dblock<8>(0), M.digit_dblock<8>(60), sys), Fault::None);
  for (unsigned i = 0; i < 32; ++i)
    EXPECT_EQ(bit(M[60 + i / 8 * 10 + i % 8]), bit(X[i])) << i;
  Bits<64> Y;
  ASSERT_EQ(tp03::dprun_my(M.digit_dblock<8>(60), Y.digit_dblock<8>(32), sys), Fault::None);
  EXPECT_EQ(Y.dword<8>(32), to_dword(0x89ABCDEFU));
}

TEST(Tp03Move, OctalBitsBeginAtZeroAndFit) {
  FakeSystem sys;
  Bits<64> X;
  Bits<98> M;
  X.digits<8>(0) = -1;
  EXPECT_EQ(tp03::prun_xm(X.digit_block<4>(9), M.digit_block<4>(0), sys), Fault::Range);
  EXPECT_EQ(tp03::prun_xm(X.digit_block<4>(8), M.digit_block<4>(8), sys), Fault::Range);
  EXPECT_EQ(tp03::prun_xm(X.digit_block<4>(8), M.digit_block<3>(0), sys), Fault::Range) << "different lengths";
  EXPECT_EQ(tp03::prun_xm(X.digit_block<3>(0), M.digit_block<3>(90), sys), Fault::Range) << "M100 does not exist";
  EXPECT_EQ(tp03::prun_xm(X.digit_block<2>(0), M.digit_block<2>(90), sys), Fault::None);
  EXPECT_EQ(tp03::prun_xy(X.digit_block<3>(56), X.digit_block<3>(0), sys), Fault::Range);
  EXPECT_EQ(bit(M[97]), on);
  EXPECT_EQ(bit(M[0]), off);
}
