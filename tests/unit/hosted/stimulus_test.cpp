// Inputs without a plant.
#include "fake_program.h"

#include "hosted/stimulus.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace ladder::hosted::test {
namespace {

std::int64_t get(const Instance &instance, std::string_view device) {
  return integer_of(instance.get(find_device(instance.symbols(), device)));
}

/// X00 to X1F and IB0 to IB69 as digits.
std::string inputs(const Instance &instance) {
  std::string text;
  for (unsigned number = 0; number < 32; ++number)
    text += get(instance, "X" + number_text(number, 16)) != 0 ? '1' : '0';
  for (unsigned number = 0; number < 70; ++number)
    text += get(instance, "IB" + std::to_string(number)) != 0 ? '1' : '0';
  return text;
}

struct Plant {
  explicit Plant(StimulusKind kind) : stimulus(kind) { instance.power_on(); }
  std::string next() {
    stimulus.apply(instance);
    return inputs(instance);
  }
  Instance instance{kFake, Clock::virtual_steps(1000)};
  Stimulus stimulus;
};

TEST(Stimulus, TheSameSeedGivesTheSameInputs) {
  Plant a({StimulusKind::Random, 7}), b({StimulusKind::Random, 7}), c({StimulusKind::Random, 8});
  std::string first = a.next();
  EXPECT_EQ(first, b.next());
  EXPECT_NE(first, c.next());
  EXPECT_NE(first, a.next());
}

TEST(Stimulus, EveryInputIsOnAboutEverySecondScan) {
  Plant plant({StimulusKind::Random, 0});
  std::vector<int> on(102);
  for (int scan = 0; scan < 1000; ++scan) {
    std::string now = plant.next();
    for (std::size_t i = 0; i < on.size(); ++i)
      on[i] += now[i] == '1';
  }
  for (int count : on) {
    EXPECT_GT(count, 400);
    EXPECT_LT(count, 600);
  }
}

TEST(Stimulus, ToggleInvertsEveryInput) {
  Plant plant({StimulusKind::Toggle, 1});
  EXPECT_EQ(plant.next(), std::string(102, '1'));
  EXPECT_EQ(plant.next(), std::string(102, '0'));
  EXPECT_EQ(plant.next(), std::string(102, '1'));
}

TEST(Stimulus, OnlyInputsChangeAndBitsStayBits) {
  Plant plant({StimulusKind::Toggle, 1});
  plant.next();
  EXPECT_EQ(get(plant.instance, "K4Y0"), 0);
  EXPECT_EQ(get(plant.instance, "K8B0"), 0);
  EXPECT_EQ(get(plant.instance, "D0"), 0);
  const unsigned char *image = plant.instance.devices().image(kFake.devices[0]);
  for (int i = 0; i < 32; ++i)
    EXPECT_EQ(image[i], 1);
  std::uint32_t packed[3];
  std::memcpy(packed, plant.instance.devices().image(kFake.devices[3]), sizeof packed);
  EXPECT_EQ(packed[2], 0x3Fu) << "bits beyond the 70 inputs stay 0";
}

TEST(Stimulus, ASetInputStaysAsSet) {
  Plant plant({StimulusKind::Toggle, 1});
  DeviceRef input = find_device(kFake, "X0");
  plant.instance.set(input, value_of_integer(input, 0));
  plant.next();
  plant.instance.scan();
  EXPECT_EQ(get(plant.instance, "Y0"), 0);
}

}  // namespace
}  // namespace ladder::hosted::test
