// How the frequency of a pulse output rises at the start of a run and falls at its end.
//
// A ramp is a stair: `levels` steps of equal time, the first at the start frequency, the last at the top. What counts is how many
// pulses each step takes, because a run must end at its last pulse and not at some time: a run looks up its speed by the pulses
// that lie behind it or before it, whichever are fewer. So rise and fall are alike, and a run that is too short for its ramp turns
// in the middle without ever reaching the top.
#pragma once

#include <cstdint>

namespace ladder::tp03 {

class SpeedRamp {
public:
  /// None: the top frequency from the first pulse to the last.
  constexpr SpeedRamp() noexcept = default;
  /// At least two levels; frequencies up to 100 kHz with the start not above the top, times up to 5 s, up to 100 levels.
  constexpr SpeedRamp(std::uint32_t start, std::uint32_t top, std::uint32_t time_us, std::uint32_t levels) noexcept
      : start_(start), top_(top), time_us_(time_us), levels_(levels) {}

  constexpr bool exists() const noexcept { return levels_ != 0; }
  constexpr std::uint32_t levels() const noexcept { return levels_; }

  /// Pulses a second at a level, 1 to levels().
  constexpr std::uint32_t frequency(std::uint32_t level) const noexcept {
    return start_ + (top_ - start_) * (level - 1) / (levels_ - 1);
  }
  /// Pulses of the levels 1 to `level` together; 0 for level 0.
  constexpr std::uint32_t pulses(std::uint32_t level) const noexcept {
    const std::uint64_t rises = std::uint64_t{level} * (level == 0 ? 0 : level - 1) / 2;  // 0 + 1 + ... + (level - 1)
    const std::uint64_t sum = std::uint64_t{level} * start_ + rises * (top_ - start_) / (levels_ - 1);
    return static_cast<std::uint32_t>(sum * time_us_ / levels_ / 1000000U);
  }
  /// The level of a pulse that has `distance` pulses between itself and the nearer end of the run.
  constexpr std::uint32_t level_at(std::uint32_t distance) const noexcept {
    std::uint32_t low = 1, high = levels_;
    while (low < high) {
      const std::uint32_t middle = (low + high) / 2;
      if (distance < pulses(middle))
        high = middle;
      else
        low = middle + 1;
    }
    return low;
  }

private:
  std::uint32_t start_ = 0, top_ = 0, time_us_ = 0, levels_ = 0;
};

}  // namespace ladder::tp03
