// Mistakes are told with the JSON text that has them.
#include "hosted/scenario_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ladder::hosted {

void check_keys(const Json &object, std::initializer_list<std::string_view> known) {
  if (!object.is_object())
    throw ScenarioError(fmt::format("{} is no object", object.dump()));
  for (const auto &[key, value] : object.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw ScenarioError(fmt::format("unknown key '{}'", key));
}

double number_at(const Json &object, const char *key, double otherwise, double largest) {
  auto found = object.find(key);
  if (found == object.end())
    return otherwise;
  if (!found->is_number() || found->get<double>() < 0 || found->get<double>() > largest)
    throw ScenarioError(fmt::format("'{}' is a number from 0 to {}, not {}", key, largest, found->dump()));
  return found->get<double>();
}

std::uint64_t count_at(const Json &object, const char *key, std::uint64_t otherwise) {
  auto found = object.find(key);
  if (found == object.end())
    return otherwise;
  if (!found->is_number_unsigned())
    throw ScenarioError(fmt::format("'{}' is a whole number from 0 on, not {}", key, found->dump()));
  return found->get<std::uint64_t>();
}

Value value_of_json(const DeviceRef &ref, const Json &json) {
  if (json.is_string())
    return value_of_pattern(ref, json.get_ref<const std::string &>());
  if (json.is_boolean())
    return value_of_integer(ref, json.get<bool>() ? 1 : 0);
  if (json.is_number_unsigned() && json.get<std::uint64_t>() > INT64_MAX)
    throw DeviceError(fmt::format("{} does not fit", json.dump()));
  if (json.is_number_integer())
    return value_of_integer(ref, json.get<std::int64_t>());
  if (json.is_number_float())
    return value_of_real(ref, json.get<double>());
  throw DeviceError(fmt::format("{} is no value: write a number or a bit pattern such as \"0x12AB\"", json.dump()));
}

Json json_of(const DeviceRef &ref, const Value &value, const Json &expected) {
  if (expected.is_string())
    return pattern_text(ref, value);
  if (value.format != Format::Float)
    return integer_of(value);
  double real = real_of(value);
  if (!std::isfinite(real))
    return fmt::format("{}", real);  // JSON has no number for it
  return real;
}

bool matches(const Value &got, const Value &wanted, const Json &expected, double tolerance) {
  if (got.format != Format::Float || expected.is_string())
    return got == wanted;
  double limit = tolerance * (real_of(wanted) == 0 ? 1 : std::abs(real_of(wanted)));
  return std::abs(real_of(got) - real_of(wanted)) <= limit;
}

}  // namespace ladder::hosted
