// What a program may use a limited number of times: an instruction, a terminal, one of several interrupt pointers.
#pragma once

#include "sema/parameters.h"
#include "syntax/ast.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ladderc::generate {

class Uses {
public:
  Uses(const FamilyInfo &family, llvm::StringRef model, const Parameters &parameters)
      : family_(family), model_(model), parameters_(parameters) {}

  /// Counts the instruction; false where the program has no more of what it needs.
  bool take(const InstructionInfo &info, llvm::ArrayRef<Operand> operands);

  /// Numbers of a class of labels that may still be placed, in ascending order. The label that means END is none of them.
  std::vector<std::uint32_t> free_labels(DeviceId device) const;
  void take_label(DeviceId device, std::uint32_t number);

private:
  std::uint32_t terminals_of(DeviceId device, std::uint64_t number) const;

  const FamilyInfo &family_;
  llvm::StringRef model_;
  const Parameters &parameters_;
  std::map<llvm::StringRef, unsigned> counts_;
  std::map<std::uint32_t, std::pair<DeviceId, std::uint64_t>> terminals_;  ///< by terminal: who has it
  std::map<DeviceId, std::vector<std::uint32_t>> labels_;                  ///< placed ones
};

}  // namespace ladderc::generate
