// Where values end up: in the image, by shape, or in the side store.
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

}  // namespace
}  // namespace ladder::hosted::test
