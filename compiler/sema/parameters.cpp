// PC parameters: the JSON object.
//
// Keys are read in the order of the table below and not of the file: latched devices and initial values are checked against the
// allocation that the same file makes.
#include "sema/parameters.h"

#include "sema/parameter_values.h"

#include "fmt/format.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

namespace ladderc {

namespace {

using sema::Json;
using sema::Problem;

constexpr std::int64_t kMaxPoints = 65'535;  // special registers tell the allocation in 16 bits
constexpr std::size_t kMaxProgramName = 8;

class ParameterReader {
public:
  ParameterReader(const FamilyInfo &family, Parameters &parameters) : family_(family), parameters_(parameters) {}

  Problem read(const Json &object);

private:
  using Read = Problem (ParameterReader::*)(const Json &);
  struct Key {
    const char *name;
    Read read;
  };
  static const Key kKeys[];

  Problem set_points(llvm::StringRef prefix, const Json &json);
  Problem device_points(const Json &json);
  Problem retentive_timer_points(const Json &json) { return set_points("ST", json); }
  Problem latched(const Json &json);
  Problem initial_values(const Json &json);
  Problem low_speed_unit(const Json &json) {
    return sema::read_milliseconds(json, 1'000, 1'000'000, 1'000, parameters_.low_speed_unit_us);
  }
  Problem high_speed_unit(const Json &json) {
    return sema::read_milliseconds(json, 100, 100'000, 100, parameters_.high_speed_unit_us);
  }
  Problem watchdog(const Json &json) { return sema::read_milliseconds(json, 0, 2'000'000, 1'000, parameters_.watchdog_us); }
  Problem constant_scan(const Json &json) { return sema::read_milliseconds(json, 0, 2'000'000, 500, parameters_.constant_scan_us); }
  Problem program_name(const Json &json);
  Problem calendar(const Json &json);

  const FamilyInfo &family_;
  Parameters &parameters_;
};

const ParameterReader::Key ParameterReader::kKeys[] = {
    {"device_points", &ParameterReader::device_points},
    {"ST_points", &ParameterReader::retentive_timer_points},
    {"latched", &ParameterReader::latched},
    {"device_initial_values", &ParameterReader::initial_values},
    {"low_speed_unit_ms", &ParameterReader::low_speed_unit},
    {"high_speed_unit_ms", &ParameterReader::high_speed_unit},
    {"watchdog_ms", &ParameterReader::watchdog},
    {"constant_scan_ms", &ParameterReader::constant_scan},
    {"program_name", &ParameterReader::program_name},
    {"calendar", &ParameterReader::calendar},
};

Problem ParameterReader::read(const Json &object) {
  for (const auto &[name, value] : object.items())
    if (!llvm::any_of(kKeys, [&, wanted = llvm::StringRef(name)](const Key &key) { return wanted == key.name; }))
      return fmt::format("unknown parameter '{}'", name);
  for (const Key &key : kKeys)
    if (auto value = object.find(key.name); value != object.end())
      if (Problem problem = (this->*key.read)(*value))
        return fmt::format("parameter '{}': {}", key.name, *problem);
  return std::nullopt;
}

/// Classes whose allocation no special register tells have a fixed one.
Problem ParameterReader::set_points(llvm::StringRef prefix, const Json &json) {
  DeviceId device = find_device(family_, prefix);
  if (device == kNoDevice || family_.devices[device].points_register < 0)
    return fmt::format("the points of '{}' cannot be set", prefix.str());
  std::int64_t points = 0;
  if (Problem problem = sema::read_integer(json, 0, kMaxPoints, points))
    return fmt::format("{}: {}", prefix.str(), *problem);
  parameters_.points[device] = static_cast<std::uint32_t>(points);
  return std::nullopt;
}

Problem ParameterReader::device_points(const Json &json) {
  if (!json.is_object())
    return "is no object like {\"D\": 8192}";
  for (const auto &[prefix, points] : json.items())
    if (Problem problem = set_points(prefix, points))
      return problem;
  return std::nullopt;
}

/// An array of ranges, or an object with the contents that the devices had before power-on; these devices are latched then.
Problem ParameterReader::latched(const Json &json) {
  if (json.is_object()) {
    for (const auto &[name, content] : json.items()) {
      InitialValue value;
      DeviceRange range;
      if (Problem problem = sema::read_value(name, content, family_, parameters_, value, range))
        return problem;
      parameters_.latched_values.push_back(std::move(value));
      parameters_.latched.push_back(range);
    }
    return std::nullopt;
  }
  if (!json.is_array())
    return "is neither an array like [\"M0-M99\"] nor an object like {\"D0\": 5}";
  for (const Json &element : json) {
    DeviceRange range;
    if (Problem problem = sema::read_range(element, family_, parameters_, range))
      return problem;
    parameters_.latched.push_back(range);
  }
  return std::nullopt;
}

Problem ParameterReader::initial_values(const Json &json) {
  if (!json.is_object())
    return "is no object like {\"D0\": 5}";
  for (const auto &[name, content] : json.items()) {
    InitialValue value;
    DeviceRange range;
    if (Problem problem = sema::read_value(name, content, family_, parameters_, value, range))
      return problem;
    parameters_.initial_values.push_back(std::move(value));
  }
  return std::nullopt;
}

Problem ParameterReader::program_name(const Json &json) {
  if (!json.is_string())
    return fmt::format("{} is no string", sema::shown(json));
  const std::string &name = json.get_ref<const std::string &>();
  bool good = !name.empty() && name.size() <= kMaxProgramName &&
              llvm::all_of(name, [](char c) { return llvm::isAlnum(c) || c == '_' || c == '-'; });
  if (!good)
    return fmt::format("'{}' is no name of 1 to {} letters, digits, '-' and '_'", name, kMaxProgramName);
  parameters_.program_name = name;
  return std::nullopt;
}

Problem ParameterReader::calendar(const Json &json) {
  if (!json.is_string())
    return fmt::format("{} is no string", sema::shown(json));
  const std::string &text = json.get_ref<const std::string &>();
  if (Problem problem = sema::check_calendar(text))
    return problem;
  parameters_.calendar = text;
  return std::nullopt;
}

}  // namespace

Parameters default_parameters(const FamilyInfo &family, llvm::StringRef model) {
  Parameters parameters;
  for (const auto &[id, device] : llvm::enumerate(family.devices)) {
    parameters.points.push_back(points_of(device, model));
    for (const ModelNumbers &run : latched_numbers(device, model))
      parameters.latched.push_back({static_cast<DeviceId>(id), run.first, run.last});
  }
  return parameters;
}

std::optional<std::string> read_parameters(llvm::StringRef json, const FamilyInfo &family, Parameters &parameters) {
  Json object = Json::parse(json.begin(), json.end(), nullptr, false);
  if (object.is_discarded())
    return "the parameters are no JSON";
  if (!object.is_object())
    return "the parameters are no JSON object";
  // Only a whole file takes effect.
  Parameters result = parameters;
  if (Problem problem = ParameterReader(family, result).read(object))
    return problem;
  parameters = std::move(result);
  return std::nullopt;
}

}  // namespace ladderc
