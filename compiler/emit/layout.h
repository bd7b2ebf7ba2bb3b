// What goes where: how large each device image is, and how rungs are cut into functions and functions into files.
//
// An image is as large as the highest number that the program can reach: firmware pays for no more. A block instruction whose
// length is known at run time only can reach every allocated number. The C++ compiler's time grows faster than a function's size,
// so the scan is cut into functions of a bounded number of rungs and operations, and these into files that compile side by side.
#pragma once

#include "ir/ir.h"
#include "sema/check.h"

#include <cstdint>
#include <vector>

namespace ladderc::emit {

struct LayoutLimits {
  unsigned rungs_per_function = 64;
  unsigned operations_per_function = 2000;
  unsigned operations_per_file = 6000;
};

/// A function: rungs [first, last] by index in the routine.
struct Chunk {
  std::size_t first, last;
  bool can_stop;  ///< returns bool: false when the CPU stopped
  unsigned file;  ///< 0: the main file
};

struct Layout {
  std::vector<std::uint32_t> count;  ///< per device class: numbers 0 to count - 1 have memory; 0: the program never touches it
  std::vector<Chunk> chunks;
  unsigned files = 1;
};

Layout make_layout(const ir::Module &module, const Parameters &parameters, const LayoutLimits &limits);

}  // namespace ladderc::emit
