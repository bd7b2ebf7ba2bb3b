// Step numbers.
#include "checking.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

/// Steps of one instruction behind LD X0.
unsigned steps_of(std::string line, llvm::StringRef parameters = R"({"ST_points": 8})") {
  auto checked = check_text("LD X0\n" + line + "\nEND\n", parameters);
  EXPECT_TRUE(checked->program.ok) << line;
  return checked->program.steps - 2;
}

TEST(Steps, OfBitInstructions) {
  EXPECT_EQ(steps_of("OUT Y0"), 1u);
  EXPECT_EQ(steps_of("OUT D0.5"), 1u);
  EXPECT_EQ(steps_of("OUT F0"), 2u);
  EXPECT_EQ(steps_of("OUT T0 K1"), 4u);
  EXPECT_EQ(steps_of("OUTH ST0 D0"), 4u);
  EXPECT_EQ(steps_of("OUT C0 K1"), 4u);
  EXPECT_EQ(steps_of("SET M0"), 1u);
  EXPECT_EQ(steps_of("SET F1"), 2u);
  EXPECT_EQ(steps_of("RST M0"), 1u);
  EXPECT_EQ(steps_of("RST D5"), 2u);
  EXPECT_EQ(steps_of("RST C0"), 4u);
  EXPECT_EQ(steps_of("PLS M0"), 2u);
  EXPECT_EQ(steps_of("FF M0"), 2u);
  EXPECT_EQ(steps_of("MC N0 M0\nMCR N0"), 3u);
  EXPECT_EQ(steps_of("EGP V0\nOUT Y0"), 2u);
  EXPECT_EQ(steps_of("EGF V0\nOUT Y0"), 3u);
  EXPECT_EQ(steps_of("INV\nMPS\nOUT Y0\nMPP\nOUT Y1"), 5u);
}

TEST(Steps, OfMoves) {
  EXPECT_EQ(steps_of("MOV D0 D1"), 2u);
  EXPECT_EQ(steps_of("MOV K5 W0"), 2u);
  EXPECT_EQ(steps_of("MOV T0 D1"), 2u);
  EXPECT_EQ(steps_of("MOV K4X10 D1"), 2u);
  EXPECT_EQ(steps_of("MOV K4X11 D1"), 3u);
  EXPECT_EQ(steps_of("MOV K3X10 D1"), 3u);
  EXPECT_EQ(steps_of("CMLP D0 K4Y0"), 2u);
  EXPECT_EQ(steps_of("DMOV D0 D2"), 3u);
  EXPECT_EQ(steps_of("DMOV K100000 D0"), 4u);
}

TEST(Steps, OfCalculations) {
  EXPECT_EQ(steps_of("+ D0 D1"), 3u);
  EXPECT_EQ(steps_of("+ K1 D1 D2"), 4u);
  EXPECT_EQ(steps_of("D+ D0 D2"), 3u);
  EXPECT_EQ(steps_of("D+ K1 D2"), 4u);
  EXPECT_EQ(steps_of("D* K1 K2 D2"), 6u);
  EXPECT_EQ(steps_of("AND= K1 D2\nOUT Y0"), 4u);
  EXPECT_EQ(steps_of("ANDD= K1 D2\nOUT Y0"), 5u);
  EXPECT_EQ(steps_of("INC D0"), 2u);
  EXPECT_EQ(steps_of("BMOV D0 D10 K5"), 4u);
  EXPECT_EQ(steps_of("S.QSABORT D0"), 7u);
  EXPECT_EQ(steps_of("S.QSABORT K7"), 8u);
}

TEST(Steps, AddUp) {
  auto checked = check_text("LD SM400\nDMOV K100000 D0\nLD X0\nS.QSABORT K7\nEND\n");
  const std::vector<Instruction> &list = checked->program.list.instructions;
  EXPECT_EQ(list[0].step, 0u);
  EXPECT_EQ(list[1].step, 1u);
  EXPECT_EQ(list[2].step, 5u);
  EXPECT_EQ(list[3].step, 6u);
  EXPECT_EQ(checked->program.steps, 15u);
}

}  // namespace
}  // namespace ladderc::test
