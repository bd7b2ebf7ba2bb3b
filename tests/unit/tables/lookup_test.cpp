// Looking things up in the tables.
#include "tables/tables.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"

#include <algorithm>
#include <string>

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

TEST(Lookup, EveryDeviceIsFoundByItsPrefixAndNumber) {
  for (const FamilyInfo &family : families())
    for (std::size_t id = 0; id < family.devices.size(); ++id) {
      const DeviceInfo &device = family.devices[id];
      EXPECT_EQ(find_device(family, device.prefix, device.first), id);
      EXPECT_EQ(find_device(family, device.prefix, device.first + std::max(device.points, 1u) - 1), id);
      EXPECT_LE(family.devices[find_device(family, device.prefix)].first, device.first);
      EXPECT_EQ(family.devices[find_device(family, device.prefix)].prefix, device.prefix);
    }
}

TEST(Lookup, NumbersBelongToTheClassThatBeginsBeforeThem) {
  const FamilyInfo &tp03 = *find_family("tp03");
  auto first = [&](llvm::StringRef prefix, std::uint64_t number) { return tp03.devices[find_device(tp03, prefix, number)].first; };
  EXPECT_EQ(first("M", 7679), 0u);
  EXPECT_EQ(first("M", 7999), 0u);
  EXPECT_EQ(first("M", 8000), 8000u);
  EXPECT_EQ(first("M", 99999), 8000u);
  EXPECT_EQ(first("C", 200), 200u);
  EXPECT_EQ(find_device(tp03, "Q", 0), kNoDevice);
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

std::string text(const llvm::SmallVector<ModelNumbers, 4> &runs) {
  std::string result;
  for (const ModelNumbers &run : runs)
    result += std::to_string(run.first) + "-" + std::to_string(run.last) + " ";
  return result;
}

TEST(Lookup, NumbersThatExist) {
  const FamilyInfo &tp03 = *find_family("tp03");
  const DeviceInfo &timers = tp03.devices[find_device(tp03, "T")], &counters = tp03.devices[find_device(tp03, "C", 200)];
  EXPECT_EQ(text(existing_numbers(timers, "TP03H", points_of(timers, "TP03H"))), "0-511 ");
  EXPECT_EQ(text(existing_numbers(timers, "TP03SR", points_of(timers, "TP03SR"))), "0-39 196-255 ");
  EXPECT_EQ(text(existing_numbers(timers, "TP03SR", 100)), "0-39 ");
  EXPECT_EQ(text(existing_numbers(timers, "TP03H", 0)), "");
  EXPECT_EQ(text(existing_numbers(counters, "TP03H", 56)), "200-249 251-254 ");
  EXPECT_EQ(text(existing_numbers(counters, "TP03SR", 56)), "220-238 241-242 246-247 251-253 ");
  for (std::uint64_t n = 190; n < 260; ++n) {
    bool listed = false;
    for (const ModelNumbers &run : existing_numbers(counters, "TP03SR", 56))
      listed |= n >= run.first && n <= run.last;
    EXPECT_EQ(number_exists(counters, "TP03SR", 56, n), listed) << n;
  }
}

TEST(Lookup, LatchedNumbersOfAModelReplaceTheGeneralOnes) {
  const FamilyInfo &tp03 = *find_family("tp03");
  const DeviceInfo &registers = tp03.devices[find_device(tp03, "D")], &relays = tp03.devices[find_device(tp03, "M")];
  EXPECT_EQ(text(latched_numbers(registers, "TP03H")), "200-7999 ");
  EXPECT_EQ(text(latched_numbers(registers, "TP03SR")), "400-511 ");
  EXPECT_EQ(text(latched_numbers(relays, "TP03SR")), "500-1535 ");
}

TEST(Lookup, IndexRegisters) {
  const FamilyInfo &tp03 = *find_family("tp03");
  EXPECT_TRUE(is_index_register(tp03, find_device(tp03, "V")));
  EXPECT_TRUE(is_index_register(tp03, find_device(tp03, "Z")));
  EXPECT_FALSE(is_index_register(tp03, find_device(tp03, "D")));
  EXPECT_FALSE(is_index_register(tp03, kNoDevice));
  EXPECT_FALSE(is_index_register(qs(), find_device(qs(), "V")));
}

TEST(Lookup, TheManualOfABasedFamilyIsThatOfItsBase) {
  FamilyInfo family = qs();
  EXPECT_EQ(cited_family(family), "melsec-qs");
  family.base = "tp03";
  EXPECT_EQ(cited_family(family), "tp03");
}

}  // namespace
