// What a program may use a limited number of times: instructions, interrupt sources, fast inputs.
//
// A number of a device class occupies its terminals where the program places it as a label or drives it; a high-speed counter that
// is only read and written is a register. An operand that takes certain numbers of the inputs occupies the one that stands there.
#include "sema/exclusive.h"

#include "sema/names.h"

namespace ladderc::sema {

void ExclusiveUses::visit(InstructionIndex index, const Resolved &resolved) {
  const InstructionInfo *info = context_.instruction(index).info;
  if (!info)
    return;
  if (info->max_uses != 0)
    count(index);
  if (!resolved.shape_fits)
    return;
  llvm::ArrayRef<Operand> operands = context_.operands(index);
  for (unsigned k = 0; k < operands.size(); ++k) {
    const Operand &operand = operands[k];
    if (!resolved.good(k) || operand.kind != OperandKind::Device || operand.index != kNoDevice || !context_.exists(operand))
      continue;
    if (info->placement == Placement::Label || (info->drives && k == 0)) {
      take_number(index, operand);
    } else if (info->operands[k].dir == Direction::In && info->operands[k].last != 0 && context_.device(operand).external_input) {
      const std::string name = info->spelling.str() + " " + context_.text(operand.range).str();
      take_terminals(index, {index, kNoDevice, 0, name}, std::uint32_t(1) << (operand.value & 31));
    }
  }
}

void ExclusiveUses::count(InstructionIndex index) {
  const InstructionInfo &info = *context_.instruction(index).info;
  const unsigned uses = ++uses_[info.mnemonic];
  if (uses <= info.max_uses)
    return;
  static constexpr const char *kOrdinals[] = {"", "first", "second", "third"};
  const std::string ordinal = uses < 4 ? kOrdinals[uses] : std::to_string(uses) + "th";
  static constexpr const char *kCounts[] = {"none", "one", "two", "three"};
  const std::string most = info.max_uses < 4 ? kCounts[info.max_uses] : std::to_string(info.max_uses);
  context_.report(DiagId::MaxUses, index).arg("mnemonic", info.mnemonic).arg("count", ordinal).arg("max", most);
}

void ExclusiveUses::take_number(InstructionIndex index, const Operand &operand) {
  const DeviceInfo &device = context_.device(operand);
  const auto number = static_cast<std::uint64_t>(operand.value);
  for (const ModelNumbers &run : device.exclusive)
    if (number >= run.first && number <= run.last)
      take_run(index, operand, run.first);
  for (const TerminalUse &use : device.terminals)
    if (number >= use.first && number <= use.last)
      take_terminals(index, {index, operand.device, operand.value, device_name(context_.family, operand.device, number)},
                     use.inputs);
}

void ExclusiveUses::take_run(InstructionIndex index, const Operand &operand, std::uint32_t run) {
  const std::string name = device_name(context_.family, operand.device, static_cast<std::uint64_t>(operand.value));
  auto [place, is_new] = runs_.try_emplace({operand.device, run}, User{index, operand.device, operand.value, name});
  const User &other = place->second;
  if (is_new || other.number == operand.value)
    return;  // the same label twice: labels.cpp
  context_.report(DiagId::InterruptTwice, index)
      .arg("label", name)
      .arg("other", other.name)
      .note(DiagId::UsedHere, context_.instruction(other.index).range)
      .arg("other", other.name);
}

void ExclusiveUses::take_terminals(InstructionIndex index, const User &user, std::uint32_t inputs) {
  DeviceId input = kNoDevice;
  for (DeviceId id = 0; id < context_.family.devices.size() && input == kNoDevice; ++id)
    if (context_.family.devices[id].external_input)
      input = id;
  bool reported = false;
  for (unsigned terminal = 0; terminal < 32; ++terminal) {
    if (((inputs >> terminal) & 1) == 0)
      continue;
    auto [place, is_new] = terminals_.try_emplace(terminal, user);
    const User &other = place->second;
    if (is_new || reported || (other.device == user.device && user.device != kNoDevice && other.number == user.number))
      continue;
    // The edges of one input are another message.
    if (other.device == user.device && user.device != kNoDevice && context_.family.devices[user.device].kind == DeviceKind::Label)
      continue;
    reported = true;
    context_.report(DiagId::TerminalShared, index)
        .arg("user", user.name)
        .arg("terminal", device_name(context_.family, input, terminal))
        .arg("other", other.name)
        .note(DiagId::UsedHere, context_.instruction(other.index).range)
        .arg("other", other.name);
  }
}

}  // namespace ladderc::sema
