// Looking things up in the tables.
#include "tables/tables.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"

using namespace ladderc;

namespace {

const FamilyInfo &qs() {
  return *find_family("melsec-qs");
}

TEST(Lookup, FamiliesAreInAlphabeticalOrder) {
  ASSERT_FALSE(families().empty());
  for (std::size_t i = 1; i < families().size(); ++i)
    EXPECT_LT(families()[i - 1].id, families()[i].id);
}

TEST(Lookup, FindsAFamilyByItsId) {
  ASSERT_NE(find_family("melsec-qs"), nullptr);
  EXPECT_EQ(find_family("melsec-qs")->id, "melsec-qs");
  EXPECT_EQ(find_family("MELSEC-QS"), nullptr);
  EXPECT_EQ(find_family(""), nullptr);
}

TEST(Lookup, EveryDeviceIsFoundByItsPrefix) {
  for (const FamilyInfo &family : families())
    for (std::size_t id = 0; id < family.devices.size(); ++id)
      EXPECT_EQ(find_device(family, family.devices[id].prefix), id);
}

TEST(Lookup, AnUnknownPrefixIsNoDevice) {
  EXPECT_EQ(find_device(qs(), "Z"), kNoDevice);
  EXPECT_EQ(find_device(qs(), "x"), kNoDevice);
  EXPECT_EQ(find_device(qs(), ""), kNoDevice);
  EXPECT_EQ(find_device(qs(), "K"), kNoDevice);
}

TEST(Lookup, EverySpellingAndAliasFindsItsEntry) {
  for (const FamilyInfo &family : families())
    for (const InstructionInfo &info : family.instructions) {
      EXPECT_THAT(find_instructions(family, info.spelling), testing::Contains(&info)) << info.form.str();
      for (llvm::StringRef alias : info.aliases)
        EXPECT_THAT(find_instructions(family, alias), testing::Contains(&info)) << alias.str();
    }
}

TEST(Lookup, OneSpellingHasAnEntryPerOperandList) {
  EXPECT_EQ(find_instructions(qs(), "LD").size(), 1u);
  EXPECT_EQ(find_instructions(qs(), "+").size(), 2u);    // S D, S1 S2 D
  EXPECT_EQ(find_instructions(qs(), "OUT").size(), 5u);  // bit, T, ST, C, F
  EXPECT_EQ(find_instructions(qs(), "OUTH").size(), 2u);
  EXPECT_EQ(find_instructions(qs(), "SET").size(), 2u);
  EXPECT_EQ(find_instructions(qs(), "RST").size(), 5u);  // bit, timer, counter, word, F
}

TEST(Lookup, AComparisonMayBeWrittenWithABlank) {
  for (const char *sign : {"=", "<>", ">", "<=", "<", ">="})
    for (const char *connection : {"LD", "AND", "OR", "LDD", "ANDD", "ORD"}) {
      std::string joined = std::string(connection) + sign, apart = std::string(connection) + " " + sign;
      ASSERT_EQ(find_instructions(qs(), joined).size(), 1u) << joined;
      EXPECT_EQ(find_instructions(qs(), joined), find_instructions(qs(), apart)) << apart;
    }
}

TEST(Lookup, AnUnknownMnemonicHasNoEntries) {
  for (const char *word : {"CALL", "ld", "", "OUT T", "MOVPP", "SETP", "LD = ", "DRST"})
    EXPECT_TRUE(find_instructions(qs(), word).empty()) << word;
}

TEST(Lookup, FindsEveryErrorByItsCode) {
  EXPECT_EQ(qs().errors.size(), 93u);
  for (const ErrorInfo &error : qs().errors)
    EXPECT_EQ(find_error(qs(), error.code), &error);
  EXPECT_EQ(find_error(qs(), 0), nullptr);
  EXPECT_EQ(find_error(qs(), 4099), nullptr);
  EXPECT_EQ(find_error(qs(), 65535), nullptr);
}

TEST(Lookup, PointsComeFromTheModelWhereItDiffers) {
  const ModelPoints by_model[] = {{"SMALL", 16}};
  DeviceInfo device = qs().devices[0];
  device.points = 64;
  device.model_points = by_model;
  EXPECT_EQ(points_of(device, "SMALL"), 16u);
  EXPECT_EQ(points_of(device, "LARGE"), 64u);
}

}  // namespace
