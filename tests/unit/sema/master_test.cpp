// Master control regions.
#include "checking.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

TEST(Master, RegionsNestAscending) {
  EXPECT_THAT(messages_of("LD X0\nMC N0 M0\nLD X1\nMC N1 M1\nLD X2\nOUT Y0\nMCR N1\nMCR N0"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nMC N0 M0\nLD X1\nMC N5 D0.3\nLD X2\nOUT Y0\nMCR N0"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nMC N0 M0\nMCR N0\nLD X1\nMC N0 M1\nMCR N0"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nMC N14 M0\nMCR N14"), no_messages());
}

TEST(Master, LevelsHaveARange) {
  EXPECT_THAT(messages_of("LD X0\nMC N15 M100\nLD X1\nOUT Y10\nMCR N15"), are("2:4 level-range"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M100\nLD X1\nOUT Y10\nMCR N15"), are("5:5 level-range"));
}

TEST(Master, InnerLevelsAreHigher) {
  EXPECT_THAT(messages_of("LD X0\nMC N1 M0\nLD X1\nMC N0 M1\nMCR N0\nMCR N1"), are("4:4 level-order"));
  EXPECT_THAT(messages_of("LD X0\nMC N1 M0\nLD X1\nMC N1 M1\nMCR N1\nMCR N1"), are("4:4 level-order"));
}

TEST(Master, RegionsAreClosed) {
  EXPECT_THAT(messages_of("LD X0\nMC N0 M0\nLD X1\nOUT Y0"), are("2:1 mc-without-mcr"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M0\nLD X1\nMC N1 M1\nMCR N1"), are("2:1 mc-without-mcr"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M0\nLD X1\nMC N1 M1\nLD X1\nOUT Y0"), are("2:1 mc-without-mcr", "4:1 mc-without-mcr"));
}

TEST(Master, RegionsAreOpened) {
  EXPECT_THAT(messages_of("LD X0\nOUT Y10\nMCR N0"), are("3:1 mcr-without-mc"));
  EXPECT_THAT(messages_of("MCR N0"), are("1:1 mcr-without-mc"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M0\nMCR N0\nMCR N0"), are("4:1 mcr-without-mc"));
  EXPECT_THAT(messages_of("LD X0\nMC N1 M0\nLD X1\nMC N2 M1\nMCR N1\nMCR N2"), are("6:1 mcr-without-mc"));
}

TEST(Master, AMismatchIsOneError) {
  EXPECT_THAT(messages_of("LD X0\nMC N0 M0\nLD X1\nOUT Y0\nMCR N1"), are("5:1 mcr-without-mc"));
  EXPECT_THAT(messages_of("LD X0\nMC N1 M0\nLD X1\nOUT Y0\nMCR N0"), are("5:1 mcr-without-mc"));
}

TEST(Master, ConsequencesOfOtherErrorsAreSilent) {
  EXPECT_THAT(messages_of("LD X0\nMCC N0 M0\nMCR N0"), are("2:1 unknown-mnemonic"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M0\nLD X1\nOUT Y0\nMRC N0"), are("5:1 unknown-mnemonic"));
  EXPECT_THAT(messages_of("LD X0\nMC M0 M0\nMCR N0"), are("2:4 operand-class"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M0\nMCR M0"), are("3:5 operand-class"));
}

TEST(Master, NoContactBeforeMcr) {
  EXPECT_THAT(messages_of("LD X0\nMC N0 M100\nLD X1\nOUT Y10\nLD X2\nMCR N0"), are("6:1 mcr-after-contact"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M100\nLD X1\nOUT Y10\nAND X2\nMCR N0"), are("6:1 mcr-after-contact"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M100\nLD X1\nMPS\nAND X2\nOUT Y10\nMCR N0"), are("4:1 mps-without-mpp"));
}

}  // namespace
}  // namespace ladderc::test
