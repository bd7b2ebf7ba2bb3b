// Runs the bit instructions of a list as the manual tells it: a stack of blocks, a stack of branch results, master control regions.
#pragma once

#include "machine.h"
#include "sema/check.h"

namespace ladderc::test {

/// One scan. Cells are devices ("M0") and, for edges, "edgeN" in the order of the instructions that have a memory of their own;
/// master control states leave no cells. Only contacts, connections, bit outputs, MC and MCR.
Cells run_list(const CheckedProgram &program, const Cells &cells);

}  // namespace ladderc::test
