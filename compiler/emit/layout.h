// What goes where: how large each device image is, and how rungs are cut into functions and functions into files.
//
// An image is as large as the highest number that the program can reach: firmware pays for no more. A block instruction whose
// length is known at run time only can reach every allocated number. The C++ compiler's time grows faster than a function's size,
// so the scan is cut into functions of a bounded number of rungs and operations, and these into files that compile side by side.
#pragma once

#include "ir/ir.h"
#include "sema/check.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ladderc::emit {

struct LayoutLimits {
  unsigned rungs_per_function = 64;
  unsigned operations_per_function = 2000;
  unsigned operations_per_file = 6000;
};

/// Rungs [first, last] by index in their routine that stand together: in a function of their own or in the body of the routine.
struct Chunk {
  std::size_t first, last;
  bool can_stop;            ///< the function returns bool: false when the CPU stopped
  unsigned file;            ///< 0: the main file
  bool own_function = true; ///< false: the rungs stand in the routine's body
};

/// A routine: its chunks in order.
struct RoutineLayout {
  std::vector<Chunk> chunks;
  bool returns = false;  ///< it is left in the middle, so that its body is a function of its own
  unsigned file = 0;     ///< of the body
};

/// A multi-scan instruction's memory.
struct MemoryObject {
  std::string type, name;
  std::uint32_t step;
};

struct Layout {
  std::vector<std::uint32_t> count;  ///< per device class: so many numbers from the first on have memory; 0: the program never touches it
  std::vector<RoutineLayout> routines;  ///< as the module's
  std::vector<MemoryObject> memories;
  unsigned files = 1;
};

/// True where input terminals matter between the scans: interrupt routines, high-speed counters.
bool has_events(const ir::Module &module);
/// Name of the member that is the memory of the instruction at a step: `ramp_12`.
std::string memory_name(const InstructionInfo &info, std::uint32_t step);

Layout make_layout(const ir::Module &module, const Parameters &parameters, const LayoutLimits &limits);

}  // namespace ladderc::emit
