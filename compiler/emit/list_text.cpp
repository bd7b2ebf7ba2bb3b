// The list's own words for comments of the output.
#include "emit/list_text.h"

#include <fmt/format.h>

namespace ladderc::emit {

namespace {

std::string number_text(const DeviceInfo &device, std::int64_t number) {
  return device.radix == 16 ? fmt::format("{:X}", number) : device.radix == 8 ? fmt::format("{:o}", number) : fmt::format("{}", number);
}

std::string operand_text(const FamilyInfo &family, const Operand &operand) {
  if (operand.kind == OperandKind::Decimal)
    return fmt::format("K{}", operand.value);
  if (operand.kind == OperandKind::Hexadecimal)
    return fmt::format("H{:X}", operand.value);
  const DeviceInfo &device = family.devices[operand.device];
  const std::string text = device.prefix.str() + number_text(device, operand.value);
  if (operand.kind == OperandKind::Digits)
    return fmt::format("K{}{}", operand.digits, text);
  return operand.kind == OperandKind::BitOfWord ? fmt::format("{}.{:X}", text, operand.bit) : text;
}

}  // namespace

std::string list_text(const CheckedProgram &program, const Instruction &instruction) {
  std::string text = instruction.info->spelling.str();
  for (const Operand &operand : program.list.operands_of(instruction))
    text += " " + operand_text(*program.family, operand);
  return text;
}

std::string comment_text(const SourceSet &sources, SourceRange range) {
  std::string text = sources.text(range).str();
  for (char &c : text)
    if (static_cast<unsigned char>(c) < 0x20)
      c = ' ';
  return text;
}

}  // namespace ladderc::emit
