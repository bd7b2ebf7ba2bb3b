// Devices that several instructions drive.
#pragma once

#include "sema/ranges.h"

#include <map>
#include <vector>

namespace ladderc::sema {

class Coils {
public:
  Coils(const Context &context, const Ranges &ranges) : context_(context), ranges_(ranges), coils_(context.family.devices.size()) {}

  /// Warns on the later of two instructions that do not go together on one device. To be called in list order.
  void visit(InstructionIndex index, const Resolved &resolved);

private:
  /// The first instruction of each kind on one bit, timer or counter.
  struct Coil {
    InstructionIndex driver = kNoInstruction;  ///< OUT, PLS and the like: writes in every scan; outside of states
    InstructionIndex writer = kNoInstruction;  ///< any instruction that writes the bit, except MC
    InstructionIndex master = kNoInstruction;  ///< MC
  };

  Coil &coil_of(const Operand &operand);
  bool is_coil(InstructionIndex index, const Operand &operand) const;
  bool drives(InstructionIndex index) const;
  InstructionIndex other_driver(InstructionIndex index, const Operand &operand, const Coil &coil) const;
  void write(InstructionIndex index, const Operand &operand);
  void warn(DiagId id, InstructionIndex index, const Operand &operand, InstructionIndex earlier);

  const Context &context_;
  const Ranges &ranges_;
  std::vector<std::vector<Coil>> coils_;  ///< per device class, allocated when the class is first written
  /// Drivers inside of states, by device.
  std::map<std::pair<DeviceId, std::int64_t>, llvm::SmallVector<InstructionIndex, 4>> state_drivers_;
};

}  // namespace ladderc::sema
