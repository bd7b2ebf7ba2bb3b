// Rungs, blocks and branches.
//
//     LD X0 / MPS / AND X1 / OUT Y0 / MPP / LD X2 / OR X3 / ANB / OUT Y1 / LD X4 / ...
//
// An LD opens a block. It begins a new rung where the instruction before is an output, one block is open and no branch; everywhere
// else its block lies inside the rung and waits for ANB or ORB. Outputs leave the result, so a contact behind an output goes on
// with it.
//
// One cause, one error: a rung that has an error is repaired as well as can be and reports no more; the next rung is clean again. A
// branch that is never taken back would swallow all rungs behind it, hence an LD directly behind an output is taken for the next
// rung as soon as its block turns out not to be joined. An unknown instruction may have been anything: its rung reports nothing
// further.
//
// Behind the STL of a state, outputs need no contact until the first LD: the state drives them. Behind SMCS and JCS a new rung
// begins.
#include "sema/rungs.h"

#include "llvm/ADT/STLExtras.h"

namespace ladderc::sema {

void Rungs::visit(InstructionIndex index) {
  Instruction &instruction = context_.instruction(index);
  instruction.rung = open_ ? rung_ : rung_ + 1;
  if (!instruction.info)
    return unknown(index);
  place(index, instruction.info->placement);
  switch (instruction.info->lowering) {
  case Lowering::State:
    state_head_ = true;
    break;
  case Lowering::StateEnd:
  case Lowering::MainEnd:
  case Lowering::Return:
  case Lowering::InterruptReturn:
  case Lowering::InterruptLabel:
    state_head_ = false;
    break;
  case Lowering::BusStart:
  case Lowering::Skip:
    range_head_ = index;
    break;
  default:
    state_head_ = state_head_ && instruction.info->placement != Placement::Start;
  }
}

void Rungs::place(InstructionIndex index, Placement placement) {
  switch (placement) {
  case Placement::Start:
    return start(index);
  case Placement::Series:
  case Placement::Parallel: {
    Lowering lowering = context_.instruction(index).info->lowering;
    bool contact = lowering == Lowering::Contact || lowering == Lowering::CompareContact;
    need_block(index, contact ? DiagId::NoOpenBlock : DiagId::NeedsCondition);
    check_edge_relay(index, placement);
    return leave_result(index);
  }
  case Placement::JoinBlocks:
    return join(index);
  case Placement::PushBranch:
    return push_branch(index);
  case Placement::ReadBranch:
    return read_branch(index, false);
  case Placement::PopBranch:
    return read_branch(index, true);
  case Placement::Output:
    return output(index);
  case Placement::Alone:
  case Placement::End:
    return stand_alone(index);
  case Placement::Label:
    return stand_alone(index);
  case Placement::BetweenRungs:
    return between_rungs(index);
  case Placement::Anywhere:
    return;
  }
}

// ---------------------------------------------------------------------------------------------- placements

void Rungs::start(InstructionIndex index) {
  bool closed = branches_.empty() && (blocks_.size() == 1 || (state_head_ && blocks_.empty()));
  bool behind_output = last_ == Last::Output && (closed || failed_ != kNoInstruction);
  bool behind_unknown = last_ == Last::Unknown && closed;
  if (!open_ || behind_output || behind_unknown) {
    bool may_go_on =
        open_ && closed && behind_output && failed_ == kNoInstruction && !blocks_.empty() && range_head_ == kNoInstruction;
    Continuation before{may_go_on ? blocks_.front().opened_by : kNoInstruction, index, page_feed_, 0};
    begin_rung(index);
    before_ = before;
    after_unknown_ = behind_unknown;
  } else {
    continue_rung(index);
  }
  blocks_.push_back({index, last_ == Last::Output});
  leave_result(index);
}

void Rungs::join(InstructionIndex index) {
  continue_rung(index);
  if (blocks_.size() >= 2) {
    check_edge_relay(index, Placement::JoinBlocks);
    blocks_.pop_back();
  } else if (goes_on_from_rung_before(index)) {
    go_on_from_rung_before(index);
  } else {
    if (blocks_.size() == 1 && after_unknown_)
      failed_ = index;
    else if (auto diagnostic = fail(DiagId::JoinWithoutBlocks, index))
      diagnostic->arg("count", blocks_.empty() ? "none" : "only one");
    if (blocks_.empty())
      blocks_.push_back({index, false});
  }
  leave_result(index);
}

/// An edge relay works on the line as a whole: what it leaves may go on in series, but not become one of several parallel branches.
void Rungs::check_edge_relay(InstructionIndex index, Placement placement) {
  const Lowering lowering = context_.instruction(index).info->lowering;
  Block &block = blocks_.back();
  if (lowering == Lowering::EdgeRelay) {
    block.edge_relay = index;
    return;
  }
  InstructionIndex relay = block.edge_relay;
  if (placement == Placement::JoinBlocks) {
    Block &first = blocks_[blocks_.size() - 2];
    if (relay == kNoInstruction)
      relay = first.edge_relay;
    first.edge_relay = relay;
  }
  if (relay != kNoInstruction && (placement == Placement::Parallel || lowering == Lowering::OrBlock))
    if (auto diagnostic = fail(DiagId::EdgeRelayInParallel, relay))
      diagnostic->note(DiagId::ParallelHere, context_.instruction(index).range);
}

/// A block of several contacts directly behind an output, and an ANB that has nothing else to join it to.
bool Rungs::goes_on_from_rung_before(InstructionIndex index) const {
  return before_.block != kNoInstruction && before_.contacts > 1 && blocks_.size() == 1 && branches_.empty() &&
         failed_ == kNoInstruction && context_.instruction(index).info->lowering == Lowering::AndBlock;
}

void Rungs::go_on_from_rung_before(InstructionIndex index) {
  --rung_;
  for (InstructionIndex i = before_.begin; i <= index; ++i)
    context_.instruction(i).rung = rung_;
  blocks_.front().opened_by = before_.block;
  if (before_.page_feed != kNoInstruction)
    (void)report(DiagId::NoplfInRung, before_.page_feed);
  before_ = {};
}

void Rungs::push_branch(InstructionIndex index) {
  need_block(index, DiagId::NeedsCondition);
  unsigned max = context_.family.max_branches;
  const auto count = static_cast<long long>(branches_.size() + 1);
  if (branches_.size() >= max) {
    if (auto diagnostic = fail(DiagId::BranchTooDeep, index))
      diagnostic->arg("count", count)
          .arg("max", max)
          .note(DiagId::OpenBranchSince, context_.instruction(branches_.front().opened_by).range);
  } else if (context_.family.warned_branches != 0 && count >= context_.family.warned_branches && failed_ == kNoInstruction) {
    report(DiagId::BranchDeep, index)
        .arg("count", count)
        .note(DiagId::OpenBranchSince, context_.instruction(branches_.front().opened_by).range);
  }
  branches_.push_back({index, blocks_.size(), blocks_.back().edge_relay});
  leave_result(index);
}

void Rungs::read_branch(InstructionIndex index, bool pop) {
  continue_rung(index);
  if (branches_.empty()) {
    if (auto diagnostic = fail(DiagId::NoOpenBranch, index))
      if (last_pop_ != kNoInstruction)
        diagnostic->note(DiagId::TakenBack, context_.instruction(last_pop_).range)
            .arg("mnemonic", context_.instruction(last_pop_).info->spelling);
    if (blocks_.empty())
      blocks_.push_back({index, false});
  } else {
    std::size_t depth = branches_.back().depth;
    if (blocks_.size() > depth) {
      report_open_block(blocks_[depth].opened_by, index);
      blocks_.truncate(depth);
    }
    if (!blocks_.empty())
      blocks_.back().edge_relay = branches_.back().edge_relay;
    if (pop) {
      branches_.pop_back();
      last_pop_ = index;
    }
  }
  unused_ = kNoInstruction;  // the result so far gives way to the kept one
  leave_result(index);
}

void Rungs::output(InstructionIndex index) {
  if (state_head_ && blocks_.empty()) {
    continue_rung(index);
    last_ = Last::Output;
    return;
  }
  need_block(index, DiagId::NeedsCondition);
  split_behind_open_branch(index);
  if (blocks_.size() > 1) {
    report_open_block(blocks_[1].opened_by, index);
    blocks_.truncate(1);
  }
  last_ = Last::Output;
  unused_ = kNoInstruction;
  before_ = {};
}

/// MCR, labels, END and the like: close the rung before and are one of their own.
void Rungs::stand_alone(InstructionIndex index) {
  end_rung(index);
  context_.instruction(index).rung = ++rung_;
}

void Rungs::between_rungs(InstructionIndex index) {
  if (!open_)
    return;
  if (last_ == Last::Output && branches_.empty())
    page_feed_ = index;
  else if (failed_ == kNoInstruction)
    (void)report(DiagId::NoplfInRung, index);
}

void Rungs::unknown(InstructionIndex index) {
  page_feed_ = kNoInstruction;
  continue_rung(index);
  if (blocks_.empty())
    blocks_.push_back({index, false});
  if (failed_ == kNoInstruction)
    failed_ = index;
  last_ = Last::Unknown;
  unused_ = kNoInstruction;
}

// ---------------------------------------------------------------------------------------------- the life of a rung

void Rungs::begin_rung(InstructionIndex index) {
  open_ = true;
  context_.instruction(index).rung = ++rung_;
  blocks_.clear();
  branches_.clear();
  last_ = Last::Nothing;
  unused_ = failed_ = last_pop_ = page_feed_ = range_head_ = kNoInstruction;
  after_unknown_ = false;
  before_ = {};
}

/// The instruction belongs to the rung that is open; begins one where none is.
void Rungs::continue_rung(InstructionIndex index) {
  if (!open_)
    return begin_rung(index);
  if (range_head_ != kNoInstruction)
    if (auto diagnostic = fail(DiagId::ContactExpected, index))
      diagnostic->arg("before", context_.instruction(range_head_).info->spelling);
  if (page_feed_ != kNoInstruction && failed_ == kNoInstruction)
    (void)report(DiagId::NoplfInRung, page_feed_);
  page_feed_ = kNoInstruction;
}

/// Continues the rung with something that works on the result of a block.
void Rungs::need_block(InstructionIndex index, DiagId id) {
  continue_rung(index);
  if (!blocks_.empty())
    return;
  (void)fail(id, index);
  blocks_.push_back({index, false});
}

/// The instruction leaves a result that some output has to use.
void Rungs::leave_result(InstructionIndex index) {
  last_ = Last::Contact;
  ++before_.contacts;
  if (unused_ == kNoInstruction)
    unused_ = index;
}

/// Closes the rung before MCR or END, or at the end of the list (`before` is kNoInstruction then).
void Rungs::end_rung(InstructionIndex before) {
  if (!open_)
    return;
  split_behind_open_branch(before == kNoInstruction ? static_cast<InstructionIndex>(context_.list.instructions.size() - 1)
                                                    : before);
  bool ends_with_contact = last_ == Last::Contact;
  bool ends_program = before == kNoInstruction || context_.instruction(before).info->placement == Placement::End;
  if (ends_with_contact && !ends_program) {
    (void)fail(DiagId::McrAfterContact, before);
  } else if (!branches_.empty()) {
    (void)fail(DiagId::MpsWithoutMpp, branches_.front().opened_by);
  } else if (ends_with_contact) {
    (void)fail(DiagId::RungWithoutOutput, unused_);
  }
  open_ = false;
  blocks_.clear();
  branches_.clear();
  last_ = Last::Nothing;
  page_feed_ = kNoInstruction;
}

void Rungs::finish() {
  end_rung(kNoInstruction);
}

// ---------------------------------------------------------------------------------------------- errors

/// The message, unless it would be a consequence of an earlier one in this rung.
std::optional<DiagBuilder> Rungs::fail(DiagId id, InstructionIndex index) {
  if (failed_ != kNoInstruction)
    return std::nullopt;
  failed_ = index;
  return report(id, index);
}

DiagBuilder Rungs::report(DiagId id, InstructionIndex index) const {
  const InstructionInfo *info = context_.instruction(index).info;
  DiagBuilder builder = context_.report(id, index);
  const bool spelt = info && info->placement != Placement::Label;
  builder.arg("mnemonic", spelt ? info->spelling : context_.text(context_.instruction(index).range));
  return builder;
}

void Rungs::report_open_block(InstructionIndex block, InstructionIndex user) {
  if (auto diagnostic = fail(DiagId::BlockNotJoined, block)) {
    diagnostic->arg("user", context_.instruction(user).info->spelling);
    if (blocks_.front().opened_by != block)
      diagnostic->note(DiagId::OuterBlock, context_.instruction(blocks_.front().opened_by).range);
  }
}

/// Where a branch is still open and an LD directly behind an output has opened a block that is not joined, the LD begins the next
/// rung and the branch lacks its MPP. `index` is the last instruction that belongs to the new rung.
void Rungs::split_behind_open_branch(InstructionIndex index) {
  auto *block = llvm::find_if(blocks_, [](const Block &b) { return b.after_output; });
  if (block == blocks_.end())
    return;
  InstructionIndex first = block->opened_by;
  bool failed_behind = failed_ != kNoInstruction && failed_ >= first;
  if (failed_ == kNoInstruction || failed_behind)
    report(DiagId::MpsWithoutMpp, branches_.front().opened_by).note(DiagId::NextRung, context_.instruction(first).range);
  if (!failed_behind)
    failed_ = kNoInstruction;

  std::size_t dropped = static_cast<std::size_t>(block - blocks_.begin());
  blocks_.erase(blocks_.begin(), block);
  blocks_.front().after_output = false;
  llvm::erase_if(branches_, [&](const Branch &b) { return b.opened_by < first; });
  for (Branch &branch : branches_)
    branch.depth -= dropped;
  if (last_pop_ < first)
    last_pop_ = kNoInstruction;
  if (unused_ < first)
    unused_ = first;
  ++rung_;
  for (InstructionIndex i = first; i <= index; ++i)
    context_.instruction(i).rung = rung_;
}

}  // namespace ladderc::sema
