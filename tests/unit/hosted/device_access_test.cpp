// Where values end up: in the image, by shape, or in the side store.
#include "fake_controller.h"
#include "fake_program.h"

#include "ladder/hosted/device_access.h"

#include <gtest/gtest.h>

#include <cstring>

namespace ladder::hosted::test {
namespace {

class DeviceAccessTest : public testing::Test {
protected:
  void put(std::string_view device, std::string_view value) {
    DeviceRef ref = find_device(kFake, device);
    access_.write(ref, value_of_text(ref, value));
  }
  std::string get(std::string_view device) const { return value_text(access_.read(find_device(kFake, device))); }

  FakeProgram program_{};
  DeviceAccess access_{kFake, &program_};
};

TEST_F(DeviceAccessTest, BitsAreBytes) {
  put("X1F", "1");
  EXPECT_EQ(program_.X[31], 1);
  EXPECT_EQ(get("X1F"), "1");
  put("X1F", "0");
  EXPECT_EQ(program_.X[31], 0);
}

TEST_F(DeviceAccessTest, PackedBitsKeepTheirNeighbours) {
  program_.B[1] = 0x80000001;
  put("B21", "1");
  EXPECT_EQ(program_.B[1], 0x80000003u);
  put("B20", "0");
  EXPECT_EQ(program_.B[1], 0x80000002u);
  EXPECT_EQ(get("B21"), "1");
}

TEST_F(DeviceAccessTest, PairsHaveTheLowWordFirst) {
  put("D4:d", "70000");
  EXPECT_EQ(program_.D[4], 70000 - 65536);
  EXPECT_EQ(program_.D[5], 1);
  EXPECT_EQ(get("D4:u"), "70000");
  put("D4:f", "-2.5");
  EXPECT_EQ(get("D4:f"), "-2.5");
}

TEST_F(DeviceAccessTest, BitsOfWordsChangeOneBit) {
  program_.D[3] = 0x0F00;
  put("D3.B", "0");
  put("D3.0", "1");
  EXPECT_EQ(program_.D[3], 0x0701);
  EXPECT_EQ(get("D3.8"), "1");
  EXPECT_EQ(get("D3.B"), "0");
}

TEST_F(DeviceAccessTest, TimersHaveContactCoilAndValue) {
  put("TN1", "1234");
  put("T1", "1");
  put("CC0", "1");
  EXPECT_EQ(program_.T[1].value, 1234);
  EXPECT_EQ(program_.T[1].contact, 1);
  EXPECT_EQ(program_.T[1].coil, 0);
  EXPECT_EQ(program_.C[0].coil, 1);
  EXPECT_EQ(get("TN1"), "1234");
  EXPECT_EQ(get("TC1"), "0");
}

TEST_F(DeviceAccessTest, DigitsStartAtAnyNumber) {
  put("K2X3", "0xA5");
  EXPECT_EQ(program_.X[3], 1);
  EXPECT_EQ(program_.X[4], 0);
  EXPECT_EQ(program_.X[10], 1);
  EXPECT_EQ(get("K2X3"), "165");
  EXPECT_EQ(get("K1X7"), "10");
}

TEST_F(DeviceAccessTest, DevicesThatTheProgramDoesNotHoldAreKeptBesides) {
  FakeProgram before = program_;
  put("D10", "7");
  put("W7FF", "-1");
  put("STN3", "5");
  put("ST3", "1");
  EXPECT_EQ(get("D10"), "7");
  EXPECT_EQ(get("W7FF"), "-1");
  EXPECT_EQ(get("STN3"), "5");
  EXPECT_EQ(get("ST3"), "1");
  EXPECT_EQ(get("STC3"), "0");
  EXPECT_EQ(get("SD10"), "0") << "same number, another class";
  EXPECT_EQ(std::memcmp(&before, &program_, sizeof before), 0);
  access_.clear_side_store();
  EXPECT_EQ(get("D10"), "0");
}

TEST_F(DeviceAccessTest, APairAcrossTheEndOfTheImageLiesInBoth) {
  put("D9:d", "0x12345678");
  EXPECT_EQ(program_.D[9], 0x5678);
  EXPECT_EQ(get("D10"), std::to_string(0x1234));
  EXPECT_EQ(get("D9:d"), std::to_string(0x12345678));
  put("K2X1C", "0xFF");
  EXPECT_EQ(program_.X[31], 1);
  EXPECT_EQ(get("X23"), "1");
}

class ControllerAccessTest : public testing::Test {
protected:
  void put(std::string_view device, std::string_view value) {
    DeviceRef ref = find_device(kController, device);
    access_.write(ref, value_of_text(ref, value));
  }
  std::string get(std::string_view device) const { return value_text(access_.read(find_device(kController, device))); }

  FakeController program_{};
  DeviceAccess access_{kController, &program_};
};

TEST_F(ControllerAccessTest, NumbersMayStartAnywhere) {
  put("M8003", "1");
  put("D8002:d", "70000");
  put("K2S130", "0x81");
  EXPECT_EQ(program_.special_M[3], 1);
  EXPECT_EQ(program_.M[3], 0);
  EXPECT_EQ(program_.special_D[2], 70000 - 65536);
  EXPECT_EQ(program_.special_D[3], 1);
  EXPECT_EQ(program_.packed_S[0], 1u << 30);
  EXPECT_EQ(program_.packed_S[1], 1u << 5);
  EXPECT_EQ(get("K2S130"), "129");
  EXPECT_EQ(get("M8003"), "1");
  EXPECT_EQ(get("M3"), "0");
}

TEST_F(ControllerAccessTest, BehindTheImageNumbersAreKeptBesides) {
  const FakeController before = program_;
  put("M8008", "1");
  put("D8004", "-5");
  put("S140", "1");
  put("CN240", "-70000");
  put("C240", "1");
  EXPECT_EQ(get("M8008"), "1");
  EXPECT_EQ(get("D8004"), "-5");
  EXPECT_EQ(get("D4"), "0") << "same place, another class";
  EXPECT_EQ(get("S140"), "1");
  EXPECT_EQ(get("C240:u"), std::to_string(4294967296 - 70000));
  EXPECT_EQ(get("C240"), "1");
  EXPECT_EQ(get("CC240"), "0");
  EXPECT_EQ(std::memcmp(&before, &program_, sizeof before), 0);
}

TEST_F(ControllerAccessTest, TimersAndCountersAreAsFarApartAsTheTableSays) {
  put("TN2", "77");
  put("T1", "1");
  put("CN2", "-3");
  put("CC1", "1");
  EXPECT_EQ(program_.T[2].value, 77);
  EXPECT_EQ(program_.T[1].contact, 1);
  EXPECT_EQ(program_.C[2].value, -3);
  EXPECT_EQ(program_.C[1].coil, 1);
  put("CN0:d", "65538");
  EXPECT_EQ(program_.C[0].value, 2);
  EXPECT_EQ(program_.C[1].value, 1);
}

TEST_F(ControllerAccessTest, LongCountersHaveContactCoilAndA32BitValue) {
  put("CN201", "-2147483648");
  put("C201", "1");
  put("CC202", "1");
  EXPECT_EQ(program_.C32[1].value, -2147483647 - 1);
  EXPECT_EQ(program_.C32[1].contact, 1);
  EXPECT_EQ(program_.C32[1].coil, 0);
  EXPECT_EQ(program_.C32[2].coil, 1);
  EXPECT_EQ(get("C201:u"), "2147483648");
  EXPECT_EQ(get("CN201"), "-2147483648");
  EXPECT_EQ(get("C201"), "1");
}

TEST_F(ControllerAccessTest, APairWithItsHighWordInAnotherClass) {
  put("Z1:d", "0x12345678");
  EXPECT_EQ(program_.Z[1], 0x5678);
  EXPECT_EQ(program_.V[1], 0x1234);
  EXPECT_EQ(program_.Z[2], 0);
  EXPECT_EQ(get("Z1:u"), std::to_string(0x12345678));
  EXPECT_EQ(get("V1"), std::to_string(0x1234));
  put("Z4:d", "-2");
  EXPECT_EQ(get("Z4:d"), "-2");
  EXPECT_EQ(get("V4"), "-1") << "both lie beside the image";
}

}  // namespace
}  // namespace ladder::hosted::test
