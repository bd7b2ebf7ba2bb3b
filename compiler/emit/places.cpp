// How places are spelt in C++. The runtime's image classes (ladder/image.h) have the members that are used here.
//
// A pair or digit run that crosses the end of its device class goes on in the next class of the memory order. Where that is, is
// known here, so the output names the parts one by one: pair(D[6143], W[0]).
#include "emit/places.h"

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

std::string word_text(const PlaceContext &context, DevicePoint point) {
  const DeviceInfo &device = context.family.devices[point.device];
  std::string text = fmt::format("{}[{}]", device.image.str(), subscript(device, point.number));
  return device.kind == DeviceKind::Word ? text : text + ".value";
}

bool crosses(const PlaceContext &context, const Place &place, std::uint32_t count) {
  return crosses_end(context.family, context.parameters, place.device, place.number, count);
}

/// `count` words from `first` words behind the place, as arguments.
std::string words(const PlaceContext &context, const Place &place, std::uint32_t first, std::uint32_t count) {
  std::string text;
  for (std::uint32_t i = first; i < first + count; ++i)
    text += (text.empty() ? "" : ", ") +
            word_text(context, point_behind(context.family, context.parameters, {place.device, place.number}, i));
  return text;
}

/// Two or four words from `first` words behind the place as one value.
std::string wide_text(const PlaceContext &context, const Place &place, std::uint32_t first, std::uint32_t count) {
  const DeviceInfo &device = device_of(context, place);
  const char *name = count == 2 ? "pair" : "quad";
  if (device.kind != DeviceKind::Word || crosses(context, place, first + count))
    return fmt::format("{}({})", name, words(context, place, first, count));
  return fmt::format("{}.{}({})", device.image.str(), name, subscript(device, place.number + first));
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

std::string constant_text(const Place &place) {
  const bool wide = place.type == OperandType::DWord;
  if (place.kind == PlaceKind::Hex) {
    const std::uint64_t pattern = static_cast<std::uint64_t>(place.value) & (wide ? 0xFFFFFFFFu : 0xFFFFu);
    const std::string digits = wide ? fmt::format("0x{:08X}", pattern) : fmt::format("0x{:04X}", pattern);
    return place.value >= 0 ? digits : fmt::format("{}({})", wide ? "dword" : "word", digits);
  }
  // There is no literal for the smallest 32-bit number.
  return place.value == INT32_MIN ? "dword(-2147483647 - 1)" : fmt::format("{}", place.value);
}

std::string block_text(const PlaceContext &context, const Place &place) {
  const DeviceInfo &device = device_of(context, place);
  const std::string at = subscript(device, place.number);
  if (place.kind == PlaceKind::Digits)
    return fmt::format("{}.digit_block<{}>({})", device.image.str(), place.digits, at);
  return fmt::format("{}.block({})", device.image.str(), at);
}

}  // namespace

std::string subscript(const DeviceInfo &device, std::uint32_t number) {
  if (device.radix == 16 && number > 9)
    return fmt::format("0x{:X}", number);
  if (device.radix == 8 && number > 7)
    return fmt::format("oct({:o})", number);
  return fmt::format("{}", number);
}

ir::Place place_of(const FamilyInfo &family, const InitialValue &value) {
  const auto [name, suffix] = llvm::StringRef(value.device).split(':');
  const Operand operand = parse_operand(family, name, {});
  const bool bit = operand.kind == OperandKind::BitOfWord ||
                   (operand.kind == OperandKind::Device && family.devices[operand.device].kind == DeviceKind::Bit);
  return ir::to_place(operand, bit ? OperandType::Bit : suffix.empty() ? OperandType::Word : OperandType::DWord);
}

std::string bit_text(const PlaceContext &context, const Place &place) {
  if (place.kind == PlaceKind::Edge)
    return fmt::format("edge[{}]", place.number);
  if (place.kind == PlaceKind::Master)
    return fmt::format("master[{}]", place.number);
  const DeviceInfo &device = device_of(context, place);
  const std::string at = subscript(device, place.number);
  if (place.kind == PlaceKind::WordBit)
    return fmt::format("{}.bit({}, {})", device.image.str(), at, place.bit);
  const bool contact = device.kind == DeviceKind::Timer || device.kind == DeviceKind::Counter;
  return fmt::format("{}[{}]{}", device.image.str(), at, contact ? ".contact" : "");
}

std::string input_text(const PlaceContext &context, const Place &place) {
  if (place.is_constant())
    return constant_text(place);
  if (place.type == OperandType::WordBlock)
    return block_text(context, place);
  const DeviceInfo &device = device_of(context, place);
  if (place.kind == PlaceKind::Digits) {
    const char *width = place.type == OperandType::Word ? "word" : "dword";
    if (crosses(context, place, 4u * place.digits))
      return fmt::format("{}.{}()", digit_references(context, place), width);
    return fmt::format("{}.{}<{}>({})", device.image.str(), width, place.digits, subscript(device, place.number));
  }
  const std::uint32_t count = ir::words_of(place.type);
  return count == 1 ? word_text(context, {place.device, place.number}) : wide_text(context, place, 0, count);
}

std::string output_text(const PlaceContext &context, const Place &place) {
  const DeviceInfo &device = device_of(context, place);
  if (place.type == OperandType::WordBlock)
    return block_text(context, place);
  if (place.kind == PlaceKind::Digits) {
    if (crosses(context, place, 4u * place.digits))
      return digit_references(context, place);
    return fmt::format("{}.digits<{}>({})", device.image.str(), place.digits, subscript(device, place.number));
  }
  switch (place.type) {
  case OperandType::DWord:
    return wide_text(context, place, 0, 2);
  case OperandType::QWord:
    return wide_text(context, place, 0, 4);
  case OperandType::WordTwice:
    return words(context, place, 0, 2);
  case OperandType::DWordTwice:
    return wide_text(context, place, 0, 2) + ", " + wide_text(context, place, 2, 2);
  default:
    return word_text(context, {place.device, place.number});
  }
}

std::string object_text(const PlaceContext &context, const Place &place) {
  const DeviceInfo &device = device_of(context, place);
  const std::string at = subscript(device, place.number);
  if (place.type == OperandType::Annunciator)
    return fmt::format("{}, {}", device.image.str(), at);
  return fmt::format("{}[{}]", device.image.str(), at);
}

}  // namespace ladderc::emit
