// The walk over the list: two passes, every check sees every instruction in order.
//
// The table entry is chosen first because everything else asks it; then step and rung are known, which all messages name. What
// needs labels or the states around an instruction is looked at in the second pass.
#include "sema/check.h"

#include "sema/coils.h"
#include "sema/context.h"
#include "sema/end.h"
#include "sema/exclusive.h"
#include "sema/jumps.h"
#include "sema/labels.h"
#include "sema/master.h"
#include "sema/operands.h"
#include "sema/ranges.h"
#include "sema/resolve.h"
#include "sema/rungs.h"
#include "sema/specials.h"
#include "sema/states.h"
#include "sema/steps.h"

#include "llvm/ADT/STLExtras.h"

#include <algorithm>
#include <cassert>

namespace ladderc {

namespace {

using sema::InstructionIndex;

/// The family's own copy of the model's name, which lives as long as the tables; the first model where none is named.
llvm::StringRef model_of(const FamilyInfo &family, llvm::StringRef model) {
  if (model.empty())
    return family.models.empty() ? llvm::StringRef() : family.models.front();
  auto *found = llvm::find(family.models, model);
  return found == family.models.end() ? model : *found;
}

/// Entries, operands, steps, rungs and master control. Returns what is known of each instruction.
std::vector<sema::Resolved> check_lines(CheckedProgram &program, const sema::Context &context, InstructionIndex behind) {
  sema::Rungs rungs(context);
  sema::MasterRegions regions(context);
  sema::Specials specials(*program.family);
  std::vector<sema::Resolved> resolved;
  resolved.reserve(behind);
  for (InstructionIndex i = 0; i < behind; ++i) {
    Instruction &instruction = context.instruction(i);
    instruction.step = program.steps;
    sema::choose_entry(context, i);
    rungs.visit(i);
    sema::Resolved &r = resolved.emplace_back(sema::match_operands(context, i));
    sema::check_operands(context, i, r);
    program.steps += sema::count_steps(*program.family, instruction.info, context.operands(i));
    regions.visit(i, r);
    if (r.known)
      specials.check(context, i, r);
  }
  rungs.finish();
  regions.finish();
  program.rungs = rungs.count();
  return resolved;
}

/// Labels, routines, loops, states, and what depends on them.
void check_flow(const sema::Context &context, llvm::ArrayRef<sema::Resolved> resolved, InstructionIndex behind) {
  sema::Labels labels(context, resolved, behind);
  sema::Ranges ranges(context, labels, behind);
  sema::Coils coils(context, ranges);
  sema::ExclusiveUses exclusive(context);
  for (InstructionIndex i = 0; i < behind; ++i) {
    ranges.visit(i);
    coils.visit(i, resolved[i]);
    exclusive.visit(i, resolved[i]);
  }
  ranges.finish();
  labels.check_uses();
  sema::check_jumps(context, labels, ranges, resolved, behind);
  sema::check_states(context, ranges, resolved, behind);
}

void walk(CheckedProgram &program, Diagnostics &diagnostics) {
  sema::Context context{program.list, *program.family, program.parameters, diagnostics, program.model};
  InstructionIndex end = sema::find_end(program.list);
  InstructionIndex behind = end == sema::kNoInstruction ? static_cast<InstructionIndex>(program.list.instructions.size()) : end + 1;
  check_flow(context, check_lines(program, context, behind), behind);
  sema::check_end(context, end);
}

}  // namespace

CheckedProgram check(ListProgram list, llvm::StringRef model, Parameters parameters, Diagnostics &diagnostics) {
  CheckedProgram program;
  program.list = std::move(list);
  program.family = program.list.family;
  program.model = model_of(*program.family, model);
  program.parameters = std::move(parameters);
  assert(program.parameters.points.size() == program.family->devices.size() && "begin with default_parameters()");
  walk(program, diagnostics);
  program.ok = diagnostics.ok();
  return program;
}

}  // namespace ladderc
