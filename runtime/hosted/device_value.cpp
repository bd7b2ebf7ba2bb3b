// Conversions of values. The width of the device decides what fits: 16 bits signed, 32 bits as the format says, and digits that do
// not fill their operand (K1 to K3, K5 to K7, K4 as 32 bits) are unsigned, because they read zero-extended.
#include "ladder/hosted/device_value.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

namespace ladder::hosted {
namespace {

unsigned operand_width(Format format) {
  return format == Format::Bit ? 1 : format == Format::Word ? 16 : 32;
}

std::uint32_t mask_of(unsigned width) {
  return width >= 32 ? ~std::uint32_t{0} : (std::uint32_t{1} << width) - 1;
}

bool is_signed(const DeviceRef &ref) {
  return (ref.format == Format::Word || ref.format == Format::Signed) && width_of(ref) == operand_width(ref.format);
}

template <typename Number> bool parse_whole(std::string_view text, Number &number, int base = 10) {
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  return error == std::errc{} && end == text.data() + text.size();
}

bool is_pattern(std::string_view text) {
  return text.starts_with("0x") || text.starts_with("0X");
}

}  // namespace

std::int64_t integer_of(const Value &value) {
  switch (value.format) {
  case Format::Word:
    return static_cast<std::int16_t>(value.bits);
  case Format::Signed:
    return static_cast<std::int32_t>(value.bits);
  case Format::Float: {
    double real = real_of(value);
    return std::abs(real) < 9e18 ? static_cast<std::int64_t>(real) : 0;
  }
  case Format::Bit:
  case Format::Unsigned:
    break;
  }
  return value.bits;
}

double real_of(const Value &value) {
  if (value.format == Format::Float)
    return std::bit_cast<float>(value.bits);
  return static_cast<double>(integer_of(value));
}

Value value_of_integer(const DeviceRef &ref, std::int64_t number) {
  if (ref.format == Format::Float)
    return value_of_real(ref, static_cast<double>(number));
  std::int64_t largest = mask_of(width_of(ref)), smallest = 0;
  if (is_signed(ref)) {
    largest >>= 1;
    smallest = -largest - 1;
  }
  if (number < smallest || number > largest)
    throw DeviceError(fmt::format("{} does not fit: the values are {} to {}", number, smallest, largest));
  return {ref.format, static_cast<std::uint32_t>(number) & mask_of(width_of(ref))};
}

Value value_of_real(const DeviceRef &ref, double number) {
  if (ref.format != Format::Float)
    throw DeviceError(fmt::format("{} is not a whole number; ':f' writes a float into a pair of words", number));
  if (!(std::abs(number) <= std::numeric_limits<float>::max()))
    throw DeviceError(fmt::format("{} does not fit a 32-bit float", number));
  return {ref.format, std::bit_cast<std::uint32_t>(static_cast<float>(number))};
}

Value value_of_pattern(const DeviceRef &ref, std::string_view text) {
  std::uint64_t bits = 0;
  if (!is_pattern(text) || !parse_whole(text.substr(2), bits, 16))
    throw DeviceError(fmt::format("'{}' is no bit pattern such as 0x12AB", text));
  if (bits > mask_of(width_of(ref)))
    throw DeviceError(fmt::format("{} has more than {} bit{}", text, width_of(ref), width_of(ref) == 1 ? "" : "s"));
  return {ref.format, static_cast<std::uint32_t>(bits)};
}

Value value_of_text(const DeviceRef &ref, std::string_view text) {
  if (is_pattern(text))
    return value_of_pattern(ref, text);
  std::int64_t number = 0;
  if (parse_whole(text, number))
    return value_of_integer(ref, number);
  double real = 0;
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), real);
  if (error != std::errc{} || end != text.data() + text.size())
    throw DeviceError(fmt::format("'{}' is no value: write a number or a bit pattern such as 0x12AB", text));
  return value_of_real(ref, real);
}

std::string value_text(const Value &value) {
  if (value.format == Format::Float)
    return fmt::format("{}", std::bit_cast<float>(value.bits));
  return fmt::format("{}", integer_of(value));
}

std::string pattern_text(const DeviceRef &ref, const Value &value) {
  return fmt::format("0x{:0{}X}", value.bits, (width_of(ref) + 3) / 4);
}

}  // namespace ladder::hosted
