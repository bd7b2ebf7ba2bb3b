// Special relays and registers that belong to the system.
#pragma once

#include "sema/context.h"
#include "sema/resolve.h"

#include <vector>

namespace ladderc::sema {

class Specials {
public:
  explicit Specials(const FamilyInfo &family);

  /// Warns of operands that the instruction writes and that the system keeps.
  void check(const Context &context, InstructionIndex index, const Resolved &resolved) const;

private:
  void add(const FamilyInfo &family, const SpecialInfo &special);

  std::vector<std::vector<const SpecialInfo *>> read_only_;  ///< per device class and number; null: free, or not listed
};

}  // namespace ladderc::sema
