// Words, pairs and digits, index registers, and the instructions that move and calculate.
#include "tp03_interpreter.h"

#include "llvm/ADT/StringRef.h"

#include <algorithm>

namespace ladderc::differential {

namespace {

std::int64_t sign_extended(std::uint64_t pattern, unsigned width) {
  return width == 1 ? static_cast<std::int16_t>(pattern) : static_cast<std::int32_t>(pattern);
}

/// The number in decimal digits of four bits.
std::uint64_t to_bcd(std::int64_t value) {
  std::uint64_t bcd = 0;
  for (unsigned shift = 0; value > 0; shift += 4, value /= 10)
    bcd |= static_cast<std::uint64_t>(value % 10) << shift;
  return bcd;
}

/// The number that the digits mean, or nothing.
std::optional<std::int64_t> from_bcd(std::uint64_t bcd) {
  std::int64_t value = 0;
  for (int shift = 28; shift >= 0; shift -= 4) {
    const auto digit = static_cast<std::int64_t>(bcd >> shift & 15);
    if (digit > 9)
      return std::nullopt;
    value = value * 10 + digit;
  }
  return value;
}

}  // namespace

std::int64_t Tp03Interpreter::index_of(const Operand &o, unsigned width) const {
  if (o.index == kNoDevice)
    return 0;
  const std::uint16_t low = arrays_[o.index].value[o.index_number];
  if (width == 1)
    return static_cast<std::int16_t>(low);
  const std::uint16_t high = arrays_[find_device(family_, "V")].value[o.index_number];
  return static_cast<std::int32_t>(std::uint32_t(high) << 16 | low);
}

/// Whether so many words, or bits of a bit class, lie in the class from the operand on.
bool Tp03Interpreter::reachable(const Operand &o, unsigned words, unsigned bits) const {
  const DeviceArray &a = arrays_[o.device];
  const bool is_bits = o.kind == OperandKind::Digits || a.value.size() + a.wide.size() == 0;
  const bool halves = !a.wide.empty() || family_.devices[o.device].prefix == "Z";  // a number has a low and a high word
  const std::size_t count = is_bits ? bits : halves ? (words + 1) / 2 : words;
  const std::size_t points = std::max({a.on.size(), a.value.size(), a.wide.size()});
  return o.value >= static_cast<std::int64_t>(family_.devices[o.device].first) && place(o) + count <= points;
}

/// Word k of a number of the class. `pair`: Z holds low words and V high ones.
std::uint16_t Tp03Interpreter::word_at(DeviceId id, std::uint64_t place, unsigned k, bool pair) const {
  if (!arrays_[id].wide.empty())
    return static_cast<std::uint16_t>(arrays_[id].wide[place + k / 2] >> 16 * (k % 2));
  if (pair && family_.devices[id].prefix == "Z")
    return arrays_[k % 2 ? find_device(family_, "V") : id].value[place + k / 2];
  return arrays_[id].value[place + k];
}

std::int64_t Tp03Interpreter::read(const Operand &o, unsigned width) const {
  std::uint64_t pattern = 0;
  switch (o.kind) {
  case OperandKind::Decimal:
  case OperandKind::Hexadecimal:
    return sign_extended(static_cast<std::uint64_t>(o.value), width);
  case OperandKind::Digits:
    for (unsigned n = 0; n < 4u * o.digits; ++n)
      pattern |= std::uint64_t(arrays_[o.device].on[place(o) + n]) << n;
    return o.digits == 4 * width ? sign_extended(pattern, width) : static_cast<std::int64_t>(pattern);
  default:
    for (unsigned k = 0; k < width; ++k)
      pattern |= std::uint64_t(word_at(o.device, place(o), k, width > 1)) << 16 * k;
    return sign_extended(pattern, width);
  }
}

/// `words`: the width of the result.
void Tp03Interpreter::write(const Operand &o, std::uint64_t value, unsigned words) {
  const std::uint64_t first = place(o);
  DeviceArray &a = arrays_[o.device];
  if (o.kind == OperandKind::Digits) {
    for (unsigned n = 0; n < 4u * o.digits; ++n)
      a.on[first + n] = value >> n & 1;
    return;
  }
  for (unsigned k = 0; k < words; ++k) {
    const auto word = static_cast<std::uint16_t>(value >> 16 * k);
    if (!a.wide.empty()) {
      std::uint32_t &wide = a.wide[first + k / 2];
      wide = k % 2 ? (wide & 0xFFFF) | std::uint32_t(word) << 16 : (wide & 0xFFFF0000) | word;
    } else if (words > 1 && family_.devices[o.device].prefix == "Z") {
      arrays_[k % 2 ? find_device(family_, "V") : o.device].value[first + k / 2] = word;
    } else {
      a.value[first + k] = word;
    }
  }
}

std::uint8_t &Tp03Interpreter::bit(const Operand &o, unsigned distance) {
  return arrays_[o.device].on[place(o) + distance];
}

/// Takes the P and the D off, and calculates where the condition lets it.
void Tp03Interpreter::word(std::size_t i, std::string name) {
  static const std::set<std::string> narrow = {"MOV", "CML",  "XCH", "ADD",  "SUB", "MUL", "DIV", "INC", "DEC",
                                               "NEG", "WAND", "WOR", "WXOR", "BCD", "BIN", "CMP", "ZCP", "ALT"};
  bool on = condition(i);
  unsigned width = 1;
  if (!narrow.count(name) && name.back() == 'P' && name != "CMP" && name != "DCMP" && name != "ZCP" && name != "DZCP") {
    on = edge(i, 'P', on) && !first_scan_;
    name.pop_back();
  }
  if (!narrow.count(name)) {
    width = 2;
    name.erase(0, 1);
  }
  if (on)
    calculate(name, i, width);
}

/// The operands with their index registers added: these count as they are before the instruction writes. Nothing where a place does
/// not exist.
std::optional<std::vector<Operand>> Tp03Interpreter::resolved(const std::string &name, std::size_t i, unsigned width) const {
  std::vector<Operand> o = operands(i).vec();
  const bool doubles = name == "MUL" || name == "DIV", compares = name == "CMP" || name == "ZCP";
  for (std::size_t k = 0; k < o.size(); ++k) {
    o[k].value += index_of(o[k], width);
    o[k].index = kNoDevice;
    if (o[k].device == kNoDevice)
      continue;
    const bool last = k + 1 == o.size(), target = doubles && last && o[k].kind != OperandKind::Digits;
    const unsigned bits = o[k].kind == OperandKind::Digits ? 4u * o[k].digits : compares && last ? 3 : 1;
    if (!reachable(o[k], target ? 2 * width : width, bits))
      return std::nullopt;
  }
  return o;
}

/// What has one result that depends on nothing but the values; nothing: another instruction.
std::optional<std::int64_t> Tp03Interpreter::result_of(const std::string &name, llvm::ArrayRef<Operand> o, unsigned width) const {
  auto in = [&](std::size_t k) { return read(o[k], width); };
  if (name == "MOV")
    return in(0);
  if (name == "CML")
    return ~in(0);
  if (name == "ADD")
    return in(0) + in(1);
  if (name == "SUB")
    return in(0) - in(1);
  if (name == "WAND")
    return in(0) & in(1);
  if (name == "WOR")
    return in(0) | in(1);
  if (name == "WXOR")
    return in(0) ^ in(1);
  if (name == "INC")
    return in(0) + 1;
  if (name == "DEC")
    return in(0) - 1;
  if (name == "NEG")
    return -in(0);
  return std::nullopt;
}

/// An operation error writes nothing.
void Tp03Interpreter::calculate(const std::string &name, std::size_t i, unsigned width) {
  const auto found = resolved(name, i, width);
  if (!found)
    return;
  const llvm::ArrayRef<Operand> o = *found;
  const std::uint64_t mask = width == 1 ? 0xFFFF : 0xFFFFFFFF;
  auto in = [&](std::size_t k) { return read(o[k], width); };
  auto out = [&](const Operand &target, std::int64_t value) { write(target, static_cast<std::uint64_t>(value), width); };
  auto one_of_three = [&](int which) {
    for (int n = 0; n < 3; ++n)
      bit(o.back(), static_cast<unsigned>(n)) = n == which;
  };
  if (const auto result = result_of(name, o, width)) {
    out(o.back(), *result);
  } else if (name == "XCH") {
    const std::int64_t first = in(0), second = in(1);
    out(o[0], second);
    out(o[1], first);
  } else if (name == "MUL") {
    write(o[2], static_cast<std::uint64_t>(in(0) * in(1)), 2 * width);
  } else if (name == "DIV") {
    const std::int64_t a = in(0), b = in(1);
    if (b == 0)
      return;
    const auto quotient = static_cast<std::uint64_t>(a / b) & mask, remainder = static_cast<std::uint64_t>(a % b) & mask;
    write(o[2], quotient | remainder << 16 * width, 2 * width);
  } else if (name == "BCD") {
    const std::int64_t value = in(0);
    if (value >= 0 && value <= (width == 1 ? 9999 : 99999999))
      out(o[1], static_cast<std::int64_t>(to_bcd(value)));
  } else if (name == "BIN") {
    if (const auto value = from_bcd(static_cast<std::uint64_t>(in(0)) & mask))
      out(o[1], *value);
  } else if (name == "CMP") {
    one_of_three(in(0) > in(1) ? 0 : in(0) == in(1) ? 1 : 2);
  } else if (name == "ZCP") {
    const std::int64_t low = in(0), high = std::max(low, in(1)), value = in(2);
    one_of_three(value < low ? 0 : value <= high ? 1 : 2);
  } else {  // ALT
    std::uint8_t &target = bit(o.front());
    target = !target;
  }
}

}  // namespace ladderc::differential
