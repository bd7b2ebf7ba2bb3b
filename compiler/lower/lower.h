// From the checked program to IR.
#pragma once

#include "ir/ir.h"
#include "sema/check.h"

namespace ladderc {

/// Lowers a program for which `program.ok` holds. Instructions behind END are not part of the result.
ir::Module lower(const CheckedProgram &program);

}  // namespace ladderc
