// F76 ASC, F82 ASCI, F83 HEX, F192 TEXT.
#include "ladder/tp03/ops/text.h"
#include "printing.h"
#include "tp03_panel_machine.h"

#include <gtest/gtest.h>

#include <string>

using namespace ladder;
using namespace ladder::tp03;

namespace {

struct Tp03Ascii : testing::Test {
  PanelMachine sys;
  Words<600> D;
  Bits<64> M;

  std::string characters(unsigned first, unsigned count) {
    std::string text;
    for (unsigned i = 0; i < count; ++i)
      text += static_cast<char>(tp03::detail::character(D.block(first), i, false));
    return text;
  }
  void bytes(bool one_each) { sys.M[8161] = bit(one_each); }
};

constexpr Fault kNone = Fault::None, kRange = Fault::Range;

}  // namespace

TEST_F(Tp03Ascii, TextOfTheList) {
  EXPECT_EQ(asc("ABCDEFGH", 8, D.block(300), sys), kNone);
  EXPECT_EQ(D[300], 0x4241);
  EXPECT_EQ(D[303], 0x4847);
  for (unsigned i = 300; i < 310; ++i)
    D[i] = -1;
  EXPECT_EQ(asc("ABC", 3, D.block(300), sys), kNone);
  EXPECT_EQ(D[301], 0x0043);
  EXPECT_EQ(D[303], 0);
  EXPECT_EQ(D[304], -1);
  bytes(true);
  EXPECT_EQ(asc("ABCDEFG", 7, D.block(300), sys), kNone);
  EXPECT_EQ(D[300], 0x0041);
  EXPECT_EQ(D[306], 0x0047);
  EXPECT_EQ(D[307], 0);
  EXPECT_EQ(D[308], -1);
  EXPECT_EQ(asc("ABCDEFGH", 8, D.block(593), sys), kRange);
  bytes(false);
  EXPECT_EQ(asc("ABCDEFGH", 8, D.block(597), sys), kRange);
  EXPECT_EQ(asc("ABCDEFGHI", 9, D.block(300), sys), kRange);
}

TEST_F(Tp03Ascii, DigitsToCharacters) {
  D[100] = 0x0ABC;
  D[101] = 0x1234;
  D[102] = 0x5678;
  const std::string all = "56781234"
                          "0ABC";
  for (word n = 1; n <= 12; ++n) {
    EXPECT_EQ(asci(D.block(100), D.block(200), n, sys), kNone);
    const auto count = static_cast<unsigned>(n);
    EXPECT_EQ(characters(200, count), all.substr(12 - count));
  }
}

TEST_F(Tp03Ascii, OddNumberKeepsTheUpperByte) {
  D[100] = 0x0ABC;
  D[200] = 0x7777;
  EXPECT_EQ(asci(D.block(100), D.block(200), 1, sys), kNone);
  EXPECT_EQ(D[200], 0x7743);
  bytes(true);
  EXPECT_EQ(asci(D.block(100), D.block(200), 1, sys), kNone);
  EXPECT_EQ(D[200], 0x0043);
}

TEST_F(Tp03Ascii, ConstantsAndDigits) {
  EXPECT_EQ(asci(0x1F, D.block(200), 4, sys), kNone);
  EXPECT_EQ(characters(200, 4), "001F");
  EXPECT_EQ(asci(-1, D.block(200), 4, sys), kNone);
  EXPECT_EQ(characters(200, 4), "FFFF");
  EXPECT_EQ(asci(0x1F, D.block(200), 5, sys), kRange);
  EXPECT_EQ(asci(0x1F, M.digit_block<2>(0), 2, sys), kNone);
  EXPECT_EQ(M.word<2>(0), '1') << "eight points take the low byte only";
}

TEST_F(Tp03Ascii, Ranges) {
  for (word n : {word{0}, word{-1}, word{257}}) {
    EXPECT_EQ(asci(D.block(0), D.block(200), n, sys), kRange);
    EXPECT_EQ(hex(D.block(0), D.block(200), n, sys), kRange);
  }
  EXPECT_EQ(asci(D.block(0), D.block(472), 256, sys), kNone);
  EXPECT_EQ(asci(D.block(0), D.block(473), 256, sys), kRange);
  EXPECT_EQ(asci(D.block(599), D.block(0), 5, sys), kRange);
  EXPECT_EQ(hex(D.block(599), D.block(0), 3, sys), kRange);
  EXPECT_EQ(asci(D.block(0), D.block(0), 8, sys), kNone);
  EXPECT_EQ(hex(D.block(0), D.block(599), 5, sys), kRange);
}

TEST_F(Tp03Ascii, CharactersToDigits) {
  for (bool one_each : {false, true}) {
    bytes(one_each);
    const std::string text = "0ABC12345";
    for (unsigned i = 0; i < text.size(); ++i)
      tp03::detail::set_character(D.block(200), i, static_cast<std::uint8_t>(text[i]), one_each);
    for (unsigned i = 0; i < 4; ++i)
      D[100 + i] = 0x7777;
    EXPECT_EQ(hex(D.block(200), D.block(100), 3, sys), kNone);
    EXPECT_EQ(D[100], 0x00AB);
    EXPECT_EQ(D[101], 0x7777);
    EXPECT_EQ(hex(D.block(200), D.block(100), 5, sys), kNone);
    EXPECT_EQ(D[100], to_word(0xABC1));
    EXPECT_EQ(D[101], 0);
    EXPECT_EQ(hex(D.block(200), D.block(100), 9, sys), kNone);
    EXPECT_EQ(D[100], 0x2345);
    EXPECT_EQ(D[101], to_word(0xABC1));
    EXPECT_EQ(D[102], 0);
    EXPECT_EQ(D[103], 0x7777);
  }
}

TEST_F(Tp03Ascii, WrongCharacterChangesNothing) {
  for (const char wrong : {'/', ':', '@', 'G', 'a', '\0'}) {
    D[200] = to_word(0x3031);
    D[201] = to_word(0x3000U | static_cast<unsigned char>(wrong));
    D[100] = 0x7777;
    EXPECT_EQ(hex(D.block(200), D.block(100), 4, sys), kRange) << int{wrong};
    EXPECT_EQ(D[100], 0x7777);
    EXPECT_EQ(hex(D.block(200), D.block(100), 2, sys), kNone);
  }
  bytes(true);
  D[200] = to_word(0x7F31);
  EXPECT_EQ(hex(D.block(200), D.block(100), 1, sys), kNone) << "only the low byte is looked at";
  EXPECT_EQ(D[100], 1);
  EXPECT_EQ(hex(0x31, D.block(100), 1, sys), kNone);
}

TEST_F(Tp03Ascii, ThereAndBackInPlace) {
  for (bool one_each : {false, true}) {
    bytes(one_each);
    for (unsigned i = 0; i < 64; ++i)
      D[i] = to_word(i * 40503U);
    EXPECT_EQ(asci(D.block(0), D.block(1), 256, sys), kNone);
    EXPECT_EQ(hex(D.block(1), D.block(0), 256, sys), kNone);
    for (unsigned i = 0; i < 64; ++i)
      EXPECT_EQ(D[i], to_word(i * 40503U)) << i;
  }
}

TEST_F(Tp03Ascii, TextOnThePanel) {
  show_text(2, D.block(300), 1, sys);
  EXPECT_EQ(sys.D[8280], 2);
  EXPECT_EQ(sys.D[8295], 300);
  EXPECT_EQ(sys.D[8284], 13);
  EXPECT_EQ(sys.D[8281], 0);
  show_text(7, D.block(310), 2, sys);
  EXPECT_EQ(sys.D[8280], 7);
  EXPECT_EQ(sys.D[8281], 8);
  EXPECT_EQ(sys.D[8296], 310);
}
