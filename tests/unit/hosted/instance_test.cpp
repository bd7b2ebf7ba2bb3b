// Instances: independent of each other, each with its clock and its held inputs.
#include "fake_controller.h"
#include "fake_program.h"

#include "hosted/simulated_io.h"

#include "ladder/hosted/instance.h"

#include <gtest/gtest.h>

namespace ladder::hosted::test {
namespace {

void put(Instance &instance, std::string_view device, std::int64_t value) {
  DeviceRef ref = find_device(instance.symbols(), device);
  instance.set(ref, value_of_integer(ref, value));
}

std::int64_t get(const Instance &instance, std::string_view device) {
  return integer_of(instance.get(find_device(instance.symbols(), device)));
}

TEST(Instance, TheVirtualClockStandsAtZeroInTheFirstScan) {
  Instance plant(kFake, Clock::virtual_steps(10'000));
  plant.power_on();
  plant.scan();
  EXPECT_EQ(get(plant, "D1"), 0);
  plant.scan();
  EXPECT_EQ(get(plant, "D1"), 10);
  EXPECT_EQ(plant.now(), 20'000u);
  EXPECT_EQ(plant.scans(), 2u);
}

TEST(Instance, TheRealClockGoesOnItsOwn) {
  Clock clock = Clock::real();
  std::uint64_t first = clock.now();
  clock.scan_done();
  auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (clock.now() == first && std::chrono::steady_clock::now() < deadline) {
  }
  EXPECT_GT(clock.now(), first);
}

TEST(Instance, TwoOfThemRunSideBySideAtTheirOwnSpeed) {
  Instance slow(kFake, Clock::virtual_steps(1'000)), fast(kFake, Clock::virtual_steps(50'000));
  slow.power_on();
  fast.power_on();
  put(fast, "X1", 1);
  for (int i = 0; i < 3; ++i) {
    slow.scan();
    fast.scan();
  }
  EXPECT_EQ(get(slow, "D1"), 2);
  EXPECT_EQ(get(fast, "D1"), 100);
  EXPECT_EQ(get(slow, "D0"), 0);
  EXPECT_EQ(get(fast, "D0"), 3);
}

TEST(Instance, ASetInputIsHeldAgainstTheProgram) {
  Instance plant(kFake, Clock::virtual_steps(1'000));
  plant.power_on();
  plant.scan();
  plant.scan();
  EXPECT_EQ(get(plant, "Y1"), 1) << "nobody drives X5: what the program wrote stays";
  put(plant, "X5", 0);
  plant.scan();
  plant.scan();
  EXPECT_EQ(get(plant, "Y1"), 0) << "the terminal overwrites it before each scan";
}

TEST(Instance, TheLaterOfOverlappingInputsWins) {
  Instance plant(kFake, Clock::virtual_steps(1'000));
  plant.power_on();
  put(plant, "X1", 1);
  put(plant, "K1X0", 0);
  plant.scan();
  EXPECT_EQ(get(plant, "D0"), 0);
  put(plant, "X1", 1);
  plant.scan();
  EXPECT_EQ(get(plant, "D0"), 1);
}

TEST(Instance, OtherDevicesAreWrittenOnce) {
  Instance plant(kFake, Clock::virtual_steps(1'000));
  plant.power_on();
  put(plant, "Y0", 1);
  plant.scan();
  EXPECT_EQ(get(plant, "Y0"), 0);
}

TEST(Instance, PowerOnKeepsLatchedDevicesAndInputs) {
  Instance plant(kFake, Clock::virtual_steps(1'000));
  plant.power_on();
  for (const char *device : {"D5", "D9", "D100", "X0", "X100"})
    put(plant, device, 1);
  plant.power_on();
  plant.scan();
  EXPECT_EQ(get(plant, "D5"), 0);
  EXPECT_EQ(get(plant, "D9"), 1) << "latched by the program";
  EXPECT_EQ(get(plant, "D100"), 0);
  EXPECT_EQ(get(plant, "Y0"), 1);
  EXPECT_EQ(get(plant, "X100"), 1);
}

TEST(Instance, KnowsACpuThatStoppedByItself) {
  Instance plant(kFake, Clock::virtual_steps(1'000));
  plant.power_on();
  plant.set_mode(Mode::Stop);
  EXPECT_FALSE(plant.stopped_by_itself());
  plant.set_mode(Mode::Run);
  put(plant, "X2", 1);
  plant.scan();
  EXPECT_TRUE(plant.stopped_by_itself());
  EXPECT_EQ(plant.status().error, 4100);
}

TEST(Instance, AConnectionStaysOverPowerOn) {
  Instance plant(kController, Clock::virtual_steps(1'000));
  SimulatedIo io;
  io.set_potentiometer(1, 512);
  EXPECT_TRUE(plant.connect(&io));
  plant.power_on();
  plant.scan();
  EXPECT_EQ(get(plant, "D2"), 512);
  EXPECT_TRUE(plant.connect(nullptr));
  plant.power_on();
  plant.scan();
  EXPECT_EQ(get(plant, "D2"), 0);
}

TEST(Instance, PulsesComeBackToWhereTheyStarted) {
  Instance plant(kController, Clock::virtual_steps(1'000));
  plant.power_on();
  plant.pulse(find_device(kController, "X5"), 3);
  EXPECT_EQ(get(plant, "CN235"), 3);
  EXPECT_EQ(get(plant, "D5"), 6);
  EXPECT_EQ(get(plant, "X5"), 0) << "the image is the scan's";
  put(plant, "X5", 1);
  plant.pulse(find_device(kController, "X5"), 2);
  EXPECT_EQ(get(plant, "CN235"), 5) << "down and up";
  plant.pulse(find_device(kController, "X12"), 1);
  EXPECT_EQ(get(plant, "D4"), 10) << "octal";
}

TEST(Instance, InterruptsGoToTheProgram) {
  Instance plant(kController, Clock::virtual_steps(1'000));
  plant.power_on();
  plant.interrupt(610);
  EXPECT_EQ(get(plant, "D6"), 610);
}

TEST(Instance, WhatAControllerDoesNotHaveIsSaid) {
  Instance plant(kFake, Clock::virtual_steps(1'000)), controller(kController, Clock::virtual_steps(1'000));
  SimulatedIo io;
  EXPECT_FALSE(plant.connect(&io));
  EXPECT_THROW(plant.pulse(find_device(kFake, "X0"), 1), DeviceError);
  EXPECT_THROW(plant.interrupt(1), DeviceError);
  EXPECT_THROW(controller.pulse(find_device(kController, "Y0"), 1), DeviceError);
  EXPECT_THROW(controller.pulse(find_device(kController, "K1X0"), 1), DeviceError);
}

}  // namespace
}  // namespace ladder::hosted::test
