// What lies inside of what: routines, loops, states of the step ladder, and the ranges that a condition switches or skips.
//
//     main program ... FEND  P10 subroutine SRET  I001 interrupt routine IRET  END
//
// Scopes are parts that are entered as a whole; they form a tree. Ranges (MC, SMCS, JCS) lie on a stack of their own, because their
// ends close several at once; each must end in the scope that it began in. Behind the end of the main program or of a routine, a
// label begins the next part: a routine, where it is called or SRET follows, else a part that jumps reach.
//
// One mistake makes others: a wrong beginning excuses its end, and where an end is missing, the list is looked through to tell
// whether it stands further on (then what stands between is wrong) or nowhere (then the beginning is).
#include "sema/ranges.h"

#include "sema/names.h"

#include "llvm/ADT/STLExtras.h"

namespace ladderc::sema {

Ranges::Ranges(const Context &context, const Labels &labels, InstructionIndex behind)
    : context_(context), labels_(labels), behind_(behind), scope_of_(behind, kMainScope), master_of_(behind, kNoInstruction) {
  scopes_.push_back({ScopeKind::Main, kMainScope, kNoInstruction});
}

void Ranges::visit(InstructionIndex index) {
  const InstructionInfo *info = context_.instruction(index).info;
  scope_of_[index] = scope_;
  auto *master = llvm::find_if(llvm::reverse(ranges_), [](const Range &r) { return r.kind != Lowering::Skip; }).base();
  master_of_[index] = master == ranges_.begin() ? kNoInstruction : (master - 1)->opened_by;
  if (!info || info->lowering == Lowering::Nothing || info->operands.size() != context_.operands(index).size())
    return;
  note_unreachable(index);
  switch (info->lowering) {
  case Lowering::Label:
    place_label(index);
    break;
  case Lowering::InterruptLabel:
    place_interrupt(index);
    break;
  case Lowering::Return:
    end_routine(index, ScopeKind::Subroutine);
    break;
  case Lowering::InterruptReturn:
    end_routine(index, ScopeKind::Interrupt);
    break;
  case Lowering::MainEnd:
    end_main(index);
    break;
  case Lowering::State:
    open_state(index);
    break;
  case Lowering::StateEnd:
    close_state(index);
    break;
  case Lowering::Loop:
    open_loop(index);
    break;
  case Lowering::LoopEnd:
    close_loop(index);
    break;
  case Lowering::MasterControl:
  case Lowering::BusStart:
  case Lowering::Skip:
    open_range(index);
    break;
  case Lowering::MasterControlReset:
    close_ranges(index, Lowering::MasterControl);
    break;
  case Lowering::BusEnd:
    close_ranges(index, Lowering::BusStart);
    break;
  case Lowering::SkipEnd:
    close_ranges(index, Lowering::Skip);
    break;
  default:
    break;
  }
  last_ = index;
}

void Ranges::finish() {
  unwind(kMainScope);
  report_open(kMainScope);
}

// ---------------------------------------------------------------------------------------------- routines

void Ranges::note_unreachable(InstructionIndex index) {
  const InstructionInfo &info = *context_.instruction(index).info;
  const bool returns = info.lowering == Lowering::Return || info.lowering == Lowering::InterruptReturn;  // an error of their own
  if (!ended_ || unreachable_ || returns || info.placement == Placement::Label || info.placement == Placement::End)
    return;
  unreachable_ = true;
  context_.report(DiagId::Unreachable, index).arg("mnemonic", text(index));
}

void Ranges::place_label(InstructionIndex index) {
  const Operand &label = operand(index);
  bool routine = labels_.is_called(label);
  if (ended_)
    routine |= !labels_.is_jumped(label) &&
               goes_on(index, Lowering::Return, {Lowering::InterruptReturn, Lowering::InterruptLabel, Lowering::MainEnd});
  if (!routine) {
    if (ended_ && first_routine_ != kNoInstruction)
      push_scope(ScopeKind::Apart, index);
    ended_ = false;
    scope_of_[index] = scope_;
    return;
  }
  // A subroutine may go on in the next one, whose SRET serves both.
  if (!ended_ && (kind() == ScopeKind::Subroutine || kind() == ScopeKind::Interrupt))
    pop_scope();
  else if (!ended_ && !is_forbidden(index, {true, true, true})) {
    context_.report(DiagId::RoutineInMain, index).arg("label", text(index));
    ++excused_returns_;
    return;
  } else if (!ended_) {
    return;
  }
  open_routine(index, ScopeKind::Subroutine);
}

void Ranges::place_interrupt(InstructionIndex index) {
  if (!ended_ && (kind() == ScopeKind::Subroutine || kind() == ScopeKind::Interrupt)) {
    report_open(scope_);
    pop_scope();
    ended_ = true;
  } else if (!ended_ && is_forbidden(index, {true, true, true})) {
    ++excused_returns_;
    return;
  }
  if (!ended_ || !main_ended_) {
    context_.report(DiagId::RoutineInMain, index).arg("label", text(index));
    ++excused_returns_;
    return;
  }
  open_routine(index, ScopeKind::Interrupt);
}

void Ranges::open_routine(InstructionIndex index, ScopeKind kind) {
  ended_ = false;
  if (first_routine_ == kNoInstruction)
    first_routine_ = index;
  push_scope(kind, index);
  scope_of_[index] = scope_;
}

/// SRET and IRET.
void Ranges::end_routine(InstructionIndex index, ScopeKind kind) {
  if (this->kind() == ScopeKind::Loop && goes_on(index, Lowering::LoopEnd, {Lowering::Loop, Lowering::Label})) {
    (void)is_forbidden(index, {true, false, false});
    return;
  }
  if (state_of(index) != kMainScope) {
    (void)is_forbidden(index, {false, true, false});
    return;
  }
  const ScopeIndex routine = routine_of(scope_);
  const ScopeKind around = scopes_[routine].kind;
  if (around == kind) {
    unwind(routine);
    pop_scope();
    ended_ = true;
    unreachable_ = false;
    return;
  }
  if (around == ScopeKind::Subroutine || around == ScopeKind::Interrupt) {
    (void)is_forbidden(index, {false, false, true});
  } else if (excused_returns_ > 0) {
    --excused_returns_;
  } else {
    const bool subroutine = kind == ScopeKind::Subroutine;
    context_.report(subroutine ? DiagId::ReturnInMain : DiagId::InterruptNotBegun, index).arg("mnemonic", text(index));
  }
}

/// FEND.
void Ranges::end_main(InstructionIndex index) {
  using enum Lowering;
  const bool in_loop = kind() == ScopeKind::Loop, in_state = state_of(index) != kMainScope;
  const ScopeKind around = scopes_[routine_of(scope_)].kind;
  if ((in_loop && goes_on(index, LoopEnd, {Loop, Label, InterruptLabel})) ||
      (in_state && goes_on(index, StateEnd, {State, Label, InterruptLabel, MainEnd})) ||
      (around == ScopeKind::Subroutine && goes_on(index, Return, {Label, InterruptLabel, MainEnd})) ||
      (around == ScopeKind::Interrupt && goes_on(index, InterruptReturn, {Label, InterruptLabel, MainEnd}))) {
    (void)is_forbidden(index, {true, true, true});
    return;
  }
  const bool lacks_end = around == ScopeKind::Subroutine || around == ScopeKind::Interrupt;
  unwind(kMainScope);
  llvm::SmallVector<Range, 4> open(ranges_.begin(), ranges_.end());
  for (const Range &range : llvm::reverse(open)) {
    const Lowering end = range.kind == MasterControl ? MasterControlReset : range.kind == BusStart ? BusEnd : SkipEnd;
    if (!goes_on(index, end, {}))
      continue;
    const std::string region = region_name(range.opened_by);
    context_.report(DiagId::InMaster, index)
        .arg("mnemonic", text(index))
        .arg("region", region)
        .note(DiagId::RangeHere, context_.instruction(range.opened_by).range)
        .arg("range", region);
    return;
  }
  report_open(kMainScope);
  ranges_.clear();
  if (first_routine_ != kNoInstruction && !lacks_end)
    context_.report(DiagId::RoutineInMain, first_routine_).arg("label", text(first_routine_));
  first_routine_ = kNoInstruction;
  ended_ = main_ended_ = true;
  unreachable_ = false;
}

// ---------------------------------------------------------------------------------------------- states and loops

void Ranges::open_state(InstructionIndex index) {
  if (last_ != kNoInstruction && lowering(last_) == Lowering::State) {
    count_merge(index);
    if (kind() == ScopeKind::State)
      scopes_[scope_].last_stl = index;
    return;
  }
  merge_ = 1;
  if (is_forbidden(index, {true, false, true})) {
    ++excused_states_;
    return;
  }
  if (kind() == ScopeKind::State)
    pop_scope();
  push_scope(ScopeKind::State, index);
  scopes_[scope_].last_stl = index;
}

void Ranges::count_merge(InstructionIndex index) {
  ++merge_;
  const FamilyInfo &family = context_.family;
  if (family.max_merge != 0 && merge_ == family.max_merge + 1u)
    context_.report(DiagId::MergeTooWide, index).arg("mnemonic", text(index)).arg("count", merge_).arg("max", family.max_merge);
  else if (family.warned_merge != 0 && merge_ == family.warned_merge)
    context_.report(DiagId::MergeWide, index).arg("mnemonic", text(index)).arg("count", merge_).arg("max", merge_ - 1);
}

void Ranges::close_state(InstructionIndex index) {
  const ScopeIndex state = state_of(index);
  if (state != kMainScope) {
    if (kind() == ScopeKind::Loop && goes_on(index, Lowering::LoopEnd, {Lowering::Loop, Lowering::State, Lowering::MainEnd})) {
      (void)is_forbidden(index, {true, false, false});
      ++excused_loops_;
      pop_scope();
    }
    unwind(state);
    pop_scope();
  } else if (excused_states_ > 0) {
    excused_states_ = 0;
  } else {
    context_.report(DiagId::StateNotOpen, index).arg("mnemonic", text(index));
  }
}

void Ranges::open_loop(InstructionIndex index) {
  unsigned depth = 1;
  for (ScopeIndex s = scope_; s != kMainScope; s = scopes_[s].parent)
    depth += scopes_[s].kind == ScopeKind::Loop;
  if (context_.family.max_loops != 0 && depth == context_.family.max_loops + 1u)
    context_.report(DiagId::LoopTooDeep, index)
        .arg("mnemonic", text(index))
        .arg("count", depth)
        .arg("max", context_.family.max_loops);
  push_scope(ScopeKind::Loop, index);
}

void Ranges::close_loop(InstructionIndex index) {
  if (kind() == ScopeKind::Loop) {
    pop_scope();
    scope_of_[index] = scope_;
  } else if (excused_loops_ > 0) {
    --excused_loops_;
  } else {
    context_.report(DiagId::LoopNotOpen, index).arg("mnemonic", text(index));
  }
}

// ---------------------------------------------------------------------------------------------- ranges

void Ranges::open_range(InstructionIndex index) {
  const Lowering kind = lowering(index);
  const bool master = kind == Lowering::MasterControl;
  const bool wrong = kind != Lowering::Skip && is_forbidden(index, {master, true, master});
  // Where it is wrong it still has its end, which is not wrong once more.
  ranges_.push_back({kind, master && !wrong ? operand(index).value : 0, index, wrong ? ScopeIndex(~0u) : scope_});
}

/// MCR closes its level and those inside, the others all of their kind.
void Ranges::close_ranges(InstructionIndex index, Lowering kind) {
  const bool master = kind == Lowering::MasterControl;
  const std::int64_t level = master ? operand(index).value : 0;
  bool found = false, crosses = false;
  llvm::erase_if(ranges_, [&](const Range &range) {
    const bool wrong = range.scope == ScopeIndex(~0u);
    if (range.kind != kind || (master && !wrong && range.level < level))
      return false;
    found = true;
    crosses |= !wrong && range.scope != scope_;
    return true;
  });
  if (crosses) {
    if (scopes_[scope_].kind == ScopeKind::State && kind != Lowering::Skip)
      (void)is_forbidden(index, {false, true, false});
    else
      context_.report(DiagId::RangesCross, index)
          .arg("mnemonic", text(index))
          .arg("range", scope_name(scope_))
          .note(DiagId::RangeHere, context_.instruction(scopes_[scope_].opened_by).range)
          .arg("range", scope_name(scope_));
    return;
  }
  if (found || master)
    return;  // an MCR without MC: master.cpp
  context_.report(kind == Lowering::BusStart ? DiagId::BusNotOpen : DiagId::SkipNotOpen, index).arg("mnemonic", text(index));
}

// ---------------------------------------------------------------------------------------------- scopes

DiagId Ranges::misplaced(InstructionIndex index, ScopeKind around) const {
  using enum Lowering;
  const Lowering what = lowering(index);
  if (around == ScopeKind::Loop)
    return DiagId::InLoop;
  if (around == ScopeKind::State) {
    const bool switches = what == MasterControl || what == MasterControlReset || what == BusStart || what == BusEnd;
    return switches || what == Return ? DiagId::InState : DiagId::RoutineInState;
  }
  return what == MainEnd ? DiagId::EndInRoutine : DiagId::InRoutine;
}

bool Ranges::is_forbidden(InstructionIndex index, Forbidden where) {
  for (ScopeIndex s = scope_; s != kMainScope; s = scopes_[s].parent) {
    const Scope &scope = scopes_[s];
    const bool loop = scope.kind == ScopeKind::Loop, state = scope.kind == ScopeKind::State;
    const bool routine = scope.kind == ScopeKind::Subroutine || scope.kind == ScopeKind::Interrupt;
    if (!((loop && where.in_loop) || (state && where.in_state) || (routine && where.in_routine)))
      continue;
    DiagBuilder builder = context_.report(misplaced(index, scope.kind), index);
    builder.arg("mnemonic", text(index));
    if (routine)
      builder.arg("label", text(scope.opened_by));
    builder.note(DiagId::RangeHere, context_.instruction(scope.opened_by).range).arg("range", scope_name(s));
    return true;
  }
  return false;
}

void Ranges::push_scope(ScopeKind kind, InstructionIndex index) {
  const bool part = kind != ScopeKind::Loop && kind != ScopeKind::State;
  if (part)
    unwind(kMainScope);  // loops that stand behind the end of a routine
  scopes_.push_back({kind, part ? kMainScope : scope_, index});
  scope_ = static_cast<ScopeIndex>(scopes_.size() - 1);
}

/// Leaves the innermost scope. Ranges that began in it end with it.
void Ranges::pop_scope() {
  const ScopeIndex left = scope_;
  for (const Range &range : ranges_)
    if (range.scope == left && range.kind != Lowering::MasterControl)
      context_.report(range.kind == Lowering::BusStart ? DiagId::BusNotClosed : DiagId::SkipNotClosed, range.opened_by)
          .arg("mnemonic", text(range.opened_by));
  // Their ends may still follow.
  for (Range &range : ranges_)
    if (range.scope == left)
      range.scope = ScopeIndex(~0u);
  scope_ = scopes_[left].parent;
}

/// Leaves all scopes inside of `to`, which lack their ends.
void Ranges::unwind(ScopeIndex to) {
  while (scope_ != to && scope_ != kMainScope) {
    report_open(scope_);
    pop_scope();
  }
}

/// Reports that the end of a scope is missing; of the main program, the ends of ranges.
void Ranges::report_open(ScopeIndex index) {
  const Scope &scope = scopes_[index];
  switch (scope.kind) {
  case ScopeKind::Loop:
    context_.report(DiagId::LoopNotClosed, scope.opened_by).arg("mnemonic", text(scope.opened_by));
    break;
  case ScopeKind::State:
    context_.report(DiagId::StateNotClosed, scope.opened_by).arg("mnemonic", text(scope.opened_by));
    break;
  case ScopeKind::Subroutine:
    context_.report(DiagId::SubroutineNotEnded, scope.opened_by).arg("label", text(scope.opened_by));
    break;
  case ScopeKind::Interrupt:
    context_.report(DiagId::InterruptNotEnded, scope.opened_by).arg("label", text(scope.opened_by));
    break;
  case ScopeKind::Apart:
    break;
  case ScopeKind::Main:
    for (const Range &range : ranges_)
      if (range.scope == kMainScope && range.kind != Lowering::MasterControl)
        context_.report(range.kind == Lowering::BusStart ? DiagId::BusNotClosed : DiagId::SkipNotClosed, range.opened_by)
            .arg("mnemonic", text(range.opened_by));
    break;
  }
}

/// True where `end` stands further on, before the program ends or one of `stops` comes.
bool Ranges::goes_on(InstructionIndex index, Lowering end, llvm::ArrayRef<Lowering> stops) const {
  for (InstructionIndex i = index + 1; i < behind_; ++i) {
    if (!context_.instruction(i).info)
      continue;
    if (lowering(i) == end)
      return true;
    if (llvm::is_contained(stops, lowering(i)))
      return false;
  }
  return false;
}

// ---------------------------------------------------------------------------------------------- names and look-up

ScopeIndex Ranges::state_of(InstructionIndex index) const {
  for (ScopeIndex s = scope_of_[index]; s != kMainScope; s = scopes_[s].parent)
    if (scopes_[s].kind == ScopeKind::State)
      return s;
  return kMainScope;
}

ScopeIndex Ranges::routine_of(ScopeIndex index) const {
  while (scopes_[index].kind == ScopeKind::Loop || scopes_[index].kind == ScopeKind::State)
    index = scopes_[index].parent;
  return index;
}

llvm::SmallVector<std::int64_t, 2> Ranges::states(ScopeIndex index) const {
  llvm::SmallVector<std::int64_t, 2> numbers;
  const Scope &scope = scopes_[index];
  if (scope.kind != ScopeKind::State)
    return numbers;
  for (InstructionIndex i = scope.opened_by; i <= scope.last_stl; ++i)
    if (context_.instruction(i).info && lowering(i) == Lowering::State && !context_.operands(i).empty())
      numbers.push_back(operand(i).value);
  return numbers;
}

std::string Ranges::scope_name(ScopeIndex index) const {
  const Scope &scope = scopes_[index];
  switch (scope.kind) {
  case ScopeKind::Main:
    return "the main program";
  case ScopeKind::Apart:
    return "the part behind a routine that begins with " + text(scope.opened_by);
  case ScopeKind::Subroutine:
  case ScopeKind::Interrupt:
    return "the routine " + text(scope.opened_by);
  case ScopeKind::Loop:
    return "the loop";
  case ScopeKind::State:
    return "the state " + context_.text(operand(scope.opened_by).range).str();
  }
  return {};
}

std::string Ranges::region_name(InstructionIndex opener) const {
  const std::string mnemonic = context_.instruction(opener).info->spelling.str();
  return lowering(opener) == Lowering::MasterControl ? mnemonic + " " + context_.text(operand(opener).range).str() : mnemonic;
}

/// The mnemonic as written; of a label, the label.
std::string Ranges::text(InstructionIndex index) const {
  const Instruction &instruction = context_.instruction(index);
  const bool label = instruction.info && instruction.info->placement == Placement::Label;
  if (label && !context_.operands(index).empty())
    return labels_.name(operand(index));
  return instruction.info ? instruction.info->spelling.str() : context_.text(instruction.range).str();
}

Lowering Ranges::lowering(InstructionIndex index) const {
  return context_.instruction(index).info->lowering;
}

}  // namespace ladderc::sema
