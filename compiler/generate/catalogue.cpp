// Sorting the table's entries by placement, kind and mnemonic.
#include "generate/catalogue.h"

#include "llvm/ADT/STLExtras.h"

namespace ladderc::generate {

namespace {

bool in_profile(const InstructionInfo &info, const GenerateOptions &options) {
  switch (options.profile) {
  case GenerateProfile::Contacts:
    return (info.lowering == Lowering::Contact && info.edge == Execution::EveryScan) || info.lowering == Lowering::AndBlock ||
           info.lowering == Lowering::OrBlock || info.lowering == Lowering::Store || info.lowering == Lowering::End;
  case GenerateProfile::Mixed:
    return !may_stop(info, *options.family) && info.style != CallStyle::System;
  case GenerateProfile::All:
    return true;
  }
  return false;
}

/// Entries of one kind do the same sort of thing.
unsigned kind_of(const InstructionInfo &info) {
  return static_cast<unsigned>(info.lowering) * 64 + static_cast<unsigned>(info.style) * 4 + info.stops_scan * 2 +
         (info.edge != Execution::EveryScan);
}

/// Opens a range, or names a label: whoever uses it has to do more than write one line.
bool needs_more(Lowering lowering) {
  switch (lowering) {
  case Lowering::MasterControl:
  case Lowering::BusStart:
  case Lowering::Skip:
  case Lowering::Jump:
  case Lowering::CallRoutine:
    return true;
  default:
    return false;
  }
}

unsigned weight_of(const InstructionInfo &info) {
  if (info.stops_scan)
    return 6;
  switch (info.lowering) {
  case Lowering::Contact:
    return info.edge == Execution::EveryScan ? 120 : 25;
  case Lowering::CompareContact:
    return 30;
  case Lowering::Store:
    return 90;
  case Lowering::Call:
    return info.style == CallStyle::Value ? 120 : info.style == CallStyle::Status ? 80 : 50;
  case Lowering::CallWithResult:
    return info.style == CallStyle::Method ? 60 : info.style == CallStyle::Memory ? 40 : 20;
  case Lowering::Transfer:
    return 40;
  default:
    return 20;
  }
}

}  // namespace

Catalogue::Catalogue(const GenerateOptions &options) {
  const llvm::StringRef model = options.model.empty() ? options.family->models.front() : options.model;
  for (const InstructionInfo &info : options.family->instructions)
    if ((info.models.empty() || llvm::is_contained(info.models, model)) && in_profile(info, options) &&
        (!options.accepts || options.accepts(info)))
      add(info);
}

void Catalogue::add(const InstructionInfo &info) {
  by_lowering_[info.lowering].push_back(&info);
  if (info.placement == Placement::Series && info.lowering == Lowering::Contact && info.edge == Execution::EveryScan)
    plain_series_.push_back(&info);
  if (info.style == CallStyle::Value && info.function.empty() && info.inputs.size() == 1 && info.operands.size() == 2 &&
      info.execution == Execution::WhileOn)
    assignments_.push_back(&info);
  if (info.placement == Placement::Alone && info.lowering == Lowering::Call)
    alone_.push_back(&info);
  if (needs_more(info.lowering))
    return;
  Kind &kind = placements_[info.placement].try_emplace(kind_of(info), Kind{weight_of(info), {}}).first->second;
  for (auto &entries : kind.mnemonics)
    if (entries.front()->mnemonic == info.mnemonic) {
      entries.push_back(&info);
      return;
    }
  kind.mnemonics.push_back({&info});
}

const InstructionInfo *Catalogue::pick(Random &random, Placement placement) const {
  const auto found = placements_.find(placement);
  if (found == placements_.end())
    return nullptr;
  unsigned total = 0;
  for (const auto &[id, kind] : found->second)
    total += kind.weight;
  unsigned at = random.below(total);
  for (const auto &[id, kind] : found->second) {
    if (at < kind.weight)
      return random.pick(llvm::ArrayRef(random.pick(llvm::ArrayRef(kind.mnemonics))));
    at -= kind.weight;
  }
  return nullptr;
}

const InstructionInfo *Catalogue::find(Lowering lowering) const {
  const auto found = by_lowering_.find(lowering);
  return found == by_lowering_.end() ? nullptr : found->second.front();
}

const InstructionInfo *Catalogue::pick(Random &random, Lowering lowering) const {
  const auto found = by_lowering_.find(lowering);
  return found == by_lowering_.end() ? nullptr : random.pick(llvm::ArrayRef(found->second));
}

const InstructionInfo *Catalogue::pick_alone(Random &random) const {
  return alone_.empty() ? nullptr : random.pick(llvm::ArrayRef(alone_));
}

const InstructionInfo *Catalogue::pick_plain_series(Random &random) const {
  return plain_series_.empty() ? nullptr : random.pick(llvm::ArrayRef(plain_series_));
}

const InstructionInfo *Catalogue::find_assignment(OperandType type) const {
  for (const InstructionInfo *info : assignments_)
    if (info->operands.back().type == type)
      return info;
  return nullptr;
}

}  // namespace ladderc::generate
