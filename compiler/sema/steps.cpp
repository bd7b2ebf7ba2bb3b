// Program steps: the basic count of the table, more for constants of 32-bit instructions, less where all operands qualify for
// subset processing.
//
// An operand qualifies when it is a constant, an internal word (the current values of timers and counters are among them), or a
// whole word or double word of bits that starts at a multiple of 16.
#include "sema/steps.h"

#include "llvm/ADT/STLExtras.h"

namespace ladderc::sema {

namespace {

bool is_constant(const Operand &operand) {
  return operand.kind == OperandKind::Decimal || operand.kind == OperandKind::Hexadecimal;
}

bool qualifies(const FamilyInfo &family, const OperandInfo &info, const Operand &operand) {
  switch (operand.kind) {
  case OperandKind::Device: {
    DeviceKind kind = family.devices[operand.device].kind;
    return kind == DeviceKind::Word || kind == DeviceKind::Timer || kind == DeviceKind::Counter;
  }
  case OperandKind::Digits:
    return operand.value % 16 == 0 &&
           operand.digits == (info.type == OperandType::Word || info.type == OperandType::WordBlock ? 4 : 8);
  case OperandKind::Decimal:
  case OperandKind::Hexadecimal:
    return true;
  case OperandKind::BitOfWord:
  case OperandKind::Text:
  case OperandKind::Invalid:
    return false;
  }
  return false;
}

}  // namespace

std::uint32_t count_steps(const FamilyInfo &family, const InstructionInfo *info, llvm::ArrayRef<Operand> operands) {
  if (!info)
    return 1;
  std::uint32_t steps = info->steps;
  if (info->steps_subset != 0 && info->operands.size() == operands.size() &&
      llvm::all_of(llvm::zip(info->operands, operands),
                   [&](const auto &pair) { return qualifies(family, std::get<0>(pair), std::get<1>(pair)); }))
    steps = info->steps_subset;
  if (info->steps_per_constant != 0)
    steps += info->steps_per_constant * static_cast<std::uint32_t>(llvm::count_if(operands, is_constant));
  return steps;
}

}  // namespace ladderc::sema
