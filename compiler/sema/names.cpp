// How messages name devices and what may stand in an operand position.
#include "sema/names.h"

#include "llvm/ADT/STLExtras.h"
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
  if (digits.size() < info.name_digits)
    digits.append(info.name_digits - digits.size(), '0');
  std::reverse(digits.begin(), digits.end());
  return info.prefix.str() + digits;
}

/// "M"; with the numbers where other classes have the same prefix and are not in the set.
static std::string class_name(const FamilyInfo &family, DeviceSet set, DeviceId device) {
  const DeviceInfo &info = family.devices[device];
  for (DeviceId other = 0; other < family.devices.size(); ++other)
    if (other != device && family.devices[other].prefix == info.prefix && !contains(set, other))
      return run_name(family, device, info.first, info.first + info.points - 1);
  return info.prefix.str();
}

std::string run_name(const FamilyInfo &family, DeviceId device, std::uint32_t first, std::uint32_t last) {
  std::string name = device_name(family, device, first);
  return first == last ? name : name + "-" + device_name(family, device, last);
}

std::string joined(llvm::ArrayRef<std::string> parts, llvm::StringRef last_word) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i != 0)
      text += i + 1 == parts.size() ? " " + last_word.str() + " " : std::string(", ");
    text += parts[i];
  }
  return text;
}

std::string numbers_text(const FamilyInfo &family, DeviceId device, llvm::ArrayRef<ModelNumbers> runs) {
  constexpr std::size_t kShown = 6;
  llvm::SmallVector<std::string, 8> parts;
  for (const ModelNumbers &run : runs.take_front(runs.size() > kShown ? kShown - 1 : kShown))
    parts.push_back(run_name(family, device, run.first, run.last));
  if (runs.size() > kShown)
    parts.push_back("others up to " + device_name(family, device, runs.back().last));
  return parts.empty() ? "none" : joined(parts, "and");
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
        if (std::string name = before + class_name(family, set, id) + behind; !llvm::is_contained(parts, name))
          parts.push_back(std::move(name));
  };
  add(allowed.devices, "", "");
  add(allowed.word_bits, "", "n.b");
  add(allowed.digits, "Kn", "");
  if (allowed.decimal)
    parts.push_back(allowed.hexadecimal ? "a K or H constant" : "a K constant");
  else if (allowed.hexadecimal)
    parts.push_back("an H constant");
  return joined(parts, "or");
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
