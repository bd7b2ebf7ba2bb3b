// What fits a device and how it is written.
#include "fake_program.h"

#include "ladder/hosted/device_value.h"

#include <gtest/gtest.h>

#include <bit>

namespace ladder::hosted::test {
namespace {

std::uint32_t bits(std::string_view device, std::string_view text) {
  return value_of_text(find_device(kFake, device), text).bits;
}

std::string round_trip(std::string_view device, std::string_view text) {
  return value_text(value_of_text(find_device(kFake, device), text));
}

std::string message(std::string_view device, std::string_view text) {
  try {
    return round_trip(device, text);
  } catch (const DeviceError &error) {
    return error.what();
  }
}

TEST(DeviceValue, NumbersAreSignedAndPatternsAreBits) {
  EXPECT_EQ(bits("D0", "-5"), 0xFFFBu);
  EXPECT_EQ(bits("D0", "0xFFFB"), 0xFFFBu);
  EXPECT_EQ(round_trip("D0", "0xFFFB"), "-5");
  EXPECT_EQ(round_trip("D0:d", "-70000"), "-70000");
  EXPECT_EQ(round_trip("D0:u", "4294967295"), "4294967295");
  EXPECT_EQ(round_trip("X0", "1"), "1");
}

TEST(DeviceValue, FloatsKeepTheirPattern) {
  EXPECT_EQ(bits("D0:f", "1.5"), std::bit_cast<std::uint32_t>(1.5F));
  EXPECT_EQ(bits("D0:f", "2"), std::bit_cast<std::uint32_t>(2.0F));
  EXPECT_EQ(bits("D0:f", "0x7F800000"), 0x7F800000u);
  EXPECT_EQ(round_trip("D0:f", "0.1"), "0.1");
}

TEST(DeviceValue, PartlyFilledDigitsAreUnsigned) {
  EXPECT_EQ(round_trip("K1X0", "15"), "15");
  EXPECT_EQ(round_trip("K4X0", "0xFFFF"), "-1");
  EXPECT_EQ(round_trip("K4X0:d", "65535"), "65535");
  EXPECT_EQ(round_trip("K8X0", "-1"), "-1");
  EXPECT_EQ(message("K1X0", "16"), "16 does not fit: the values are 0 to 15");
}

TEST(DeviceValue, WhatDoesNotFitIsRefused) {
  EXPECT_EQ(message("D0", "32768"), "32768 does not fit: the values are -32768 to 32767");
  EXPECT_EQ(message("D0:u", "-1"), "-1 does not fit: the values are 0 to 4294967295");
  EXPECT_EQ(message("X0", "2"), "2 does not fit: the values are 0 to 1");
  EXPECT_EQ(message("D0", "0x12345"), "0x12345 has more than 16 bits");
  EXPECT_EQ(message("D0", "1.5"), "1.5 is not a whole number; ':f' writes a float into a pair of words");
  EXPECT_EQ(message("D0:f", "1e39"), "1e+39 does not fit a 32-bit float");
  EXPECT_EQ(message("D0", "ten"), "'ten' is no value: write a number or a bit pattern such as 0x12AB");
  EXPECT_EQ(message("D0", ""), "'' is no value: write a number or a bit pattern such as 0x12AB");
  EXPECT_EQ(message("D0", "0x"), "'0x' is no bit pattern such as 0x12AB");
}

TEST(DeviceValue, PatternsAreAsWideAsTheDevice) {
  auto pattern = [](std::string_view device, std::string_view text) {
    DeviceRef ref = find_device(kFake, device);
    return pattern_text(ref, value_of_text(ref, text));
  };
  EXPECT_EQ(pattern("D0", "240"), "0x00F0");
  EXPECT_EQ(pattern("D0:d", "-1"), "0xFFFFFFFF");
  EXPECT_EQ(pattern("X0", "1"), "0x1");
  EXPECT_EQ(pattern("K2X0", "3"), "0x03");
}

}  // namespace
}  // namespace ladder::hosted::test
