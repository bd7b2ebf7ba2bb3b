// What lowering must know of a list before it walks it: where the main program ends, which labels are called, which buses are open where.
#pragma once

#include "sema/check.h"

#include "llvm/ADT/DenseSet.h"

#include <map>
#include <optional>

namespace ladderc::lowering {

/// What switches the outputs of a region off: an MC, an SMCS. The innermost one's state contains those around it.
struct Bus {
  std::uint32_t master;  ///< master control state
  bool has_level;        ///< MC: ended by the MCR of its level or an outer one; else by SMCR
  unsigned level;
};

/// Ends the buses that an MCR or SMCR ends.
void close_buses(std::vector<Bus> &buses, const CheckedProgram &program, const Instruction &end);

struct Plan {
  std::optional<std::uint32_t> main_end;  ///< index of the last FEND
  llvm::DenseSet<std::uint32_t> called, jumped;
  bool calls_by_index = false;  ///< CALL P0Z0: any label behind the main program may be called
  std::map<std::uint32_t, std::vector<Bus>> label_buses;  ///< open at each label
};

Plan make_plan(const CheckedProgram &program);

}  // namespace ladderc::lowering
