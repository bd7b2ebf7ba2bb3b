// One operand word by the device table of the QS.
#include "parsing.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

Operand read(llvm::StringRef word) {
  return parse_operand(qs(), word, SourceRange(0, static_cast<std::uint32_t>(word.size())));
}

std::string device(const Operand &operand) {
  return operand.device == kNoDevice ? "-" : qs().devices[operand.device].prefix.str();
}

void expect_device(llvm::StringRef word, llvm::StringRef prefix, std::int64_t number) {
  const Operand operand = read(word);
  EXPECT_EQ(operand.kind, OperandKind::Device) << word.str();
  EXPECT_EQ(device(operand), prefix) << word.str();
  EXPECT_EQ(operand.value, number) << word.str();
  EXPECT_EQ(operand.index, kNoDevice) << word.str();
}

TEST(Operand, DeviceNumbersCountInTheRadixOfTheirClass) {
  expect_device("X1F", "X", 0x1F);
  expect_device("X001F", "X", 0x1F);
  expect_device("XA", "X", 0xA);
  expect_device("YFFF", "Y", 0xFFF);
  expect_device("M100", "M", 100);
  expect_device("D6143", "D", 6143);
  expect_device("N14", "N", 14);
  expect_device("BCD", "B", 0xCD);
}

TEST(Operand, TheLongestPrefixWins) {
  expect_device("SM400", "SM", 400);
  expect_device("SD0", "SD", 0);
  expect_device("SB1F", "SB", 0x1F);
  expect_device("SW0", "SW", 0);
  expect_device("ST5", "ST", 5);
}

TEST(Operand, BitsOfWords) {
  for (auto [word, bit] : {std::pair("D0.5", 5), std::pair("D0.A", 10), std::pair("D0.0B", 11), std::pair("D0.F", 15)}) {
    const Operand operand = read(word);
    EXPECT_EQ(operand.kind, OperandKind::BitOfWord) << word;
    EXPECT_EQ(device(operand), "D") << word;
    EXPECT_EQ(operand.value, 0) << word;
    EXPECT_EQ(operand.bit, bit) << word;
  }
  EXPECT_EQ(read("W1F.3").value, 0x1F);
  EXPECT_EQ(read("T0.3").kind, OperandKind::BitOfWord) << "whether T has bits is not a matter of syntax";
}

TEST(Operand, DigitsAreNoConstants) {
  const Operand digits = read("K4X10");
  EXPECT_EQ(digits.kind, OperandKind::Digits);
  EXPECT_EQ(digits.digits, 4);
  EXPECT_EQ(device(digits), "X");
  EXPECT_EQ(digits.value, 0x10);
  EXPECT_EQ(read("K410").kind, OperandKind::Decimal);
  EXPECT_EQ(read("K410").value, 410);
  EXPECT_EQ(read("K2SB1F").value, 0x1F);
  EXPECT_EQ(read("K0M0").digits, 0) << "the count is judged later";
  EXPECT_EQ(read("K9M0").digits, 9);
  EXPECT_EQ(read("K999999999999999999999M0").digits, 255);
  EXPECT_EQ(read("K4D0.1").kind, OperandKind::Invalid);
}

TEST(Operand, Constants) {
  EXPECT_EQ(read("K-32768").value, -32768);
  EXPECT_EQ(read("K007").value, 7);
  EXPECT_EQ(read("K9223372036854775807").value, INT64_MAX);
  EXPECT_EQ(read("K9223372036854775808").kind, OperandKind::Invalid);
  EXPECT_EQ(read("HFF0F").kind, OperandKind::Hexadecimal);
  EXPECT_EQ(read("HFF0F").value, 0xFF0F);
  EXPECT_EQ(read("H0FF00FF00").value, 0xFF00FF00);
  EXPECT_EQ(read("H8000000000000000").kind, OperandKind::Invalid);
}

TEST(Operand, IndexRegistersOfOtherFamiliesAreKnown) {
  for (const char *word : {"D0Z1", "K4X10Z1", "K5Z1", "HFFZ1", "D0.5Z1"}) {
    const Operand operand = read(word);
    EXPECT_NE(operand.kind, OperandKind::Invalid) << word;
    EXPECT_EQ(operand.index, kForeignIndex) << word;
    EXPECT_EQ(operand.index_number, 1) << word;
  }
  EXPECT_EQ(read("K5Z1").kind, OperandKind::Decimal);
  EXPECT_EQ(read("D0Z").kind, OperandKind::Invalid);
  EXPECT_EQ(read("D0Z256").kind, OperandKind::Invalid);
  EXPECT_EQ(read("D0Z1Z1").kind, OperandKind::Invalid);
}

TEST(Operand, IndexRegistersOfTheFamily) {
  // No family with index registers is in the tables yet: a copy of the QS with a class Z stands in.
  std::vector<DeviceInfo> devices(qs().devices.begin(), qs().devices.end());
  DeviceInfo z = devices.front();
  z.prefix = "Z";
  z.kind = DeviceKind::Index;
  z.radix = 10;
  devices.push_back(z);
  FamilyInfo family = qs();
  family.devices = devices;
  family.has_index_registers = true;
  const auto id = static_cast<DeviceId>(devices.size() - 1);
  EXPECT_EQ(parse_operand(family, "D0Z3", SourceRange()).index, id);
  EXPECT_EQ(parse_operand(family, "D0Z3", SourceRange()).index_number, 3);
  EXPECT_EQ(parse_operand(family, "K5Z3", SourceRange()).kind, OperandKind::Decimal);
  EXPECT_EQ(parse_operand(family, "Z3", SourceRange()).kind, OperandKind::Device);
  EXPECT_EQ(parse_operand(family, "D0V3", SourceRange()).kind, OperandKind::Invalid);
}

TEST(Operand, EverythingElseIsInvalid) {
  for (const char *word : {"",     "X", "Q5", "X1G", "M1F", "D0.",  "D0.10",    "D0.G", "K",   "K-",          "K--5", "K+5", "K1.5",
                           "K4Q0", "H", "HG", "100", "-5",  "E1.5", "\"text\"", "X 1",  "X1.", "D4294967296", "手动", "=",   "."}) {
    EXPECT_EQ(read(word).kind, OperandKind::Invalid) << word;
  }
  expect_device("D4294967295", "D", 4294967295);
}

}  // namespace
}  // namespace ladderc
