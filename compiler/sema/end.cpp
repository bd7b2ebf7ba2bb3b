// The end of the program: END stands there, once, and nothing behind it.
#include "sema/end.h"

#include "llvm/ADT/STLExtras.h"

namespace ladderc::sema {

namespace {

/// NOPs fill the program memory behind END on some controllers.
bool is_padding(const Instruction &instruction) {
  return !instruction.candidates.empty() && instruction.candidates.front()->lowering == Lowering::Nothing;
}

}  // namespace

InstructionIndex find_end(const ListProgram &list) {
  auto end = llvm::find_if(list.instructions, [](const Instruction &i) {
    return !i.candidates.empty() && i.candidates.front()->placement == Placement::End;
  });
  return end == list.instructions.end() ? kNoInstruction : static_cast<InstructionIndex>(end - list.instructions.begin());
}

void check_end(const Context &context, InstructionIndex end) {
  const std::vector<Instruction> &instructions = context.list.instructions;
  if (end == kNoInstruction) {
    if (instructions.empty())
      (void)context.diagnostics.report(DiagId::MissingEnd, context.list.end_of_text);
    else
      (void)context.report(DiagId::MissingEnd, static_cast<InstructionIndex>(instructions.size() - 1));
    return;
  }
  auto behind = llvm::find_if_not(llvm::drop_begin(instructions, end + 1), is_padding);
  if (behind != instructions.end())
    context.diagnostics.report(DiagId::AfterEnd, behind->range).arg("mnemonic", context.text(behind->range));
}

}  // namespace ladderc::sema
