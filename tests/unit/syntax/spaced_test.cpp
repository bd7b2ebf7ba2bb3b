// Lists of a family that prints blanks inside of operands and mnemonics, has function numbers, labels and texts.
#include "parsing.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

struct Tp03Parsed : Parsed {
  explicit Tp03Parsed(std::string list) : Parsed(std::move(list), ListFormat::Auto, tp03()) {}
};

/// The AST of a list that parses without a message.
std::string ast(std::string list) {
  Tp03Parsed parsed(std::move(list));
  EXPECT_EQ(parsed.messages(), "");
  return parsed.ast();
}

std::string messages(std::string list) {
  return Tp03Parsed(std::move(list)).messages();
}

/// The spelling that the first words of a line mean.
std::string spelling(const std::string &line) {
  const std::string text = ast(line);
  return text.substr(3, text.find_first_of(" \n", 3) - 3);
}

TEST(Spaced, LetterAndNumberStandApart) {
  EXPECT_EQ(ast("STL S 20\nOUT Y 010\nLD X 010\nOUT T 0 K 100\nMOV K -5 D 10\nMOV H FF D 0\n"),
            "1: STL | device S 20\n"
            "2: OUT | device Y 10\n"
            "3: LD | device X 10\n"
            "4: OUT | device T 0 | decimal 100\n"
            "5: MOV | decimal -5 | device D 10\n"
            "6: MOV | hexadecimal FF | device D 0\n");
  Tp03Parsed parsed("LD X  010\n");
  EXPECT_EQ(parsed.sources.text(parsed.program.operands[0].range), "X  010");
}

TEST(Spaced, OtherFamiliesKeepTheirWords) {
  EXPECT_NE(Parsed("LD X 010\n").messages(), "");
}

TEST(Spaced, StepNumbersAndTabs) {
  EXPECT_EQ(ast("0\tLD\tX000\n1\tOR\tY005\n2  ANI X 001\n3\tOUT\tY005\n"), "1: LD | device X 0\n"
                                                                           "2: OR | device Y 5\n"
                                                                           "3: ANI | device X 1\n"
                                                                           "4: OUT | device Y 5\n");
}

TEST(Spaced, AMessageMarksTheWholeOperand) {
  EXPECT_EQ(messages("LD X 08\n"), "1:4 digit-not-in-radix\n");
  EXPECT_EQ(messages("LD X08\n"), "1:6 digit-not-in-radix\n");
}

TEST(Spaced, PairsNameTheirSecondDeviceInBrackets) {
  EXPECT_EQ(ast("DMOV D0(D1) D4(D5)\n"), "1: DMOV | device D 0 | device D 4\n");
}

TEST(Spaced, NumbersChooseTheClass) {
  Tp03Parsed parsed("LD M7679\nLD M8002\nLD C199\nLD C200\nMOV D7999 D8000\n");
  std::string firsts;
  for (const Operand &operand : parsed.program.operands)
    firsts += std::to_string(tp03().devices[operand.device].first) + " ";
  EXPECT_EQ(firsts, "0 8000 0 200 0 8000 ");
}

// ---------------------------------------------------------------------------------------------- index registers
TEST(Indexed, DevicesDigitsConstantsAndLabels) {
  EXPECT_EQ(ast("MOV D20V0 K4M0Z0\nMOV K30V0 C20Z15\nMOV H30V5 D0\nCJ P0Z0\nBON K2X0Z1 M0Z2 K0\n"),
            "1: MOV | device D 20 index V 0 | 4 digits from M 0 index Z 0\n"
            "2: MOV | decimal 30 index V 0 | device C 20 index Z 15\n"
            "3: MOV | hexadecimal 30 index V 5 | device D 0\n"
            "4: CJ | device P 0 index Z 0\n"
            "5: BON | 2 digits from X 0 index Z 1 | device M 0 index Z 2 | decimal 0\n");
}

TEST(Indexed, TheNumberOfDigitsIsFixed) {
  EXPECT_EQ(messages("MOV K1 K0Z0M0\n"), "1:8 digit-count-indexed\n");
  EXPECT_EQ(messages("MOV K1 K2V1Y0\n"), "1:8 digit-count-indexed\n");
}

// ---------------------------------------------------------------------------------------------- mnemonics
TEST(Decorated, PrefixAndSuffixStandApart) {
  EXPECT_EQ(spelling("D MOV K1 D0\n"), "DMOV");
  EXPECT_EQ(spelling("MOV P K1 D0\n"), "MOVP");
  EXPECT_EQ(spelling("D MOV P K1 D0\n"), "DMOVP");
  EXPECT_EQ(spelling("D LD= K200 C200\n"), "DLD=");
  EXPECT_EQ(spelling("D LD <> D0 D2\n"), "DLD<>");
  EXPECT_EQ(spelling("LD = D0 K1\n"), "LD=");
  EXPECT_EQ(spelling("LD≠ D0 K1\n"), "LD<>");
  EXPECT_EQ(spelling("AND≤ D0 K1\n"), "AND<=");
  EXPECT_EQ(spelling("CALL P P10\n"), "CALLP");
  EXPECT_EQ(spelling("WDT P\n"), "WDTP");
  EXPECT_EQ(spelling("ANF X0\n"), "ANDF");
  EXPECT_EQ(spelling("OUT I Y0\n"), "OUTI");
  EXPECT_EQ(spelling("OUT NOT Y0\n"), "OUTI");
  EXPECT_EQ(ast("CALL P 10\n"), "1: CALL | device P 10\n");
  Tp03Parsed parsed("D  MOV P K1 D0\n");
  EXPECT_EQ(parsed.sources.text(parsed.program.instructions[0].range), "D  MOV P");
}

TEST(Decorated, FunctionNumbers) {
  EXPECT_EQ(spelling("F12 K1 D0\n"), "MOV");
  EXPECT_EQ(spelling("FNC12 K1 D0\n"), "MOV");
  EXPECT_EQ(spelling("FNC 12 K1 D0\n"), "MOV");
  EXPECT_EQ(spelling("F12P K1 D0\n"), "MOVP");
  EXPECT_EQ(spelling("F12 P K1 D0\n"), "MOVP");
  EXPECT_EQ(spelling("FD12 K1 D0\n"), "DMOV");
  EXPECT_EQ(spelling("DF12 K1 D0\n"), "DMOV");
  EXPECT_EQ(spelling("D F12 P K1 D0\n"), "DMOVP");
  EXPECT_EQ(spelling("FNCD12P K1 D0\n"), "DMOVP");
  EXPECT_EQ(spelling("F00 P8\n"), "CJ");
  EXPECT_EQ(spelling("F0 P8\n"), "CJ");
  EXPECT_EQ(spelling("F224 D0 K1\n"), "LD=");
}

TEST(Decorated, FunctionNumbersWithTheirNames) {
  EXPECT_EQ(spelling("F12 MOV K1 D0\n"), "MOV");
  EXPECT_EQ(spelling("F12 DMOV K1 D0\n"), "DMOV");
  EXPECT_EQ(spelling("F12 D MOV P K1 D0\n"), "DMOVP");
  EXPECT_EQ(spelling("F12 MOVP K1 D0\n"), "MOVP");
  EXPECT_EQ(spelling("F00(CJ) P8\n"), "CJ");
  EXPECT_EQ(spelling("FNC01 (CALL) P10\n"), "CALL");
  EXPECT_EQ(spelling("F224 D LD= D0 D2\n"), "DLD=");
}

TEST(Decorated, AnInstructionOf32BitsOnlyNeedsNoDByNumber) {
  EXPECT_EQ(spelling("F53 K100 C235 Y0\n"), "DHSCS");
  EXPECT_EQ(messages("HSCS K100 C235 Y0\n"), "1:1 unknown-mnemonic\n");
}

TEST(Decorated, NumbersThatAreNone) {
  EXPECT_EQ(messages("F51 K1\n"), "1:1 unknown-mnemonic\n");
  EXPECT_EQ(messages("F12(ADD) K1 D0\n"), "1:1 unknown-mnemonic\n");
  EXPECT_EQ(messages("F12345 K1 D0\n"), "1:1 unknown-mnemonic\n");
}

// ---------------------------------------------------------------------------------------------- labels
TEST(LabelLines, AreInstructions) {
  EXPECT_EQ(ast("P8\nLD X0\nI001\nP 9\nP10:\nP11: LD X1\n"), "1: P | device P 8\n"
                                                             "2: LD | device X 0\n"
                                                             "3: I | device I 1\n"
                                                             "4: P | device P 9\n"
                                                             "5: P | device P 10\n"
                                                             "6: P | device P 11\n"
                                                             "6: LD | device X 1\n");
}

TEST(LabelLines, AreOperandsWhereOneIsDue) {
  EXPECT_EQ(ast("CALL\nP10\nP10\n"), "1: CALL | device P 10\n3: P | device P 10\n");
  EXPECT_EQ(ast("LD X0 CJ P8 LD X1 OUT Y0 P8 LD X2\n"), "1: LD | device X 0\n"
                                                        "1: CJ | device P 8\n"
                                                        "1: LD | device X 1\n"
                                                        "1: OUT | device Y 0\n"
                                                        "1: P | device P 8\n"
                                                        "1: LD | device X 2\n");
}

TEST(LabelLines, InATable) {
  Tp03Parsed parsed("0,,LD,X0,,,\n1,,CJ,P8,,,\n2,,P8,,,,\n3,,LD,X1,,,\n4,,OUT,Y0,,,\n5,,STL,S 20,,,\n6,,END,,,,\n");
  EXPECT_EQ(parsed.messages(), "");
  EXPECT_EQ(parsed.ast(), "1: LD | device X 0\n2: CJ | device P 8\n3: P | device P 8\n4: LD | device X 1\n5: OUT | device Y 0\n"
                          "6: STL | device S 20\n7: END\n");
}

// ---------------------------------------------------------------------------------------------- comments and texts
TEST(DashComments, EndALine) {
  Tp03Parsed parsed("LD X0\nOUT Y010   -drive part\nOUT Y1 - 2nd ; and more\nOUT Y2 -- \n-- a line\nOUT Y3 -3rd\n");
  EXPECT_EQ(parsed.messages(), "");
  EXPECT_EQ(parsed.ast(),
            "1: LD | device X 0\n2: OUT | device Y 10\n3: OUT | device Y 1\n4: OUT | device Y 2\n6: OUT | device Y 3\n");
  std::string text;
  for (const Comment &comment : parsed.program.comments)
    text += std::to_string(comment.instruction) + " " + parsed.sources.text(comment.range).str() + "\n";
  EXPECT_EQ(text, "1 drive part\n2 2nd ; and more\n4 a line\n4 3rd\n");
}

TEST(DashComments, ANumberWhereAnOperandIsDueIsAMistake) {
  EXPECT_EQ(messages("MOV -5 D0\n"), "1:5 constant-syntax\n");
}

TEST(DashComments, AreNoneWhereTheDashIsAMnemonic) {
  EXPECT_EQ(Parsed("LD X0\n- D0 D1\n").ast(), "1: LD | device X 0\n2: - | device D 0 | device D 1\n");
}

TEST(Texts, WithAndWithoutQuotes) {
  EXPECT_EQ(ast("ASC ABCDEFGH D300\nASC \"a \"\"b\" D0\nASC end D0\nASC\nMOV\nD5\n"), "1: ASC | text ABCDEFGH | device D 300\n"
                                                                                      "2: ASC | text a \"b | device D 0\n"
                                                                                      "3: ASC | text end | device D 0\n"
                                                                                      "4: ASC | text MOV | device D 5\n");
}

TEST(Texts, ThoseWithoutATakerAreReported) {
  EXPECT_EQ(messages("MOV \"ab\" D0\n"), "1:5 unsupported-constant\n");
}

TEST(Spaced, EveryExampleOfTheTablesParses) {
  ASSERT_FALSE(tp03().instructions.empty());
  for (const InstructionInfo &instruction : tp03().instructions) {
    Tp03Parsed parsed(instruction.example.str());
    EXPECT_EQ(parsed.messages(), "") << instruction.form.str();
    bool found = false;
    for (const Instruction &read : parsed.program.instructions)
      found = found || (!read.candidates.empty() && read.candidates.front()->spelling == instruction.spelling);
    EXPECT_TRUE(found) << instruction.form.str();
  }
}

}  // namespace
}  // namespace ladderc
