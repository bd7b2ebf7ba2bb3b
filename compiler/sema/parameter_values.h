// Values in the parameter file: numbers, device names with values, dates.
#pragma once

#include "sema/parameters.h"

#include "nlohmann/json.hpp"

namespace ladderc::sema {

/// What is wrong, or nothing.
using Problem = std::optional<std::string>;
using Json = nlohmann::json;

/// The value for a message: scalars as written, of arrays and objects the kind only (they may be nested without limit).
std::string shown(const Json &json);

/// A whole number from `min` to `max`.
Problem read_integer(const Json &json, std::int64_t min, std::int64_t max, std::int64_t &value);

/// Milliseconds, in whole steps of `step_us`, as microseconds.
Problem read_milliseconds(const Json &json, std::uint32_t min_us, std::uint32_t max_us, std::uint32_t step_us, std::uint32_t &us);

/// "M0-M99" or "D5".
Problem read_range(const Json &json, const FamilyInfo &family, const Parameters &parameters, DeviceRange &range);

/// A device with its value: bits 0 or 1, words -32768 to 65535, with ":d" or ":u" a pair of words; a string "0x..." is a bit
/// pattern. `TN0` and `CN0` are current values, `TC0` and `CC0` coils. `range` becomes the device numbers that hold the value,
/// `value.value` the signed number of its width.
Problem read_value(llvm::StringRef name, const Json &json, const FamilyInfo &family, const Parameters &parameters,
                   InitialValue &value, DeviceRange &range);

/// "2024-02-29T13:30:00".
Problem check_calendar(llvm::StringRef text);

}  // namespace ladderc::sema
