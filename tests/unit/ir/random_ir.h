// Random IR with so few bits that all of their states can be tried.
#pragma once

#include "ir/ir.h"

#include <string>
#include <vector>

namespace ladderc::test {

/// The cells that random IR uses: three inputs, four relays, an edge relay and two edge memories.
const std::vector<std::string> &random_cells();

/// One to three rungs of up to `operations` operations each. The same seed gives the same module.
ir::Module random_module(unsigned seed, unsigned operations = 16);

}  // namespace ladderc::test
