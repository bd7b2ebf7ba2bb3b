// What the host may write, by what the tables say of each device class.
#pragma once

#include "generate/random.h"
#include "sema/parameters.h"

#include <optional>
#include <vector>

namespace ladderc::differential {

/// One place and what is written there: a bit where `is_bit`. `index` counts from the lowest number of the class.
struct Poke {
  DeviceId device;
  std::uint32_t index;
  bool is_bit;
  std::uint16_t value;
};

class Stimulus {
public:
  Stimulus(const FamilyInfo &family, const Parameters &parameters);

  /// What devices hold when the program starts.
  std::vector<Poke> fill(Random &random) const;
  /// What the host writes between two scans: nothing mostly.
  std::vector<Poke> some(Random &random) const;
  /// The class with the input terminals.
  DeviceId inputs() const { return inputs_; }

private:
  struct Places {
    DeviceId device;
    bool is_bit, is_index;
    std::vector<std::uint32_t> special;  ///< that the system obeys, by index
    std::uint32_t plain;                 ///< from here on a few without a meaning, by index
  };
  Poke poke(const Places &places, std::uint32_t index, Random &random) const;

  const FamilyInfo &family_;
  const Parameters &parameters_;
  DeviceId inputs_ = kNoDevice;
  std::vector<Places> places_;
};

}  // namespace ladderc::differential
