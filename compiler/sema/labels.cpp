// Labels: where they are placed, and what jumps to them or calls them.
//
// A number that the model lacks is reported once, where it stands first: the jump and its label are one mistake. A label that an
// index register picks may be any, so that then none is unused.
#include "sema/labels.h"

#include "sema/names.h"

#include "llvm/ADT/STLExtras.h"

#include <utility>

namespace ladderc::sema {

namespace {

bool is_label(const FamilyInfo &family, const Operand &operand) {
  return operand.kind == OperandKind::Device && family.devices[operand.device].kind == DeviceKind::Label;
}

}  // namespace

Labels::Labels(const Context &context, llvm::ArrayRef<Resolved> resolved, InstructionIndex behind)
    : context_(context), behind_(behind) {
  for (InstructionIndex i = 0; i < behind; ++i)
    enter(i, resolved[i]);
  for (InstructionIndex i = 0; i < behind; ++i) {
    const Instruction &instruction = context.instruction(i);
    if (!instruction.info || instruction.info->placement == Placement::Label)
      continue;
    for (auto [k, operand] : llvm::enumerate(context.operands(i)))
      if (resolved[i].good(static_cast<unsigned>(k)) && is_label(context.family, operand) && operand.index == kNoDevice)
        check_use(i, operand);
  }
}

void Labels::enter(InstructionIndex index, const Resolved &resolved) {
  const Instruction &instruction = context_.instruction(index);
  if (!instruction.info)
    return;
  for (auto [k, operand] : llvm::enumerate(context_.operands(index))) {
    if (!resolved.good(static_cast<unsigned>(k)) || !is_label(context_.family, operand))
      continue;
    Uses &uses = uses_[key(operand)];
    if (!context_.exists(operand)) {
      if (!std::exchange(uses.reported, true))
        report_missing(index, operand);
      continue;
    }
    if (instruction.info->placement == Placement::Label)
      enter_place(index, operand, uses);
    else if (operand.index == kNoDevice)
      enter_use(index, operand, uses);
    else
      jumps_by_index_ = true;
  }
}

void Labels::report_missing(InstructionIndex index, const Operand &operand) const {
  const DeviceInfo &device = context_.device(operand);
  const bool interrupt = context_.instruction(index).info->lowering == Lowering::InterruptLabel;
  context_.report(interrupt ? DiagId::NoSuchInterrupt : DiagId::NoSuchLabel, index, operand.range)
      .arg("operand", context_.text(operand.range))
      .arg("model", context_.model)
      .arg("numbers", numbers_text(context_.family, operand.device,
                                   existing_numbers(device, context_.model, context_.parameters.points[operand.device])));
}

void Labels::enter_place(InstructionIndex index, const Operand &operand, Uses &uses) {
  if (is_end(operand))
    context_.report(DiagId::EndLabel, index).arg("label", name(operand)).arg("what", "it is nowhere placed");
  else if (uses.placed == kNoInstruction)
    uses.placed = index;
  else
    context_.report(DiagId::LabelTwice, index)
        .arg("label", name(operand))
        .note(DiagId::FirstPlace, context_.instruction(uses.placed).range)
        .arg("label", name(operand));
}

void Labels::enter_use(InstructionIndex index, const Operand &operand, Uses &uses) {
  const Instruction &instruction = context_.instruction(index);
  const bool calls = instruction.info->lowering == Lowering::CallRoutine;
  if (!calls && instruction.info->lowering != Lowering::Jump)
    return;
  InstructionIndex &first = calls ? uses.called : uses.jumped;
  const InstructionIndex other = calls ? uses.jumped : uses.called;
  if (first == kNoInstruction && other != kNoInstruction) {
    const llvm::StringRef spelling = context_.instruction(other).info->spelling;
    context_.report(DiagId::LabelJumpAndCall, index, operand.range)
        .arg("mnemonic", instruction.info->spelling)
        .arg("label", name(operand))
        .arg("other", spelling)
        .note(DiagId::UsedHere, context_.instruction(other).range)
        .arg("other", spelling);
  }
  if (first == kNoInstruction)
    first = index;
}

void Labels::check_use(InstructionIndex index, const Operand &operand) const {
  const Instruction &instruction = context_.instruction(index);
  const Uses &uses = this->uses(operand);
  if (uses.reported)
    return;
  if (is_end(operand)) {
    if (instruction.info->lowering == Lowering::CallRoutine)
      context_.report(DiagId::EndLabel, index, operand.range).arg("label", name(operand)).arg("what", "no subroutine begins there");
    return;
  }
  if (uses.placed == kNoInstruction)
    context_.report(DiagId::LabelUndefined, index, operand.range)
        .arg("mnemonic", instruction.info->spelling)
        .arg("label", name(operand));
}

void Labels::check_uses() const {
  if (jumps_by_index_)
    return;
  for (InstructionIndex i = 0; i < behind_; ++i) {
    const Instruction &instruction = context_.instruction(i);
    if (!instruction.info || instruction.info->lowering != Lowering::Label || instruction.operand_count == 0)
      continue;
    const Operand &operand = context_.operands(i).front();
    const Uses &uses = this->uses(operand);
    if (uses.placed == i && uses.jumped == kNoInstruction && uses.called == kNoInstruction)
      context_.report(DiagId::LabelUnused, i).arg("label", name(operand));
  }
}

const Labels::Uses &Labels::uses(const Operand &operand) const {
  static const Uses kNone;
  auto found = uses_.find(key(operand));
  return found == uses_.end() ? kNone : found->second;
}

InstructionIndex Labels::place(const Operand &operand) const {
  return uses(operand).placed;
}

bool Labels::is_end(const Operand &operand) const {
  return context_.family.end_label >= 0 && operand.value == context_.family.end_label;
}

std::string Labels::name(const Operand &operand) const {
  return device_name(context_.family, operand.device, static_cast<std::uint64_t>(operand.value));
}

}  // namespace ladderc::sema
