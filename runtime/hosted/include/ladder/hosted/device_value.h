// Values of devices: a bit pattern and how to read it, and the conversions from and to what people and files write.
//
// A number is signed (or what the format says); "0x1234" is a bit pattern. What does not fit the device is an error, never cut off.
#pragma once

#include "ladder/hosted/device_name.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace ladder::hosted {

struct Value {
  Format format;
  std::uint32_t bits;  ///< the pattern, low bits used; bits beyond the width are 0

  friend bool operator==(const Value &, const Value &) = default;
};

/// The value as a number; Float is cut off towards 0 and not meant to be asked.
std::int64_t integer_of(const Value &value);
/// The value as a real number, for every format.
double real_of(const Value &value);

/// Each throws DeviceError when the value does not fit the device.
Value value_of_integer(const DeviceRef &ref, std::int64_t number);
Value value_of_real(const DeviceRef &ref, double number);
Value value_of_pattern(const DeviceRef &ref, std::string_view text);  ///< "0x1234"
Value value_of_text(const DeviceRef &ref, std::string_view text);     ///< "-5", "1.5" where the format is Float, "0x1234"

/// As value_of_text reads it.
std::string value_text(const Value &value);
/// "0x00F0", as wide as the device.
std::string pattern_text(const DeviceRef &ref, const Value &value);

}  // namespace ladder::hosted
