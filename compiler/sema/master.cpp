// Master control: the regions between MC and MCR.
//
// Levels ascend from the outer region to the inner one, so the open regions are a stack. MCR closes its level and all inner ones.
// A mistake in one of the partners makes the other look wrong too: MC N0 ... MCR N1 is one mistake. Each report therefore excuses
// one partner that is left over.
#include "sema/master.h"

#include "llvm/ADT/STLExtras.h"

namespace ladderc::sema {

namespace {

/// The position of the level operand; the tables give every MC and MCR one.
unsigned level_operand(const InstructionInfo &info) {
  for (unsigned k = 0; k < info.operands.size(); ++k)
    if (info.operands[k].type == OperandType::Level)
      return k;
  return 0;
}

}  // namespace

void MasterRegions::visit(InstructionIndex index, const Resolved &resolved) {
  const InstructionInfo *info = context_.instruction(index).info;
  if (!info)
    visit_unknown(index);
  else if (info->lowering == Lowering::MasterControl)
    open(index, resolved);
  else if (info->lowering == Lowering::MasterControlReset)
    close(index, resolved);
}

/// A mnemonic that nobody knows with a level as operand was meant as one of the two.
void MasterRegions::visit_unknown(InstructionIndex index) {
  auto is_level = [&](const Operand &operand) {
    return operand.device != kNoDevice && context_.family.devices[operand.device].kind == DeviceKind::Nesting;
  };
  if (!llvm::any_of(context_.operands(index), is_level))
    return;
  ++excused_closings_;
  ++excused_regions_;
}

bool MasterRegions::level_in_range(InstructionIndex index, unsigned operand) const {
  const OperandInfo &info = context_.instruction(index).info->operands[operand];
  std::int64_t level = context_.operands(index)[operand].value;
  return level >= info.min && level <= info.max && level < context_.family.max_levels;
}

void MasterRegions::report_range(InstructionIndex index, unsigned operand) {
  const OperandInfo &info = context_.instruction(index).info->operands[operand];
  context_.report(DiagId::LevelRange, index, context_.operands(index)[operand].range)
      .arg("operand", level_name(index, operand))
      .arg("min", info.min)
      .arg("max", std::min<std::int64_t>(info.max, context_.family.max_levels - 1));
}

std::string MasterRegions::level_name(InstructionIndex index, unsigned operand) const {
  return context_.text(context_.operands(index)[operand].range).str();
}

void MasterRegions::open(InstructionIndex index, const Resolved &resolved) {
  unsigned operand = level_operand(*context_.instruction(index).info);
  if (!resolved.good(operand)) {
    ++excused_closings_;
    return;
  }
  std::int64_t level = context_.operands(index)[operand].value;
  bool misplaced = false;
  if (!level_in_range(index, operand)) {
    report_range(index, operand);
  } else if (!open_.empty() && level <= open_.back().level) {
    misplaced = true;
    InstructionIndex outer = open_.back().opened_by;
    std::string outer_name = level_name(outer, level_operand(*context_.instruction(outer).info));
    context_.report(DiagId::LevelOrder, index, context_.operands(index)[operand].range)
        .arg("operand", level_name(index, operand))
        .arg("outer", outer_name)
        .note(DiagId::OuterRegion, context_.instruction(outer).range)
        .arg("outer", outer_name);
    ++excused_closings_;
  }
  open_.push_back({index, level, misplaced});
}

void MasterRegions::close(InstructionIndex index, const Resolved &resolved) {
  unsigned operand = level_operand(*context_.instruction(index).info);
  if (!resolved.good(operand)) {
    ++excused_regions_;
    return;
  }
  std::int64_t level = context_.operands(index)[operand].value;
  bool is_open = llvm::any_of(open_, [&](const Region &r) { return r.level == level; });
  if (!is_open && !level_in_range(index, operand)) {
    report_range(index, operand);
    ++excused_regions_;
  } else if (!is_open && excused_closings_ > 0) {
    --excused_closings_;
  } else if (!is_open) {
    context_.report(DiagId::McrWithoutMc, index)
        .arg("mnemonic", context_.instruction(index).info->spelling)
        .arg("operand", level_name(index, operand));
    ++excused_regions_;
  }
  if (!open_.empty() && open_.back().misplaced && open_.back().level == level) {
    // Closes the region of the wrong level; whether those around are meant too, their own MCR will tell.
    open_.pop_back();
    ++excused_regions_;
    return;
  }
  auto *inner = llvm::find_if(open_, [&](const Region &r) { return r.level >= level; });
  open_.erase(inner, open_.end());
}

void MasterRegions::finish() {
  while (!open_.empty() && excused_regions_ > 0) {
    open_.pop_back();
    --excused_regions_;
  }
  for (const Region &region : open_)
    context_.report(DiagId::McWithoutMcr, region.opened_by)
        .arg("operand", level_name(region.opened_by, level_operand(*context_.instruction(region.opened_by).info)));
}

}  // namespace ladderc::sema
