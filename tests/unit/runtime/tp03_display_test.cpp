// Displays, printers and knobs: F73 SEGD, F74 SEGL, F75 ARWS, F77 PR, F85 VRRD, F86 VRSC, F89 EPSC.
#include "ladder/tp03/ops/panel.h"
#include "printing.h"
#include "tp03_panel_machine.h"

#include <gtest/gtest.h>

#include <string>

using namespace ladder;
using namespace ladder::tp03;

namespace {

struct Tp03Show : testing::Test {
  PanelMachine sys;
  Bits<64> X, Y;
  Words<16> D;

  std::uint32_t outputs(unsigned first, unsigned count) { return tp03::detail::read_bits(Y.run(first), 0, count); }
  void keys(std::uint32_t down, unsigned first = 0, unsigned count = 10) { tp03::detail::write_bits(X.run(first), 0, count, down); }
};

constexpr Fault kNone = Fault::None, kRange = Fault::Range;

}  // namespace

// ---------------------------------------------------------------------------------------------- F73, F74, F75

TEST_F(Tp03Show, SevenSegments) {
  EXPECT_EQ(segd(0x1235, to_word(0x5A00), sys), to_word(0x5A6D));
  EXPECT_EQ(segd(-1, 0, sys), 0x71);
  sys.M[8273] = on;
  EXPECT_EQ(segd(0, 0, sys), 0xC0);
  EXPECT_EQ(segd(7, to_word(0xFF00), sys), to_word(0xFFD8));
}

namespace {

struct Tp03Display : Tp03Show {
  SegmentLatch segl;
  ArrowSwitch arws;
  unsigned shown[2][4] = {};

  /// The displays take the data while the strobe is ON.
  void look(word n, unsigned first = 0) {
    for (unsigned digit = 0; digit < 4; ++digit)
      if (Y[first + 4 + digit] != bit((n & 1) != 0)) {
        const std::uint32_t inverse = (n & 2) != 0 ? 0xF : 0;
        shown[0][digit] = outputs(first, 4) ^ inverse;
        shown[1][digit] = outputs(first + 8, 4) ^ inverse;
      }
  }
  unsigned number(unsigned set = 0) const {
    return shown[set][3] * 1000 + shown[set][2] * 100 + shown[set][1] * 10 + shown[set][0];
  }
  Fault edit(word n = 0, bit condition = on) {
    const Fault fault = arws.run(condition, X.run(0), D[0], Y.run(0), n, D[0], sys);
    look(n);
    return fault;
  }
  void press(unsigned key) {
    keys(1U << key, 0, 4);
    edit();
    keys(0, 0, 4);
    edit();
  }
};

}  // namespace

TEST_F(Tp03Display, FourDigitsInTwelveScans) {
  D[0] = 1234;
  for (word n = 0; n < 4; ++n) {
    segl = {};
    for (int scan = 1; scan <= 24; ++scan) {
      EXPECT_EQ(segl.run(on, D.block(0), Y.run(0), n, sys), kNone);
      EXPECT_EQ(sys.complete(), bit(scan % 12 == 0));
      look(n);
    }
    EXPECT_EQ(number(), 1234U) << n;
    EXPECT_EQ(outputs(010, 4), 0U);
  }
}

TEST_F(Tp03Display, TwoSets) {
  D[0] = 90;
  D[1] = 8765;
  for (word n = 4; n < 8; ++n) {
    segl = {};
    for (int scan = 0; scan < 12; ++scan) {
      segl.run(on, D.block(0), Y.run(0), n, sys);
      look(n);
    }
    EXPECT_EQ(number(0), 90U) << n;
    EXPECT_EQ(number(1), 8765U) << n;
  }
}

TEST_F(Tp03Display, ConstantAndStop) {
  for (int scan = 0; scan < 5; ++scan)
    segl.run(on, 4711, Y.run(0), 1, sys);
  EXPECT_EQ(outputs(4, 4), 0b1101U) << "second digit, inverse strobes";
  segl.run(off, 4711, Y.run(0), 1, sys);
  EXPECT_EQ(outputs(0, 8), 0U);
  segl.run(on, 4711, Y.run(0), 0, sys);
  EXPECT_EQ(outputs(0, 8), 1U) << "from the lowest digit on";
  EXPECT_EQ(segl.run(on, 4711, Y.run(0), 4, sys), kRange) << "a constant has no second set";
}

TEST_F(Tp03Display, ValuesOutOfRange) {
  for (word value : {word{-1}, word{10000}}) {
    D[0] = value;
    EXPECT_EQ(segl.run(on, D.block(0), Y.run(0), 0, sys), kRange);
    EXPECT_EQ(edit(), kRange);
  }
  D[0] = 0;
  EXPECT_EQ(segl.run(on, D.block(0), Y.run(57), 0, sys), kRange);
  EXPECT_EQ(segl.run(on, D.block(0), Y.run(54), 4, sys), kRange);
  EXPECT_EQ(arws.run(on, X.run(0), D[0], Y.run(57), 0, D[0], sys), kRange);
  EXPECT_EQ(outputs(0, 16), 0U);
}

TEST_F(Tp03Display, ArrowsEdit) {
  D[0] = 9990;
  edit();
  press(3);
  press(1);
  EXPECT_EQ(D[0], 9991) << "advance goes from the highest digit to the lowest";
  press(0);
  press(0);
  EXPECT_EQ(D[0], 9999) << "without a borrow";
  press(1);
  EXPECT_EQ(D[0], 9990) << "without a carry";
  press(2);
  press(1);
  EXPECT_EQ(D[0], 990) << "retreat goes from the lowest digit to the highest";
  press(2);
  press(0);
  EXPECT_EQ(D[0], 890);
  edit(0, off);
  EXPECT_EQ(outputs(0, 8), 0U);
  keys(0b0010, 0, 4);
  edit(0, off);
  edit();
  EXPECT_EQ(D[0], 890) << "no key goes down";
  keys(0, 0, 4);
  edit();
  press(1);
  EXPECT_EQ(D[0], 1890) << "begins with the highest digit";
}

TEST_F(Tp03Display, ArrowsShowNumberAndDigit) {
  D[0] = 5678;
  unsigned marks[4] = {};
  for (int scan = 0; scan < 48; ++scan) {
    edit(3);
    for (unsigned digit = 0; digit < 4; ++digit)
      marks[digit] += Y[4 + digit] ? 0U : 1U;
  }
  EXPECT_EQ(number(), 5678U);
  EXPECT_EQ(marks[0], 2U);
  EXPECT_EQ(marks[3], 22U) << "the strobe of the digit that is edited";
}

// ---------------------------------------------------------------------------------------------- F77

namespace {

struct Tp03Printer : Tp03Show {
  PrintCharacters pr;
  std::string printed;
  bit strobe{};

  void load(const std::string &text) {
    for (unsigned i = 0; i < text.size(); ++i)
      D[i / 2] = to_word((pattern_of(D[i / 2]) & (i % 2 == 0 ? 0xFF00U : 0xFFU)) |
                         static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])) << 8 * (i % 2));
  }
  void scan(unsigned count, bit condition = on) {
    for (unsigned i = 0; i < count; ++i) {
      EXPECT_EQ(pr.run(condition, D.block(0), Y.run(0), sys), kNone);
      if (Y[010] & !strobe)
        printed += static_cast<char>(outputs(0, 8));
      strobe = Y[010];
    }
  }
};

}  // namespace

TEST_F(Tp03Printer, EightCharactersAgainAndAgain) {
  load("ABCDEFGH");
  scan(24);
  EXPECT_EQ(printed, "ABCDEFGH");
  EXPECT_EQ(Y[011], on);
  scan(4);
  EXPECT_EQ(printed, "ABCDEFGHA");
  scan(1, off);
  EXPECT_EQ(outputs(0, 10), 0U);
  scan(3);
  EXPECT_EQ(printed, "ABCDEFGHAA") << "from the beginning";
  EXPECT_EQ(sys.complete(), off);
}

TEST_F(Tp03Printer, LongModeEndsOnce) {
  sys.M[8027] = on;
  load(std::string("Hello, world\0!!!", 16));
  scan(1);
  EXPECT_EQ(Y[011], on);
  scan(20, off);
  scan(30);
  EXPECT_EQ(printed, "Hello, world") << "OFF does not stop it, ON again does not repeat it";
  EXPECT_EQ(outputs(0, 10), 0U);
  EXPECT_EQ(sys.complete(), on);
  scan(1, off);
  EXPECT_EQ(sys.complete(), off);
  load("0123456789abcdef");
  scan(48);
  EXPECT_EQ(sys.complete(), off);
  scan(1);
  EXPECT_EQ(printed, "Hello, world0123456789abcdef");
  EXPECT_EQ(sys.complete(), on);
  sys.first = on;
  scan(1, off);
  EXPECT_EQ(Y[011], off);
}

TEST_F(Tp03Printer, LongModeWithoutCondition) {
  sys.M[8027] = on;
  load(std::string("x\0", 2));
  scan(1);
  scan(2, off);
  EXPECT_EQ(sys.complete(), off);
  scan(1, off);
  EXPECT_EQ(sys.complete(), on) << "for one scan";
  scan(1, off);
  EXPECT_EQ(sys.complete(), off);
}

TEST_F(Tp03Printer, Range) {
  EXPECT_EQ(pr.run(on, D.block(13), Y.run(0), sys), kRange);
  sys.M[8027] = on;
  EXPECT_EQ(pr.run(on, D.block(9), Y.run(0), sys), kRange);
  EXPECT_EQ(pr.run(on, D.block(0), Y.run(55), sys), kRange);
}

// ---------------------------------------------------------------------------------------------- F85, F86, F89

TEST_F(Tp03Show, Knobs) {
  sys.scripted.positions[0] = 512;
  sys.scripted.positions[7] = 2000;
  EXPECT_EQ(vrrd(0, D[0], sys), kNone);
  EXPECT_EQ(D[0], 512);
  EXPECT_EQ(vrrd(7, D[0], sys), kNone);
  EXPECT_EQ(D[0], 1023) << "nothing is above the end of the scale";
  EXPECT_EQ(vrrd(8, D[0], sys), kRange);
  EXPECT_EQ(vrrd(-1, D[0], sys), kRange);
  struct {
    std::uint16_t position;
    word step;
  } const cases[] = {{0, 0}, {51, 0}, {52, 1}, {153, 1}, {154, 2}, {511, 5}, {512, 5}, {971, 9}, {972, 10}, {1023, 10}};
  for (const auto &[position, step] : cases) {
    sys.scripted.positions[1] = position;
    EXPECT_EQ(vrsc(1, D[0], sys), kNone);
    EXPECT_EQ(D[0], step) << position;
  }
  EXPECT_EQ(vrsc(8, D[0], sys), kRange);
}

TEST_F(Tp03Show, ScaleOfTheExpansionCard) {
  sys.scripted.channels[5] = 1023;
  EXPECT_EQ(epsc(5, 0, 20, D[0], sys), kNone);
  EXPECT_EQ(D[0], 20);
  EXPECT_EQ(epsc(5, -32768, 32767, D[0], sys), kNone);
  EXPECT_EQ(D[0], 32767);
  EXPECT_EQ(epsc(0, -32768, 32767, D[0], sys), kNone);
  EXPECT_EQ(D[0], -32768);
  sys.scripted.channels[0] = 512;
  EXPECT_EQ(epsc(0, -10, 10, D[0], sys), kNone);
  EXPECT_EQ(D[0], 0) << "10.01 of 20 from -10 on";
  EXPECT_EQ(epsc(0, 7, 7, D[0], sys), kNone);
  EXPECT_EQ(D[0], 7);
  EXPECT_EQ(epsc(6, 0, 1, D[0], sys), kRange);
  EXPECT_EQ(epsc(0, 1, 0, D[0], sys), kRange);
  EXPECT_EQ(D[0], 7);
}
