// Coils and timers of states, and what a program may use a limited number of times.
#include "tp03.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

TEST(StateCoils, StatesActByTurns) {
  EXPECT_THAT(tp03("STL S0\nOUT Y0\nLD X0\nSET S20\nSTL S20\nOUT Y0\nRET"), no_messages());
  EXPECT_THAT(tp03("STL S0\nOUT Y0\nLD X0\nOUT Y0\nRET"), are("4:5 double-coil"));
  EXPECT_THAT(tp03("STL S0\nOUT Y0\nRET\nLD X0\nOUT Y0"), are("5:5 double-coil"));
  EXPECT_THAT(tp03("LD X0\nOUT Y0\nSTL S0\nOUT Y0\nRET"), are("4:5 double-coil"));
  EXPECT_THAT(tp03("STL S0\nOUT Y0\nSTL S20\nOUT Y1\nSTL S0\nOUT Y0\nRET"), are("6:5 double-coil"));
  EXPECT_THAT(tp03("STL S0\nSTL S20\nOUT Y0\nSTL S20\nOUT Y0\nRET"), are("5:5 double-coil"));
}

TEST(StateCoils, TransfersAreNoCoils) {
  EXPECT_THAT(tp03("STL S0\nLD X0\nOUT S20\nLD X1\nOUT S20\nSTL S20\nLD X2\nOUT S0\nRET"), no_messages());
  EXPECT_THAT(tp03("LD X0\nOUT S20\nLD X1\nOUT S20"), are("4:5 double-coil"));
  EXPECT_THAT(tp03("LD X0\nSET S20\nLD X1\nSET S20"), no_messages());
}

TEST(StateTimers, AreNotSharedByNeighbours) {
  EXPECT_THAT(tp03("STL S0\nOUT T0 K10\nLD T0\nSET S20\nSTL S20\nOUT T0 K20\nRET"), are("6:5 timer-in-adjacent-states"));
  EXPECT_THAT(tp03("STL S0\nOUT T0 K10\nLD T0\nSET S20\nSTL S20\nOUT T1 K20\nLD T1\nSET S21\nSTL S21\nOUT T0 K5\nRET"),
              no_messages());
  EXPECT_THAT(tp03_texts("STL S0\nOUT T0 K10\nLD T0\nSET S20\nSTL S20\nOUT T0 K20\nRET"),
              are("T0 is driven in S20, which a transfer enters from S0, where it is driven too"));
  EXPECT_THAT(tp03("STL S0\nOUT T0 K10\nLD T0\nSET S20\nSTL S20\nOUT T0 K20\nLD X0\nOUT S0\nRET"), testing::SizeIs(1));
}

TEST(Exclusive, InstructionsThatExistOnce) {
  EXPECT_THAT(tp03("LD X0\nTKY X20 D0 M10\nLD X1\nTKY X30 D2 M30"), are("4:1 max-uses"));
  EXPECT_THAT(tp03("LD X0\nTKY X20 D0 M10\nLD X1\nDTKY X30 D2 M30"), are("4:1 max-uses"));
  EXPECT_THAT(tp03_texts("LD X0\nDSW X20 Y20 D0 K1\nDSW X30 Y30 D2 K1\nDSW X40 Y40 D4 K1"),
              are("DSW stands here for the third time; a program may have two"));
}

TEST(Exclusive, EdgesAndPeriodsOfInterrupts) {
  EXPECT_THAT(tp03("FEND\nI100\nIRET\nI101\nIRET"), are("4:1 interrupt-twice"));
  EXPECT_THAT(tp03("FEND\nI610\nIRET\nI620\nIRET\nI710\nIRET"), are("4:1 interrupt-twice"));
  EXPECT_THAT(tp03("FEND\nI001\nIRET\nI100\nIRET\nI010\nIRET\nI020\nIRET"), no_messages());
}

TEST(Exclusive, FastInputs) {
  EXPECT_THAT(tp03("LD M8000\nOUT C235 K10\nOUT C241 K20"), are("3:1 terminal-shared"));
  EXPECT_THAT(tp03("LD M8000\nOUT C235 K10\nOUT C242 K20\nOUT C239 K1"), no_messages());
  EXPECT_THAT(tp03("LD M8000\nOUT C235 K10\nEI\nFEND\nI001\nIRET"), are("5:1 terminal-shared"));
  EXPECT_THAT(tp03("LD M8000\nSPD X0 K100 D0\nOUT C235 K10"), are("3:1 terminal-shared"));
  EXPECT_THAT(tp03("LD M8000\nDMOV C235 D0\nOUT C241 K20"), no_messages());
  EXPECT_THAT(tp03_texts("LD M8000\nOUT C235 K10\nOUT C241 K20"), are("C241 needs X0, which C235 has already"));
}

}  // namespace
}  // namespace ladderc::test
