// Digits and words of the interpreter, one bit and one word at a time.
#include "memory.h"

#include "syntax/parser.h"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>

namespace ladderc::differential {

namespace {

/// The parts of the QS memory that runs of digits and words pass through. Between them lie timer bits, and an empty range.
constexpr std::initializer_list<std::initializer_list<const char *>> kChains = {
    {"SM", "X", "Y", "M", "B", "F", "SB", "V"}, {"T", "ST", "C", "D", "W"}, {"SW", "SD"}};

std::int64_t sign_extended(std::uint64_t pattern, unsigned words) {
  return words == 1 ? static_cast<std::int16_t>(pattern) : static_cast<std::int32_t>(pattern);
}

}  // namespace

Memory::Memory(const FamilyInfo &family, const Parameters &parameters)
    : family_(family), parameters_(parameters), arrays_(family.devices.size()), next_(family.devices.size(), kNoDevice) {
  for (DeviceId id = 0; id < family.devices.size(); ++id) {
    const std::size_t points = parameters.points[id];
    const DeviceKind kind = family.devices[id].kind;
    const bool has_parts = kind == DeviceKind::Timer || kind == DeviceKind::Counter;
    if (kind == DeviceKind::Bit || has_parts)
      arrays_[id].on.resize(points);
    if (has_parts)
      arrays_[id].coil.resize(points);
    if (kind == DeviceKind::Word || has_parts)
      arrays_[id].value.resize(points);
  }
  for (const auto &chain : kChains) {
    DeviceId before = kNoDevice;
    for (const char *prefix : chain) {
      const DeviceId id = find_device(family, prefix);
      if (before != kNoDevice)
        next_[before] = id;
      before = id;
    }
  }
}

void Memory::clear() {
  for (DeviceId id = 0; id < arrays_.size(); ++id)
    clear_unlatched(arrays_[id], id, family_, parameters_);
}

void Memory::write_initial_values() {
  for (const InitialValue &initial : parameters_.initial_values)
    write_initial_value(initial, family_, [&](DeviceId id) -> DeviceArray & { return arrays_[id]; });
}

void clear_unlatched(DeviceArray &array, DeviceId id, const FamilyInfo &family, const Parameters &parameters) {
  const bool of_system = family.devices[id].prefix == "SM" || family.devices[id].prefix == "SD";
  const std::size_t first = family.devices[id].first;
  for (std::size_t n = 0; n < std::max(array.on.size(), array.value.size()); ++n) {
    const bool latched = !of_system && std::any_of(parameters.latched.begin(), parameters.latched.end(), [&](const DeviceRange &r) {
      return r.device == id && r.first <= first + n && first + n <= r.last;
    });
    if (latched)
      continue;
    if (n < array.on.size())
      array.on[n] = 0;
    if (n < array.coil.size())
      array.coil[n] = 0;
    if (n < array.value.size())
      array.value[n] = 0;
    if (n < array.wide.size())
      array.wide[n] = 0;
  }
}

void write_initial_value(const InitialValue &initial, const FamilyInfo &family,
                         llvm::function_ref<DeviceArray &(DeviceId)> array_of) {
  const Operand operand = parse_operand(family, initial.device, {});
  DeviceArray &array = array_of(operand.device);
  const auto number = static_cast<std::size_t>(operand.value);
  if (family.devices[operand.device].kind == DeviceKind::Bit)
    array.on[number] = initial.value != 0;
  else
    array.value[number] = static_cast<std::uint16_t>(initial.value);
}

DeviceArray &Memory::array(std::string_view prefix) {
  return arrays_[find_device(family_, prefix)];
}

std::uint8_t &Memory::bit(DeviceId id, std::uint64_t number, unsigned distance) {
  std::uint64_t n = number + distance;
  while (n >= arrays_[id].on.size()) {
    n -= arrays_[id].on.size();
    id = next_[id];
    if (id == kNoDevice)
      throw std::out_of_range("a run of digits leaves the memory");
  }
  return arrays_[id].on[n];
}

std::uint16_t &Memory::word(DeviceId id, std::uint64_t number, unsigned distance) {
  std::uint64_t n = number + distance;
  while (n >= arrays_[id].value.size()) {
    n -= arrays_[id].value.size();
    id = next_[id];
    if (id == kNoDevice)
      throw std::out_of_range("a run of words leaves the memory");
  }
  return arrays_[id].value[n];
}

bool Memory::read_bit(const Operand &o) {
  const auto number = static_cast<std::uint64_t>(o.value);
  if (o.kind == OperandKind::BitOfWord)
    return (word(o.device, number) >> o.bit & 1) != 0;
  return bit(o.device, number) != 0;
}

void Memory::write_bit(const Operand &o, bool on) {
  const auto number = static_cast<std::uint64_t>(o.value);
  if (o.kind != OperandKind::BitOfWord) {
    bit(o.device, number) = on;
    return;
  }
  std::uint16_t &w = word(o.device, number);
  w = static_cast<std::uint16_t>((w & ~(1u << o.bit)) | unsigned(on) << o.bit);
}

std::int64_t Memory::read(const Operand &o, unsigned words) {
  const auto number = static_cast<std::uint64_t>(o.value);
  std::uint64_t pattern = 0;
  switch (o.kind) {
  case OperandKind::Decimal:
  case OperandKind::Hexadecimal:
    return sign_extended(number, words);
  case OperandKind::Digits:
    for (unsigned i = 0; i < 4u * o.digits; ++i)
      pattern |= std::uint64_t(bit(o.device, number, i)) << i;
    return o.digits == 4 * words ? sign_extended(pattern, words) : static_cast<std::int64_t>(pattern);
  default:
    for (unsigned i = 0; i < words; ++i)
      pattern |= std::uint64_t(word(o.device, number, i)) << 16 * i;
    return sign_extended(pattern, words);
  }
}

void Memory::write(const Operand &o, std::uint64_t pattern, unsigned words) {
  const auto number = static_cast<std::uint64_t>(o.value);
  if (o.kind == OperandKind::Digits) {
    for (unsigned i = 0; i < 4u * o.digits; ++i)
      bit(o.device, number, i) = pattern >> i & 1;
    return;
  }
  for (unsigned i = 0; i < words; ++i)
    word(o.device, number, i) = static_cast<std::uint16_t>(pattern >> 16 * i);
}

}  // namespace ladderc::differential
