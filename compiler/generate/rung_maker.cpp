// A rung is a network of contacts that leaves one result, and outputs behind it:
//
//     block    = start { more }
//     more     = series | parallel | block ANB | block ORB
//     outputs  = output | output behind outputs | more outputs | MPS outputs { MRD outputs } MPP outputs
//
// Behind an output a block of its own would be the next rung, unless a branch is open; what may stand there else is one contact.
#include "generate/rung_maker.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ladderc::generate {

namespace {

constexpr unsigned kTries = 60;
constexpr unsigned kGuards = 4;  ///< contacts in series before an instruction that would soon stop the CPU

}  // namespace

void RungMaker::rung() {
  ++rungs_;
  edge_relay_ = false;
  filler(Placement::BetweenRungs);
  block(2);
  outputs(3);
}

void RungMaker::condition(unsigned depth) {
  ++rungs_;
  edge_relay_ = false;
  block(depth);
}

void RungMaker::block(unsigned depth) {
  while (!instruction(catalogue_.pick(random_, Placement::Start))) {
  }
  for (unsigned n = random_.below(4); n > 0; --n)
    more(depth);
}

/// Something that changes the result of the block before.
void RungMaker::more(unsigned depth) {
  filler(Placement::Anywhere);
  const bool would_be_next_rung = behind_output_ && open_branches_ == 0;
  switch (random_.below(depth == 0 || would_be_next_rung ? 4 : 6)) {
  case 0:
  case 1:
  case 2:
    instruction(catalogue_.pick(random_, Placement::Series));
    return;
  case 3:
    instruction(catalogue_.pick(random_, edge_relay_ ? Placement::Series : Placement::Parallel));
    return;
  default:
    block(depth - 1);
    instruction(edge_relay_ ? catalogue_.find(Lowering::AndBlock) : catalogue_.pick(random_, Placement::JoinBlocks));
  }
}

void RungMaker::outputs(unsigned depth) {
  const InstructionInfo *push = catalogue_.find(Lowering::PushBranch);
  switch (depth == 0 ? 0 : random_.below(push && open_branches_ + 1 < options_.family->max_branches ? 5 : 4)) {
  case 0:
  case 1:
    return output();
  case 2:
    output();
    return outputs(depth - 1);
  case 3:
    more(depth - 1);
    return outputs(depth - 1);
  default:
    line(*push, {});
    ++open_branches_;
    outputs(depth - 1);
    for (unsigned n = random_.below(3); n > 0; --n) {
      line(*catalogue_.find(Lowering::ReadBranch), {});
      outputs(depth - 1);
    }
    line(*catalogue_.find(Lowering::PopBranch), {});
    --open_branches_;
    return outputs(depth - 1);
  }
}

void RungMaker::output() {
  filler(Placement::Anywhere);
  for (unsigned i = 0; i < kTries; ++i) {
    const InstructionInfo *info = catalogue_.pick(random_, Placement::Output);
    if (!info || !operands_.possible(*info))
      continue;
    if (info->stops_scan || (may_stop(*info, *options_.family) && random_.one_in(6)))
      return seldom_output(*info);
    if (may_stop(*info, *options_.family) && random_.one_in(2) ? instruction_on_fresh_number(*info) : instruction(info))
      return;
  }
}

/// Stops the CPU soon if it is executed: many contacts before it make that seldom.
void RungMaker::seldom_output(const InstructionInfo &info) {
  guard();
  for (unsigned i = 0; i < kTries && !instruction(&info, false); ++i) {
  }
}

void RungMaker::guard() {
  for (unsigned i = 0; i < kGuards; ++i)
    instruction(catalogue_.pick_plain_series(random_));
}

/// The source that could make the instruction fail is assigned a good number just before.
bool RungMaker::instruction_on_fresh_number(const InstructionInfo &info) {
  auto operands = operands_.make(info, true);
  std::size_t source = info.operands.size();
  bool has_block = false;
  for (std::size_t k = 0; k < info.operands.size(); ++k) {
    has_block |= info.operands[k].type == OperandType::WordBlock;
    if (info.operands[k].dir == Direction::In)
      source = k;
  }
  if (!operands || has_block || source == info.operands.size())
    return instruction(&info);
  const InstructionInfo *assignment = catalogue_.find_assignment(info.operands[source].type);
  const auto assigned = assignment ? operands_.make(*assignment, true) : std::nullopt;
  if (!assigned)
    return instruction(&info);
  line(*assignment, {operands_.tame_constant(info.operands[source].type), assigned->back()});
  (*operands)[source] = assigned->back();
  line(info, *operands);
  return true;
}

void RungMaker::filler(Placement placement) {
  if (random_.one_in(40))
    instruction(catalogue_.pick(random_, placement));
}

bool RungMaker::instruction(const InstructionInfo *info, bool tame) {
  if (!info || !operands_.possible(*info))
    return false;
  const auto operands = operands_.make(*info, tame);
  if (!operands)
    return false;
  line(*info, *operands);
  return true;
}

void RungMaker::line(const InstructionInfo &info, llvm::ArrayRef<std::string> operands) {
  edge_relay_ |= info.lowering == Lowering::EdgeRelay;
  if (info.placement != Placement::Anywhere)
    behind_output_ = info.placement == Placement::Output;
  const bool alias = !info.aliases.empty() && random_.one_in(6);
  if (info.placement != Placement::Label)
    text_ += alias ? random_.pick(info.aliases) : info.spelling;
  for (const std::string &operand : operands)
    text_ += (text_.empty() || text_.back() == '\n' ? "" : " ") + operand;
  text_ += "\n";
}

}  // namespace ladderc::generate
