// How places are spelt in C++. The runtime's image classes (ladder/image.h) have the members that are used here.
//
// A pair or digit run that crosses the end of its device class goes on in the next class of the memory order. Where that is, is
// known here, so the output names the parts one by one: pair(D[6143], W[0]).
#include "emit/places.h"

#include "emit/names.h"
#include "ir/extent.h"
#include "syntax/parser.h"

#include <fmt/format.h>

namespace ladderc::emit {

namespace {

using ir::Place;
using ir::PlaceKind;

const DeviceInfo &device_of(const PlaceContext &context, const Place &place) {
  return context.family.devices[place.device];
}

/// An index register: `Z[0]`, or the pair of 32-bit instructions.
std::string index_text(const PlaceContext &context, const Place &place) {
  const DeviceInfo &device = context.family.devices[place.index];
  const std::string low = fmt::format("{}[{}]", device.image.str(), place.index_number);
  if (!place.wide_index || device.high_words == kNoDevice)
    return low;
  return fmt::format("pair({}, {}[{}])", low, context.family.devices[device.high_words].image.str(), place.index_number);
}

/// The number of the place, `first` numbers behind it: `5`, `0x1F`, `at(20, V[0])`.
std::string number_of(const PlaceContext &context, const Place &place, std::uint32_t first = 0) {
  const std::string number = subscript(device_of(context, place), place.number + first);
  return place.is_indexed() ? fmt::format("at({}, {})", number, index_text(context, place)) : number;
}

bool has_value_member(const DeviceInfo &device) {
  return device.kind == DeviceKind::Timer || device.kind == DeviceKind::Counter || device.kind == DeviceKind::LongCounter;
}

std::string element_text(const DeviceInfo &device, const std::string &number) {
  return fmt::format("{}[{}]{}", device.image.str(), number, has_value_member(device) ? ".value" : "");
}

bool crosses(const PlaceContext &context, const Place &place, std::uint32_t count) {
  return !place.is_indexed() && crosses_end(context.family, context.parameters, place.device, place.number, count);
}

/// The word that lies `distance` words behind the place.
std::string word_behind(const PlaceContext &context, const Place &place, std::uint32_t distance) {
  const DeviceInfo &device = device_of(context, place);
  if (device.high_words != kNoDevice) {
    const DeviceInfo &high = context.family.devices[device.high_words];
    return element_text(distance % 2 == 0 ? device : high, number_of(context, place, distance / 2));
  }
  if (place.is_indexed())
    return element_text(device, number_of(context, place, distance));
  const DevicePoint point = point_behind(context.family, context.parameters, {place.device, place.number}, distance);
  const DeviceInfo &there = context.family.devices[point.device];
  return element_text(there, subscript(there, point.number));
}

/// `count` words from `first` words behind the place, as arguments.
std::string words(const PlaceContext &context, const Place &place, std::uint32_t first, std::uint32_t count) {
  std::string text;
  for (std::uint32_t i = first; i < first + count; ++i)
    text += (text.empty() ? "" : ", ") + word_behind(context, place, i);
  return text;
}

/// Two or four words from `first` words behind the place as one value.
std::string wide_text(const PlaceContext &context, const Place &place, std::uint32_t first, std::uint32_t count) {
  const DeviceInfo &device = device_of(context, place);
  if (device.kind == DeviceKind::LongCounter)
    return element_text(device, number_of(context, place, first / 2));
  const char *name = place.type == OperandType::Real ? "real" : count == 2 ? "pair" : "quad";
  if (device.kind != DeviceKind::Word || device.high_words != kNoDevice || crosses(context, place, first + count))
    return fmt::format("{}({})", name, words(context, place, first, count));
  return fmt::format("{}.{}({})", device.image.str(), name, number_of(context, place, first));
}

std::string digit_references(const PlaceContext &context, const Place &place) {
  std::string text;
  for (std::uint32_t i = 0; i < 4u * place.digits; ++i) {
    const DevicePoint point = point_behind(context.family, context.parameters, {place.device, place.number}, i);
    const DeviceInfo &device = context.family.devices[point.device];
    text += fmt::format("{}{}[{}]", text.empty() ? "" : ", ", device.image.str(), subscript(device, point.number));
  }
  return "digits_of(" + text + ")";
}

std::string plain_constant(const Place &place) {
  const bool wide = place.type == OperandType::DWord;
  if (place.kind == PlaceKind::Hex) {
    const std::uint64_t pattern = static_cast<std::uint64_t>(place.value) & (wide ? 0xFFFFFFFFu : 0xFFFFu);
    const std::string digits = wide ? fmt::format("0x{:08X}", pattern) : fmt::format("0x{:04X}", pattern);
    return place.value >= 0 ? digits : fmt::format("{}({})", wide ? "dword" : "word", digits);
  }
  // There is no literal for the smallest 32-bit number.
  return place.value == INT32_MIN ? "dword(-2147483647 - 1)" : fmt::format("{}", place.value);
}

std::string constant_text(const PlaceContext &context, const Place &place) {
  if (place.type == OperandType::Real)
    return fmt::format("{}.0F", place.value);
  if (!place.is_indexed())
    return plain_constant(place);
  return fmt::format("plus({}{{{}}}, {})", place.type == OperandType::DWord ? "dword" : "word", plain_constant(place),
                     index_text(context, place));
}

/// Blocks and bit runs.
std::string run_text(const PlaceContext &context, const Place &place) {
  const DeviceInfo &device = device_of(context, place);
  const std::string at = number_of(context, place);
  const bool wide = place.type == OperandType::DWordBlock;
  if (place.kind == PlaceKind::Digits)
    return fmt::format("{}.digit_{}<{}>({})", device.image.str(), wide ? "dblock" : "block", place.digits, at);
  const char *name = place.kind == PlaceKind::Bit ? "run" : wide ? "dblock" : "block";
  return fmt::format("{}.{}({})", device.image.str(), name, at);
}

/// How many numbers of its class the place takes.
std::uint32_t numbers_of(const DeviceInfo &device, const Place &place) {
  if (place.kind == PlaceKind::Digits)
    return 4u * place.digits * (place.count ? place.count : 1u);
  const std::uint32_t words = place.count ? place.count * (place.type == OperandType::DWordBlock ? 2u : 1u) : ir::words_of(place.type);
  return device.kind == DeviceKind::LongCounter || device.high_words != kNoDevice ? (words + 1) / 2 : words;
}

}  // namespace

std::string subscript(const DeviceInfo &device, std::uint32_t number) {
  if (device.radix == 16 && number > 9)
    return fmt::format("0x{:X}", number);
  if (device.radix == 8 && number > 7)
    return fmt::format("0{:02o}", number);  // X10 is X[010], an octal literal as the manual writes the device
  return fmt::format("{}", number);
}

ir::Place place_of(const FamilyInfo &family, const InitialValue &value) {
  auto [name, suffix] = llvm::StringRef(value.device).split(':');
  Operand operand = parse_operand(family, name, {});
  // TN0, CC0: a letter between the prefix and the number says which part of a timer or counter is meant.
  char part = 0;
  if (operand.kind == OperandKind::Invalid) {
    const std::size_t digit = name.find_first_of("0123456789");
    part = name[digit - 1];
    operand = parse_operand(family, (name.take_front(digit - 1) + name.drop_front(digit)).str(), {});
  }
  const DeviceKind kind = family.devices[operand.device].kind;
  const bool bit = operand.kind == OperandKind::BitOfWord || kind == DeviceKind::Bit || (kind != DeviceKind::Word && part != 'N' && suffix.empty());
  const bool wide = !suffix.empty() || kind == DeviceKind::LongCounter;
  ir::Place place = ir::to_place(operand, bit ? OperandType::Bit : wide ? OperandType::DWord : OperandType::Word);
  place.bit = part == 'C' ? 1 : place.bit;  // of a timer or counter: the coil
  return place;
}

std::string bit_text(const PlaceContext &context, const Place &place) {
  if (place.kind == PlaceKind::Edge)
    return fmt::format("edge[{}]", place.number);
  if (place.kind == PlaceKind::Master)
    return fmt::format("master[{}]", place.number);
  const DeviceInfo &device = device_of(context, place);
  const std::string at = number_of(context, place);
  if (place.kind == PlaceKind::WordBit)
    return fmt::format("{}.bit({}, {})", device.image.str(), at, place.bit);
  const char *member = !has_value_member(device) ? "" : place.bit ? ".coil" : ".contact";
  return fmt::format("{}[{}]{}", device.image.str(), at, member);
}

std::string number_text(const PlaceContext &context, const Place &place) {
  return number_of(context, place);
}

std::string range_check(const PlaceContext &context, const Place &place) {
  const DeviceInfo &device = device_of(context, place);
  const std::uint32_t count = numbers_of(device, place);
  return fmt::format("{}.has({}{})", device.image.str(), number_of(context, place), count > 1 ? fmt::format(", {}", count) : "");
}

std::string input_text(const PlaceContext &context, const Place &place) {
  if (place.type == OperandType::String)
    return fmt::format("{0}, {1}", quoted(context.texts[static_cast<std::size_t>(place.value)]),
                       context.texts[static_cast<std::size_t>(place.value)].size());
  if (place.is_constant())
    return constant_text(context, place);
  if (place.kind == PlaceKind::Label || device_of(context, place).kind == DeviceKind::Label)
    return fmt::format("{}", place.number);
  if (place.kind == PlaceKind::Object)
    return object_text(context, place);
  if (ir::is_run(place.type))
    return run_text(context, place);
  if (place.kind == PlaceKind::Bit)
    return bit_text(context, place);
  const DeviceInfo &device = device_of(context, place);
  if (place.kind == PlaceKind::Digits) {
    const char *width = place.type == OperandType::Word ? "word" : "dword";
    if (crosses(context, place, 4u * place.digits))
      return fmt::format("{}.{}()", digit_references(context, place), width);
    return fmt::format("{}.{}<{}>({})", device.image.str(), width, place.digits, number_of(context, place));
  }
  const std::uint32_t count = ir::words_of(place.type);
  return count == 1 ? word_behind(context, place, 0) : wide_text(context, place, 0, count);
}

std::string output_text(const PlaceContext &context, const Place &place) {
  const DeviceInfo &device = device_of(context, place);
  if (place.kind == PlaceKind::Object)
    return object_text(context, place);
  if (ir::is_run(place.type))
    return run_text(context, place);
  if (place.kind == PlaceKind::Bit)
    return bit_text(context, place);
  if (place.kind == PlaceKind::Digits) {
    if (crosses(context, place, 4u * place.digits))
      return digit_references(context, place);
    return fmt::format("{}.digits<{}>({})", device.image.str(), place.digits, number_of(context, place));
  }
  switch (place.type) {
  case OperandType::DWord:
  case OperandType::Real:
    return wide_text(context, place, 0, 2);
  case OperandType::QWord:
    return wide_text(context, place, 0, 4);
  case OperandType::WordTwice:
    return device.kind == DeviceKind::LongCounter ? wide_text(context, place, 0, 2) : words(context, place, 0, 2);
  case OperandType::DWordTwice:
    return wide_text(context, place, 0, 2) + ", " + wide_text(context, place, 2, 2);
  default:
    return word_behind(context, place, 0);
  }
}

std::string object_text(const PlaceContext &context, const Place &place) {
  const DeviceInfo &device = device_of(context, place);
  const std::string at = number_of(context, place);
  if (place.type == OperandType::Annunciator)
    return fmt::format("{}, {}", device.image.str(), at);
  return fmt::format("{}[{}]", device.image.str(), at);
}

}  // namespace ladderc::emit
