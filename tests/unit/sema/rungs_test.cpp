// Rungs, blocks and branches.
#include "checking.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

std::vector<unsigned> rungs_of(std::string list) {
  auto checked = check_text(std::move(list));
  std::vector<unsigned> rungs;
  for (const Instruction &i : checked->program.list.instructions)
    rungs.push_back(i.rung);
  return rungs;
}

std::string repeat(const char *line, int times) {
  std::string text;
  for (int i = 0; i < times; ++i)
    text += line;
  return text;
}

TEST(Rungs, AnLdBehindAnOutputBeginsARung) {
  EXPECT_EQ(rungs_of("LD X0\nOUT Y0\nLD X1\nAND X2\nOUT Y1\nEND\n"), (std::vector<unsigned>{1, 1, 2, 2, 2, 3}));
  EXPECT_EQ(check_text("LD X0\nOUT Y0\nEND\n")->program.rungs, 2u);
}

TEST(Rungs, AContactBehindAnOutputGoesOn) {
  EXPECT_EQ(rungs_of("LD X5\nAND X6\nOUT Y35\nAND X7\nOUT Y36\nEND\n"), (std::vector<unsigned>{1, 1, 1, 1, 1, 2}));
  EXPECT_THAT(messages_of("LD X5\nOUT Y35\nAND X7\nLD X8\nOR X9\nANB\nOUT Y36"), no_messages());
}

TEST(Rungs, BranchesHoldARungTogether) {
  const char *list =
      "LD X0\nMPS\nAND X1\nOUT Y0\nMRD\nLD X2\nOR X3\nANB\nOUT Y1\nMPP\nLD X4\nOR X5\nANB\nOUT Y2\nLD X6\nOUT Y3\nEND\n";
  EXPECT_EQ(rungs_of(list), (std::vector<unsigned>{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 3}));
  EXPECT_THAT(check_text(list)->messages(), no_messages());
}

TEST(Rungs, ABlockBehindAnOutputOfAnOpenBranchBelongsToIt) {
  EXPECT_THAT(messages_of("LD X0\nMPS\nAND X1\nOUT Y0\nLD X2\nOR X3\nANB\nOUT Y1\nMPP\nOUT Y2"), no_messages());
}

TEST(Rungs, ABlockBehindAnOutputGoesOnWithAnb) {
  const char *list = "LD X0\nOUT Y0\nLD X1\nOR X2\nANB\nOUT Y1\nLD X3\nOR X4\nANB\nOUT Y2\nLD X5\nOUT Y3\nEND\n";
  EXPECT_THAT(check_text(list)->messages(), no_messages());
  EXPECT_EQ(rungs_of(list), (std::vector<unsigned>{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 3}));
  EXPECT_THAT(messages_of("LD X0\nMPS\nAND X1\nOUT Y0\nMPP\nAND X7\nOUT Y2\nLD X10\nOR X11\nANB\nOUT Y3"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nOUT Y0\nNOPLF\nLD X1\nOR X2\nANB\nOUT Y1"), are("3:1 noplf-in-rung"));
  EXPECT_THAT(messages_of("LD X0\nOUT Y0\nLD X1\nANB\nOUT Y1"), are("4:1 join-without-blocks"));
  EXPECT_THAT(messages_of("LD X0\nOUT Y0\nLD X1\nOR X2\nORB\nOUT Y1"), are("5:1 join-without-blocks"));
  EXPECT_THAT(messages_of("LD X0\nOUT Y0\nLD X1\nOR X2\nANB\nANB\nOUT Y1"), are("6:1 join-without-blocks"));
  EXPECT_THAT(messages_of("LD X0\nOUT Y0\nLD X1\nOUT Y1\nOR X2\nANB\nOUT Y2"), are("6:1 join-without-blocks"));
}

TEST(Rungs, NopsBelongToTheRungTheyStandIn) {
  EXPECT_EQ(rungs_of("NOP\nLD X0\nNOP\nOUT Y0\nNOP\nLD X1\nOUT Y1\nEND\n"), (std::vector<unsigned>{1, 1, 1, 1, 1, 2, 2, 3}));
}

TEST(Rungs, BlocksAreJoined) {
  EXPECT_THAT(messages_of("LD X0\nAND X1\nLDI X2\nAND X3\nORB\nOUT Y10\nLD X4\nOR X5\nLD X6\nOR X7\nANB\nOUT Y11"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nLD X1\nLD X2\nORB\nANB\nOUT Y0"), no_messages());
  EXPECT_THAT(messages_of("LD M3\nLD> K100 D3\nOR M8\nANB\nOUT Y33"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nINV\nMEP\nEGP V0\nOUT Y0"), no_messages());
}

TEST(Rungs, ContactsNeedAnOpenBlock) {
  EXPECT_THAT(messages_of("AND X0\nOUT Y0"), are("1:1 no-open-block"));
  EXPECT_THAT(messages_of("OR X0\nOUT Y0"), are("1:1 no-open-block"));
  EXPECT_THAT(messages_of("AND= D0 D1\nOUT Y0"), are("1:1 no-open-block"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M0\nLD X1\nOUT Y0\nMCR N0\nANI X2\nOUT Y1"), are("6:1 no-open-block"));
}

TEST(Rungs, OutputsAndOperationsOnTheResultNeedACondition) {
  for (const char *line : {"INV", "MEP", "MEF", "EGP V0", "EGF V0", "MPS\nMPP"})
    EXPECT_THAT(messages_of(std::string(line) + "\nOUT Y10"), are("1:1 needs-condition")) << line;
  for (const char *line : {"OUT Y0", "MOV K1 D0", "SET Y0", "MC N0 M0\nMCR N0"})
    EXPECT_THAT(messages_of(line), are("1:1 needs-condition")) << line;
}

TEST(Rungs, JoinsNeedTwoBlocks) {
  EXPECT_THAT(messages_of("LD X0\nANB\nOUT Y0"), are("2:1 join-without-blocks"));
  EXPECT_THAT(messages_of("ORB\nOUT Y0"), are("1:1 join-without-blocks"));
  EXPECT_THAT(messages_of("LD X0\nOUT Y0\nLD X1\nORB\nOUT Y1"), are("4:1 join-without-blocks"));
}

TEST(Rungs, BlocksThatAreNotJoined) {
  EXPECT_THAT(messages_of("LD X0\nLD X1\nOUT Y0"), are("2:1 block-not-joined"));
  EXPECT_THAT(messages_of("LD X0\nLD X1\nLD X2\nANB\nOUT Y0"), are("2:1 block-not-joined"));
  EXPECT_THAT(messages_of("LD X0\nOUT Y0\nAND X1\nLD X2\nOUT Y2"), are("4:1 block-not-joined"));
  EXPECT_THAT(messages_of("LD X0\nMPS\nLD X1\nOUT Y0\nMPP\nOUT Y1"), are("3:1 block-not-joined"));
  EXPECT_THAT(messages_of("LD X0\nMPS\nLD X1\nMPP\nOUT Y1"), are("3:1 block-not-joined"));
}

TEST(Rungs, ResultsThatNothingUses) {
  EXPECT_THAT(messages_of("LD X0\nAND X1"), are("1:1 rung-without-output"));
  EXPECT_THAT(messages_of("LD X0\nOUT Y0\nAND X1"), are("3:1 rung-without-output"));
  EXPECT_THAT(messages_of("LD X0\nLD X1"), are("1:1 rung-without-output"));
}

TEST(Rungs, OneErrorARungAndAllRungs) {
  EXPECT_THAT(messages_of("LD X0\nANB\nORB\nMPP\nOUT Y0\nLD X1\nLD X2\nOUT Y1\nLD X3\nMRD\nOUT Y2"),
              are("2:1 join-without-blocks", "7:1 block-not-joined", "10:1 no-open-branch"));
}

TEST(Rungs, UnknownInstructionsSilenceTheirRung) {
  EXPECT_THAT(messages_of("LDX X0\nAND X1\nOUT Y0"), are("1:1 unknown-mnemonic"));
  EXPECT_THAT(messages_of("LD X0\nLDX X1\nANB\nOUT Y0"), are("2:1 unknown-mnemonic"));
  EXPECT_THAT(messages_of("LDX X0\nLD X1\nANB\nOUT Y0"), are("1:1 unknown-mnemonic"));
  EXPECT_THAT(messages_of("LD X0\nMPQ\nAND X1\nOUT Y0\nMPP\nOUT Y1\nLD X2\nORB\nOUT Y2"),
              are("2:1 unknown-mnemonic", "8:1 join-without-blocks"));
  EXPECT_THAT(messages_of("LD X0\nMPS\nAND X1\nOUT Y0\nMPQ\nOUT Y1\nLD X2\nOUT Y2"), are("5:1 unknown-mnemonic"));
}

TEST(Branches, SixteenAreKept) {
  EXPECT_THAT(messages_of("LD X0\n" + repeat("MPS\n", 16) + "OUT Y0\n" + repeat("MPP\n", 16) + "OUT Y1"), no_messages());
  EXPECT_THAT(messages_of("LD X0\n" + repeat("MPS\n", 17) + "OUT Y0\n" + repeat("MPP\n", 17) + "OUT Y1"),
              are("18:1 branch-too-deep"));
  EXPECT_THAT(messages_of("LD X0\n" + repeat("MPS\nMPP\n", 40) + "OUT Y0"), no_messages());
}

TEST(Branches, NotTakenBack) {
  EXPECT_THAT(messages_of("LD X0\nMPS\nAND X1\nOUT Y10"), are("2:1 mps-without-mpp"));
  EXPECT_THAT(messages_of("LD X0\nMPS\nAND X1\nMPS\nAND X2\nOUT Y0\nMPP\nAND X3\nOUT Y1"), are("2:1 mps-without-mpp"));
  EXPECT_THAT(messages_of("LD X0\nMPS\nAND X1\nOUT Y10\nMRD\nOUT Y11"), are("2:1 mps-without-mpp"));
}

TEST(Branches, NotTakenBackBeforeTheNextRung) {
  EXPECT_THAT(messages_of("LD X0\nMPS\nAND X1\nOUT Y10\nLD X2\nOUT Y11\nLD X3\nLD X4\nOUT Y12"),
              are("2:1 mps-without-mpp", "8:1 block-not-joined"));
  EXPECT_THAT(messages_of("LD X0\nMPS\nOUT Y0\nLD X1\nMPS\nOUT Y1\nMPP\nOUT Y2\nLD X3\nOUT Y3"), are("2:1 mps-without-mpp"));
  EXPECT_THAT(messages_of("LD X0\nMPS\nOUT Y0\nLD X1\nLD X2\nOUT Y1"), are("2:1 mps-without-mpp", "5:1 block-not-joined"));
  EXPECT_THAT(messages_of("LD X0\nMPS\nOUT Y0\nLD X1"), are("2:1 mps-without-mpp", "4:1 rung-without-output"));
  EXPECT_EQ(rungs_of("LD X0\nMPS\nOUT Y0\nLD X1\nOUT Y1\nLD X2\nOUT Y2\nEND\n"), (std::vector<unsigned>{1, 1, 1, 2, 2, 3, 3, 4}));
}

TEST(Branches, ReadWithoutAny) {
  EXPECT_THAT(messages_of("LD X0\nMRD\nOUT Y0"), are("2:1 no-open-branch"));
  EXPECT_THAT(messages_of("MPP\nOUT Y0"), are("1:1 no-open-branch"));
  auto checked = check_text("LD X0\nMPS\nOUT Y0\nMPP\nOUT Y1\nMPP\nOUT Y2\nEND\n");
  EXPECT_THAT(checked->messages(), are("6:1 no-open-branch"));
  ASSERT_EQ(checked->diagnostics->sorted()[0].notes.size(), 1u);
  EXPECT_EQ(checked->sources.position(checked->diagnostics->sorted()[0].notes[0].range).line, 4u);
}

TEST(PageFeed, StandsBetweenRungs) {
  EXPECT_THAT(messages_of("NOPLF\nLD X0\nOUT Y0\nNOPLF\nPAGE K1\nLD X1\nOUT Y1\nNOPLF"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nNOPLF\nAND X1\nOUT Y0"), are("2:1 noplf-in-rung"));
  EXPECT_THAT(messages_of("LD X0\nOUT Y0\nNOPLF\nAND X1\nOUT Y1"), are("3:1 noplf-in-rung"));
  EXPECT_THAT(messages_of("LD X0\nMPS\nOUT Y0\nNOPLF\nMPP\nOUT Y1"), are("4:1 noplf-in-rung"));
}

}  // namespace
}  // namespace ladderc::test
