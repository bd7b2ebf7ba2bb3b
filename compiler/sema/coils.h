// Devices that several instructions drive.
#pragma once

#include "sema/context.h"
#include "sema/resolve.h"

#include <vector>

namespace ladderc::sema {

class Coils {
public:
  explicit Coils(const Context &context) : context_(context), coils_(context.family.devices.size()) {}

  /// Warns on the later of two instructions that do not go together on one device. To be called in list order.
  void visit(InstructionIndex index, const Resolved &resolved);

private:
  /// The first instruction of each kind on one bit, timer or counter.
  struct Coil {
    InstructionIndex driver = kNoInstruction;  ///< OUT, PLS and the like: writes in every scan
    InstructionIndex writer = kNoInstruction;  ///< any instruction that writes the bit, except MC
    InstructionIndex master = kNoInstruction;  ///< MC
  };

  Coil &coil_of(const Operand &operand);
  void write(InstructionIndex index, const Operand &operand);
  void warn(DiagId id, InstructionIndex index, const Operand &operand, InstructionIndex earlier);

  const Context &context_;
  std::vector<std::vector<Coil>> coils_;  ///< per device class, allocated when the class is first written
};

}  // namespace ladderc::sema
