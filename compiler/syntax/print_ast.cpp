// `--emit=ast`: what the parser made of a list, one instruction a line, operands taken apart.
#include "syntax/parser.h"

#include "llvm/Support/Format.h"

namespace ladderc {
namespace {

void print_number(std::int64_t value, unsigned radix, llvm::raw_ostream &out) {
  if (radix == 16)
    out << llvm::format("%llX", static_cast<unsigned long long>(value));
  else if (radix == 8)
    out << llvm::format("%llo", static_cast<unsigned long long>(value));
  else
    out << value;
}

void print_device(const FamilyInfo &family, const Operand &operand, llvm::raw_ostream &out) {
  const DeviceInfo &device = family.devices[operand.device];
  out << device.prefix << ' ';
  print_number(operand.value, device.radix, out);
}

void print_operand(const ListProgram &program, const Operand &operand, const SourceSet &sources, llvm::raw_ostream &out) {
  const FamilyInfo &family = *program.family;
  switch (operand.kind) {
  case OperandKind::Device:
    print_device(family, operand, out << "device ");
    break;
  case OperandKind::BitOfWord:
    print_number(operand.bit, 16, out << "bit ");
    print_device(family, operand, out << " of ");
    break;
  case OperandKind::Digits:
    print_device(family, operand, out << unsigned(operand.digits) << " digits from ");
    break;
  case OperandKind::Decimal:
    out << "decimal " << operand.value;
    break;
  case OperandKind::Hexadecimal:
    print_number(operand.value, 16, out << "hexadecimal ");
    break;
  case OperandKind::Text:
    out << "text " << program.texts[static_cast<std::size_t>(operand.value)];
    break;
  case OperandKind::Invalid:
    out << "unreadable " << sources.text(operand.range);
    break;
  }
  if (operand.index == kForeignIndex)
    out << " index Z " << unsigned(operand.index_number);
  else if (operand.index != kNoDevice)
    out << " index " << family.devices[operand.index].prefix << ' ' << unsigned(operand.index_number);
}

}  // namespace

void print_ast(const ListProgram &program, const SourceSet &sources, llvm::raw_ostream &out) {
  for (const Instruction &instruction : program.instructions) {
    out << sources[program.file].line_of(instruction.range.begin) << ": ";
    if (instruction.candidates.empty())
      out << "unknown " << sources.text(instruction.range);
    else
      out << instruction.candidates.front()->spelling;
    for (const Operand &operand : program.operands_of(instruction))
      print_operand(program, operand, sources, out << " | ");
    out << '\n';
  }
}

}  // namespace ladderc
