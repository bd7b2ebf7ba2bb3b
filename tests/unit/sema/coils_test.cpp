// Devices that several instructions drive, and devices of the system.
#include "checking.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

TEST(Coils, TheSecondDriverIsPointedOut) {
  auto checked = check_text("LD X0\nOUT Y5\nLD X1\nOUT Y5\nEND\n");
  EXPECT_THAT(checked->messages(), are("4:5 double-coil"));
  EXPECT_TRUE(checked->program.ok);
  ASSERT_EQ(checked->diagnostics->sorted()[0].notes.size(), 1u);
  EXPECT_EQ(checked->sources.position(checked->diagnostics->sorted()[0].notes[0].range).line, 2u);
}

TEST(Coils, EveryFurtherDriverIsPointedOut) {
  EXPECT_THAT(messages_of("LD X0\nOUT M0\nOUT M0\nOUT M0"), are("3:5 double-coil", "4:5 double-coil"));
}

TEST(Coils, PulsesTimersCountersAndBitsOfWordsAreCoils) {
  EXPECT_THAT(messages_of("LD X0\nPLS M0\nLD X1\nPLF M0"), are("4:5 double-coil"));
  EXPECT_THAT(messages_of("LD X0\nOUT M0\nLD X1\nPLS M0"), are("4:5 double-coil"));
  EXPECT_THAT(messages_of("LD X0\nOUT T0 K1\nLD X1\nOUT T0 K2"), are("4:5 double-coil"));
  EXPECT_THAT(messages_of("LD X0\nOUT C0 K1\nLD X1\nOUT C0 K2"), are("4:5 double-coil"));
  EXPECT_THAT(messages_of("LD X0\nOUT F0\nLD X1\nPLS F0"), are("4:5 double-coil"));
  EXPECT_THAT(messages_of("LD X0\nOUT D0.A\nLD X1\nOUT D0.0A"), are("4:5 double-coil"));
  EXPECT_THAT(messages_of("LD X0\nOUT D0.A\nOUT D0.B\nOUT D1.A\nOUT T0 K1\nOUT C0 K1\nOUT Y0\nOUT M0"), no_messages());
}

TEST(Coils, SetAndResetAreNone) {
  EXPECT_THAT(messages_of("LD X0\nSET Y0\nLD X1\nRST Y0\nLD X2\nRST Y0\nFF Y0\nRST D5\nRST D5"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nOUT T0 K1\nLD X1\nRST T0\nLD X2\nOUT C0 K1\nRST C0"), no_messages());
}

TEST(Coils, TheDeviceOfAnMcIsNobodyElses) {
  EXPECT_THAT(messages_of("LD X0\nMC N0 M100\nLD X1\nOUT Y0\nMCR N0\nLD X2\nOUT M100"), are("7:5 mc-device-driven"));
  EXPECT_THAT(messages_of("LD X2\nOUT M100\nLD X0\nMC N0 M100\nMCR N0"), are("4:7 mc-device-driven"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M100\nMCR N0\nLD X2\nSET M100"), are("5:5 mc-device-driven"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M100\nMCR N0\nLD X2\nMC N0 M100\nMCR N0"), are("5:7 mc-device-driven"));
  EXPECT_THAT(messages_of("LD X0\nMC N0 M100\nMCR N0\nLD M100\nOUT Y0"), no_messages());
}

TEST(Coils, OneTimerOneSpeed) {
  EXPECT_THAT(messages_of("LD X0\nOUT T0 K1\nLD X1\nOUTH T0 K2"), are("4:6 timer-speed-mixed"));
}

TEST(Coils, EdgeRelaysAreUsedOnce) {
  EXPECT_THAT(messages_of("LD X0\nEGP V0\nOUT Y0\nLD X1\nEGF V0\nOUT Y1"), are("5:5 edge-relay-shared"));
  EXPECT_THAT(messages_of("LD X0\nEGP V0\nOUT Y0\nLD X1\nEGF V1\nOUT Y1"), no_messages());
}

TEST(Specials, WritesToWhatTheSystemSets) {
  EXPECT_THAT(messages_of("LD X0\nOUT SM400"), are("2:5 special-read-only"));
  EXPECT_THAT(messages_of("LD X0\nMOV K1 SD520"), are("2:8 special-read-only"));
  EXPECT_THAT(messages_of("LD X0\nRST SD0"), are("2:5 special-read-only"));
  EXPECT_THAT(messages_of("LD X0\nSET SD0.1"), are("2:5 special-read-only"));
  EXPECT_THAT(messages_of("LD X0\nMOV D0 K4SM402"), are("2:8 special-read-only"));
  EXPECT_THAT(messages_of("LD X0\nDMOV D0 SD419"), are("2:9 special-read-only"));
  EXPECT_THAT(messages_of("LD X0\nMOV K1 SD1003"), are("2:8 special-read-only"));
}

TEST(Specials, WhatTheProgramMayWrite) {
  EXPECT_THAT(messages_of("LD X3\nOUT SM50\nMOVP K9000 SD50\nOUT SM722\nMOV K5 SD414\nOUT SM2000\nMOV SD520 D0"), no_messages());
}

}  // namespace
}  // namespace ladderc::test
