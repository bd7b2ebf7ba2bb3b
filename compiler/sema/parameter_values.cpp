// Values in the parameter file: numbers, device names with values, dates.
#include "sema/parameter_values.h"

#include "sema/names.h"
#include "syntax/parser.h"

#include "fmt/format.h"

#include <cmath>

namespace ladderc::sema {

namespace {

constexpr std::int64_t kTwoTo16 = 65'536;
constexpr std::int64_t kTwoTo32 = 4'294'967'296;

bool has_memory(DeviceKind kind) {
  return kind == DeviceKind::Bit || kind == DeviceKind::Word || kind == DeviceKind::Timer || kind == DeviceKind::Counter ||
         kind == DeviceKind::LongCounter;
}

/// A device or bit of a word that exists with these parameters.
Problem read_device(llvm::StringRef text, const FamilyInfo &family, const Parameters &parameters, Operand &operand) {
  operand = parse_operand(family, text, {});
  bool plain = (operand.kind == OperandKind::Device || operand.kind == OperandKind::BitOfWord) && operand.index == kNoDevice;
  if (!plain || !has_memory(family.devices[operand.device].kind))
    return fmt::format("'{}' is no device", text.str());
  std::uint32_t points = parameters.points[operand.device];
  if (!number_exists(family.devices[operand.device], {}, points, static_cast<std::uint64_t>(operand.value)))
    return fmt::format("'{}' lies outside the {} allocated points", text.str(), points);
  return std::nullopt;
}

/// "TN0" is the current value and "TC0" the coil of timer T0: the letter in front of the number, and the name without it.
char take_part_letter(llvm::StringRef text, const FamilyInfo &family, std::string &device) {
  std::size_t number = text.find_first_of("0123456789");
  if (number == llvm::StringRef::npos || number < 2)
    return 0;
  char letter = text[number - 1];
  DeviceId id = find_device(family, text.take_front(number - 1));
  if ((letter != 'N' && letter != 'C') || id == kNoDevice || find_device(family, text.take_front(number)) != kNoDevice)
    return 0;
  DeviceKind kind = family.devices[id].kind;
  if (kind != DeviceKind::Timer && kind != DeviceKind::Counter && kind != DeviceKind::LongCounter)
    return 0;
  device = text.take_front(number - 1).str() + text.drop_front(number).str();
  return letter;
}

/// A number, true or false, or "0x1F".
Problem read_number(const Json &json, std::int64_t min, std::int64_t max, std::int64_t &value) {
  if (json.is_boolean()) {
    value = json.get<bool>() ? 1 : 0;
    return std::nullopt;
  }
  if (!json.is_string())
    return read_integer(json, min, max, value);
  const std::string &text = json.get_ref<const std::string &>();
  std::uint64_t bits = 0;
  llvm::StringRef rest(text);
  if (!rest.consume_front_insensitive("0x") || rest.getAsInteger(16, bits))
    return fmt::format("'{}' is no number", text);
  if (bits > static_cast<std::uint64_t>(max))
    return fmt::format("{} is outside {} to {}", text, min, max);
  value = static_cast<std::int64_t>(bits);
  return std::nullopt;
}

}  // namespace

std::string shown(const Json &json) {
  return json.is_structured() ? fmt::format("an {}", json.type_name()) : json.dump();
}

Problem read_integer(const Json &json, std::int64_t min, std::int64_t max, std::int64_t &value) {
  if (!json.is_number_integer())
    return fmt::format("{} is no whole number", shown(json));
  bool huge = json.is_number_unsigned() && json.get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX);
  value = huge ? INT64_MAX : json.get<std::int64_t>();
  if (value < min || value > max)
    return fmt::format("{} is outside {} to {}", shown(json), min, max);
  return std::nullopt;
}

Problem read_milliseconds(const Json &json, std::uint32_t min_us, std::uint32_t max_us, std::uint32_t step_us, std::uint32_t &us) {
  if (!json.is_number())
    return fmt::format("{} is no number", shown(json));
  double exact = json.get<double>() * 1000.0;
  double min = min_us, max = max_us;
  if (!(exact >= min && exact <= max))
    return fmt::format("{} is outside {} to {}", shown(json), min / 1000.0, max / 1000.0);
  double rounded = std::round(exact);
  if (std::abs(exact - rounded) > 1e-6 || static_cast<std::uint32_t>(rounded) % step_us != 0)
    return fmt::format("{} is no multiple of {}", shown(json), step_us / 1000.0);
  us = static_cast<std::uint32_t>(rounded);
  return std::nullopt;
}

Problem read_range(const Json &json, const FamilyInfo &family, const Parameters &parameters, DeviceRange &range) {
  if (!json.is_string())
    return fmt::format("{} is no range like \"M0-M99\"", shown(json));
  llvm::StringRef text = json.get_ref<const std::string &>();
  auto [first_text, last_text] = text.split('-');
  Operand first, last;
  if (Problem problem = read_device(first_text, family, parameters, first))
    return problem;
  last = first;
  if (text.contains('-'))
    if (Problem problem = read_device(last_text, family, parameters, last))
      return problem;
  if (first.kind != OperandKind::Device || last.kind != OperandKind::Device || last.device != first.device ||
      last.value < first.value)
    return fmt::format("'{}' is no range like \"M0-M99\"", text.str());
  range = {first.device, static_cast<std::uint32_t>(first.value), static_cast<std::uint32_t>(last.value)};
  return std::nullopt;
}

Problem read_value(llvm::StringRef name, const Json &json, const FamilyInfo &family, const Parameters &parameters,
                   InitialValue &value, DeviceRange &range) {
  auto [device_text, suffix] = name.split(':');
  std::string without_letter;
  char letter = take_part_letter(device_text, family, without_letter);
  Operand operand;
  if (Problem problem = read_device(letter != 0 ? llvm::StringRef(without_letter) : device_text, family, parameters, operand))
    return problem;
  bool wide_suffix = suffix == "d" || suffix == "u";
  const bool long_counter = operand.kind == OperandKind::Device && family.devices[operand.device].kind == DeviceKind::LongCounter;
  bool word = letter == 'N' || (operand.kind == OperandKind::Device && family.devices[operand.device].kind == DeviceKind::Word) ||
              (long_counter && letter == 0 && wide_suffix);
  bool pair = wide_suffix && !long_counter;
  if (name.contains(':') && !(word && letter == 0 && wide_suffix))
    return fmt::format("'{}': a pair of words is written like D0:d or D0:u", name.str());

  std::int64_t min = 0, max = 1, width = 2;
  const bool wide = word && long_counter;
  if (word && (pair || wide)) {
    width = kTwoTo32;
    min = suffix == "u" ? 0 : -kTwoTo32 / 2;
    max = kTwoTo32 - 1;
  } else if (word) {
    width = kTwoTo16;
    min = -kTwoTo16 / 2;
    max = kTwoTo16 - 1;
  }
  if (Problem problem = read_number(json, min, suffix == "d" && !json.is_string() ? kTwoTo32 / 2 - 1 : max, value.value))
    return fmt::format("'{}': {}", name.str(), *problem);
  if (word && value.value >= width / 2)
    value.value -= width;

  std::uint32_t number = static_cast<std::uint32_t>(operand.value);
  if (pair && number + 1 - family.devices[operand.device].first >= parameters.points[operand.device])
    return fmt::format("'{}' lies outside the {} allocated points", name.str(), parameters.points[operand.device]);
  value.device = name.str();
  range = {operand.device, number, pair ? number + 1 : number};
  return std::nullopt;
}

Problem check_calendar(llvm::StringRef text) {
  Problem problem = fmt::format("'{}' is no date and time like \"2024-02-29T13:30:00\" of the years 1980 to 2079", text.str());
  constexpr llvm::StringRef kShape = "0000-00-00T00:00:00";
  if (text.size() != kShape.size())
    return problem;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (kShape[i] == '0' ? text[i] < '0' || text[i] > '9' : text[i] != kShape[i])
      return problem;
  auto number = [text](std::size_t begin, std::size_t digits) {
    unsigned value = 0;
    text.substr(begin, digits).getAsInteger(10, value);
    return value;
  };
  constexpr unsigned kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  unsigned year = number(0, 4), month = number(5, 2), day = number(8, 2);
  if (year < 1980 || year > 2079 || month < 1 || month > 12)
    return problem;
  bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
  unsigned days = kDays[month - 1] + (month == 2 && leap ? 1 : 0);
  if (day < 1 || day > days || number(11, 2) > 23 || number(14, 2) > 59 || number(17, 2) > 59)
    return problem;
  return std::nullopt;
}

}  // namespace ladderc::sema
