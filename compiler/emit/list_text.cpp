// The list's own words for comments of the output.
#include "emit/list_text.h"

#include <fmt/format.h>

namespace ladderc::emit {

namespace {

std::string number_text(const DeviceInfo &device, std::int64_t number) {
  return device.radix == 16  ? fmt::format("{:X}", number)
         : device.radix == 8 ? fmt::format("{:o}", number)
                             : fmt::format("{}", number);
}

std::string plain_text(const CheckedProgram &program, const Operand &operand) {
  const FamilyInfo &family = *program.family;
  if (operand.kind == OperandKind::Decimal)
    return fmt::format("K{}", operand.value);
  if (operand.kind == OperandKind::Hexadecimal)
    return fmt::format("H{:X}", operand.value);
  if (operand.kind == OperandKind::Text)
    return "\"" + program.list.texts[static_cast<std::size_t>(operand.value)] + "\"";
  const DeviceInfo &device = family.devices[operand.device];
  std::string digits = number_text(device, operand.value);
  if (digits.size() < device.name_digits)
    digits.insert(0, device.name_digits - digits.size(), '0');
  const std::string text = device.prefix.str() + digits;
  if (operand.kind == OperandKind::Digits)
    return fmt::format("K{}{}", operand.digits, text);
  return operand.kind == OperandKind::BitOfWord ? fmt::format("{}.{:X}", text, operand.bit) : text;
}

std::string operand_text(const CheckedProgram &program, const Operand &operand) {
  std::string text = plain_text(program, operand);
  if (operand.index != kNoDevice)
    text += fmt::format("{}{}", program.family->devices[operand.index].prefix.str(), unsigned(operand.index_number));
  return text;
}

}  // namespace

std::string list_text(const CheckedProgram &program, const Instruction &instruction) {
  // A label is its own mnemonic.
  std::string text = instruction.info->placement == Placement::Label ? "" : instruction.info->spelling.str();
  for (const Operand &operand : program.list.operands_of(instruction))
    text += (text.empty() ? "" : " ") + operand_text(program, operand);
  return text;
}

bool belongs_to_file(const SourceSet &sources, SourceRange range) {
  return sources[range.file].text().take_front(range.begin).rtrim(" \t").ends_with(";;;");
}

std::string comment_text(const SourceSet &sources, SourceRange range) {
  std::string text;
  for (llvm::StringRef rest = sources.text(range); !rest.empty();) {
    const auto lead = static_cast<unsigned char>(rest.front());
    const std::size_t size = std::min<std::size_t>(lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4, rest.size());
    const llvm::StringRef character = rest.take_front(size);
    rest = rest.drop_front(size);
    // U+202A-202E and U+2066-2069: compilers warn of them, and a comment could seem to be code.
    const bool turns = (character >= "\xE2\x80\xAA" && character <= "\xE2\x80\xAE") ||
                       (character >= "\xE2\x81\xA6" && character <= "\xE2\x81\xA9");
    if (!turns)
      text += lead < 0x20 || lead == 0x7F ? " " : character.str();
  }
  return text;
}

}  // namespace ladderc::emit
