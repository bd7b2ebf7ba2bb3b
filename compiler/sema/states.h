// States of the step ladder that follow each other and share a timer.
#pragma once

#include "sema/ranges.h"

namespace ladderc::sema {

/// Warns of timers that are driven in a state and in the one that a transfer enters from it.
void check_states(const Context &context, const Ranges &ranges, llvm::ArrayRef<Resolved> resolved, InstructionIndex behind);

}  // namespace ladderc::sema
