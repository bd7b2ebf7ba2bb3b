// Types that the scan interface and hosts share.
#pragma once

#include <cstdint>

namespace ladder {

/// The host's clock in microseconds. Only differences count, so it may wrap around; a scan must take less than 71 minutes.
using Micros = std::uint32_t;

enum class Mode : std::uint8_t { Stop, Run };

/// What the CPU is doing and why.
struct Status {
  Mode mode;            ///< the switch
  bool running;         ///< in RUN and not stopped by an error
  std::uint16_t error;  ///< code of the error that stopped the CPU or was reported last; 0: none
  std::uint32_t step;   ///< where it occurred; meaningful while error is a program error
  std::uint32_t scans;  ///< scans completed since RUN
};

/// Local date and time as the CPU's clock keeps it.
struct Calendar {
  std::uint16_t year;   ///< 1980-2079
  std::uint8_t month, day, hour, minute, second;
  std::uint8_t weekday; ///< 0 Sunday to 6 Saturday
};

}  // namespace ladder
