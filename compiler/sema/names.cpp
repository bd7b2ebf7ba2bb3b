// How messages name devices and what may stand in an operand position.
#include "sema/names.h"

#include "llvm/ADT/SmallVector.h"

#include <algorithm>

namespace ladderc::sema {

std::string device_name(const FamilyInfo &family, DeviceId device, std::uint64_t number) {
  const DeviceInfo &info = family.devices[device];
  std::string digits;
  do {
    digits.push_back("0123456789ABCDEF"[number % info.radix]);
    number /= info.radix;
  } while (number != 0);
  std::reverse(digits.begin(), digits.end());
  return info.prefix.str() + digits;
}

void Allowed::add(const OperandInfo &operand) {
  devices |= operand.devices;
  word_bits |= operand.word_bits;
  digits |= operand.digits;
  decimal |= operand.decimal;
  hexadecimal |= operand.hexadecimal;
}

std::string allowed_text(const FamilyInfo &family, const Allowed &allowed) {
  llvm::SmallVector<std::string, 32> parts;
  auto add = [&](DeviceSet set, const char *before, const char *behind) {
    for (DeviceId id = 0; id < family.devices.size(); ++id)
      if (contains(set, id))
        parts.push_back(before + family.devices[id].prefix.str() + behind);
  };
  add(allowed.devices, "", "");
  add(allowed.word_bits, "", "n.b");
  add(allowed.digits, "Kn", "");
  if (allowed.decimal)
    parts.push_back(allowed.hexadecimal ? "a K or H constant" : "a K constant");
  else if (allowed.hexadecimal)
    parts.push_back("an H constant");
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i != 0)
      text += i + 1 == parts.size() ? " or " : ", ";
    text += parts[i];
  }
  return text;
}

std::string shape_text(const InstructionInfo &info) {
  std::string text = info.spelling.str();
  for (const OperandInfo &operand : info.operands) {
    std::string name = operand.name.str();
    std::replace(name.begin(), name.end(), ' ', '-');
    text += " " + name;
  }
  return text;
}

}  // namespace ladderc::sema
