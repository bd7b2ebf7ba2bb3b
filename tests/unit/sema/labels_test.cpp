// Labels, jumps and calls.
#include "tp03.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

TEST(LabelPlaces, OnceEach) {
  EXPECT_THAT(tp03("LD X0\nCJ P8\nLD X1\nOUT Y1\nP8\nLD X2\nOUT Y2"), no_messages());
  EXPECT_THAT(tp03("LD X0\nCJ P8\nP8\nLD X2\nOUT Y2\nP8"), are("6:1 label-twice"));
  EXPECT_THAT(tp03("EI\nFEND\nI001\nIRET\nI001\nIRET"), are("5:1 label-twice"));
}

TEST(LabelPlaces, MustBeThere) {
  EXPECT_THAT(tp03("LD X0\nCJ P8\nLD X1\nOUT Y1"), are("2:4 label-undefined"));
  EXPECT_THAT(tp03("LD X0\nCALL P8\nLD X1\nOUT Y1"), are("2:6 label-undefined"));
  EXPECT_THAT(tp03("LD X0\nOUT C235 K10\nDHSCS K100 C235 I010\nFEND"), are("3:17 label-undefined"));
  EXPECT_THAT(tp03("LD X0\nOUT C235 K10\nDHSCS K100 C235 I010\nEI\nFEND\nI010\nLD M8000\nOUT Y0\nIRET"), no_messages());
}

TEST(LabelPlaces, ANumberThatDoesNotExistIsOneError) {
  EXPECT_THAT(tp03("LD X0\nCJ P256\nP256"), are("2:4 no-such-label"));
  EXPECT_THAT(tp03("LD X0\nCJ P128\nP128", kTp03Sr), are("2:4 no-such-label"));
  EXPECT_THAT(tp03("EI\nFEND\nI605\nLD M8000\nOUT Y0\nIRET"), are("3:1 no-such-interrupt"));
  EXPECT_THAT(tp03("EI\nFEND\nI401\nLD M8000\nOUT Y0\nIRET", kTp03Sr), are("3:1 no-such-interrupt"));
}

TEST(LabelPlaces, TheLabelOfEnd) {
  EXPECT_THAT(tp03("LD X0\nCJ P63\nLD X1\nOUT Y0"), no_messages());
  EXPECT_THAT(tp03("LD X0\nCJ P63\nP63"), are("3:1 end-label"));
  EXPECT_THAT(tp03("LD X0\nCALL P63\nFEND"), are("2:6 end-label"));
}

TEST(LabelPlaces, UnusedOnes) {
  EXPECT_THAT(tp03("LD X0\nOUT Y0\nP5\nLD X1\nOUT Y1"), are("3:1 label-unused"));
  EXPECT_THAT(tp03("LD X0\nCJ P0Z0\nP5\nLD X1\nOUT Y1"), no_messages());
  EXPECT_THAT(tp03("FEND\nP5\nLD X1\nOUT Y1\nSRET"), are("2:1 label-unused"));
}

TEST(Jumps, StayInTheirRoutineAndState) {
  EXPECT_THAT(tp03("LD X0\nCJ P1\nFEND\nP2\nP1\nSRET\nLD X1"), testing::Not(no_messages()));
  EXPECT_THAT(tp03("LD X0\nCALL P1\nCJ P2\nFEND\nP1\nLD X1\nOUT Y0\nP2\nLD X2\nOUT Y1\nSRET"), are("3:4 jump-not-followed"));
  EXPECT_THAT(tp03("LD X0\nCALL P1\nP2\nFEND\nP1\nLD X1\nCJ P2\nSRET"), are("7:4 jump-not-followed"));
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nLD X1\nCJ P2\nLD X3\nOUT Y0\nP2\nLD X2\nOUT Y1\nSRET"), no_messages());
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nLD X1\nCJ P63\nSRET"), are("6:4 jump-not-followed"));
  EXPECT_THAT(tp03("LD M8002\nSET S0\nSTL S0\nLD X0\nCJ P1\nSTL S20\nP1\nRET"), are("5:4 jump-not-followed"));
  EXPECT_THAT(tp03("LD M8002\nSET S0\nLD X0\nCJ P1\nSTL S0\nP1\nRET"), are("4:4 jump-not-followed"));
  EXPECT_THAT(tp03("LD X0\nCJ P1\nSTL S0\nOUT Y0\nRET\nP1\nLD X1\nOUT Y1"), no_messages());
}

TEST(Jumps, LeaveLoopsButDoNotEnterThem) {
  EXPECT_THAT(tp03("FOR K3\nLD X0\nCJ P1\nLD X1\nINC D0\nNEXT\nP1"), no_messages());
  EXPECT_THAT(tp03("P1\nFOR K3\nFOR K3\nLD X0\nCJ P1\nNEXT\nNEXT"), no_messages());
  EXPECT_THAT(tp03("LD X0\nCJ P1\nFOR K3\nLD X1\nINC D0\nP1\nNEXT"), are("2:4 jump-not-followed"));
  EXPECT_THAT(tp03("LD X0\nCJ P63\nFOR K2\nLD X1\nCJ P63\nNEXT"), no_messages());
}

TEST(Jumps, TextsSayWhatIsCrossed) {
  EXPECT_THAT(tp03_texts("LD X0\nCJ P1\nFOR K3\nP1\nNEXT"), are("the jump to P1 enters the loop; it cannot be compiled"));
  EXPECT_THAT(tp03_texts("LD M8002\nSET S0\nSTL S0\nLD X0\nCJ P1\nRET\nP1"),
              are("the jump to P1 leaves the state S0; it cannot be compiled"));
}

TEST(Jumps, BehindFendBelongToTheMainProgram) {
  EXPECT_THAT(
      tp03("LD X0\nCJ P1\nLD X1\nOUT Y0\nFEND\nP1\nLD X2\nOUT Y1\nFEND\nP2\nLD X3\nOUT Y2\nSRET\nI001\nLD X4\nCALL P2\nIRET"),
      no_messages());
  EXPECT_THAT(tp03("LD X0\nCJ P1\nCALL P2\nFEND\nP2\nLD X3\nOUT Y2\nSRET\nP1\nLD X2\nOUT Y1"), are("2:4 jump-not-followed"));
}

TEST(Jumps, OverTheBorderOfAMasterRegion) {
  EXPECT_THAT(tp03("LD X0\nCJ P1\nLD X1\nMC N0 M0\nP1\nLD X2\nOUT Y0\nMCR N0"), are("2:4 jump-crosses-master"));
  EXPECT_THAT(tp03("LD X1\nMC N0 M0\nLD X0\nCJ P1\nMCR N0\nP1"), are("4:4 jump-crosses-master"));
  EXPECT_THAT(tp03("LD X0\nCJ P1\nLD X1\nSMCS\nP1\nLD X2\nOUT Y0\nSMCR"), are("2:4 jump-crosses-master"));
  EXPECT_THAT(tp03("LD X1\nMC N0 M0\nLD X0\nCJ P1\nP1\nLD X2\nOUT Y0\nMCR N0"), no_messages());
  EXPECT_THAT(tp03("LD X0\nCJ P1\nLD X1\nJCS\nP1\nLD X2\nOUT Y0\nJCR"), no_messages());
}

TEST(Calls, GoToSubroutines) {
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nLD X1\nOUT Y0\nSRET"), no_messages());
  EXPECT_THAT(tp03("LD X0\nCALL P1\nP1\nLD X1\nOUT Y0\nSRET"), are("3:1 routine-in-main"));
  EXPECT_THAT(tp03("LD X0\nCALL P10\nLD X1\nCJ P10\nFEND\nP10\nLD X2\nOUT Y0\nSRET"), are("4:4 label-jump-and-call"));
}

TEST(Calls, NestSixteenDeep) {
  auto calls = [](int n) {
    std::string text = "LD X0\nCALL P0\nFEND\n";
    for (int k = 0; k < n; ++k)
      text += "P" + std::to_string(k) + "\nLD X0\n" + (k + 1 < n ? "CALL P" + std::to_string(k + 1) : std::string("OUT Y0")) +
              "\nSRET\n";
    return text;
  };
  EXPECT_THAT(tp03(calls(16)), no_messages());
  EXPECT_THAT(tp03(calls(17)), are("66:1 call-too-deep"));
  EXPECT_THAT(tp03(calls(19)), are("66:1 call-too-deep"));
}

TEST(Calls, DoNotComeBack) {
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nLD X1\nCALL P1\nSRET"), are("6:6 call-recursive"));
  EXPECT_THAT(tp03("LD X0\nCALL P1\nFEND\nP1\nLD X1\nCALL P2\nSRET\nP2\nLD X1\nCALL P1\nSRET"), are("10:6 call-recursive"));
  EXPECT_THAT(tp03("LD X0\nCALL P1\nCALL P2\nFEND\nP1\nLD X1\nCALL P3\nSRET\nP2\nLD X1\nCALL P3\nSRET\nP3\nLD X1\nOUT Y0\nSRET"),
              no_messages());
}

}  // namespace
}  // namespace ladderc::test
