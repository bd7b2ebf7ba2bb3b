// Devices that several instructions drive.
//
// OUT, PLS and PLF write their device in every scan, so two of them on one device hide each other: a double coil, legal and mostly
// a slip. SET and RST act only while ON and belong in pairs. The device of an MC tells the state of its region and must be nobody
// else's. An edge relay is the memory of one place. The first instruction of each kind on each device is remembered in flat
// vectors.
//
// States of a step ladder are active by turns: a device may have a driver in each. Two in one state are a double coil, and so is
// one in a state with one outside.
#include "sema/coils.h"

#include "sema/names.h"

#include "fmt/format.h"
#include "llvm/ADT/STLExtras.h"

namespace ladderc::sema {

namespace {

constexpr unsigned kBitsOfWord = 16;

bool is_written_bit(const OperandInfo &info) {
  if (info.dir == Direction::In)
    return false;
  return info.type == OperandType::Bit || info.type == OperandType::Timer || info.type == OperandType::Counter ||
         info.type == OperandType::LongCounter || info.type == OperandType::Annunciator;
}

std::string coil_name(const FamilyInfo &family, const Operand &operand) {
  std::string name = device_name(family, operand.device, static_cast<std::uint64_t>(operand.value));
  return operand.kind == OperandKind::BitOfWord ? fmt::format("{}.{:X}", name, operand.bit) : name;
}

}  // namespace

void Coils::visit(InstructionIndex index, const Resolved &resolved) {
  if (!resolved.all_good())
    return;
  const InstructionInfo &info = *context_.instruction(index).info;
  llvm::ArrayRef<Operand> operands = context_.operands(index);
  for (unsigned k = 0; k < operands.size(); ++k) {
    if (!is_written_bit(info.operands[k]) || operands[k].device == kNoDevice)
      continue;
    if (is_coil(index, operands[k]))
      write(index, operands[k]);
    break;
  }
}

bool Coils::is_coil(InstructionIndex index, const Operand &operand) const {
  // RST of a whole word has a word entry of its own or names the word here; only bits are coils.
  const bool whole_word = operand.kind == OperandKind::Device && context_.device(operand).kind == DeviceKind::Word;
  const bool transfers = context_.instruction(index).info->lowering == Lowering::Transfer && ranges_.state_of(index) != kMainScope;
  return !whole_word && !transfers && operand.kind != OperandKind::Digits && operand.index == kNoDevice;
}

/// Writes its device in every scan.
bool Coils::drives(InstructionIndex index) const {
  const InstructionInfo &info = *context_.instruction(index).info;
  return info.drives || (info.lowering == Lowering::Transfer && info.transfer_outside == Lowering::Store);
}

/// An earlier driver of the device that can act in the same scan.
InstructionIndex Coils::other_driver(InstructionIndex index, const Operand &operand, const Coil &coil) const {
  if (coil.driver != kNoInstruction)
    return coil.driver;
  auto in_states = state_drivers_.find({operand.device, operand.value});
  if (in_states == state_drivers_.end() || operand.kind == OperandKind::BitOfWord)
    return kNoInstruction;
  const ScopeIndex state = ranges_.state_of(index);
  if (state == kMainScope)
    return in_states->second.front();
  const auto own = ranges_.states(state);
  for (InstructionIndex other : in_states->second)
    for (std::int64_t number : ranges_.states(ranges_.state_of(other)))
      if (llvm::is_contained(own, number))
        return other;
  return kNoInstruction;
}

Coils::Coil &Coils::coil_of(const Operand &operand) {
  bool of_word = operand.kind == OperandKind::BitOfWord;
  std::vector<Coil> &coils = coils_[operand.device];
  if (coils.empty())
    coils.resize(std::size_t(context_.parameters.points[operand.device]) * (of_word ? kBitsOfWord : 1));
  std::size_t slot = static_cast<std::size_t>(operand.value) - context_.device(operand).first;
  return coils[of_word ? slot * kBitsOfWord + operand.bit : slot];
}

void Coils::write(InstructionIndex index, const Operand &operand) {
  const InstructionInfo &info = *context_.instruction(index).info;
  Coil &coil = coil_of(operand);
  auto first = [index](InstructionIndex &place) { place = place == kNoInstruction ? index : place; };

  if (info.lowering == Lowering::MasterControl) {
    if (InstructionIndex earlier = coil.writer != kNoInstruction ? coil.writer : coil.master; earlier != kNoInstruction)
      warn(DiagId::McDeviceDriven, index, operand, earlier);
    return first(coil.master);
  }
  if (coil.master != kNoInstruction) {
    warn(DiagId::McDeviceDriven, index, operand, coil.master);
  } else if (info.lowering == Lowering::EdgeRelay) {
    if (coil.driver != kNoInstruction)
      warn(DiagId::EdgeRelayShared, index, operand, coil.driver);
  } else if (const InstructionIndex other = drives(index) ? other_driver(index, operand, coil) : kNoInstruction;
             other != kNoInstruction) {
    bool is_timer = context_.device(operand).kind == DeviceKind::Timer;
    bool other_speed = is_timer && info.function != context_.instruction(other).info->function;
    warn(other_speed ? DiagId::TimerSpeedMixed : DiagId::DoubleCoil, index, operand, other);
  }
  first(coil.writer);
  if (info.lowering == Lowering::EdgeRelay)
    return first(coil.driver);
  if (!drives(index))
    return;
  if (ranges_.state_of(index) == kMainScope)
    first(coil.driver);
  else
    state_drivers_[{operand.device, operand.value}].push_back(index);
}

void Coils::warn(DiagId id, InstructionIndex index, const Operand &operand, InstructionIndex earlier) {
  const Instruction &other = context_.instruction(earlier);
  std::string name = coil_name(context_.family, operand);
  DiagBuilder builder = context_.report(id, index, operand.range);
  if (id == DiagId::DoubleCoil || id == DiagId::TimerSpeedMixed)
    builder.arg("mnemonic", context_.instruction(index).info->spelling);
  if (id == DiagId::TimerSpeedMixed)
    builder.arg("other", other.info->spelling);
  builder.arg("device", name)
      .note(DiagId::EarlierInstruction, other.range)
      .arg("mnemonic", other.info->spelling)
      .arg("device", name);
}

}  // namespace ladderc::sema
