// Which table entry a line is, and whether its operands fit it.
#include "checking.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

const InstructionInfo *entry_of(std::string line, llvm::StringRef parameters = "{}") {
  auto checked = check_text("LD X0\n" + line + "\nEND\n", parameters);
  EXPECT_THAT(checked->messages(), no_messages()) << line;
  return checked->program.list.instructions[1].info;
}

TEST(Resolve, TheNumberOfOperandsChoosesTheEntry) {
  EXPECT_EQ(entry_of("+ D0 D1")->operands.size(), 2u);
  EXPECT_EQ(entry_of("+ D0 D1 D2")->operands.size(), 3u);
  EXPECT_EQ(entry_of("DXNRP D0 D2 D4")->operands.size(), 3u);
}

TEST(Resolve, TheDeviceChoosesTheEntry) {
  EXPECT_EQ(entry_of("OUT Y0")->form, "OUT");
  EXPECT_EQ(entry_of("OUT T0 K1")->form, "OUT T");
  EXPECT_EQ(entry_of("OUTH T0 K1")->form, "OUTH T");
  EXPECT_EQ(entry_of("OUT C0 K1")->form, "OUT C");
  EXPECT_EQ(entry_of("OUT F0")->form, "OUT F");
  EXPECT_EQ(entry_of("SET F0")->form, "SET F");
  EXPECT_EQ(entry_of("RST F0")->form, "RST F");
  EXPECT_EQ(entry_of("OUT ST0 K1", R"({"ST_points": 1})")->operands[0].type, OperandType::Timer);
  EXPECT_EQ(entry_of("RST D0")->operands[0].type, OperandType::Word);
  EXPECT_EQ(entry_of("RST D0.0")->operands[0].type, OperandType::Bit);
  EXPECT_EQ(entry_of("RST T0")->operands[0].type, OperandType::Timer);
  EXPECT_EQ(entry_of("RST C0")->operands[0].type, OperandType::Counter);
}

TEST(Resolve, CountsOfOperands) {
  EXPECT_THAT(messages_of("LD\nOUT Y0"), are("1:1 operand-count"));
  EXPECT_THAT(messages_of("LD X0\nMOV D0"), are("2:1 operand-count"));
  EXPECT_THAT(messages_of("LD X0\nINC D0 D1"), are("2:1 operand-count"));
  EXPECT_THAT(messages_of("LD X0\nMC N0\nMCR N0"), are("2:1 operand-count"));
  auto checked = check_text("LD X0\n+ D0\nEND\n");
  EXPECT_THAT(checked->texts(), are("+ has one operand here; it is written + S D or + S1 S2 D"));
}

TEST(Resolve, ATimerWithoutSetValueIsMeantAsTimer) {
  EXPECT_THAT(messages_of("LD X0\nOUT T0"), are("2:1 operand-count"));
  EXPECT_THAT(messages_of("LD X0\nOUT C0"), are("2:1 operand-count"));
  EXPECT_THAT(messages_of("LD X0\nOUT Y0 K5"), are("2:1 operand-count"));
}

TEST(Resolve, ClassesOfOperands) {
  EXPECT_THAT(messages_of("LD X0\nEGP M0\nOUT Y0"), are("2:5 operand-class"));
  EXPECT_THAT(messages_of("LD X0\nBMOV K5 D0 K2"), are("2:6 operand-class"));
  EXPECT_THAT(messages_of("LD K5\nOUT Y0"), are("1:4 operand-class"));
  EXPECT_THAT(messages_of("LD V0\nOUT Y0"), are("1:4 operand-class"));
  EXPECT_THAT(messages_of("LD X0\nOUT V0"), are("2:5 operand-class"));
  EXPECT_THAT(messages_of("LD X0\nMOV N0 D0"), are("2:5 operand-class"));
  EXPECT_THAT(messages_of("LD X0\nMOV D0.5 D0"), are("2:5 operand-class"));
  EXPECT_THAT(messages_of("LD X0\nMC K0 M0\nMCR N0"), are("2:4 operand-class"));
  EXPECT_THAT(messages_of("LD K4X0\nOUT Y0"), are("1:4 operand-class"));
}

TEST(Resolve, TheMessageTellsWhatMayStandThere) {
  auto checked = check_text("LD X0\nOUT V0\nEND\n");
  EXPECT_THAT(checked->texts(), are("OUT takes X, Y, M, B, F, SB, SM, Dn.b, Wn.b, SWn.b or SDn.b as D, 'V0' stands there"));
}

TEST(Resolve, ConstantsAsDestination) {
  EXPECT_THAT(messages_of("LD X0\nMOV D0 K5"), are("2:8 constant-destination"));
  EXPECT_THAT(messages_of("LD X0\n+ D0 D1 H5"), are("2:9 constant-destination"));
  EXPECT_THAT(messages_of("LD X0\nINC K5"), are("2:5 constant-destination"));
  EXPECT_THAT(messages_of("LD X0\nOUT K5"), are("2:5 constant-destination"));
}

TEST(Resolve, SetValues) {
  EXPECT_THAT(messages_of("LD X0\nOUT T0 T1"), are("2:8 set-value"));
  EXPECT_THAT(messages_of("LD X0\nOUTH T0 C1"), are("2:9 set-value"));
  EXPECT_THAT(messages_of("LD X0\nOUT C0 X1"), are("2:8 set-value"));
  EXPECT_THAT(messages_of("LD X0\nOUT C0 K4X0"), are("2:8 set-value"));
  EXPECT_THAT(messages_of("LD X0\nOUT T0 H0FF"), are("2:8 hex-constant"));
  EXPECT_THAT(messages_of("LD X0\nOUT T0 K-1"), are("2:8 constant-range"));
  EXPECT_THAT(messages_of("LD X0\nOUT C0 K-5"), are("2:8 constant-range"));
  EXPECT_THAT(messages_of("LD X0\nOUT T0 K32768"), are("2:8 constant-range"));
  EXPECT_THAT(messages_of("LD X0\nOUT T0 K32767\nOUT T1 K0\nOUTH T2 D5\nOUT C0 W1F"), no_messages());
}

TEST(Resolve, TimersAndCountersAreNoPlainBits) {
  for (const char *line : {"PLS C0", "PLF T0", "FF T0", "SET T0", "SET C0"})
    EXPECT_THAT(messages_of(std::string("LD X0\n") + line)[0], testing::EndsWith(" timer-counter-output")) << line;
  EXPECT_THAT(messages_of("LD X0\nMC N0 T0\nMCR N0"), are("2:7 timer-counter-output"));
  EXPECT_THAT(messages_of("LD T0\nAND C0\nOUT Y0"), no_messages());
}

TEST(Resolve, BitsOfWords) {
  EXPECT_THAT(messages_of("LD T0.5\nOUT Y0"), are("1:4 timer-counter-bit"));
  EXPECT_THAT(messages_of("LD X0\nOUT C0.1"), are("2:5 timer-counter-bit"));
  EXPECT_THAT(messages_of("LD D0.5\nANI W1F.A\nOR SD0.0B\nOUT SW0.F"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nFF D0"), are("2:4 word-for-bit"));
  EXPECT_THAT(messages_of("LD D0\nOUT Y0"), are("1:4 word-for-bit"));
  EXPECT_THAT(messages_of("LD X0\nMOV X0 D0"), are("2:5 bit-for-word"));
  EXPECT_THAT(messages_of("LD X0\nDMOV D0 Y0"), are("2:9 bit-for-word"));
}

TEST(Resolve, IndexRegistersDoNotExist) {
  EXPECT_THAT(messages_of("LD X0\nMOV D0Z1 D1"), are("2:5 index-register"));
  EXPECT_THAT(messages_of("LD X0\nMOV K4X0Z1 D1"), are("2:5 index-register"));
  EXPECT_THAT(messages_of("LD X0\nMOV X0Z1 D1"), are("2:5 index-register"));
}

TEST(Resolve, EveryBadOperandOfALineIsReported) {
  EXPECT_THAT(messages_of("LD X0\nMOV X1 K5"), are("2:5 bit-for-word", "2:8 constant-destination"));
  EXPECT_THAT(messages_of("LD X0\nMOV K40000 D9999"), are("2:5 constant-range", "2:12 device-out-of-range"));
}

TEST(Operands, DeviceNumbers) {
  EXPECT_THAT(messages_of("LD X0\nMOV K1 D6143"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nMOV K1 D6144"), are("2:8 device-out-of-range"));
  EXPECT_THAT(messages_of("LD X17FF\nOUT Y1800"), are("2:5 device-out-of-range"));
  EXPECT_THAT(messages_of("LD X0\nMOV K1 D8191", R"({"device_points": {"D": 8192}})"), no_messages());
  EXPECT_THAT(messages_of("LD M100\nOUT Y0", R"({"device_points": {"M": 100}})"), are("1:4 device-out-of-range"));
  EXPECT_THAT(messages_of("LD D6144.0\nOUT Y0"), are("1:4 device-out-of-range"));
  EXPECT_THAT(messages_of("LD X0\nMOV K4X1800 D0"), are("2:5 device-out-of-range"));
  EXPECT_THAT(messages_of("LD X0\nMOV K4X4294967295 D0").size(), 1u);
}

TEST(Operands, RetentiveTimersHaveToBeAllocated) {
  EXPECT_THAT(messages_of("LD X0\nOUT ST0 K10"), are("2:5 device-not-allocated"));
  EXPECT_THAT(messages_of("LD X0\nOUT ST0 K10\nLD ST15\nOUT Y0\nLD X1\nRST ST0", R"({"ST_points": 16})"), no_messages());
  EXPECT_THAT(messages_of("LD ST16\nOUT Y0", R"({"device_points": {"ST": 16}})"), are("1:4 device-out-of-range"));
}

TEST(Operands, Digits) {
  EXPECT_THAT(messages_of("LD X0\nMOV K4X0 D0\nMOV K1X5 K3Y7"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nMOV K5X0 D0"), are("2:5 digit-count"));
  EXPECT_THAT(messages_of("LD X0\nMOV K0X0 D0"), are("2:5 digit-count"));
  EXPECT_THAT(messages_of("LD X0\nDMOV K8X0 K5M0"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nDMOV K9X0 D0"), are("2:6 digit-count"));
  EXPECT_THAT(messages_of("LD X0\n* K-1 K2 K8Y20"), no_messages());
  EXPECT_THAT(messages_of("LD X0\n* K5X0 K2 D0"), are("2:3 digit-count"));
  EXPECT_THAT(messages_of("LD X0\nBMOV K5X0 D0 K1"), are("2:6 digit-count"));
}

TEST(Operands, BlocksOfDigitsAreOfOneSize) {
  EXPECT_THAT(messages_of("LD X0\nBMOV K1X0 K2Y0 K2"), are("2:11 digits-unequal"));
  EXPECT_THAT(messages_of("LD X0\nBMOV K2X0 K2Y0 K2\nBMOV D0 K1Y0 K2\nBMOV K3X0 D0 K2"), no_messages());
}

TEST(Operands, Constants16) {
  EXPECT_THAT(messages_of("LD X0\nMOV K-32768 D0\nMOV K32767 D0\nMOV H0 D0\nMOV HFFFF D0"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nMOV K32768 D0"), are("2:5 constant-range"));
  EXPECT_THAT(messages_of("LD X0\nMOV K-32769 D0"), are("2:5 constant-range"));
  EXPECT_THAT(messages_of("LD X0\nMOV H10000 D0"), are("2:5 constant-range"));
  EXPECT_THAT(messages_of("LD= K32768 D0\nOUT Y0"), are("1:5 constant-range"));
}

TEST(Operands, Constants32) {
  EXPECT_THAT(messages_of("LD X0\nDMOV K-2147483648 D0\nDMOV K2147483647 D0\nDMOV H0FFFFFFFF D0"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nDMOV K2147483648 D0"), are("2:6 constant-range"));
  EXPECT_THAT(messages_of("LD X0\nDMOV K-2147483649 D0"), are("2:6 constant-range"));
  EXPECT_THAT(messages_of("LD X0\nDMOV H100000000 D0"), are("2:6 constant-range"));
}

TEST(Operands, LengthsOfBlocksAreNotNegative) {
  EXPECT_THAT(messages_of("LD X0\nFMOV K7 D100 K0"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nFMOV K7 D100 K-1"), are("2:14 constant-range"));
  EXPECT_THAT(messages_of("LD X0\nFMOV K7 D100 H8000"), are("2:14 constant-range"));
  EXPECT_THAT(messages_of("PAGE K1\nLD X0\nOUT Y0"), no_messages());
}

TEST(Operands, PairsOverTheEndOfADevice) {
  EXPECT_THAT(messages_of("LD X0\nDMOV K1 D6142"), no_messages());
  auto checked = check_text("LD X0\nDMOV K65537 D6143\nEND\n");
  EXPECT_THAT(checked->messages(), are("2:13 crosses-device-end"));
  EXPECT_THAT(checked->texts(), are("'D6143' is 2 words long: it goes on behind D6143 with W0"));
  EXPECT_TRUE(checked->program.ok);
  EXPECT_THAT(messages_of("LD X0\nD* D0 D2 D6141"), are("2:10 crosses-device-end"));
  EXPECT_THAT(messages_of("LD X0\n/ D0 D2 D6143"), are("2:9 crosses-device-end"));
  EXPECT_THAT(messages_of("LD X0\nDMOV T511 D0"), are("2:6 crosses-device-end"));
}

TEST(Operands, DigitsOverTheEndOfADevice) {
  EXPECT_THAT(messages_of("LD X0\nMOV K4X17F0 D0"), no_messages());
  auto checked = check_text("LD X0\nMOV K4X17F1 D0\nEND\n");
  EXPECT_THAT(checked->messages(), are("2:5 crosses-device-end"));
  EXPECT_THAT(checked->texts(), are("'K4X17F1' is 16 bits long: it goes on behind X17FF with Y0"));
}

TEST(Operands, RunsThatHaveNowhereToGo) {
  EXPECT_THAT(messages_of("LD X0\nDMOV K1 SD5119")[0], "2:9 runs-off-memory");
  EXPECT_THAT(messages_of("LD X0\nMOV K4SB5F8 D0", R"({"device_points": {"V": 0}})"), are("2:5 runs-off-memory"));
}

TEST(Operands, BlocksBeyondTheEnd) {
  EXPECT_THAT(messages_of("LD X0\nFMOVP K1 D6142 K2"), no_messages());
  EXPECT_THAT(messages_of("LD X0\nFMOVP K1 D6142 K3"), are("2:10 block-beyond-end"));
  EXPECT_THAT(messages_of("LD X0\nBMOV D6142 D0 K3"), are("2:6 block-beyond-end"));
  EXPECT_THAT(messages_of("LD X0\nFMOV D0 K4Y17E0 K3"), are("2:9 block-beyond-end"));
  EXPECT_THAT(messages_of("LD X0\nFMOV D0 K4Y17F8 K1"), are("2:9 block-beyond-end"));
  EXPECT_THAT(messages_of("LD X0\nFMOV D0 K4Y17E0 K2\nFMOV D0 D6143 D1"), no_messages());
}

TEST(Operands, MessagesNameStepAndRung) {
  auto checked = check_text("LD X0\nOUT Y0\nLD X1\nMOV K1 D6144\nEND\n");
  ASSERT_EQ(checked->diagnostics->errors(), 1u);
  EXPECT_EQ(checked->diagnostics->sorted()[0].step, 3);
  EXPECT_EQ(checked->diagnostics->sorted()[0].rung, 2);
  EXPECT_FALSE(checked->program.ok);
}

TEST(Operands, UnreadableOperandsHaveTheirMessageAlready) {
  EXPECT_THAT(messages_of("LD X0\nMOV D0 %").size(), 1u);
  EXPECT_THAT(messages_of("LD XG\nOUT Y0").size(), 1u);
}

}  // namespace
}  // namespace ladderc::test
