// What every check of sema looks at: the list, its family and parameters, and where to report.
//
// Positions in messages come with the step and the rung of their instruction, which are known when the walk has reached it.
#pragma once

#include "sema/parameters.h"
#include "support/diagnostics.h"
#include "syntax/ast.h"

#include <optional>

namespace ladderc::sema {

/// Index of an instruction in the list.
using InstructionIndex = std::uint32_t;
constexpr InstructionIndex kNoInstruction = ~InstructionIndex(0);

struct Context {
  ListProgram &list;
  const FamilyInfo &family;
  const Parameters &parameters;
  Diagnostics &diagnostics;
  llvm::StringRef model;

  Instruction &instruction(InstructionIndex i) const { return list.instructions[i]; }
  llvm::ArrayRef<Operand> operands(InstructionIndex i) const { return list.operands_of(list.instructions[i]); }
  llvm::StringRef text(SourceRange range) const { return diagnostics.sources().text(range); }

  /// The device class of an operand that names a device.
  const DeviceInfo &device(const Operand &operand) const { return family.devices[operand.device]; }
  bool exists(const Operand &operand) const {
    return number_exists(device(operand), model, parameters.points[operand.device], static_cast<std::uint64_t>(operand.value));
  }

  [[nodiscard]] DiagBuilder report(DiagId id, InstructionIndex i, std::optional<SourceRange> range = std::nullopt) const {
    const Instruction &at = instruction(i);
    DiagBuilder builder = diagnostics.report(id, range ? *range : at.range);
    builder.at(static_cast<std::int32_t>(at.step), static_cast<std::int32_t>(at.rung));
    return builder;
  }
};

}  // namespace ladderc::sema
