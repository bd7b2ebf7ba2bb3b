// Random bytes and random words parse without a crash into a program that can be walked. Seeds are fixed; a failure names its
// round.
#include "parsing.h"

#include <gtest/gtest.h>

#include <random>

namespace ladderc {
namespace {

void check(const std::string &list, ListFormat format, const FamilyInfo &family = qs()) {
  Parsed parsed(list, format, family);
  std::size_t next = 0;
  const std::size_t size = parsed.sources[0].text().size();
  for (const Instruction &instruction : parsed.program.instructions) {
    EXPECT_EQ(instruction.first_operand, next);
    next += instruction.operand_count;
    EXPECT_LE(instruction.operand_count, kMaxOperands);
    EXPECT_GT(instruction.range.length, 0u);
    EXPECT_LE(instruction.range.end(), size);
    EXPECT_TRUE(!instruction.candidates.empty() || !parsed.diagnostics.ok());
    for (const Operand &operand : parsed.program.operands_of(instruction)) {
      EXPECT_LE(operand.range.end(), size);
      EXPECT_TRUE(operand.kind != OperandKind::Invalid || !parsed.diagnostics.ok());
      EXPECT_TRUE(operand.device == kNoDevice || operand.device < family.devices.size());
    }
  }
  EXPECT_EQ(next, parsed.program.operands.size());
  std::uint32_t before = 0;
  for (const Comment &comment : parsed.program.comments) {
    EXPECT_GE(comment.instruction, before);
    EXPECT_LE(comment.instruction, parsed.program.instructions.size());
    before = comment.instruction;
  }
  EXPECT_EQ(parsed.rendered().empty(), parsed.diagnostics.errors() + parsed.diagnostics.warnings() == 0);
  EXPECT_EQ(parsed.ast().empty(), parsed.program.instructions.empty());
}

TEST(RandomLists, Bytes) {
  std::mt19937 random(1);
  for (unsigned round = 0; round < 3000; ++round) {
    SCOPED_TRACE(round);
    std::string bytes(random() % 200, '\0');
    for (char &c : bytes)
      c = static_cast<char>(round % 2 == 0 ? random() % 256 : 32 + random() % 64);
    check(decode(bytes).text, round % 3 == 0 ? ListFormat::GxCsv : ListFormat::Auto);
  }
}

TEST(RandomLists, WordsThatListsAreMadeOf) {
  static constexpr const char *kWords[] = {"LD",
                                           "AND",
                                           "=",
                                           "<=",
                                           "OUT",
                                           "BCD",
                                           "X0",
                                           "X1G",
                                           "D0.5",
                                           "K4X0",
                                           "K10",
                                           "H",
                                           "T0",
                                           "+",
                                           "/",
                                           "/P",
                                           "//",
                                           ";",
                                           "\n",
                                           "\n",
                                           ",",
                                           "\t",
                                           "\"",
                                           "D0Z1",
                                           "END",
                                           "12:",
                                           "ＬＤ",
                                           "≤",
                                           "手动",
                                           "E1.5",
                                           "K",
                                           "\r\n",
                                           "MPS",
                                           "OUTT",
                                           "K4",
                                           "D",
                                           ":",
                                           "K-5",
                                           "D0.",
                                           "ST0",
                                           "K4ST0",
                                           "CJ P0",
                                           "; ladderc: allow",
                                           "",
                                           "X",
                                           "\"ab\"",
                                           "M99999999999"};
  std::mt19937 random(2);
  for (unsigned round = 0; round < 6000; ++round) {
    SCOPED_TRACE(round);
    std::string list;
    for (unsigned n = random() % 40; n > 0; --n)
      (list += kWords[random() % std::size(kWords)]) += random() % 5 == 0 ? "" : " ";
    check(list, round % 4 == 0 ? ListFormat::GxCsv : ListFormat::Auto);
  }
}

TEST(RandomLists, WordsOfAFamilyWithBlanksInside) {
  static constexpr const char *kWords[] = {
      "LD",     "D",  "MOV", "P",    "F12",      "FNC",    "FD12P",  "(MOV)", "F00(CJ)", "S",      "20",  "K",       "-5",
      "H",      "FF", "Y",   "010",  "D20V0",    "K4M0Z0", "K0Z0M0", "P8",    "P8:",     "I001",   "ASC", "\"a b\"", "abc",
      "-drive", "--", "-",   "—",    "\n",       "\n",     ",",      "\t",    "OUT",     "I",      "NOT", "=",       "≠",
      "D4(D5)", "(",  ")",   "C200", "X0Z99999", "END",    "12:",    "F12(",  "DF",      "F99999", "STL", ";",       "\r\n"};
  std::mt19937 random(3);
  for (unsigned round = 0; round < 6000; ++round) {
    SCOPED_TRACE(round);
    std::string list;
    for (unsigned n = random() % 40; n > 0; --n)
      (list += kWords[random() % std::size(kWords)]) += random() % 5 == 0 ? "" : " ";
    check(list, round % 4 == 0 ? ListFormat::GxCsv : ListFormat::Auto, tp03());
  }
}

}  // namespace
}  // namespace ladderc
