// What the parser reports, and where.
#include "parsing.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

std::string messages(std::string list) {
  return Parsed(std::move(list)).messages();
}

TEST(ParserMessages, UnknownMnemonicWithTheNearestOne) {
  EXPECT_EQ(Parsed("LD X0\n  outt y0 ; 手动\nEND\n").rendered(),
            "a.il:2:3: error: 'outt' is no instruction of MELSEC QS (QS001CPU) [unknown-mnemonic]\n"
            "    2 |   outt y0 ; 手动\n"
            "      |   ^~~~\n"
            "a.il:2:3: note: the nearest one is 'OUT'\n"
            "  = manual: QS 9.1.6; the controller reports 4000\n"
            "\n"
            "1 error\n");
}

TEST(ParserMessages, NothingNearNothingSaid) {
  EXPECT_EQ(Parsed("PLUGH X0\n").rendered(),
            "a.il:1:1: error: 'PLUGH' is no instruction of MELSEC QS (QS001CPU) [unknown-mnemonic]\n"
            "    1 | PLUGH X0\n"
            "      | ^~~~~\n"
            "  = manual: QS 9.1.6; the controller reports 4000\n"
            "\n"
            "1 error\n");
}

TEST(ParserMessages, OneCauseOneError) {
  EXPECT_EQ(messages("XYZZY Q5 FOO X0 LD X1\nX3\nK5\nLD X0\n"), "1:1 unknown-mnemonic\n2:1 stray-operand\n");
  EXPECT_EQ(messages("XYZZY X0\nK5 Q7\nLD X0\n"), "1:1 unknown-mnemonic\n");
}

TEST(ParserMessages, AMisspeltMnemonicInsideALine) {
  EXPECT_EQ(messages("LD X0 ADN X1 OUT Y0\n"), "1:7 unknown-mnemonic\n");
  EXPECT_EQ(messages("LD X0 OUT Y0 OUTT Y1\n"), "1:14 unknown-mnemonic\n");
}

TEST(ParserMessages, TheNarrowestPlaceOfAWrongOperand) {
  EXPECT_EQ(messages("LD D1F\n"), "1:6 digit-not-in-radix\n");
  EXPECT_EQ(messages("LD X1G\n"), "1:6 digit-not-in-radix\n");
  EXPECT_EQ(messages("MOV K4M1F D0\n"), "1:9 digit-not-in-radix\n");
  EXPECT_EQ(messages("MOV HFG D0\n"), "1:7 digit-not-in-radix\n");
  EXPECT_EQ(messages("LD D0.1F\n"), "1:7 bit-number\n");
  EXPECT_EQ(messages("LD ＤＦ１\nLD Ｄ１Ｆ\n"), "1:4 operand-unreadable\n2:4 digit-not-in-radix\n");
  EXPECT_EQ(messages("LD Q5\n"), "1:4 operand-unreadable\n");
  EXPECT_EQ(messages("LD X\n"), "1:4 device-number-missing\n");
  EXPECT_EQ(messages("LD M99999999999\n"), "1:5 number-too-large\n");
  EXPECT_EQ(messages("MOV K99999999999999999999 D0\n"), "1:6 number-too-large\n");
}

TEST(ParserMessages, Constants) {
  EXPECT_EQ(messages("OUT T0 100\n"), "1:8 constant-syntax\n");
  EXPECT_EQ(messages("MOV K1.5 D0\n"), "1:5 constant-syntax\n");
  EXPECT_EQ(messages("MOV K-X D0\n"), "1:5 constant-syntax\n");
  EXPECT_EQ(messages("MOV E1.5 D0\n"), "1:5 unsupported-constant\n");
  EXPECT_EQ(messages("MOV E-3 D0\n"), "1:5 unsupported-constant\n");
  EXPECT_EQ(Parsed("MOV \"a b\" D0\n").rendered(),
            "a.il:1:5: error: \"a b\" is a string constant, which MELSEC QS (QS001CPU) does not have [unsupported-constant]\n"
            "    1 | MOV \"a b\" D0\n"
            "      |     ^~~~~\n"
            "\n"
            "1 error\n");
}

TEST(ParserMessages, TheTextOfADigit) {
  EXPECT_EQ(Parsed("LD D1F\n").rendered(),
            "a.il:1:6: error: 'D1F' has the digit F; D is followed by a number in decimal [digit-not-in-radix]\n"
            "    1 | LD D1F\n"
            "      |      ^\n"
            "\n"
            "1 error\n");
}

TEST(ParserMessages, AnUnreadableOperandKeepsItsPlace) {
  Parsed parsed("MOV Q5 D0\n");
  EXPECT_EQ(parsed.ast(), "1: MOV | unreadable Q5 | device D 0\n");
}

TEST(ParserMessages, StrayOperands) {
  EXPECT_EQ(messages("K5\nX0 X1\nLD X0\n"), "1:1 stray-operand\n");
  EXPECT_EQ(messages("LD X0\nX5 X6 OUT Y0\n"), "2:1 stray-operand\n");
  EXPECT_EQ(messages(",,,K5,,,\n,,,K6,,,\n0,,LD,X0,,,\n"), "1:4 stray-operand\n");
}

TEST(ParserMessages, TheOperandsOfOneInstructionEnd) {
  std::string list = "LD";
  for (unsigned i = 0; i < 3 * kMaxOperands; ++i)
    list += " X0";
  Parsed parsed(list + "\nOUT Y0\n");
  EXPECT_EQ(parsed.messages(), "1:" + std::to_string(4 + 3 * kMaxOperands) + " stray-operand\n");
  ASSERT_EQ(parsed.program.instructions.size(), 2u);
  EXPECT_EQ(parsed.program.instructions[0].operand_count, kMaxOperands);
}

TEST(ParserMessages, PlacesInTables) {
  EXPECT_EQ(messages("\"0\"\t\"\"\t\"LD\"\t\"M1F\"\t\"\"\t\"\"\t\"\"\r\n\"1\"\t\"\"\t\"OUTT\"\t\"Y0\"\t\"\"\t\"\"\t\"\"\r\n"),
            "1:16 digit-not-in-radix\n2:9 unknown-mnemonic\n");
}

}  // namespace
}  // namespace ladderc
