// Program steps.
#pragma once

#include "syntax/ast.h"

namespace ladderc::sema {

/// Steps that the instruction takes in the controller's program memory. 1 for an unknown one.
std::uint32_t count_steps(const FamilyInfo &family, const InstructionInfo *info, llvm::ArrayRef<Operand> operands);

}  // namespace ladderc::sema
