// Inputs for programs that run without a plant: every external input in the image gets a new value before each scan.
#pragma once

#include "ladder/hosted/instance.h"

#include <cstdint>

namespace ladder::hosted {

struct StimulusKind {
  enum Pattern : std::uint8_t { None, Random, Toggle } pattern = None;
  std::uint64_t seed = 1;  ///< of Random; the same seed gives the same bits everywhere
};

class Stimulus {
public:
  explicit Stimulus(StimulusKind kind);
  void apply(const Instance &instance);

private:
  std::uint64_t next_bits();

  StimulusKind::Pattern pattern_;
  std::uint64_t state_;
  bool on_ = false;
};

}  // namespace ladder::hosted
