// How long the real CPU takes for a scan.
//
// The manual gives a time for each instruction, some with a condition or a kind of operand. Conditions are taken as ON, since the times of
// instructions that do act are what a plant's scan time is made of; a row for another operand than this one's is skipped.
#include "driver/plc_time.h"

#include "llvm/ADT/StringExtras.h"

namespace ladderc::driver {

namespace {

/// True where the table's example operand ("X0", "D0.0", "T,C", "K") describes the instruction's operands.
bool device_fits(const CheckedProgram &program, const Instruction &instruction, llvm::StringRef device) {
  if (device.empty())
    return true;
  llvm::SmallVector<llvm::StringRef> names;
  device.split(names, ',');
  for (llvm::StringRef name : names) {
    name = name.trim();
    const bool word_bit = name.contains('.');
    const llvm::StringRef prefix = name.take_while(llvm::isAlpha);
    const llvm::ArrayRef<Operand> operands = program.list.operands_of(instruction);
    for (std::size_t i = 0; i < operands.size(); ++i) {
      const Operand &operand = operands[i];
      if (operand.kind == OperandKind::BitOfWord || word_bit) {
        if (operand.kind == OperandKind::BitOfWord && word_bit)
          return true;
        continue;
      }
      // X0 stands for every bit that is no bit of a word, the contacts of timers and counters too.
      if (names.size() == 1 && instruction.info->operands[i].type == OperandType::Bit)
        return true;
      if (prefix == "K" && operand.kind == OperandKind::Decimal)
        return true;
      if (operand.kind != OperandKind::Device)
        continue;
      const DeviceInfo &actual = program.family->devices[operand.device];
      // D stands for every word device.
      const DeviceId example = find_device(*program.family, prefix);
      if (prefix == actual.prefix || (example != kNoDevice && actual.kind == program.family->devices[example].kind && names.size() == 1))
        return true;
    }
  }
  return false;
}

/// Rows for the condition OFF or for another state than "acts" rank behind.
int rank(const TimeInfo &time) {
  const llvm::StringRef c = time.condition;
  if (c.starts_with("not executed") || c == "OFF" || c == "OFF->OFF")
    return 2;
  return c.contains("display") || c.contains("after") ? 1 : 0;
}

}  // namespace

PlcTime plc_time(const CheckedProgram &program) {
  PlcTime total;
  for (const Instruction &instruction : program.list.instructions) {
    if (instruction.info->lowering == Lowering::End)
      break;
    const TimeInfo *best = nullptr;
    for (const TimeInfo &time : instruction.info->times)
      if (device_fits(program, instruction, time.device) && (!best || rank(time) < rank(*best)))
        best = &time;
    if (best)
      total.instructions_us += best->nanoseconds / 1000.0;
    else
      ++total.unknown;
  }
  total.end_us = (program.family->end_ns + program.family->io_refresh_ns) / 1000.0;
  return total;
}

}  // namespace ladderc::driver
