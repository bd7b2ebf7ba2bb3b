// What a program may use a limited number of times: instructions, interrupt sources, fast inputs.
#pragma once

#include "sema/context.h"
#include "sema/resolve.h"

#include "llvm/ADT/StringMap.h"

#include <map>

namespace ladderc::sema {

class ExclusiveUses {
public:
  explicit ExclusiveUses(const Context &context) : context_(context) {}

  /// To be called for every instruction in list order.
  void visit(InstructionIndex index, const Resolved &resolved);

private:
  /// Who has something for itself.
  struct User {
    InstructionIndex index;
    DeviceId device;
    std::int64_t number;
    std::string name;
  };

  void count(InstructionIndex index);
  void take_number(InstructionIndex index, const Operand &operand);
  void take_run(InstructionIndex index, const Operand &operand, std::uint32_t run);
  void take_terminals(InstructionIndex index, const User &user, std::uint32_t inputs);

  const Context &context_;
  llvm::StringMap<unsigned> uses_;                           ///< by mnemonic
  std::map<std::pair<DeviceId, std::uint32_t>, User> runs_;  ///< by class and first number
  std::map<unsigned, User> terminals_;                       ///< by input
};

}  // namespace ladderc::sema
