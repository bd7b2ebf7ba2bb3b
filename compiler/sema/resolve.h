// Which entry of the instruction table a list line is.
#pragma once

#include "sema/context.h"

namespace ladderc::sema {

/// What is known of an instruction once its mnemonic and operands have been compared with the tables.
struct Resolved {
  bool known = false;       ///< `info` is set; false: no such mnemonic
  bool shape_fits = false;  ///< there are as many operands as the entry has; otherwise none can be checked further
  std::uint64_t bad = 0;    ///< bit k: operand k is unreadable or of a class that the entry does not take

  bool all_good() const { return known && shape_fits && bad == 0; }
  bool good(unsigned operand) const { return known && shape_fits && operand < 64 && ((bad >> operand) & 1) == 0; }
};

/// Sets `info` of the instruction to the entry that fits, or to the closest one; it stays null where the mnemonic is unknown.
void choose_entry(const Context &context, InstructionIndex index);

/// Compares the operands with the chosen entry and reports the differences.
Resolved match_operands(const Context &context, InstructionIndex index);

}  // namespace ladderc::sema
