// Jumps and calls: whether they can be followed.
//
// A jump may leave loops, and nothing else; it enters nothing. So its target lies in a scope around it, with loops only in between.
// Calls form a graph of routines. The level of a call is one more than the highest level at which its routine can be running.
#include "sema/jumps.h"

#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/DenseSet.h"
#include "llvm/ADT/STLExtras.h"

#include <algorithm>

namespace ladderc::sema {

namespace {

class JumpChecker {
public:
  JumpChecker(const Context &context, const Labels &labels, const Ranges &ranges)
      : context_(context), labels_(labels), ranges_(ranges) {}

  void take(InstructionIndex index) {
    const Operand &target = context_.operands(index).front();
    const bool jumps = context_.instruction(index).info->lowering == Lowering::Jump;
    if (target.index != kNoDevice)
      return;
    if (jumps && labels_.is_end(target))
      return check_path(index, kMainScope, target);
    const InstructionIndex place = labels_.place(target);
    if (place == kNoInstruction || (jumps && labels_.is_called(target)))
      return;
    if (jumps) {
      check_path(index, ranges_.scope_of(place), target);
      check_master(index, place, target);
    } else if (ranges_.scope(ranges_.scope_of(place)).opened_by == place) {
      calls_.push_back({index, ranges_.routine_of(ranges_.scope_of(index)), ranges_.scope_of(place)});
    }
  }

  void check_calls() {
    for (const Call &call : calls_)
      by_caller_[call.caller].push_back(&call);
    for (const auto &[caller, calls] : by_caller_)
      order(caller);
    if (recursive_)
      return;
    llvm::DenseMap<ScopeIndex, unsigned> levels;
    const unsigned max = context_.family.max_calls;
    for (ScopeIndex routine : llvm::reverse(order_))
      for (const Call *call : by_caller_.lookup(routine)) {
        const unsigned level = levels.lookup(routine) + 1;
        if (max != 0 && level == max + 1)
          context_.report(DiagId::CallTooDeep, call->index)
              .arg("mnemonic", context_.instruction(call->index).info->spelling)
              .arg("count", level)
              .arg("max", max);
        unsigned &known = levels[call->callee];
        known = std::max(known, level);
      }
  }

private:
  struct Call {
    InstructionIndex index;
    ScopeIndex caller, callee;
  };

  void check_path(InstructionIndex index, ScopeIndex target, const Operand &label) {
    const ScopeIndex from = ranges_.scope_of(index);
    llvm::SmallVector<ScopeIndex, 8> around;
    for (ScopeIndex s = target;; s = ranges_.scope(s).parent) {
      around.push_back(s);
      if (s == kMainScope)
        break;
    }
    for (ScopeIndex s = from; !llvm::is_contained(around, s); s = ranges_.scope(s).parent)
      if (ranges_.scope(s).kind != ScopeKind::Loop)
        return report(index, label, "leaves", s);
    // What both lie in has been found; the target is inside of something else.
    ScopeIndex common = from;
    while (!llvm::is_contained(around, common))
      common = ranges_.scope(common).parent;
    if (common != target)
      report(index, label, "enters", *(llvm::find(around, common) - 1));
  }

  void report(InstructionIndex index, const Operand &label, llvm::StringRef how, ScopeIndex scope) {
    const std::string range = ranges_.scope_name(scope);
    context_.report(DiagId::JumpNotFollowed, index, context_.operands(index).front().range)
        .arg("label", labels_.name(label))
        .arg("crosses", how)
        .arg("range", range)
        .note(DiagId::RangeHere, context_.instruction(ranges_.scope(scope).opened_by).range)
        .arg("range", range);
  }

  void check_master(InstructionIndex index, InstructionIndex place, const Operand &label) {
    const InstructionIndex from = ranges_.master_of(index), to = ranges_.master_of(place);
    if (from == to)
      return;
    const std::string region = ranges_.region_name(to != kNoInstruction ? to : from);
    context_.report(DiagId::JumpCrossesMaster, index, context_.operands(index).front().range)
        .arg("label", labels_.name(label))
        .arg("region", region)
        .note(DiagId::LabelHere, context_.instruction(place).range)
        .arg("label", labels_.name(label));
  }

  /// Depth first, on a stack of its own: callers come behind what they call. A call back to a routine that is still open is
  /// recursion.
  void order(ScopeIndex root) {
    struct Visit {
      ScopeIndex routine;
      std::size_t next;
    };
    if (!seen_.insert(root).second)
      return;
    llvm::SmallVector<Visit, 16> stack{{root, 0}};
    open_.insert(root);
    while (!stack.empty()) {
      Visit &visit = stack.back();
      const auto found = by_caller_.find(visit.routine);
      if (found == by_caller_.end() || visit.next == found->second.size()) {
        order_.push_back(visit.routine);
        open_.erase(visit.routine);
        stack.pop_back();
        continue;
      }
      const Call &call = *found->second[visit.next++];
      if (open_.contains(call.callee)) {
        recursive_ = true;
        const Operand &label = context_.operands(call.index).front();
        context_.report(DiagId::CallRecursive, call.index, label.range).arg("label", labels_.name(label));
      } else if (seen_.insert(call.callee).second) {
        open_.insert(call.callee);
        stack.push_back({call.callee, 0});
      }
    }
  }

  const Context &context_;
  const Labels &labels_;
  const Ranges &ranges_;
  std::vector<Call> calls_;
  llvm::DenseMap<ScopeIndex, llvm::SmallVector<const Call *, 4>> by_caller_;
  llvm::DenseSet<ScopeIndex> seen_, open_;
  std::vector<ScopeIndex> order_;
  bool recursive_ = false;
};

}  // namespace

void check_jumps(const Context &context, const Labels &labels, const Ranges &ranges, llvm::ArrayRef<Resolved> resolved,
                 InstructionIndex behind) {
  JumpChecker checker(context, labels, ranges);
  for (InstructionIndex i = 0; i < behind; ++i) {
    const InstructionInfo *info = context.instruction(i).info;
    if (info && (info->lowering == Lowering::Jump || info->lowering == Lowering::CallRoutine) && resolved[i].all_good())
      checker.take(i);
  }
  checker.check_calls();
}

}  // namespace ladderc::sema
