// Rotation, shift registers and queues of the TP03, against plain models.
#include "ladder/image.h"
#include "ladder/numbered.h"
#include "ladder/tp03/ops/shift.h"
#include "ladder/words.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <vector>

using namespace ladder;
using namespace ladder::tp03;

namespace {

struct FakeSystem {
  Numbered<Bits<512>, 8000> M;
};

/// One step at a time, as the manual draws it.
template <class Number> void step(std::uint32_t &value, bool &carry, bool right, bool through) {
  constexpr unsigned top = 8 * sizeof(Number) - 1;
  const bool leaving = (value >> (right ? 0 : top) & 1U) != 0;
  const bool entering = through ? carry : leaving;
  constexpr std::uint32_t mask = top == 31 ? ~0U : 0xFFFFU;
  value = (right ? value >> 1 | std::uint32_t{entering} << top : (value << 1 | std::uint32_t{entering})) & mask;
  carry = leaving;
}

template <class Number, class Rotate> void compare_with_steps(Rotate rotate, bool right, bool through) {
  constexpr int width = 8 * sizeof(Number);
  for (const std::uint32_t start : {0x0001U, 0x8000U, 0xE00FU, 0x12345678U, 0x80000001U, 0xFFFFFFFFU}) {
    for (int n = 1; n <= width; ++n) {
      for (const bool carry : {false, true}) {
        std::uint32_t model = width == 16 ? start & 0xFFFFU : start;
        bool model_carry = carry;
        FakeSystem sys;
        sys.M[8022] = bit(carry);
        const Number value = width == 16 ? static_cast<Number>(to_word(start)) : static_cast<Number>(to_dword(start));
        for (int i = 0; i < n; ++i)
          step<Number>(model, model_carry, right, through);
        Number result = 0;
        EXPECT_EQ(rotate(value, to_word(static_cast<std::uint32_t>(n)), result, sys), Fault::None);
        EXPECT_EQ(pattern_of(result), model) << "start " << start << ", n " << n << ", carry " << carry;
        EXPECT_EQ(sys.M[8022], bit(model_carry)) << "start " << start << ", n " << n << ", carry " << carry;
      }
    }
  }
}

}  // namespace

#define ROTATION(f) [](auto value, word n, auto &out, FakeSystem &sys) { return f(value, n, out, sys); }

TEST(Tp03Rotate, TurnsAsManySingleStepsDo) {
  compare_with_steps<word>(ROTATION(ror), true, false);
  compare_with_steps<dword>(ROTATION(dror), true, false);
  compare_with_steps<word>(ROTATION(rol), false, false);
  compare_with_steps<dword>(ROTATION(drol), false, false);
}

TEST(Tp03Rotate, CarryIsPartOfTheRing) {
  compare_with_steps<word>(ROTATION(rcr), true, true);
  compare_with_steps<dword>(ROTATION(drcr), true, true);
  compare_with_steps<word>(ROTATION(rcl), false, true);
  compare_with_steps<dword>(ROTATION(drcl), false, true);
}

TEST(Tp03Rotate, ByNothingChangesNothing) {
  FakeSystem sys;
  sys.M[8022] = on;
  word d = 5;
  EXPECT_EQ(ror(d, 0, d, sys), Fault::None);
  EXPECT_EQ(rcl(d, 0, d, sys), Fault::None);
  EXPECT_EQ(d, 5);
  EXPECT_EQ(sys.M[8022], on);
}

TEST(Tp03Rotate, RefusesOtherCountsAndOtherDigits) {
  FakeSystem sys;
  word d = 1;
  EXPECT_EQ(ror(d, 17, d, sys), Fault::Range);
  EXPECT_EQ(rcr(d, -1, d, sys), Fault::Range);
  EXPECT_EQ(d, 1);

  Bits<64> m;
  m[0] = on;
  EXPECT_EQ(ror(m.word<4>(0), 1, m.digits<4>(0), sys), Fault::None);
  EXPECT_EQ(m[15], on);
  EXPECT_EQ(sys.M[8022], on);
  EXPECT_EQ(ror(m.word<2>(0), 1, m.digits<2>(0), sys), Fault::Operand);
  EXPECT_EQ(drol(m.dword<4>(0), 1, m.digits<4>(0), sys), Fault::Operand);
  EXPECT_EQ(drol(m.dword<8>(0), 17, m.digits<8>(0), sys), Fault::None);
  EXPECT_EQ(m[0], on) << "bit 15 by 17 places";
}

namespace {

/// What a register is after one shift that reads S before anything moves.
template <class T> std::vector<T> shifted(std::vector<T> memory, unsigned s, unsigned d, unsigned n1, unsigned n2, bool right) {
  const std::vector<T> before = memory;
  for (unsigned i = 0; i + n2 < n1; ++i)
    memory[right ? d + i : d + i + n2] = before[right ? d + i + n2 : d + i];
  for (unsigned j = 0; j < n2; ++j)
    memory[(right ? d + n1 - n2 : d) + j] = before[s + j];
  return memory;
}

constexpr unsigned kSize = 14;

}  // namespace

TEST(Tp03Shift, WordsReadTheSourceFirstWhereverItLies) {
  FakeSystem sys;
  for (unsigned d = 0; d < 8; ++d) {
    for (unsigned n1 = 1; d + n1 <= kSize; ++n1) {
      for (unsigned n2 = 1; n2 <= n1; ++n2) {
        for (unsigned s = 0; s + n2 <= kSize; ++s) {
          for (const bool right : {false, true}) {
            Words<kSize> words;
            std::vector<word> model;
            for (unsigned i = 0; i < kSize; ++i)
              model.push_back(words[i] = to_word(100 + i));
            const word length = to_word(n1), count = to_word(n2);
            const Fault fault = right ? wsfr(words.block(s), words.block(d), length, count, sys)
                                      : wsfl(words.block(s), words.block(d), length, count, sys);
            EXPECT_EQ(fault, Fault::None);
            model = shifted(model, s, d, n1, n2, right);
            for (unsigned i = 0; i < kSize; ++i)
              ASSERT_EQ(words[i], model[i]) << "s " << s << " d " << d << " n1 " << n1 << " n2 " << n2 << " right " << right;
          }
        }
      }
    }
  }
}

template <class Image> void check_bits() {
  FakeSystem sys;
  for (unsigned seed = 1; seed < 2000; ++seed) {
    const std::uint32_t pattern = seed * 2654435761U;
    const unsigned d = seed % 7, n1 = 1 + seed / 7 % (kSize - d), n2 = 1 + seed / 3 % n1, s = seed % (kSize - n2 + 1);
    for (const bool right : {false, true}) {
      Image bits;
      std::vector<bit> model;
      for (unsigned i = 0; i < kSize; ++i) {
        bits[i] = bit::lowest_of(pattern >> i);
        model.push_back(bit::lowest_of(pattern >> i));
      }
      const word length = to_word(n1), count = to_word(n2);
      EXPECT_EQ(right ? sftr(bits.run(s), bits.run(d), length, count, sys) : sftl(bits.run(s), bits.run(d), length, count, sys),
                Fault::None);
      model = shifted(model, s, d, n1, n2, right);
      for (unsigned i = 0; i < kSize; ++i)
        ASSERT_EQ(static_cast<bit>(bits[i]), model[i]) << "seed " << seed << " right " << right;
    }
  }
}

TEST(Tp03Shift, Bits) {
  check_bits<Bits<kSize, false>>();
  check_bits<Bits<kSize, true>>();
}

TEST(Tp03Shift, TakesTheSourceFromAnotherClass) {
  FakeSystem sys;
  Bits<16> x;
  Bits<64> m;
  x[0] = x[2] = on;
  m[4] = m[15] = on;
  EXPECT_EQ(sftr(x.run(0), m.run(0), 16, 4, sys), Fault::None);
  EXPECT_EQ(m.word<4>(0), to_word(0x5801)) << "M15-M12 from X3-X0, M11 from M15, M0 from M4";
  EXPECT_EQ(sftl(x.run(0), m.run(0), 16, 4, sys), Fault::None);
  EXPECT_EQ(m.word<4>(0), to_word(0x8015));
}

TEST(Tp03Shift, DigitGroups) {
  FakeSystem sys;
  Bits<64> m;
  for (unsigned i = 0; i < 4; ++i)
    m.digits<1>(4 * i) = to_word(i + 1);
  EXPECT_EQ(wsfl(m.digit_block<1>(12), m.digit_block<1>(0), 4, 1, sys), Fault::None) << "a ring of groups";
  EXPECT_EQ(m.word<4>(0), to_word(0x3214));
  EXPECT_EQ(wsfl(m.digit_block<1>(2), m.digit_block<1>(0), 4, 1, sys), Fault::Operand);
  EXPECT_EQ(m.word<4>(0), to_word(0x3214));
  EXPECT_EQ(wsfr(m.digit_block<1>(18), m.digit_block<1>(0), 4, 2, sys), Fault::None) << "beside each other, not in step";
  EXPECT_EQ(m.word<4>(0), to_word(0x0032));
}

TEST(Tp03Shift, RefusesWhatDoesNotFit) {
  FakeSystem sys;
  Bits<32> m;
  m[1] = on;
  EXPECT_EQ(sftr(m.run(20), m.run(0), 4, 5, sys), Fault::Range) << "n2 above n1";
  EXPECT_EQ(sftr(m.run(0), m.run(20), 13, 1, sys), Fault::Range) << "D";
  EXPECT_EQ(sftr(m.run(30), m.run(0), 8, 3, sys), Fault::Range) << "S";
  EXPECT_EQ(sftr(m.run(30), m.run(0), 8, 0, sys), Fault::Range);
  EXPECT_EQ(sftr(m.run(0), m.run(0), -1, 1, sys), Fault::Range);
  EXPECT_EQ(m[1], on);
  EXPECT_EQ(m[0], off);
}

TEST(Tp03Queue, IsFirstInFirstOut) {
  FakeSystem sys;
  Words<32> d;
  for (word item = 1; item <= 3; ++item)
    EXPECT_EQ(sfwr(to_word(static_cast<std::uint32_t>(item) * 11), d.block(1), 5, sys), Fault::None);
  EXPECT_EQ(d[1], 3);
  EXPECT_EQ(d[2], 11);
  EXPECT_EQ(d[4], 33);
  for (const int item : {11, 22, 33}) {
    EXPECT_EQ(sfrd(d.block(1), 5, d[20], sys), Fault::None);
    EXPECT_EQ(d[20], item);
  }
  EXPECT_EQ(d[1], 0);
  EXPECT_EQ(sys.M[8020], off);
}

TEST(Tp03Queue, FullAndEmptyAreFlags) {
  FakeSystem sys;
  Words<32> d;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(sfwr(7, d.block(1), 4, sys), Fault::None);
    EXPECT_EQ(sys.M[8022], off);
  }
  EXPECT_EQ(sfwr(8, d.block(1), 4, sys), Fault::None);
  EXPECT_EQ(sys.M[8022], on);
  EXPECT_EQ(d[1], 3);
  EXPECT_EQ(d[4], 7);
  EXPECT_EQ(d[5], 0);

  d[1] = 0;
  d[20] = 5;
  EXPECT_EQ(sfrd(d.block(1), 4, d[20], sys), Fault::None);
  EXPECT_EQ(sys.M[8020], on);
  EXPECT_EQ(d[20], 5);
  EXPECT_EQ(d[1], 0);
}

TEST(Tp03Queue, TheLastPlaceKeepsItsValue) {
  FakeSystem sys;
  Words<16> d;
  d[0] = 3;
  d[1] = 1, d[2] = 2, d[3] = 3, d[4] = 4;
  EXPECT_EQ(sfrd(d.block(0), 4, d[10], sys), Fault::None);
  EXPECT_EQ(d[1], 2);
  EXPECT_EQ(d[2], 3);
  EXPECT_EQ(d[3], 3);
  EXPECT_EQ(d[4], 4) << "behind the queue";
}

TEST(Tp03Queue, RefusesWhatDoesNotFit) {
  FakeSystem sys;
  Words<16> d;
  d[0] = -1;
  EXPECT_EQ(sfwr(1, d.block(0), 4, sys), Fault::Range);
  EXPECT_EQ(sfrd(d.block(0), 4, d[10], sys), Fault::Range);
  d[0] = 0;
  EXPECT_EQ(sfwr(1, d.block(12), 5, sys), Fault::Range);
  EXPECT_EQ(sfrd(d.block(12), 5, d[10], sys), Fault::Range);
  EXPECT_EQ(sfwr(1, d.block(0), 1, sys), Fault::Range);
  EXPECT_EQ(d[1], 0);
}
