// Keys and switches: F70 TKY, F71 HKY, F72 DSW.
#include "ladder/tp03/ops/panel.h"
#include "printing.h"
#include "tp03_panel_machine.h"

#include <gtest/gtest.h>

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
