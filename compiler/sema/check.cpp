// The walk over the list: one pass, every check sees every instruction in order.
//
// The table entry is chosen first because everything else asks it; then step and rung are known, which all messages name.
#include "sema/check.h"

#include "sema/coils.h"
#include "sema/context.h"
#include "sema/end.h"
#include "sema/master.h"
#include "sema/operands.h"
#include "sema/resolve.h"
#include "sema/rungs.h"
#include "sema/specials.h"
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

void walk(CheckedProgram &program, Diagnostics &diagnostics) {
  sema::Context context{program.list, *program.family, program.parameters, diagnostics};
  sema::Rungs rungs(context);
  sema::MasterRegions regions(context);
  sema::Coils coils(context);
  sema::Specials specials(*program.family);

  InstructionIndex end = sema::find_end(program.list);
  InstructionIndex behind = end == sema::kNoInstruction ? static_cast<InstructionIndex>(program.list.instructions.size()) : end + 1;
  for (InstructionIndex i = 0; i < behind; ++i) {
    Instruction &instruction = context.instruction(i);
    instruction.step = program.steps;
    sema::choose_entry(context, i);
    rungs.visit(i);
    sema::Resolved resolved = sema::match_operands(context, i);
    sema::check_operands(context, i, resolved);
    program.steps += sema::count_steps(*program.family, instruction.info, context.operands(i));
    regions.visit(i, resolved);
    coils.visit(i, resolved);
    if (resolved.known)
      specials.check(context, i, resolved);
  }
  rungs.finish();
  regions.finish();
  sema::check_end(context, end);
  program.rungs = rungs.count();
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
