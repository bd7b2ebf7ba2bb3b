// Where instructions begin and which operands are theirs.
#include "parsing.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

/// The AST of a list that parses without a message.
std::string ast(std::string list) {
  Parsed parsed(std::move(list));
  EXPECT_EQ(parsed.messages(), "");
  return parsed.ast();
}

TEST(Parser, OneInstructionALine) {
  EXPECT_EQ(ast("LD X1F\nOUT T0 K10\nMOV K4X10 D0\nLD D0.5\nMOV HFF D1\nEND\n"), "1: LD | device X 1F\n"
                                                                                 "2: OUT | device T 0 | decimal 10\n"
                                                                                 "3: MOV | 4 digits from X 10 | device D 0\n"
                                                                                 "4: LD | bit 5 of D 0\n"
                                                                                 "5: MOV | hexadecimal FF | device D 1\n"
                                                                                 "6: END\n");
}

TEST(Parser, AWholeListOnOneLine) {
  EXPECT_EQ(ast("LD X0 OR Y0 ANI X1 OUT Y0 LD X2 OUT T0 K10 MPS AND X3 MPP + D0 D1 - D0 D1 D2 END"),
            "1: LD | device X 0\n"
            "1: OR | device Y 0\n"
            "1: ANI | device X 1\n"
            "1: OUT | device Y 0\n"
            "1: LD | device X 2\n"
            "1: OUT | device T 0 | decimal 10\n"
            "1: MPS\n"
            "1: AND | device X 3\n"
            "1: MPP\n"
            "1: + | device D 0 | device D 1\n"
            "1: - | device D 0 | device D 1 | device D 2\n"
            "1: END\n");
}

TEST(Parser, OperandsOnFollowingLines) {
  EXPECT_EQ(ast("OUT T0\nK10\n+\nD0\nD1 D2\nLD\nX0 OUT Y0\n"), "1: OUT | device T 0 | decimal 10\n"
                                                               "3: + | device D 0 | device D 1 | device D 2\n"
                                                               "6: LD | device X 0\n"
                                                               "7: OUT | device Y 0\n");
}

TEST(Parser, ComparisonsWithABlank) {
  EXPECT_EQ(ast("LD = D0 K5\nLD= D0 K5\nAND <= K1 D0 ORD <> D0 D2\nLD ≥ D0 D1\n"), "1: LD= | device D 0 | decimal 5\n"
                                                                                   "2: LD= | device D 0 | decimal 5\n"
                                                                                   "3: AND<= | decimal 1 | device D 0\n"
                                                                                   "3: ORD<> | device D 0 | device D 2\n"
                                                                                   "4: LD>= | device D 0 | device D 1\n");
  Parsed parsed("LD  =  D0 K5\n");
  EXPECT_EQ(parsed.sources.text(parsed.program.instructions[0].range), "LD  =");
}

TEST(Parser, AMnemonicThatReadsAsADevice) {
  EXPECT_EQ(ast("LD BCD\nBCD D0 D1\nLD X0 BCD D0 D1\nLD\nBCD D0 D1\n"), "1: LD | device B CD\n"
                                                                        "2: BCD | device D 0 | device D 1\n"
                                                                        "3: LD | device X 0\n"
                                                                        "3: BCD | device D 0 | device D 1\n"
                                                                        "4: LD\n"
                                                                        "5: BCD | device D 0 | device D 1\n");
}

TEST(Parser, InATableTheCellDecides) {
  EXPECT_EQ(ast("0,,LD,BCD,,,\n1,,BCD,BCD,,,\n,,,BCD,,,\n"), "1: LD | device B CD\n2: BCD | device B CD | device B CD\n");
  Parsed parsed("0,,LD,X0,,,\n1,,OUT,T0,,,\n,,,K10,,,\n2,,P10,,,,\n3,,END,,,,\n");
  EXPECT_EQ(parsed.ast(), "1: LD | device X 0\n2: OUT | device T 0 | decimal 10\n4: unknown P10\n5: END\n");
  EXPECT_EQ(parsed.messages(), "4:4 unknown-mnemonic\n");
}

TEST(Parser, TooManyOperandsOnTheLineAreLeftToSema) {
  EXPECT_EQ(ast("LD X0 X1 X2\n"), "1: LD | device X 0 | device X 1 | device X 2\n");
}

TEST(Parser, CommentsFindTheirInstructions) {
  Parsed parsed("; motor\nLD X0 ; start\n; coil\nOUT T0 ; timer\nK10 ; preset\n; the end\n");
  std::string text;
  for (const Comment &comment : parsed.program.comments)
    text += std::to_string(comment.instruction) + (comment.kind == CommentKind::Statement ? "[" : " ") +
            parsed.sources.text(comment.range).str() + "\n";
  EXPECT_EQ(text, "0[motor\n0 start\n1[coil\n1 timer\n1 preset\n2[the end\n");
}

TEST(Parser, CommentsStayInTheOrderOfTheirInstructions) {
  Parsed parsed("OUT T0\n; between\nK10 ; preset\nLD X0\n");
  ASSERT_EQ(parsed.program.comments.size(), 2u);
  EXPECT_EQ(parsed.sources.text(parsed.program.comments[0].range), "preset");
  EXPECT_EQ(parsed.program.comments[0].instruction, 0u);
  EXPECT_EQ(parsed.sources.text(parsed.program.comments[1].range), "between");
  EXPECT_EQ(parsed.program.comments[1].instruction, 1u);
}

TEST(Parser, StatementsAndNotesOfTables) {
  Parsed parsed("0,motor,,,,,\n0,,LD,X0,,,\n1,,OUT,Y0,,,\n,,,,,,lamp\n2,,END,,,,\n");
  ASSERT_EQ(parsed.program.comments.size(), 2u);
  EXPECT_EQ(parsed.program.comments[0].kind, CommentKind::Statement);
  EXPECT_EQ(parsed.program.comments[0].instruction, 0u);
  EXPECT_EQ(parsed.program.comments[1].kind, CommentKind::Note);
  EXPECT_EQ(parsed.program.comments[1].instruction, 1u);
  EXPECT_EQ(parsed.sources.text(parsed.program.comments[1].range), "lamp");
}

TEST(Parser, AnEmptyListHasAnEnd) {
  Parsed parsed("\n; nothing\n");
  EXPECT_TRUE(parsed.program.instructions.empty());
  EXPECT_EQ(parsed.program.end_of_text.begin, 11u);
  EXPECT_EQ(parsed.program.family, &qs());
}

TEST(Parser, EveryExampleOfTheTablesParses) {
  ASSERT_FALSE(qs().instructions.empty());
  for (const InstructionInfo &instruction : qs().instructions) {
    Parsed parsed(instruction.example.str());
    EXPECT_EQ(parsed.messages(), "") << instruction.form.str();
    bool found = false;
    for (const Instruction &read : parsed.program.instructions)
      found = found || (!read.candidates.empty() && read.candidates.front()->spelling == instruction.spelling);
    EXPECT_TRUE(found) << instruction.form.str();
  }
}

}  // namespace
}  // namespace ladderc
