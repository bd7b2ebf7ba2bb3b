// Operands of an instruction, made from what the table says that each position takes.
#pragma once

#include "generate/generate.h"
#include "generate/random.h"
#include "generate/uses.h"
#include "syntax/ast.h"

#include <string>
#include <vector>

namespace ladderc::generate {

class OperandMaker {
public:
  OperandMaker(const GenerateOptions &options, Random &random);

  /// The words behind the mnemonic, or nothing where the allocation has no device for a position, or the program has used up what
  /// the instruction needs. `tame`: operands for which an instruction that stops the CPU when it fails does not.
  std::optional<std::vector<std::string>> make(const InstructionInfo &info, bool tame);

  /// A device of the class that the position takes, with that number.
  std::string device_text(const OperandInfo &info, std::uint32_t number) const;
  /// A small count for a loop: a constant, or one digit of bits where `constant` does not forbid it and the position takes it.
  std::string small_count(const OperandInfo &info, bool constant);

  /// True where each operand has a device that the allocation provides, or takes a constant.
  bool possible(const InstructionInfo &info) const;

  Uses &uses() { return uses_; }

  /// A number of decimal digits that is greater than 0 both as it stands and read as BCD, as an operand of that type.
  std::string tame_constant(OperandType type);

private:
  std::optional<Operand> operand(const OperandInfo &info);
  std::optional<Operand> try_operand(const OperandInfo &info);
  Operand constant(const OperandInfo &info);
  std::int64_t constant_value(const OperandInfo &info, bool hexadecimal);
  std::uint32_t number_from(std::uint32_t first, std::uint32_t last, std::uint32_t few);
  bool take_number(const OperandInfo &info, Operand &operand);
  bool in_place(const OperandInfo &info, const Operand &operand) const;
  bool may_write(const Operand &operand, std::uint32_t count) const;
  DeviceId device_of(DeviceSet set);
  void overlap_blocks(const InstructionInfo &info, std::vector<Operand> &operands);
  void fit_blocks(const InstructionInfo &info, std::vector<Operand> &operands, bool tame);
  void modify(const InstructionInfo &info, std::vector<Operand> &operands);
  std::string some_text();
  std::string text(const Operand &operand) const;
  std::uint32_t points(DeviceId device) const { return options_.parameters.points[device]; }
  std::uint32_t last(DeviceId device) const { return family_.devices[device].first + points(device) - 1; }

  const GenerateOptions &options_;
  const FamilyInfo &family_;
  Random &random_;
  Uses uses_;
  DeviceSet allocated_ = 0;                              ///< without labels
  std::vector<std::vector<std::uint32_t>> interesting_;  ///< per class: numbers of special devices
  std::vector<std::uint32_t> plain_;                     ///< per class with special devices: numbers from here on are plain memory
  std::vector<std::vector<std::uint32_t>> runs_;         ///< per class: where the runs begin that some instruction is made for
  std::vector<std::vector<bool>> read_only_;             ///< per class and number: belongs to the system
};

}  // namespace ladderc::generate
