// Device numbers, index registers and texts of a family whose classes share letters.
#include "tp03.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

const InstructionInfo *entry_of(const std::string &line) {
  auto checked = check_text("LD X0\n" + line + "\nEND\n", "{}", kTp03);
  EXPECT_THAT(checked->messages(), no_messages()) << line;
  return checked->program.list.instructions[1].info;
}

TEST(Numbers, TheNumberChoosesTheEntry) {
  EXPECT_EQ(entry_of("OUT T0 K1")->function, "on_delay_100ms");
  EXPECT_EQ(entry_of("OUT T199 K1")->function, "on_delay_100ms");
  EXPECT_EQ(entry_of("OUT T200 K1")->function, "on_delay_10ms");
  EXPECT_EQ(entry_of("OUT T246 D0")->function, "accumulate_1ms");
  EXPECT_EQ(entry_of("OUT T511 K1")->function, "on_delay_1ms");
  EXPECT_EQ(entry_of("OUT C0 K1")->operands[0].type, OperandType::Counter);
  EXPECT_EQ(entry_of("OUT C200 K-5")->operands[0].type, OperandType::LongCounter);
  EXPECT_EQ(entry_of("OUT M0")->steps, 1);
  EXPECT_EQ(entry_of("OUT M8034")->steps, 2);
}

TEST(Numbers, ThatDoNotExist) {
  EXPECT_THAT(tp03("LD M7680\nOUT Y0"), are("1:4 no-such-device"));
  EXPECT_THAT(tp03("LD M8512\nOUT Y0"), are("1:4 no-such-device"));
  EXPECT_THAT(tp03("LD X0\nOUT Y400"), are("2:5 no-such-device"));
  EXPECT_THAT(tp03("LD X0\nOUT C250 K1"), are("2:5 no-such-device"));
  EXPECT_THAT(tp03("LD X0\nMOV D8512 V16"), are("2:5 no-such-device", "2:11 no-such-device"));
  EXPECT_THAT(tp03_texts("LD M7680\nOUT Y0"), are("TP03H has no M7680; it has M0-M7679"));
}

TEST(Numbers, OfASmallerModel) {
  EXPECT_THAT(tp03("LD M1536\nOUT Y0", kTp03Sr), are("1:4 no-such-device"));
  EXPECT_THAT(tp03("LD X0\nOUT T39 K1\nOUT T196 K1\nOUT T255 K1", kTp03Sr), no_messages());
  EXPECT_THAT(tp03_texts("LD X0\nOUT T40 K1", kTp03Sr), are("TP03SR has no T40; it has T0-T39 and T196-T255"));
  EXPECT_THAT(tp03("LD X0\nOUT C219 K1\nOUT C220 K1\nOUT C100 K1", kTp03Sr), are("2:5 no-such-device", "4:5 no-such-device"));
}

TEST(Numbers, ThatAPositionTakes) {
  EXPECT_THAT(tp03("LD X0\nPLSY K100 K5 Y2"), are("2:14 operand-number"));
  EXPECT_THAT(tp03_texts("LD X0\nSTMR T200 K10 M0"), are("STMR takes T0-T199 as S, 'T200' stands there"));
}

TEST(Numbers, LongCountersAreNoWords) {
  EXPECT_THAT(tp03("LD X0\nMOV C200 D0"), are("2:5 long-counter-in-word"));
  EXPECT_THAT(tp03("LD= C200 K1\nOUT Y0"), are("1:5 long-counter-in-word"));
  EXPECT_THAT(tp03("LD X0\nDMOV C200 D0\nLD C200\nOUT Y0"), no_messages());
  EXPECT_THAT(tp03("LD X0\nOUT T0 C200"), are("2:8 set-value"));
}

TEST(Numbers, ClassesOfOneLetterAreToldApart) {
  EXPECT_THAT(tp03_texts("LD X0\nPLS M8034"), are("PLS takes Y or M0-M7679 as D, 'M8034' stands there"));
  EXPECT_THAT(tp03_texts("LD X0\nOUT X1"), testing::ElementsAre(testing::HasSubstr("takes Y, M")));
}

TEST(Numbers, RunsEndWithTheirClass) {
  EXPECT_THAT(tp03("LD X0\nDMOV K1 D7999"), are("2:9 runs-off-memory"));
  EXPECT_THAT(tp03("LD X0\nDMOV K1 D7998\nDMOV K1 C255"), are("3:9 no-such-device"));
  EXPECT_THAT(tp03("LD X0\nDMOV K1 C199\nDMOV K1 C254\nDMOV K1 Z15"), are("2:9 runs-off-memory"));
  EXPECT_THAT(tp03("LD X0\nDIV D0 D2 Z15"), no_messages());  // the remainder goes to V15
  EXPECT_THAT(tp03("LD X0\nCMP K1 D0 M7678"), are("2:11 runs-off-memory"));
  EXPECT_THAT(tp03("LD X0\nMOV K4M7668 K4Y361"), are("2:5 runs-off-memory", "2:13 runs-off-memory"));
  EXPECT_THAT(tp03("LD X0\nCMP K1 D0 M7677"), no_messages());
}

// ---------------------------------------------------------------------------------------------- index registers
TEST(Indexes, StandWhereTheManualMarksThem) {
  EXPECT_THAT(tp03("LD X0\nMOV D20V0 K4M0Z0\nMOV K30V15 C20Z0\nDMOV C200Z1 D0Z2\nDEC D0Z0"), no_messages());
  EXPECT_THAT(tp03("LD X0Z1\nOUT Y0Z0\nSET M0V0"), are("1:4 not-indexable", "2:5 not-indexable", "3:5 not-indexable"));
  EXPECT_THAT(tp03("LD X0\nMOV D0 V0Z0"), are("2:8 not-indexable"));
  EXPECT_THAT(tp03("LD M8002\nSET S0\nSTL S0Z0\nRET"), are("3:5 not-indexable"));
  EXPECT_THAT(tp03("LD= D0Z0 K1\nOUT Y0"), are("1:5 not-indexable"));
}

TEST(Indexes, Exist) {
  EXPECT_THAT(tp03("LD X0\nMOV D0V16 D1"), are("2:5 no-such-device"));
  EXPECT_THAT(tp03_texts("LD X0\nMOV D0Z16 D1"), are("TP03H has no Z16; it has Z0-Z15"));
}

TEST(Indexes, Of32BitInstructionsArePairs) {
  EXPECT_THAT(tp03_texts("LD X0\nDMOV D0V1 D10"), are("'D0V1' is modified by V1; DMOV has 32 bits, for which Z1 is written"));
  EXPECT_THAT(tp03("LD X0\nDMOV K5V1 D10Z1"), are("2:6 index-not-pair"));
}

TEST(Indexes, ShiftNumbersAndConstantsAtRunTime) {
  EXPECT_THAT(tp03("LD X0\nDMOV K1 D7999Z0\nMOV K32767V0 D0\nMOV K2M7679Z0 D0"), no_messages());
  EXPECT_THAT(tp03("LD X0\nMOV K1 D8512Z0"), are("2:8 no-such-device"));
}

// ---------------------------------------------------------------------------------------------- models, texts
TEST(Models, LackInstructions) {
  EXPECT_THAT(tp03("LD X0\nTADD D10 D20 D30", kTp03Sr), are("2:1 not-on-model"));
  EXPECT_THAT(tp03("LD X0\nTADD D10 D20 D30"), no_messages());
  EXPECT_THAT(tp03_texts("LD X0\nTADD D10 D20 D30", kTp03Sr), are("TP03SR has no TADD; TP03H and TP03M have it"));
}

TEST(Texts, HaveAPlaceAndACharacterSet) {
  EXPECT_THAT(tp03("LD X0\nASC ABCDEFGH D0\nASC \"a b\" D10"), no_messages());
  EXPECT_THAT(tp03("LD X0\nASC ABCDEFGHI D0"), are("2:5 text-length"));
  EXPECT_THAT(tp03("LD X0\nASC \"\" D0"), are("2:5 text-length"));
  EXPECT_THAT(tp03("LD X0\nASC 温度 D0"), are("2:5 text-character"));
}

// ---------------------------------------------------------------------------------------------- parameters
TEST(LatchedDefaults, OfTheModel) {
  const FamilyInfo &family = *find_family("tp03");
  auto ranges = [&](llvm::StringRef model, llvm::StringRef prefix, std::uint64_t number) {
    std::string text;
    for (const DeviceRange &range : default_parameters(family, model).latched)
      if (range.device == find_device(family, prefix, number))
        text += std::to_string(range.first) + "-" + std::to_string(range.last) + " ";
    return text;
  };
  EXPECT_EQ(ranges("TP03H", "M", 0), "500-7679 ");
  EXPECT_EQ(ranges("TP03SR", "M", 0), "500-1535 ");
  EXPECT_EQ(ranges("TP03H", "D", 0), "200-7999 ");
  EXPECT_EQ(ranges("TP03SR", "D", 0), "400-511 ");
  EXPECT_EQ(ranges("TP03H", "C", 200), "200-255 ");
  EXPECT_EQ(ranges("TP03SR", "C", 0), "90-99 ");
  EXPECT_EQ(ranges("TP03H", "D", 8000), "");
}

TEST(LatchedDefaults, AreAddedTo) {
  const FamilyInfo &family = *find_family("tp03");
  Parameters parameters = default_parameters(family, "TP03H");
  const std::size_t before = parameters.latched.size();
  EXPECT_FALSE(read_parameters(R"({"latched": ["M0-M99", "C200-C210"]})", family, parameters));
  ASSERT_EQ(parameters.latched.size(), before + 2);
  EXPECT_EQ(parameters.latched.back().first, 200u);
  EXPECT_EQ(family.devices[parameters.latched.back().device].kind, DeviceKind::LongCounter);
  EXPECT_TRUE(read_parameters(R"({"latched": ["M7680"]})", family, parameters));
  EXPECT_TRUE(read_parameters(R"({"latched": ["C190-C210"]})", family, parameters));
}

TEST(LatchedDefaults, ValuesOfLongCountersHave32Bits) {
  const FamilyInfo &family = *find_family("tp03");
  Parameters parameters = default_parameters(family, "TP03H");
  EXPECT_FALSE(read_parameters(R"({"latched": {"CN200": 70000, "CN0": 5, "D8010:d": 1}})", family, parameters));
  EXPECT_EQ(parameters.latched_values[0].value, 5);
  EXPECT_EQ(parameters.latched_values[1].value, 70000);
  EXPECT_TRUE(read_parameters(R"({"latched": {"CN0": 70000}})", family, parameters));
  EXPECT_TRUE(read_parameters(R"({"latched": {"D8511:d": 1}})", family, parameters));
}

}  // namespace
}  // namespace ladderc::test
