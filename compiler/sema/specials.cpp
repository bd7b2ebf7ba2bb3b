// Special relays and registers that belong to the system: writing one is legal, has mostly no lasting effect, and is worth a look.
#include "sema/specials.h"

#include "sema/names.h"
#include "sema/operands.h"
#include "syntax/parser.h"

#include <algorithm>

namespace ladderc::sema {

Specials::Specials(const FamilyInfo &family) : read_only_(family.devices.size()) {
  for (const SpecialInfo &special : family.specials)
    if (!special.writable)
      add(family, special);
}

void Specials::add(const FamilyInfo &family, const SpecialInfo &special) {
  auto [first_text, last_text] = special.device.split('-');
  Operand first = parse_operand(family, first_text, {});
  Operand last = last_text.empty() ? first : parse_operand(family, last_text, {});
  auto &numbers = read_only_[first.device];
  numbers.resize(std::max(numbers.size(), static_cast<std::size_t>(last.value + 1)));
  for (std::int64_t n = first.value; n <= last.value; ++n)
    numbers[static_cast<std::size_t>(n)] = &special;
}

void Specials::check(const Context &context, InstructionIndex index, const Resolved &resolved) const {
  const InstructionInfo &info = *context.instruction(index).info;
  llvm::ArrayRef<Operand> operands = context.operands(index);
  for (unsigned k = 0; k < operands.size(); ++k) {
    const Operand &operand = operands[k];
    if (!resolved.good(k) || info.operands[k].dir == Direction::In || operand.device == kNoDevice || operand.index != kNoDevice)
      continue;
    const auto &numbers = read_only_[operand.device];
    std::uint64_t first = static_cast<std::uint64_t>(operand.value);
    std::uint64_t end = std::min<std::uint64_t>(first + extent(context.family, info.operands[k], operand), numbers.size());
    for (std::uint64_t n = first; n < end; ++n) {
      if (!numbers[n])
        continue;
      context.report(DiagId::SpecialReadOnly, index, operand.range)
          .arg("mnemonic", info.spelling)
          .arg("device", device_name(context.family, operand.device, n))
          .arg("title", numbers[n]->name);
      break;
    }
  }
}

}  // namespace ladderc::sema
