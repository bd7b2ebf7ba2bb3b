// Reset, decoding, counting, mean values, annunciators and check codes of the TP03, against plain models.
#include "ladder/image.h"
#include "ladder/numbered.h"
#include "ladder/tp03/counter.h"
#include "ladder/tp03/ops/data.h"
#include "ladder/tp03/timer.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace ladder;
using tp03::Fault;

namespace {

struct FakeSystem {
  Numbered<Bits<512>, 8000> M;
  Numbered<Words<512>, 8000> D;
};

unsigned below(std::mt19937 &random, unsigned limit) {
  return static_cast<unsigned>(random()) % limit;
}

/// The MODBUS check bit by bit, the register as a row of bits.
std::uint32_t model_crc(const std::vector<std::uint32_t> &bytes) {
  std::uint32_t code = 0xFFFF;
  for (const std::uint32_t byte : bytes)
    for (unsigned i = 0; i < 8; ++i) {
      const std::uint32_t leaving = (code ^ byte >> i) & 1U;
      code = code >> 1 ^ leaving * 0xA001U;
    }
  return code;
}

}  // namespace

TEST(Tp03Data, ResetsBits) {
  FakeSystem sys;
  for (unsigned first = 0; first < 20; ++first)
    for (unsigned last = 0; last < 20; ++last) {
      Bits<20> M;
      for (unsigned i = 0; i < 20; ++i)
        M[i] = on;
      ASSERT_EQ(tp03::zrst(M.run(first), M.run(last), sys), Fault::None);
      for (unsigned i = 0; i < 20; ++i)
        EXPECT_EQ(bit(M[i]), bit(!(i == first || (i > first && i <= last)))) << first << ' ' << last << ' ' << i;
    }
}

TEST(Tp03Data, ResetsWords) {
  FakeSystem sys;
  Words<6> D;
  for (unsigned i = 0; i < 6; ++i)
    D[i] = 7;
  ASSERT_EQ(tp03::zrst(D.block(1), D.block(3), sys), Fault::None);
  EXPECT_EQ(D[0], 7);
  EXPECT_EQ(D[1], 0);
  EXPECT_EQ(D[3], 0);
  EXPECT_EQ(D[4], 7);
  ASSERT_EQ(tp03::zrst(D.block(5), D.block(0), sys), Fault::None);
  EXPECT_EQ(D[5], 0) << "the higher number alone";
  EXPECT_EQ(D[4], 7);
}

TEST(Tp03Data, ResetsTimersAndCountersAsAWhole) {
  FakeSystem sys;
  tp03::Timers<4> T;
  tp03::Counters<4> C;
  tp03::LongCounters<4> L;
  for (unsigned i = 0; i < 4; ++i) {
    T[i].value = C[i].value = 5;
    L[i].value = 100000;
    T[i].contact = T[i].coil = C[i].contact = L[i].contact = on;
  }
  ASSERT_EQ(tp03::zrst(T.block(1), T.block(2), sys), Fault::None);
  ASSERT_EQ(tp03::zrst(C.block(0), C.block(1), sys), Fault::None);
  ASSERT_EQ(tp03::zrst(L.dblock(2), L.dblock(3), sys), Fault::None);
  EXPECT_EQ(T[1].value, 0);
  EXPECT_EQ(T[2].contact, off);
  EXPECT_EQ(T[2].coil, off);
  EXPECT_EQ(T[3].value, 5);
  EXPECT_EQ(C[1].contact, off);
  EXPECT_EQ(C[1].value, 0);
  EXPECT_EQ(C[2].contact, on);
  EXPECT_EQ(L[2].value, 0);
  EXPECT_EQ(L[3].contact, off);
  EXPECT_EQ(L[1].value, 100000);
}

TEST(Tp03Data, ResetsOneClassOnly) {
  FakeSystem sys;
  Bits<8> M, Y;
  Bits<16> S;
  tp03::Timers<4> T;
  Words<4> D, E;
  M[0] = Y[0] = on;
  D[0] = 1;
  EXPECT_EQ(tp03::zrst(M.run(0), Y.run(3), sys), Fault::Operand) << "alike, but two images";
  EXPECT_EQ(tp03::zrst(M.run(0), S.run(3), sys), Fault::Operand);
  EXPECT_EQ(tp03::zrst(D.block(0), E.block(3), sys), Fault::Operand);
  EXPECT_EQ(tp03::zrst(D.block(0), T.block(3), sys), Fault::Operand);
  EXPECT_EQ(tp03::zrst_mixed(sys), Fault::Operand);
  EXPECT_EQ(bit(M[0]), on);
  EXPECT_EQ(D[0], 1);
}

TEST(Tp03Data, DecodesToBits) {
  FakeSystem sys;
  for (word n = 1; n <= 8; ++n)
    for (unsigned code = 0; code < 300; code += 7) {
      Bits<300> M;
      Bits<16> X;
      X.digits<4>(0) = code;
      for (unsigned i = 0; i < 300; ++i)
        M[i] = on;
      const unsigned size = 1U << n;
      const Fault fault = code % 2 == 0 ? tp03::deco_to_bits(to_word(code), M.run(10), n, sys)
                                        : tp03::deco_bits_to_bits(X.run(0), M.run(10), n, sys);
      ASSERT_EQ(fault, Fault::None);
      for (unsigned i = 0; i < 300; ++i)
        ASSERT_EQ(bit(M[i]), bit(i < 10 || i >= 10 + size || i - 10 == code % size)) << n << ' ' << code << ' ' << i;
    }
}

TEST(Tp03Data, DecodesToWords) {
  FakeSystem sys;
  for (word n = 1; n <= 4; ++n)
    for (unsigned code = 0; code < 64; ++code) {
      Bits<16> X;
      X.digits<4>(0) = code;
      word out = -1, other = -1;
      ASSERT_EQ(tp03::deco(to_word(code), n, out, sys), Fault::None);
      ASSERT_EQ(tp03::deco_bits(X.run(0), n, other, sys), Fault::None);
      EXPECT_EQ(out, to_word(1U << code % (1U << n)));
      EXPECT_EQ(other, out);
    }
}

TEST(Tp03Data, DecodingChecksItsLength) {
  FakeSystem sys;
  Bits<20> M;
  M[0] = M[18] = on;
  word out = 9;
  for (const word n : {word{-1}, word{9}, word{-32768}, word{32767}}) {
    EXPECT_EQ(tp03::deco_to_bits(0, M.run(0), n, sys), Fault::Range);
    EXPECT_EQ(tp03::deco_bits_to_bits(M.run(0), M.run(0), n, sys), Fault::Range);
    EXPECT_EQ(tp03::deco(0, n, out, sys), Fault::Range);
    EXPECT_EQ(tp03::deco_bits(M.run(0), n, out, sys), Fault::Range);
    EXPECT_EQ(tp03::enco(1, n, out, sys), Fault::Range);
    EXPECT_EQ(tp03::enco_bits(M.run(0), n, out, sys), Fault::Range);
  }
  EXPECT_EQ(tp03::deco(0, 5, out, sys), Fault::Range);
  EXPECT_EQ(tp03::deco_bits(M.run(0), 5, out, sys), Fault::Range);
  EXPECT_EQ(tp03::enco(1, 5, out, sys), Fault::Range);
  EXPECT_EQ(tp03::deco_bits(M.run(18), 3, out, sys), Fault::Range) << "M20 does not exist";
  EXPECT_EQ(tp03::deco_bits_to_bits(M.run(18), M.run(0), 3, sys), Fault::Range);
  EXPECT_EQ(tp03::deco_to_bits(0, M.run(13), 3, sys), Fault::Range);
  EXPECT_EQ(tp03::enco_bits(M.run(13), 3, out, sys), Fault::Range);
  for (const Fault fault :
       {tp03::deco(1, 0, out, sys), tp03::deco_bits(M.run(0), 0, out, sys), tp03::deco_to_bits(1, M.run(0), 0, sys),
        tp03::deco_bits_to_bits(M.run(0), M.run(0), 0, sys), tp03::enco(0, 0, out, sys), tp03::enco_bits(M.run(1), 0, out, sys)})
    EXPECT_EQ(fault, Fault::None) << "n = 0: no operation";
  EXPECT_EQ(out, 9);
  EXPECT_EQ(bit(M[0]), on);
}

TEST(Tp03Data, EncodesTheHighestBit) {
  FakeSystem sys;
  for (word n = 1; n <= 4; ++n)
    for (std::uint32_t source = 0; source < 0x10000; source += 3) {
      word out = -5;
      const std::uint32_t seen = source & ((1U << (1U << n)) - 1U);
      const Fault fault = tp03::enco(to_word(source), n, out, sys);
      ASSERT_EQ(fault, seen != 0 ? Fault::None : Fault::Range);
      if (seen == 0)
        ASSERT_EQ(out, -5);
      else
        ASSERT_TRUE(seen >> out == 1U) << source << ' ' << out;
    }
  Bits<300> M;
  M[10] = M[265] = on;
  word out = 0;
  EXPECT_EQ(tp03::enco_bits(M.run(10), 8, out, sys), Fault::None);
  EXPECT_EQ(out, 255);
  M[265] = off;
  EXPECT_EQ(tp03::enco_bits(M.run(10), 8, out, sys), Fault::None);
  EXPECT_EQ(out, 0);
  M[10] = off;
  EXPECT_EQ(tp03::enco_bits(M.run(10), 8, out, sys), Fault::Range);
}

TEST(Tp03Data, CountsBits) {
  FakeSystem sys;
  for (std::uint32_t pattern = 0; pattern < 0x10000; ++pattern) {
    word expected = 0;
    for (std::uint32_t rest = pattern; rest != 0; rest >>= 1)
      expected = static_cast<word>(expected + static_cast<word>(rest & 1U));
    ASSERT_EQ(tp03::sum(to_word(pattern), sys), expected);
    ASSERT_EQ(bit(sys.M[8020]), bit(pattern == 0));
    ASSERT_EQ(tp03::dsum(to_dword(pattern << 16 | (pattern ^ 0xFFFF)), sys), 16);
  }
  EXPECT_EQ(tp03::dsum(-1, sys), 32);
  EXPECT_EQ(tp03::dsum(0, sys), 0);
  EXPECT_EQ(bit(sys.M[8020]), on);
  EXPECT_EQ(bit(sys.M[8021]), off);
}

TEST(Tp03Data, LooksAtBits) {
  FakeSystem sys;
  Bits<4> M;
  for (word n = -2; n < 34; ++n) {
    M[1] = on;
    EXPECT_EQ(tp03::bon(0x7FFE, n, M[1], sys), n >= 0 && n <= 15 ? Fault::None : Fault::Range);
    EXPECT_EQ(bit(M[1]), bit(!(n == 0 || n == 15))) << n;
    M[1] = on;
    EXPECT_EQ(tp03::dbon(0x7FFFFFFE, n, M[1], sys), n >= 0 && n <= 31 ? Fault::None : Fault::Range);
    EXPECT_EQ(bit(M[1]), bit(!(n == 0 || n == 31))) << n;
  }
}

TEST(Tp03Data, MeanValues) {
  FakeSystem sys;
  std::mt19937 random(45);
  for (int round = 0; round < 2000; ++round) {
    Words<140> D;
    for (unsigned i = 0; i < 140; ++i)
      D[i] = round == 0 ? word{-32768} : to_word(static_cast<std::uint32_t>(random()));
    const unsigned first = below(random, 140), n = 1 + below(random, 64);
    const unsigned count = n < 140 - first ? n : 140 - first;
    qword total = 0;
    for (unsigned i = 0; i < count; ++i)
      total += D[first + i];
    word out = 0;
    ASSERT_EQ(tp03::mean(D.block(first), static_cast<word>(n), out, sys), Fault::None);
    ASSERT_EQ(out, total / static_cast<qword>(count));
    if (first == 139)
      continue;
    const unsigned pairs = n < (140 - first) / 2 ? n : (140 - first) / 2;
    total = 0;
    for (unsigned i = 0; i < pairs; ++i)
      total += static_cast<dword>(D.pair(first + 2 * i));
    dword wide = 0;
    ASSERT_EQ(tp03::dmean(D.dblock(first), static_cast<word>(n), wide, sys), Fault::None);
    ASSERT_EQ(wide, total / static_cast<qword>(pairs));
  }
}

TEST(Tp03Data, MeanValuesOfDigitsAndCounters) {
  FakeSystem sys;
  Bits<32> X;
  X.digits<8>(0) = 0x04030201;
  word out = 0;
  ASSERT_EQ(tp03::mean(X.digit_block<2>(0), 3, out, sys), Fault::None);
  EXPECT_EQ(out, 2);
  tp03::LongCounters<3> C;
  C[1].value = C[2].value = -2147483647;
  dword wide = 0;
  ASSERT_EQ(tp03::dmean(C.dblock(1), 64, wide, sys), Fault::None);
  EXPECT_EQ(wide, -2147483647);
  out = 3;
  for (const word n : {word{0}, word{-1}, word{65}}) {
    EXPECT_EQ(tp03::mean(X.digit_block<2>(0), n, out, sys), Fault::Range);
    EXPECT_EQ(tp03::dmean(C.dblock(1), n, wide, sys), Fault::Range);
  }
  EXPECT_EQ(tp03::mean(X.digit_block<4>(20), 1, out, sys), Fault::Range) << "not even one";
  EXPECT_EQ(out, 3);
}

TEST(Tp03Data, AnnunciatorsOneAfterTheOther) {
  FakeSystem sys;
  Bits<4096> S;
  S[899] = S[900] = S[910] = S[999] = S[1000] = on;
  sys.D[8049] = 77;
  tp03::anr(S, sys);
  EXPECT_EQ(bit(S[900]), off);
  EXPECT_EQ(bit(S[910]), on);
  EXPECT_EQ(sys.D[8049], 77) << "only kept with M8049";
  sys.M[8049] = on;
  tp03::anr(S, sys);
  EXPECT_EQ(bit(S[910]), off);
  EXPECT_EQ(sys.D[8049], 999);
  EXPECT_EQ(bit(sys.M[8048]), on);
  tp03::anr(S, sys);
  EXPECT_EQ(bit(S[999]), off);
  EXPECT_EQ(sys.D[8049], 0);
  EXPECT_EQ(bit(sys.M[8048]), off);
  tp03::anr(S, sys);
  EXPECT_EQ(bit(S[899]), on);
  EXPECT_EQ(bit(S[1000]), on);
  Bits<500> few;
  tp03::anr(few, sys);
}

TEST(Tp03Data, GrayCodeThereAndBack) {
  FakeSystem sys;
  word before = 0;
  for (int value = 0; value <= 32767; ++value) {
    word code = -1, back = -1;
    ASSERT_EQ(tp03::gry(static_cast<word>(value), code, sys), Fault::None);
    ASSERT_EQ(tp03::sum(to_word(pattern_of(code) ^ pattern_of(before)), sys), value > 0 ? 1 : 0) << value;
    ASSERT_EQ(tp03::gbin(code, back, sys), Fault::None);
    ASSERT_EQ(back, value);
    before = code;
  }
  std::mt19937 random(170);
  for (int i = 0; i < 20000; ++i) {
    const dword value = to_dword(static_cast<std::uint32_t>(random()) >> 1);
    dword code = -1, back = -1;
    ASSERT_EQ(tp03::dgry(value, code, sys), Fault::None);
    ASSERT_EQ(tp03::dgbin(code, back, sys), Fault::None);
    ASSERT_EQ(back, value);
  }
}

TEST(Tp03Data, NoGrayCodeOfNegativeNumbers) {
  FakeSystem sys;
  word out = 3;
  dword wide = 4;
  EXPECT_EQ(tp03::gry(-1, out, sys), Fault::Range);
  EXPECT_EQ(tp03::gbin(-32768, out, sys), Fault::Range);
  EXPECT_EQ(tp03::dgry(-1, wide, sys), Fault::Range);
  EXPECT_EQ(tp03::dgbin(-1, wide, sys), Fault::Range);
  EXPECT_EQ(out, 3);
  EXPECT_EQ(wide, 4);
}

TEST(Tp03Data, CheckCodesAgainstAModel) {
  std::mt19937 random(188);
  for (int round = 0; round < 500; ++round) {
    FakeSystem sys;
    const bool bytewise = round % 2 != 0;
    sys.M[8161] = bit(bytewise);
    Words<300> D;
    for (unsigned i = 0; i < 300; ++i)
      D[i] = to_word(static_cast<std::uint32_t>(random()));
    const unsigned n = 1 + below(random, 256);
    std::vector<std::uint32_t> bytes;
    for (unsigned i = 0; i < n; ++i)
      bytes.push_back(bytewise ? pattern_of(D[i]) & 0xFFU : pattern_of(D[i / 2]) >> (i % 2 != 0 ? 8 : 0) & 0xFFU);
    Words<2> out;
    out[1] = 99;
    const std::uint32_t code = model_crc(bytes);
    ASSERT_EQ(tp03::crc(D.block(0), out.block(0), static_cast<word>(n), sys), Fault::None);
    ASSERT_EQ(out[0], to_word(bytewise ? code & 0xFFU : code));
    ASSERT_EQ(out[1], bytewise ? to_word(code >> 8) : 99);
    std::uint32_t total = 0, parity = 0;
    for (const std::uint32_t byte : bytes) {
      total += byte;
      parity ^= byte;
    }
    ASSERT_EQ(tp03::ccd(D.block(0), out.block(0), static_cast<word>(n), sys), Fault::None);
    ASSERT_EQ(out[0], to_word(total));
    ASSERT_EQ(out[1], to_word(parity));
  }
}

TEST(Tp03Data, CheckCodeOfTheManual) {
  FakeSystem sys;
  Words<4> D;
  D[0] = 0x0101;
  D[1] = to_word(0xCD03);
  D[2] = 0x056B;
  ASSERT_EQ(tp03::crc(D.block(0), D.block(3), 6, sys), Fault::None);
  EXPECT_EQ(D[3], to_word(0x8242));
}

TEST(Tp03Data, CheckCodesCheckTheirRange) {
  FakeSystem sys;
  Words<10> D;
  Words<2> out;
  out[0] = 5;
  for (const word n : {word{0}, word{-1}, word{257}, word{21}}) {
    EXPECT_EQ(tp03::crc(D.block(0), out.block(0), n, sys), Fault::Range) << n;
    EXPECT_EQ(tp03::ccd(D.block(0), out.block(0), n, sys), Fault::Range) << n;
  }
  EXPECT_EQ(tp03::ccd(D.block(0), out.block(1), 2, sys), Fault::Range) << "no second word";
  EXPECT_EQ(tp03::crc(D.block(5), out.block(1), 9, sys), Fault::None) << "five words, the last one's high byte is not needed";
  sys.M[8161] = on;
  EXPECT_EQ(tp03::crc(D.block(0), out.block(1), 2, sys), Fault::Range) << "two words with M8161";
  EXPECT_EQ(tp03::crc(D.block(0), out.block(0), 11, sys), Fault::Range);
  EXPECT_EQ(out[0], 5);
}
