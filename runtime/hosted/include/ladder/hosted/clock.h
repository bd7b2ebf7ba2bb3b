// The time that a program is told: the real monotonic clock, or a virtual one that a scan moves; and the calendar of the computer.
#pragma once

#include "ladder/scan_types.h"

#include <chrono>
#include <cstdint>

namespace ladder::hosted {

class Clock {
public:
  /// Counts from now on.
  static Clock real();
  /// Stands at 0 during the first scan and moves by `step` from scan to scan.
  static Clock virtual_steps(Micros step);

  /// Microseconds since the start. The program sees the low 32 bits.
  std::uint64_t now() const;
  void scan_done() { virtual_now_ += step_; }

private:
  Clock() = default;

  bool real_ = false;
  std::chrono::steady_clock::time_point start_;
  std::uint64_t virtual_now_ = 0;
  Micros step_ = 0;
};

/// Date and time of this computer, local.
Calendar system_calendar();

}  // namespace ladder::hosted
