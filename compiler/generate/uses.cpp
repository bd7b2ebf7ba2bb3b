// A device that a program drives, or places as a label, has its terminals for itself; so has an input that an instruction asks for
// by number.
#include "generate/uses.h"

#include "llvm/ADT/STLExtras.h"

namespace ladderc::generate {

bool Uses::take(const InstructionInfo &info, llvm::ArrayRef<Operand> operands) {
  if (info.max_uses != 0 && counts_[info.mnemonic] >= info.max_uses)
    return false;
  std::map<std::uint32_t, std::pair<DeviceId, std::uint64_t>> taken;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    const Operand &o = operands[k];
    if (o.kind != OperandKind::Device)
      continue;
    const auto number = static_cast<std::uint64_t>(o.value);
    const bool input =
        family_.devices[o.device].external_input && info.operands[k].dir == Direction::In && info.operands[k].last != 0;
    const std::uint32_t mask = input                   ? std::uint32_t(1) << (number & 31)
                               : info.drives && k == 0 ? terminals_of(o.device, number)
                                                       : 0;
    for (std::uint32_t terminal = 0; terminal < 32; ++terminal)
      if (mask >> terminal & 1) {
        const auto found = terminals_.find(terminal);
        if (found != terminals_.end() && (input || found->second != std::pair(o.device, number)))
          return false;
        taken[terminal] = {input ? kNoDevice : o.device, number};
      }
  }
  terminals_.insert(taken.begin(), taken.end());
  ++counts_[info.mnemonic];
  return true;
}

std::vector<std::uint32_t> Uses::free_labels(DeviceId device) const {
  const DeviceInfo &info = family_.devices[device];
  std::vector<std::uint32_t> numbers;
  for (const ModelNumbers &run : existing_numbers(info, model_, parameters_.points[device]))
    for (std::uint32_t n = run.first; n <= run.last; ++n) {
      const auto placed = labels_.find(device);
      const bool clashes = placed != labels_.end() && llvm::any_of(placed->second, [&](std::uint32_t other) {
                             return other == n || llvm::any_of(info.exclusive, [&](const ModelNumbers &e) {
                                      return n >= e.first && n <= e.last && other >= e.first && other <= e.last;
                                    });
                           });
      bool free = !clashes && !(info.exclusive.empty() && static_cast<std::int64_t>(n) == family_.end_label);
      for (std::uint32_t terminal = 0; terminal < 32; ++terminal)
        free &= !(terminals_of(device, n) >> terminal & 1) || !terminals_.count(terminal);
      if (free)
        numbers.push_back(n);
    }
  return numbers;
}

void Uses::take_label(DeviceId device, std::uint32_t number) {
  labels_[device].push_back(number);
  const std::uint32_t mask = terminals_of(device, number);
  for (std::uint32_t terminal = 0; terminal < 32; ++terminal)
    if (mask >> terminal & 1)
      terminals_[terminal] = {device, number};
}

std::uint32_t Uses::terminals_of(DeviceId device, std::uint64_t number) const {
  for (const TerminalUse &use : family_.devices[device].terminals)
    if (number >= use.first && number <= use.last)
      return use.inputs;
  return 0;
}

}  // namespace ladderc::generate
