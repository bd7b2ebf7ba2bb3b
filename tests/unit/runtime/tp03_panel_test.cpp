// F70 TKY, F71 HKY, F72 DSW, F73 SEGD, F74 SEGL, F75 ARWS, F77 PR, F85 VRRD, F86 VRSC, F89 EPSC.
#include "ladder/tp03/ops/panel.h"
#include "printing.h"
#include "tp03_panel_machine.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace ladder;
using namespace ladder::tp03;

namespace {

struct Tp03Panel : testing::Test {
  PanelMachine sys;
  Bits<64> X, Y, M;
  Words<16> D;

  std::uint32_t outputs(unsigned first, unsigned count) { return tp03::detail::read_bits(Y.run(first), 0, count); }
  std::uint32_t relays(unsigned first, unsigned count) { return tp03::detail::read_bits(M.run(first), 0, count); }
  void keys(std::uint32_t down, unsigned first = 0, unsigned count = 10) { tp03::detail::write_bits(X.run(first), 0, count, down); }
};

constexpr Fault kNone = Fault::None, kRange = Fault::Range;

struct Tp03TenKeys : Tp03Panel {
  TenKey tky;
  Fault scan(bit condition = on) { return tky.run(condition, X.run(0), D[0], M.run(10), D[0], sys); }
  void press(unsigned key) {
    keys(1U << key);
    scan();
    keys(0);
    scan();
  }
};

}  // namespace

TEST_F(Tp03TenKeys, TypeANumber) {
  for (unsigned key : {2U, 1U, 3U, 0U})
    press(key);
  EXPECT_EQ(D[0], 2130);
  EXPECT_EQ(relays(10, 11), 1U) << "the memory of key 0 stays, no key is down";
  press(5);
  EXPECT_EQ(D[0], 1305) << "the highest digit drops out";
  scan(off);
  EXPECT_EQ(D[0], 1305);
  EXPECT_EQ(relays(10, 11), 0U);
  M[11] = on;
  scan(off);
  EXPECT_EQ(M[11], on) << "the relays are cleared once";
}

TEST_F(Tp03TenKeys, FirstKeyCounts) {
  keys(0b0000010000);
  scan();
  EXPECT_EQ(D[0], 4);
  keys(0b0000010010);
  scan();
  scan();
  EXPECT_EQ(D[0], 4) << "key 1 waits until key 4 is let go, and has then to be pressed again";
  keys(0b0000000010);
  scan();
  EXPECT_EQ(D[0], 4);
  EXPECT_EQ(M[20], off);
  keys(0);
  scan();
  keys(0b1000000100);
  scan();
  EXPECT_EQ(D[0], 42) << "of two at once the lower number counts";
}

TEST_F(Tp03TenKeys, KeyThatIsDownCountsAtTheStart) {
  keys(0b1000);
  scan(off);
  scan();
  EXPECT_EQ(D[0], 3);
  scan(off);
  scan();
  EXPECT_EQ(D[0], 33);
  sys.first = on;
  scan();
  EXPECT_EQ(D[0], 333) << "RUN begins anew";
}

TEST_F(Tp03TenKeys, OldContentsOfAnyKind) {
  D[0] = -1;
  press(7);
  EXPECT_EQ(D[0], 65535 % 1000 * 10 + 7);
}

TEST_F(Tp03TenKeys, Range) {
  EXPECT_EQ(tky.run(on, X.run(60), D[0], M.run(10), D[0], sys), kRange);
  EXPECT_EQ(tky.run(on, X.run(0), D[0], M.run(60), D[0], sys), kRange);
  EXPECT_EQ(tky.run(off, X.run(60), D[0], M.run(60), D[0], sys), kNone);
}

TEST_F(Tp03Panel, EightDigits) {
  DTenKey tky;
  for (unsigned digit = 1; digit <= 9; ++digit)
    for (std::uint32_t down : {1U << digit, 0U}) {
      keys(down);
      EXPECT_EQ(tky.run(on, X.run(0), D.pair(0), M.run(10), D.pair(0), sys), kNone);
    }
  EXPECT_EQ(D.pair(0), 23456789);
}

// ---------------------------------------------------------------------------------------------- F71

namespace {

template <class Hky> struct Matrix : Tp03Panel {
  Hky hky;
  std::uint32_t down = 0;
  int completed = 0;

  template <class Number, class Out> void scan(Number now, Out &&out, unsigned count, bit condition = on) {
    for (unsigned i = 0; i < count; ++i) {
      std::uint32_t columns = 0;
      for (unsigned row = 0; row < 4; ++row)
        if (Y[010 + row])
          columns |= down >> 4 * row & 0xFU;
      keys(columns, 4, 4);
      EXPECT_EQ(hky.run(condition, X.run(4), Y.run(010), Number(now), M.run(0), out, sys), kNone);
      completed += sys.complete() ? 1 : 0;
    }
  }
};

struct Tp03SixteenKeys : Matrix<HexKey> {
  void press(unsigned key) {
    for (std::uint32_t pattern : {1U << key, 0U}) {
      down = pattern;
      scan(D[0], D[0], 8);
    }
  }
};
struct Tp03SixteenKeysWide : Matrix<DHexKey> {};

}  // namespace

TEST_F(Tp03SixteenKeys, DigitsAndLetters) {
  press(1);
  press(9);
  EXPECT_EQ(D[0], 19);
  press(10);
  EXPECT_EQ(relays(0, 8), 0b000001U);
  press(13);
  EXPECT_EQ(relays(0, 8), 0b001000U) << "D replaces A";
  EXPECT_EQ(D[0], 19);
  down = 1U << 15;
  scan(D[0], D[0], 8);
  EXPECT_EQ(relays(0, 8), 0b01100000U);
  down = 1U << 4;
  scan(D[0], D[0], 8);
  EXPECT_EQ(relays(0, 8), 0b10100000U);
  EXPECT_EQ(D[0], 194);
  EXPECT_EQ(completed, 10);
}

TEST_F(Tp03SixteenKeys, RowsOneAfterTheOther) {
  for (unsigned row = 0; row < 4; ++row) {
    scan(D[0], D[0], 1);
    EXPECT_EQ(outputs(010, 4), 1U << row);
    EXPECT_EQ(completed, 0);
    scan(D[0], D[0], 1);
    EXPECT_EQ(outputs(010, 4), 1U << row);
  }
  EXPECT_EQ(sys.complete(), on);
  M[2] = on;
  EXPECT_EQ(hky.run(off, X.run(4), Y.run(010), D[0], M.run(0), D[0], sys), kNone);
  EXPECT_EQ(outputs(010, 4), 0U);
  EXPECT_EQ(relays(0, 8), 0U);
  EXPECT_EQ(sys.complete(), off);
}

TEST_F(Tp03SixteenKeys, Hexadecimal) {
  sys.M[8167] = on;
  for (unsigned key : {1U, 2U, 10U, 15U})
    press(key);
  EXPECT_EQ(D[0], 0x12AF);
  press(0);
  EXPECT_EQ(D[0], 0x2AF0);
  EXPECT_EQ(relays(0, 6), 0U);
}

TEST_F(Tp03SixteenKeys, ShortPressIsMissed) {
  down = 1;
  scan(D[0], D[0], 1);
  down = 0;
  scan(D[0], D[0], 15);
  EXPECT_EQ(relays(0, 8), 0U);
}

TEST_F(Tp03SixteenKeysWide, EightDigits) {
  for (unsigned digit = 1; digit <= 9; ++digit)
    for (std::uint32_t pattern : {1U << digit, 0U}) {
      down = pattern;
      for (unsigned i = 0; i < 8; ++i)
        scan(static_cast<dword>(D.pair(2)), D.pair(2), 1);
    }
  EXPECT_EQ(D.pair(2), 23456789);
  sys.M[8167] = on;
  D.pair(2) = 0x12345678;
  down = 1U << 14;
  for (unsigned i = 0; i < 8; ++i)
    scan(static_cast<dword>(D.pair(2)), D.pair(2), 1);
  EXPECT_EQ(D.pair(2), 0x2345678E);
}

// ---------------------------------------------------------------------------------------------- F72

namespace {

struct Tp03Wheels : Tp03Panel {
  DigitalSwitch dsw;
  word first = 0, second = 0;  ///< as they are set, BCD patterns

  Fault scan(word sets, bit condition = on) {
    std::uint32_t lines = 0;
    for (unsigned digit = 0; digit < 4; ++digit)
      if (Y[digit])
        lines = (pattern_of(first) >> 4 * digit & 0xFU) | (pattern_of(second) >> 4 * digit & 0xFU) << 4;
    keys(lines, 0, 8);
    return dsw.run(condition, X.run(0), Y.run(0), D.block(0), sets, sys);
  }
  /// Scans until a cycle is complete.
  unsigned cycle(word sets) {
    for (unsigned scans = 1; scans < 100; ++scans) {
      EXPECT_EQ(scan(sets), kNone);
      if (sys.complete())
        return scans;
    }
    return 0;
  }
};

}  // namespace

TEST_F(Tp03Wheels, TwoSets) {
  first = 0x1234;
  second = 0x0987;
  EXPECT_EQ(cycle(2), 41U) << "four strobes of 100 ms";
  EXPECT_EQ(D[0], 1234);
  EXPECT_EQ(D[1], 987);
  EXPECT_EQ(cycle(2), 40U);
  D[1] = 77;
  first = to_word(0x9999);
  dsw = {};
  cycle(1);
  EXPECT_EQ(D[0], 9999);
  EXPECT_EQ(D[1], 77);
}

TEST_F(Tp03Wheels, StrobesStop) {
  scan(1);
  EXPECT_EQ(outputs(0, 4), 1U);
  for (int i = 0; i < 10; ++i)
    scan(1);
  EXPECT_EQ(outputs(0, 4), 2U);
  D[0] = 5;
  scan(1, off);
  EXPECT_EQ(outputs(0, 4), 0U);
  EXPECT_EQ(D[0], 5);
  scan(1);
  EXPECT_EQ(outputs(0, 4), 1U) << "from the beginning";
}

TEST_F(Tp03Wheels, NotDecimal) {
  first = 0x1A34;
  D[0] = 5;
  for (int i = 0; i < 40; ++i)
    EXPECT_EQ(scan(1), kNone);
  EXPECT_EQ(scan(1), kRange);
  EXPECT_EQ(scan(1), kRange) << "until a cycle reads decimal digits only";
  EXPECT_EQ(D[0], 5);
  EXPECT_EQ(sys.complete(), off);
  first = 0x1934;
  for (int i = 0; i < 80; ++i)
    scan(1);
  EXPECT_EQ(D[0], 1934);
  EXPECT_EQ(scan(1), kNone);
}

TEST_F(Tp03Wheels, Range) {
  EXPECT_EQ(dsw.run(on, X.run(60), Y.run(0), D.block(0), 2, sys), kRange);
  EXPECT_EQ(dsw.run(on, X.run(60), Y.run(0), D.block(0), 1, sys), kNone);
  EXPECT_EQ(dsw.run(on, X.run(0), Y.run(61), D.block(0), 1, sys), kRange);
  EXPECT_EQ(dsw.run(on, X.run(0), Y.run(0), D.block(15), 2, sys), kRange);
}

// ---------------------------------------------------------------------------------------------- F73, F74, F75

TEST_F(Tp03Panel, SevenSegments) {
  EXPECT_EQ(segd(0x1235, to_word(0x5A00), sys), to_word(0x5A6D));
  EXPECT_EQ(segd(-1, 0, sys), 0x71);
  sys.M[8273] = on;
  EXPECT_EQ(segd(0, 0, sys), 0xC0);
  EXPECT_EQ(segd(7, to_word(0xFF00), sys), to_word(0xFFD8));
}

namespace {

struct Tp03Display : Tp03Panel {
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

struct Tp03Printer : Tp03Panel {
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

TEST_F(Tp03Panel, Knobs) {
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

TEST_F(Tp03Panel, ScaleOfTheExpansionCard) {
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
