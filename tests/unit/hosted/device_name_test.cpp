// Which texts name which devices, and what is said about those that name none.
#include "fake_controller.h"
#include "fake_program.h"

#include "ladder/hosted/device_name.h"

#include <gtest/gtest.h>

namespace ladder::hosted::test {
namespace {

std::string message(std::string_view text, const ProgramSymbols &symbols = kFake) {
  try {
    find_device(symbols, text);
  } catch (const DeviceError &error) {
    return error.what();
  }
  return "found";
}

std::string prefix_of(const DeviceRef &ref) {
  return kFake.devices[ref.device].prefix;
}

TEST(DeviceName, NumbersCountInTheRadixOfTheClass) {
  EXPECT_EQ(find_device(kFake, "X1F").number, 31u);
  EXPECT_EQ(find_device(kFake, "XA").number, 10u);
  EXPECT_EQ(find_device(kFake, "D100").number, 100u);
  EXPECT_EQ(find_device(kOctal, "X17").number, 15u);
}

TEST(DeviceName, CaseDoesNotMatter) {
  EXPECT_EQ(find_device(kFake, "x1f"), find_device(kFake, "X1F"));
  EXPECT_EQ(find_device(kFake, "d0:D"), find_device(kFake, "D0:d"));
}

TEST(DeviceName, TheLongestPrefixWithANumberWins) {
  EXPECT_EQ(prefix_of(find_device(kFake, "SD5")), "SD");
  EXPECT_EQ(prefix_of(find_device(kFake, "S5")), "S");
  EXPECT_EQ(prefix_of(find_device(kFake, "ST5")), "ST");
  DeviceRef relay = find_device(kFake, "BAD");
  EXPECT_EQ(prefix_of(relay), "B");
  EXPECT_EQ(relay.number, 0xADu);
}

TEST(DeviceName, TimersAndCountersHaveThreeParts) {
  EXPECT_EQ(find_device(kFake, "T1").part, Part::Contact);
  EXPECT_EQ(find_device(kFake, "TS1").part, Part::Contact);
  EXPECT_EQ(find_device(kFake, "TN1").part, Part::Current);
  EXPECT_EQ(find_device(kFake, "TC1").part, Part::Coil);
  EXPECT_EQ(find_device(kFake, "CC1").part, Part::Coil);
  DeviceRef current = find_device(kFake, "STN7");
  EXPECT_EQ(prefix_of(current), "ST");
  EXPECT_EQ(current.part, Part::Current);
  EXPECT_EQ(current.format, Format::Word);
  EXPECT_EQ(find_device(kFake, "STC7").format, Format::Bit);
}

TEST(DeviceName, SuffixesChooseTheFormat) {
  EXPECT_EQ(find_device(kFake, "D0").format, Format::Word);
  EXPECT_EQ(find_device(kFake, "D0:d").format, Format::Signed);
  EXPECT_EQ(find_device(kFake, "D0:u").format, Format::Unsigned);
  EXPECT_EQ(find_device(kFake, "D0:f").format, Format::Float);
  EXPECT_EQ(find_device(kFake, "TN0:d").format, Format::Signed);
}

TEST(DeviceName, BitsOfWordsAreHexadecimal) {
  EXPECT_EQ(find_device(kFake, "D0.5").word_bit, 5);
  EXPECT_EQ(find_device(kFake, "D0.0B").word_bit, 11);
  EXPECT_EQ(find_device(kFake, "D0.f").format, Format::Bit);
  EXPECT_EQ(message("D0.10"), "'D0.10': a word has the bits 0 to F");
  EXPECT_EQ(message("T0.0"), "'T0.0': T is no word with bits");
  EXPECT_EQ(message("TN0.0"), "'TN0.0': T is no word with bits");
  EXPECT_EQ(message("D0.5:d"), "'D0.5:d': a bit of a word is not read as 32 bits");
}

TEST(DeviceName, DigitsAreGroupsOfFourBits) {
  DeviceRef digits = find_device(kFake, "K4X10");
  EXPECT_EQ(digits.digits, 4);
  EXPECT_EQ(digits.number, 16u);
  EXPECT_EQ(digits.format, Format::Word);
  EXPECT_EQ(width_of(digits), 16u);
  EXPECT_EQ(find_device(kFake, "K8X0").format, Format::Signed);
  EXPECT_EQ(find_device(kFake, "K4X0:d").format, Format::Signed);
  EXPECT_EQ(message("K9X0"), "'K9X0': digits are K1 to K8");
  EXPECT_EQ(message("K4D0"), "'K4D0': digits are made of bit devices and D is none");
  EXPECT_EQ(message("K4X0:f"), "'K4X0:f': a float takes K8");
}

TEST(DeviceName, WhatIsNoDeviceIsSaidWithTheFamily) {
  EXPECT_EQ(message("X1Z"), "'X1Z' is no device of melsec-qs");
  EXPECT_EQ(message("Q7"), "'Q7' is no device of melsec-qs");
  EXPECT_EQ(message("X"), "'X' is no device of melsec-qs");
  EXPECT_EQ(message(""), "'' is no device of melsec-qs");
  EXPECT_EQ(message("X18", kOctal), "'X18' is no device of octal: X counts in octal");
  EXPECT_EQ(message("X0:d"), "'X0:d': a bit is not read as 32 bits");
  EXPECT_EQ(message("D0:x"), "'D0:x': the formats are :d (signed), :u (unsigned) and :f (float), each of 32 bits");
}

TEST(DeviceName, TheControllersRangeIsTheLimit) {
  EXPECT_EQ(message("D6143"), "found");
  EXPECT_EQ(message("D9000"), "'D9000' lies beyond D6143");
  EXPECT_EQ(message("D6143:d"), "'D6143:d' lies beyond D6143");
  EXPECT_EQ(message("X1800"), "'X1800' lies beyond X17FF");
  EXPECT_EQ(message("K1X17FD"), "'K1X17FD' lies beyond X17FF");
  EXPECT_EQ(message("TN512"), "'TN512' lies beyond TN511");
  EXPECT_EQ(message("Y20", kOctal), "'Y20' lies beyond Y17");
  EXPECT_EQ(message("D99999999999999999999"), "'D99999999999999999999' lies beyond D6143");
  EXPECT_EQ(message("L0"), "'L0': this controller has no L");
}

TEST(DeviceName, ClassesWithOnePrefixDifferInTheirNumbers) {
  auto start = [](std::string_view text) {
    const DeviceRef ref = find_device(kController, text);
    return std::pair(kController.devices[ref.device].first, ref.number);
  };
  EXPECT_EQ(start("M9"), std::pair(0u, 9u));
  EXPECT_EQ(start("M8000"), std::pair(8000u, 8000u));
  EXPECT_EQ(start("K4M8008"), std::pair(8000u, 8008u));
  EXPECT_EQ(start("D7999"), std::pair(0u, 7999u));
  EXPECT_EQ(start("D8511"), std::pair(8000u, 8511u));
  EXPECT_EQ(start("C199"), std::pair(0u, 199u));
  EXPECT_EQ(start("CN200"), std::pair(200u, 200u));
  EXPECT_EQ(message("M7680", kController), "'M7680' lies beyond M7679");
  EXPECT_EQ(message("M8512", kController), "'M8512' lies beyond M8511");
  EXPECT_EQ(message("K4M8500", kController), "'K4M8500' lies beyond M8511");
  EXPECT_EQ(message("CC256", kController), "'CC256' lies beyond CC255");
  EXPECT_EQ(message("S99", kController), "'S99' lies before S100");
}

TEST(DeviceName, APairLiesInOneClass) {
  EXPECT_EQ(message("D7998:d", kController), "found");
  EXPECT_EQ(message("D7999:d", kController), "'D7999:d' lies beyond D7999");
  EXPECT_EQ(message("D8511:d", kController), "'D8511:d' lies beyond D8511");
}

TEST(DeviceName, APairMayHaveItsHighWordsInAnotherClass) {
  EXPECT_EQ(find_device(kController, "Z0").format, Format::Word);
  EXPECT_EQ(find_device(kController, "V0").format, Format::Word);
  EXPECT_EQ(find_device(kController, "Z15:d").format, Format::Signed) << "V15 is the other word";
  EXPECT_EQ(message("Z16:d", kController), "'Z16:d' lies beyond Z15");
  EXPECT_EQ(message("V0:d", kController), "'V0:d': V has high words; a pair is named by Z");
}

TEST(DeviceName, LongCountersHave32Bits) {
  const DeviceRef value = find_device(kController, "CN200");
  EXPECT_EQ(value.part, Part::Current);
  EXPECT_EQ(value.format, Format::Signed);
  EXPECT_EQ(width_of(value), 32u);
  EXPECT_EQ(find_device(kController, "C200:d"), value);
  EXPECT_EQ(find_device(kController, "CN255:u").format, Format::Unsigned) << "no second counter takes part";
  EXPECT_EQ(find_device(kController, "C200").part, Part::Contact);
  EXPECT_EQ(find_device(kController, "C200").format, Format::Bit);
  EXPECT_EQ(find_device(kController, "CC200").part, Part::Coil);
  EXPECT_EQ(message("C200:f", kController), "'C200:f': a counter is not read as float");
  EXPECT_EQ(message("CC200:d", kController), "'CC200:d': a bit is not read as 32 bits");
  EXPECT_EQ(message("C0:d", kController), "'C0:d': a bit is not read as 32 bits");
  EXPECT_EQ(find_device(kController, "CN0").format, Format::Word);
  EXPECT_EQ(find_device(kController, "CN0:d").format, Format::Signed) << "CN0 and CN1";
}

}  // namespace
}  // namespace ladder::hosted::test
