// The end of the program.
#pragma once

#include "sema/context.h"

namespace ladderc::sema {

/// Index of the first END, or kNoInstruction.
InstructionIndex find_end(const ListProgram &list);

/// Reports a missing END, and instructions behind END (`end`, from find_end) that are never executed.
void check_end(const Context &context, InstructionIndex end);

}  // namespace ladderc::sema
