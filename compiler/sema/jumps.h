// Jumps and calls: whether they can be followed.
#pragma once

#include "sema/labels.h"
#include "sema/ranges.h"

namespace ladderc::sema {

/// Reports jumps into or out of what a jump cannot cross, calls that nest too deep, and subroutines that call themselves.
void check_jumps(const Context &context, const Labels &labels, const Ranges &ranges, llvm::ArrayRef<Resolved> resolved,
                 InstructionIndex behind);

}  // namespace ladderc::sema
