// PC parameters: what the engineering tool sets beside the program.
//
// A JSON object with the names of the scenario files' `parameters`. Unknown keys are errors, so that a misspelt one is not lost.
#pragma once

#include "tables/tables.h"

#include "llvm/ADT/StringRef.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ladderc {

struct DeviceRange {
  DeviceId device;
  std::uint32_t first, last;  ///< inclusive
};

struct InitialValue {
  std::string device;  ///< as written: "D0", "D10:d", "D3.A", "TN0" (current value)
  std::int64_t value;  ///< the signed number of its width; a bit is 0 or 1
};

struct Parameters {
  std::vector<std::uint32_t>
      points;  ///< per device class: allocation; numbers run from the first one of the class to that plus points - 1
  std::vector<DeviceRange> latched;           ///< kept over power-off and reset
  std::vector<InitialValue> latched_values;   ///< contents before power-on; the devices are in `latched` too
  std::vector<InitialValue> initial_values;   ///< written at power-on and at STOP to RUN
  std::uint32_t low_speed_unit_us = 100'000;  ///< 1-1000 ms in 1 ms
  std::uint32_t high_speed_unit_us = 10'000;  ///< 0.1-100 ms in 0.1 ms
  std::uint32_t watchdog_us = 0;              ///< scan longer than this: error 5001 and stop; 0: not watched
  std::uint32_t constant_scan_us = 0;         ///< 0: none
  std::string program_name = "MAIN";          ///< up to 8 characters, in the error information
  std::string calendar;                       ///< ISO date and time at power-on; empty: 2000-01-01T00:00:00
};

/// The defaults of a model.
Parameters default_parameters(const FamilyInfo &family, llvm::StringRef model);

/// Reads `json` (an object) over `parameters`. Returns an error text, or nothing.
[[nodiscard]] std::optional<std::string> read_parameters(llvm::StringRef json, const FamilyInfo &family, Parameters &parameters);

}  // namespace ladderc
