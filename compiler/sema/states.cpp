// States of the step ladder that follow each other and share a timer.
//
// In the scan of the transfer both states are active, so the timer's coil stays ON and its value goes on. Collects what each state
// drives and where it goes, then compares the ends of every transfer.
#include "sema/states.h"

#include "sema/names.h"

#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/STLExtras.h"

#include <map>
#include <set>

namespace ladderc::sema {

namespace {

struct StateUse {
  std::map<std::int64_t, InstructionIndex> timers;  ///< the first instruction that drives each
  std::set<std::int64_t> targets;
};

}  // namespace

void check_states(const Context &context, const Ranges &ranges, llvm::ArrayRef<Resolved> resolved, InstructionIndex behind) {
  std::map<std::int64_t, StateUse> states;
  for (InstructionIndex i = 0; i < behind; ++i) {
    const InstructionInfo *info = context.instruction(i).info;
    if (!info || !resolved[i].all_good() || context.operands(i).empty() || ranges.scope_of(i) == kMainScope)
      continue;
    const ScopeIndex scope = ranges.state_of(i);
    const Operand &operand = context.operands(i).front();
    const bool transfers = info->lowering == Lowering::Transfer;
    const bool drives = info->drives && operand.kind == OperandKind::Device && context.device(operand).kind == DeviceKind::Timer;
    if (scope == kMainScope || (!transfers && !drives))
      continue;
    for (std::int64_t state : ranges.states(scope))
      if (transfers)
        states[state].targets.insert(operand.value);
      else
        states[state].timers.try_emplace(operand.value, i);
  }
  std::set<std::pair<std::int64_t, InstructionIndex>> reported;
  for (const auto &[source, use] : states)
    for (std::int64_t target : use.targets) {
      auto entered = states.find(target);
      if (target == source || entered == states.end())
        continue;
      for (const auto &[timer, first] : use.timers) {
        auto second = entered->second.timers.find(timer);
        if (second == entered->second.timers.end() || second->second == first)
          continue;
        // A pair of states that enter each other is one finding.
        const InstructionIndex later = std::max(first, second->second);
        if (!reported.insert({timer, later}).second)
          continue;
        const Operand &operand = context.operands(second->second).front();
        auto state_name = [&](std::int64_t number) {
          const InstructionIndex stl = ranges.scope(ranges.state_of(second->second)).opened_by;
          return device_name(context.family, context.operands(stl).front().device, static_cast<std::uint64_t>(number));
        };
        const std::string device = device_name(context.family, operand.device, static_cast<std::uint64_t>(timer));
        context.report(DiagId::TimerInAdjacentStates, second->second, operand.range)
            .arg("device", device)
            .arg("state", state_name(target))
            .arg("source", state_name(source))
            .note(DiagId::EarlierInstruction, context.instruction(first).range)
            .arg("mnemonic", context.instruction(first).info->spelling)
            .arg("device", device);
      }
    }
}

}  // namespace ladderc::sema
