// What lies inside of what: routines, loops, states, ranges.
#include "tp03.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

// ---------------------------------------------------------------------------------------------- routines
TEST(Routines, LieBehindTheMainProgram) {
  EXPECT_THAT(tp03("I001\nLD X0\nOUT Y0\nIRET"), are("1:1 routine-in-main"));
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nLD X1\nOUT Y0\nSRET\nP2\nLD X2\nOUT Y1\nFEND"),
              testing::Contains("4:1 routine-in-main"));
  EXPECT_THAT(tp03("LD X0\nOUT Y0\nSRET"), are("3:1 return-in-main"));
  EXPECT_THAT(tp03("LD X0\nOUT Y0\nIRET"), are("3:1 interrupt-not-begun"));
}

TEST(Routines, HaveTheirEnds) {
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nLD X1\nOUT Y0"), are("4:1 subroutine-not-ended"));
  EXPECT_THAT(tp03("FEND\nI001\nLD X1\nOUT Y1"), are("2:1 interrupt-not-ended"));
  EXPECT_THAT(tp03("FEND\nI001\nLD X1\nOUT Y1\nI101\nLD X1\nOUT Y2\nIRET"), are("2:1 interrupt-not-ended"));
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nLD X1\nOUT Y0\nI001\nLD X1\nOUT Y1\nIRET"), are("4:1 subroutine-not-ended"));
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nLD X1\nOUT Y0\nIRET\nSRET"), are("7:1 in-routine"));
}

TEST(Routines, OneMayGoOnInTheNext) {
  EXPECT_THAT(tp03("LD X0\nCALL P1\nCALL P2\nFEND\nP1\nLD X1\nOUT Y0\nP2\nLD X2\nOUT Y1\nSRET"), no_messages());
}

TEST(Routines, HoldNoOtherEnds) {
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nLD M8000\nINC D0\nFEND\nSRET"), are("7:1 end-in-routine"));
  EXPECT_THAT(tp03("LD X0\nCALL P0\nFEND\nP0\nSTL S20\nOUT Y0\nRET\nSRET"), are("5:1 in-routine"));
  EXPECT_THAT(tp03("LD X0\nCALL P0\nFEND\nP0\nLD X1\nMC N0 M0\nLD X2\nOUT Y0\nMCR N0\nSRET"), are("6:1 in-routine"));
  EXPECT_THAT(tp03("LD X0\nCALL P0\nFEND\nP0\nLD X1\nSMCS\nLD X2\nOUT Y0\nSMCR\nFOR K2\nNEXT\nSRET"), no_messages());
}

TEST(Routines, WhatNothingReaches) {
  EXPECT_THAT(tp03("LD X0\nOUT Y0\nFEND\nLD X1\nOUT Y1"), are("4:1 unreachable"));
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nLD X1\nOUT Y0\nSRET\nLD X1\nOUT Y1\nLD X2\nOUT Y2"), are("8:1 unreachable"));
  EXPECT_THAT(tp03("LD X0\nOUT Y0\nFEND\nNOP"), no_messages());
}

// ---------------------------------------------------------------------------------------------- loops
TEST(Loops, PairAndNest) {
  EXPECT_THAT(tp03("FOR K2\nFOR D0Z0\nLD X0\nINC D0\nNEXT\nNEXT"), no_messages());
  EXPECT_THAT(tp03("FOR K2\nLD X0\nINC D0"), are("1:1 loop-not-closed"));
  EXPECT_THAT(tp03("LD X0\nINC D0\nNEXT"), are("3:1 loop-not-open"));
  EXPECT_THAT(tp03("FOR K2\nLD X0\nINC D0\nFEND\nP1\nLD X1\nOUT Y0\nSRET"), testing::Contains("1:1 loop-not-closed"));
  EXPECT_THAT(tp03(numbered("FOR K{}\n", 1, 16) + "LD X0\nINC D0\n" + numbered("NEXT\nNOP\n", 1, 16)), no_messages());
  EXPECT_THAT(tp03(numbered("FOR K{}\n", 1, 18) + "LD X0\nINC D0\n" + numbered("NEXT\nNOP\n", 1, 18)), are("17:1 loop-too-deep"));
}

TEST(Loops, BehindTheEndOfTheMainProgramAreClosed) {
  EXPECT_THAT(tp03("FEND\nFOR K2\nP2\nNOP\nSRET"), testing::Contains("2:1 loop-not-closed"));
}

TEST(Loops, HoldNoRegionsAndNoEnds) {
  EXPECT_THAT(tp03("FOR K2\nLD M8000\nINC D0\nFEND\nNEXT"), are("4:1 in-loop"));
  EXPECT_THAT(tp03("FOR K3\nLD X0\nMC N0 M100\nLD X1\nOUT Y0\nMCR N0\nNEXT"), are("3:1 in-loop"));
  EXPECT_THAT(tp03("FOR K2\nSTL S20\nOUT Y0\nRET\nNEXT"), are("2:1 in-loop"));
  EXPECT_THAT(tp03("LD X0\nMC N0 M0\nFOR K2\nLD X1\nINC D0\nMCR N0\nNEXT"), are("6:1 ranges-cross"));
  EXPECT_THAT(tp03("LD X0\nMC N0 M0\nFOR K2\nLD X1\nINC D0\nNEXT\nMCR N0"), no_messages());
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nFOR K2\nSRET\nNEXT\nSRET"), are("6:1 in-loop"));
}

// ---------------------------------------------------------------------------------------------- master control
TEST(MasterRegions, LieOnOneSideOfFend) {
  EXPECT_THAT(tp03("LD X0\nMC N0 M100\nLD X1\nOUT Y0\nFEND\nMCR N0"), are("5:1 in-master"));
  EXPECT_THAT(tp03("LD X0\nMC N0 M100\nLD X1\nOUT Y0\nFEND"), are("2:1 mc-without-mcr"));
  EXPECT_THAT(tp03("LD X0\nSMCS\nLD X1\nOUT Y0\nFEND\nSMCR"), are("5:1 in-master"));
}

TEST(MasterRegions, ALevelInTheWrongOrderIsOneError) {
  EXPECT_THAT(tp03("LD X0\nMC N0 M100\nLD X1\nMC N1 M101\nLD X2\nMC N0 M102\nLD X3\nOUT Y0\nMCR N0\nMCR N1\nMCR N0"),
              are("6:4 level-order"));
}

// ---------------------------------------------------------------------------------------------- SMCS, JCS
TEST(Buses, PairAndAddUp) {
  EXPECT_THAT(tp03("LD X0\nSMCS\nLD X1\nSMCS\nLD X2\nOUT Y0\nSMCR"), no_messages());
  EXPECT_THAT(tp03("LD X0\nSMCS\nLD X1\nOUT Y0"), are("2:1 bus-not-closed"));
  EXPECT_THAT(tp03("LD X1\nOUT Y0\nSMCR"), are("3:1 bus-not-open"));
  EXPECT_THAT(tp03("FOR K2\nLD X0\nSMCS\nLD X1\nINC D0\nNEXT\nSMCR"), are("3:1 bus-not-closed"));
}

TEST(Buses, BeginARungBehindThem) {
  EXPECT_THAT(tp03("LD X0\nSMCS\nOUT Y0\nSMCR"), are("3:1 contact-expected"));
  EXPECT_THAT(tp03("LD X0\nSMCS\nAND X1\nOUT Y0\nSMCR"), are("3:1 contact-expected"));
  EXPECT_THAT(tp03("LD X0\nSMCS\nMOV K1 D0\nSMCR"), are("3:1 contact-expected"));
  EXPECT_THAT(tp03("LD X0\nJCS\nOUT Y0\nJCR"), are("3:1 contact-expected"));
  EXPECT_THAT(tp03("LD X0\nSMCS\nP1\nSMCR\nLD X1\nCJ P1"), are("6:4 jump-crosses-master"));
}

TEST(Skips, PairInOneScope) {
  EXPECT_THAT(tp03("LD X0\nJCS\nLD X1\nJCS\nLD X2\nOUT Y0\nJCR"), no_messages());
  EXPECT_THAT(tp03("LD X0\nJCS\nLD X1\nOUT Y0"), are("2:1 skip-not-closed"));
  EXPECT_THAT(tp03("LD X1\nOUT Y0\nJCR"), are("3:1 skip-not-open"));
  EXPECT_THAT(tp03("LD X0\nJCS\nFOR K2\nLD X1\nINC D0\nJCR\nNEXT"), are("6:1 ranges-cross"));
  EXPECT_THAT(tp03("LD X0\nJCS\nSTL S0\nLD X1\nOUT Y0\nJCR\nRET"), are("6:1 ranges-cross"));
  EXPECT_THAT(tp03("LD X0\nJCS\nSTL S0\nOUT Y0\nRET\nJCR"), no_messages());
}

// ---------------------------------------------------------------------------------------------- step ladder
TEST(StateRanges, GoUpToTheNextOrToRet) {
  EXPECT_THAT(tp03("LD M8002\nSET S0\nSTL S0\nLD X0\nSET S20\nSTL S20\nOUT Y0\nRET\nLD X1\nOUT Y1"), no_messages());
  EXPECT_THAT(tp03("LD M8002\nSET S0\nSTL S0\nLD X0\nSET S20\nSTL S20\nOUT Y0"), are("6:1 state-not-closed"));
  EXPECT_THAT(tp03("LD X1\nOUT Y1\nRET"), are("3:1 state-not-open"));
  EXPECT_THAT(tp03("STL S0\nOUT Y0\nFEND"), are("1:1 state-not-closed"));
}

TEST(StateRanges, HoldNoRegionsAndNoEnds) {
  EXPECT_THAT(tp03("STL S0\nLD X0\nMC N0 M100\nLD X1\nOUT Y0\nMCR N0\nRET"), are("3:1 in-state"));
  EXPECT_THAT(tp03("STL S0\nLD X0\nSMCS\nLD X1\nOUT Y0\nSMCR\nRET"), are("3:1 in-state"));
  EXPECT_THAT(tp03("STL S0\nLD X0\nOUT Y0\nSRET\nRET"), are("4:1 in-state"));
  EXPECT_THAT(tp03("STL S0\nLD X0\nOUT Y0\nFEND\nRET"), are("4:1 routine-in-state"));
  EXPECT_THAT(tp03("LD X0\nMC N0 M0\nSTL S0\nLD X1\nOUT Y0\nMCR N0\nRET"), are("6:1 in-state"));
  EXPECT_THAT(tp03("LD X0\nMC N0 M0\nSTL S0\nLD X1\nOUT Y0\nRET\nMCR N0"), no_messages());
  EXPECT_THAT(tp03("STL S0\nFOR K2\nLD X0\nINC D0\nNEXT\nRET"), no_messages());
  EXPECT_THAT(tp03("STL S0\nFOR K2\nLD X0\nINC D0\nRET\nNEXT"), are("5:1 in-loop"));
  EXPECT_THAT(tp03("STL S0\nFOR K2\nLD X0\nINC D0\nSTL S20\nOUT Y0\nNEXT\nRET"), testing::Contains("5:1 in-loop"));
}

TEST(StateRanges, MergeUpToTen) {
  auto merge = [](int n) { return numbered("STL S{}\n", 20, 19 + n) + "LD X0\nSET S50\nSTL S50\nOUT Y0\nRET"; };
  EXPECT_THAT(tp03(merge(8)), no_messages());
  EXPECT_THAT(tp03(merge(10)), are("9:1 merge-wide"));
  EXPECT_THAT(tp03(merge(12)), are("9:1 merge-wide", "11:1 merge-too-wide"));
}

TEST(StateRanges, OutputsAtTheirHeadNeedNoContact) {
  EXPECT_THAT(tp03("STL S20\nOUT Y10\nOUT T0 K10\nMOV K1 D0\nLD X10\nOR X11\nOUT Y11\nOUT Y12\nLD X0\nANI X1\nSET S21\nRET"),
              no_messages());
  EXPECT_THAT(tp03("STL S20\nSET S21\nRET"), no_messages());
  EXPECT_THAT(tp03("STL S20\nMPS\nAND X0\nOUT Y0\nMPP\nOUT Y1\nRET"), are("2:1 needs-condition"));
  EXPECT_THAT(tp03("STL S20\nAND X0\nOUT Y0\nRET"), are("2:1 no-open-block"));
  EXPECT_THAT(tp03("STL S20\nOUT Y0\nAND X0\nOUT Y1\nRET"), are("3:1 no-open-block"));
  EXPECT_THAT(tp03("STL S20\nOUT Y0\nRET\nOUT Y1"), are("4:1 needs-condition"));
  EXPECT_THAT(tp03("STL S20\nLD X0\nOUT Y0\nFOR K2\nOUT Y1\nNEXT\nRET"), are("5:1 needs-condition"));
}

TEST(StateRanges, HaveRungsOfTheirOwn) {
  auto checked =
      check_text("LD X0\nSET S0\nSTL S0\nOUT Y0\nOUT Y1\nLD X1\nSET S20\nP1\nSTL S20\nFOR K1\nNEXT\nRET\nEND\n", "{}", kTp03);
  std::vector<unsigned> rungs;
  for (const Instruction &i : checked->program.list.instructions)
    rungs.push_back(i.rung);
  EXPECT_EQ(rungs, (std::vector<unsigned>{1, 1, 2, 3, 3, 4, 4, 5, 6, 7, 8, 9, 10}));
}

TEST(BranchDepth, TheEighthIsDoubtful) {
  auto branches = [](int n) {
    return "LD X0\n" + numbered("MPS\nAND M{}\n", 1, n) + "OUT Y0\n" + numbered("MPP\nOUT Y{}\n", 1, n);
  };
  EXPECT_THAT(tp03(branches(7)), no_messages());
  EXPECT_THAT(tp03("LD X0\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nOUT Y0\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nOUT Y1"),
              are("9:1 branch-deep"));
}

}  // namespace
}  // namespace ladderc::test
