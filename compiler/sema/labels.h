// Labels: where they are placed, and what jumps to them or calls them.
#pragma once

#include "sema/context.h"
#include "sema/resolve.h"

#include "llvm/ADT/DenseMap.h"

namespace ladderc::sema {

class Labels {
public:
  /// Looks at the instructions before `behind` and reports labels that do not exist, are placed twice or nowhere, or serve both
  /// jumps and calls.
  Labels(const Context &context, llvm::ArrayRef<Resolved> resolved, InstructionIndex behind);

  /// Where the label of an operand is placed, or kNoInstruction.
  InstructionIndex place(const Operand &operand) const;
  bool is_called(const Operand &label) const { return uses(label).called != kNoInstruction; }
  bool is_jumped(const Operand &label) const { return uses(label).jumped != kNoInstruction; }
  /// The operand is the label that means END.
  bool is_end(const Operand &operand) const;
  /// "P8".
  std::string name(const Operand &operand) const;

  /// Warns of labels that nothing names.
  void check_uses() const;

private:
  struct Uses {
    InstructionIndex placed = kNoInstruction;
    InstructionIndex jumped = kNoInstruction, called = kNoInstruction;  ///< the first of each
    bool reported = false;                                              ///< there is no label of that number
  };

  static std::uint64_t key(const Operand &operand) {
    return std::uint64_t(operand.device) << 32 | static_cast<std::uint32_t>(operand.value);
  }
  const Uses &uses(const Operand &operand) const;
  void enter(InstructionIndex index, const Resolved &resolved);
  void enter_place(InstructionIndex index, const Operand &operand, Uses &uses);
  void enter_use(InstructionIndex index, const Operand &operand, Uses &uses);
  void check_use(InstructionIndex index, const Operand &operand) const;
  void report_missing(InstructionIndex index, const Operand &operand) const;

  const Context &context_;
  InstructionIndex behind_;
  llvm::DenseMap<std::uint64_t, Uses> uses_;
  bool jumps_by_index_ = false;
};

}  // namespace ladderc::sema
