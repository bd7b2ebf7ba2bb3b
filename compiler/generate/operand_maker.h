// Operands of an instruction, made from what the table says that each position takes.
#pragma once

#include "generate/generate.h"
#include "generate/random.h"
#include "syntax/ast.h"

#include <string>
#include <vector>

namespace ladderc::generate {

class OperandMaker {
public:
  OperandMaker(const GenerateOptions &options, Random &random);

  /// The words behind the mnemonic, or nothing where the allocation has no device for a position. `tame`: operands for which an
  /// instruction that can fail does not.
  std::optional<std::vector<std::string>> make(const InstructionInfo &info, bool tame);

  /// True where each operand has a device that the allocation provides, or takes a constant.
  bool possible(const InstructionInfo &info) const;

  /// A number of decimal digits that is greater than 0 both as it stands and read as BCD, as an operand of that type.
  std::string tame_constant(OperandType type);

private:
  std::optional<Operand> operand(const OperandInfo &info);
  std::optional<Operand> try_operand(const OperandInfo &info);
  Operand constant(const OperandInfo &info);
  bool take_number(const OperandInfo &info, Operand &operand);
  bool in_place(const OperandInfo &info, const Operand &operand) const;
  bool may_write(const Operand &operand, std::uint32_t count) const;
  DeviceId device_of(DeviceSet set);
  void overlap_blocks(const InstructionInfo &info, std::vector<Operand> &operands);
  void fit_blocks(const InstructionInfo &info, std::vector<Operand> &operands, bool tame);
  std::string text(const Operand &operand) const;
  std::uint32_t points(DeviceId device) const { return options_.parameters.points[device]; }

  const GenerateOptions &options_;
  const FamilyInfo &family_;
  Random &random_;
  DeviceSet allocated_ = 0;
  std::vector<std::vector<std::uint32_t>> interesting_;  ///< per class: numbers of special devices
  std::vector<std::vector<bool>> read_only_;             ///< per class and number: belongs to the system
};

}  // namespace ladderc::generate
