// What scenario files consist of: objects with known keys, numbers, and values of devices.
#pragma once

#include "hosted/scenario.h"

#include "ladder/hosted/device_value.h"

#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string_view>

namespace ladder::hosted {

/// A scenario file that says nothing sensible; ends as "error" of the scenario.
class ScenarioError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Throws where `object` is none or has another key.
void check_keys(const Json &object, std::initializer_list<std::string_view> known);

double number_at(const Json &object, const char *key, double otherwise, double largest);
std::uint64_t count_at(const Json &object, const char *key, std::uint64_t otherwise);

/// Throws DeviceError when the value does not fit the device.
Value value_of_json(const DeviceRef &ref, const Json &json);
/// In the form of the expectation, so that both can be compared by eye.
Json json_of(const DeviceRef &ref, const Value &value, const Json &expected);
bool matches(const Value &got, const Value &wanted, const Json &expected, double tolerance);

}  // namespace ladder::hosted
