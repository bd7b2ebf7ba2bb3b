// One operand word, as the device table of the family has it:
//
//   operand   = device [index] | word "." bit [index] | "K" digits device [index] | constant [index]
//   device    = prefix number            the longest prefix that reads; the number counts in the radix of its class
//   bit       = hexadecimal 0-F, leading zeros allowed
//   constant  = "K" ["-"] decimal | "H" hexadecimal
//   index     = index register class and decimal number; "Z" number is known in families without index registers, too, so that sema
//               can say that there are none
//
// Several classes may share a prefix (M0 and M8000); then the number chooses.
//
// `K410` is a constant and `K4X10` digits: letters behind the decimal digits make the difference.
#include "syntax/operand.h"

#include "syntax/parser.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

#include <limits>

namespace ladderc {
namespace {

unsigned digit_value(char c) {
  return llvm::hexDigitValue(c);
}

struct Number {
  llvm::StringRef digits;
  std::uint64_t value = 0;
  bool overflow = false;
};

/// Takes the leading digits of that radix from `rest`.
Number take_number(llvm::StringRef &rest, unsigned radix, std::uint64_t limit) {
  Number number;
  number.digits = rest.take_while([&](char c) { return digit_value(c) < radix; });
  rest = rest.drop_front(number.digits.size());
  for (char c : number.digits) {
    // Checked before each step, so that nothing wraps.
    if (number.value > (limit - digit_value(c)) / radix) {
      number.overflow = true;
      break;
    }
    number.value = number.value * radix + digit_value(c);
  }
  return number;
}

constexpr std::uint64_t kDeviceLimit = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kConstantLimit = std::numeric_limits<std::int64_t>::max();
constexpr std::uint64_t kByteLimit = std::numeric_limits<std::uint8_t>::max();

/// Fills in the problem; returns false so that readers can end with it.
bool blame(OperandProblem &problem, DiagId id, llvm::StringRef word, llvm::StringRef part) {
  problem.id = id;
  problem.begin = static_cast<std::size_t>(part.begin() - word.begin());
  problem.length = part.size();
  return false;
}

/// A letter or digit where a digit of the radix was due, or something that does not belong to a number at all.
bool blame_digit(OperandProblem &problem, llvm::StringRef word, llvm::StringRef rest, llvm::StringRef device, unsigned radix) {
  problem.device = device;
  problem.radix = radix;
  if (llvm::isAlnum(rest.front()))
    return blame(problem, DiagId::DigitNotInRadix, word, rest.take_front(1));
  return blame(problem, DiagId::OperandUnreadable, word, word);
}

}  // namespace

OperandReader::OperandReader(const FamilyInfo &family) : family_(family) {
  for (const auto &[id, device] : llvm::enumerate(family.devices)) {
    if (device.prefix.empty())
      continue;
    auto *known = llvm::find_if(prefixes_, [&, text = device.prefix](const Prefix &prefix) { return prefix.text == text; });
    if (known == prefixes_.end()) {
      prefixes_.push_back({device.prefix, static_cast<DeviceId>(id), device.radix, false});
      continue;
    }
    known->shared = true;
    if (device.first < family.devices[known->device].first)
      known->device = static_cast<DeviceId>(id);
  }
  llvm::stable_sort(prefixes_, [](const Prefix &a, const Prefix &b) {
    if (a.text.front() != b.text.front())
      return static_cast<unsigned char>(a.text.front()) < static_cast<unsigned char>(b.text.front());
    return a.text.size() > b.text.size();
  });
  std::size_t next = 0;
  for (unsigned c = 0; c < 256; ++c) {
    first_[c] = static_cast<std::uint8_t>(next);
    while (next < prefixes_.size() && static_cast<unsigned char>(prefixes_[next].text.front()) == c)
      ++next;
  }
  first_[256] = static_cast<std::uint8_t>(next);
}

llvm::ArrayRef<OperandReader::Prefix> OperandReader::prefixes(char first) const {
  const auto c = static_cast<unsigned char>(first);
  return llvm::ArrayRef<Prefix>(prefixes_).slice(first_[c], first_[c + 1u] - first_[c]);
}

/// Of the classes that begin at or before the number, the last one.
DeviceId OperandReader::class_of(const Prefix &prefix, std::uint64_t number) const {
  DeviceId found = prefix.device;
  for (const auto &[id, device] : llvm::enumerate(family_.devices))
    if (device.prefix == prefix.text && device.first <= number && device.first > family_.devices[found].first)
      found = static_cast<DeviceId>(id);
  return found;
}

bool OperandReader::read_device_word(llvm::StringRef word, Operand &operand, OperandProblem &problem) const {
  bool first = true;
  for (const Prefix &prefix : prefixes(word.front())) {
    if (!word.starts_with(prefix.text))
      continue;
    OperandProblem why;
    if (read_device(word, prefix, operand, why))
      return true;
    // The longest prefix is what the author most likely meant, unless it explains nothing.
    if (first || !problem.looks_like_operand())
      problem = why;
    first = false;
  }
  return false;
}

bool OperandReader::read_device(llvm::StringRef word, const Prefix &prefix, Operand &operand, OperandProblem &problem) const {
  llvm::StringRef rest = word.drop_front(prefix.text.size());
  const Number number = take_number(rest, prefix.radix, kDeviceLimit);
  problem.device = prefix.text;
  if (number.digits.empty()) {
    if (rest.empty())
      return blame(problem, DiagId::DeviceNumberMissing, word, word);
    if (llvm::isDigit(rest.front()))
      return blame_digit(problem, word, rest, prefix.text, prefix.radix);
    return blame(problem, DiagId::OperandUnreadable, word, word);
  }
  if (number.overflow)
    return blame(problem, DiagId::NumberTooLarge, word, number.digits);
  operand.kind = OperandKind::Device;
  operand.device = prefix.shared ? class_of(prefix, number.value) : prefix.device;
  operand.value = static_cast<std::int64_t>(number.value);
  if (rest.consume_front(".") && !read_bit(rest, word, operand, problem))
    return false;
  if (rest.empty() || read_index(rest, operand))
    return true;
  return blame_digit(problem, word, rest, prefix.text, prefix.radix);
}

bool OperandReader::read_bit(llvm::StringRef &rest, llvm::StringRef word, Operand &operand, OperandProblem &problem) const {
  llvm::StringRef written = rest;
  const Number bit = take_number(rest, 16, 15);
  Operand index;
  if (bit.digits.empty() || bit.overflow || (!rest.empty() && !read_index(rest, index)))
    return blame(problem, DiagId::BitNumber, word, written);
  operand.kind = OperandKind::BitOfWord;
  operand.bit = static_cast<std::uint8_t>(bit.value);
  return true;
}

bool OperandReader::read_index(llvm::StringRef rest, Operand &operand) const {
  auto take = [&](llvm::StringRef prefix, DeviceId device) {
    llvm::StringRef behind = rest;
    if (!behind.consume_front(prefix))
      return false;
    const Number number = take_number(behind, 10, kByteLimit);
    if (number.digits.empty() || number.overflow || !behind.empty())
      return false;
    operand.index = device;
    operand.index_number = static_cast<std::uint8_t>(number.value);
    return true;
  };
  if (rest.empty())
    return false;
  if (!family_.has_index_registers)
    return take("Z", kForeignIndex);
  for (const Prefix &prefix : prefixes(rest.front()))
    if (is_index_register(family_, prefix.device) && take(prefix.text, prefix.device))
      return true;
  return false;
}

bool OperandReader::read_decimal(llvm::StringRef word, Operand &operand, OperandProblem &problem) const {
  llvm::StringRef rest = word.drop_front();
  const bool negative = rest.consume_front("-");
  const Number number = take_number(rest, 10, kConstantLimit);
  if (number.digits.empty())
    return blame(problem, DiagId::ConstantSyntax, word, word);
  if (!rest.empty() && !read_index(rest, operand)) {
    if (negative || !llvm::isAlpha(rest.front()))
      return blame(problem, DiagId::ConstantSyntax, word, word);
    return read_digits(word, rest, number.overflow ? kByteLimit : number.value, operand, problem);
  }
  if (number.overflow)
    return blame(problem, DiagId::NumberTooLarge, word, number.digits);
  operand.kind = OperandKind::Decimal;
  operand.value = static_cast<std::int64_t>(number.value);
  if (negative)
    operand.value = -operand.value;
  return true;
}

/// `Z0M0` behind the K and its number: the count of digits was to be modified.
bool OperandReader::is_indexed_count(llvm::StringRef rest) const {
  for (const Prefix &prefix : prefixes(rest.front())) {
    llvm::StringRef behind = rest;
    Operand operand;
    OperandProblem why;
    if (!is_index_register(family_, prefix.device) || !behind.consume_front(prefix.text))
      continue;
    llvm::StringRef device = behind.drop_while(llvm::isDigit);
    if (device.size() < behind.size() && !device.empty() && read_device_word(device, operand, why))
      return true;
  }
  return false;
}

bool OperandReader::read_digits(llvm::StringRef word, llvm::StringRef rest, std::uint64_t count, Operand &operand,
                                OperandProblem &problem) const {
  OperandProblem why;
  if (!read_device_word(rest, operand, why)) {
    if (is_indexed_count(rest))
      return blame(problem, DiagId::DigitCountIndexed, word, word);
    if (!why.looks_like_operand())
      return blame_digit(problem, word, rest, word.take_front(1), 10);
    problem = why;
    problem.begin += word.size() - rest.size();
    return false;
  }
  if (operand.kind != OperandKind::Device)
    return blame(problem, DiagId::OperandUnreadable, word, word);
  operand.kind = OperandKind::Digits;
  operand.digits = static_cast<std::uint8_t>(std::min(count, kByteLimit));
  return true;
}

bool OperandReader::read_hexadecimal(llvm::StringRef word, Operand &operand, OperandProblem &problem) const {
  llvm::StringRef rest = word.drop_front();
  const Number number = take_number(rest, 16, kConstantLimit);
  if (number.digits.empty())
    return blame(problem, DiagId::ConstantSyntax, word, word);
  if (!rest.empty() && !read_index(rest, operand))
    return blame_digit(problem, word, rest, word.take_front(1), 16);
  if (number.overflow)
    return blame(problem, DiagId::NumberTooLarge, word, number.digits);
  operand.kind = OperandKind::Hexadecimal;
  operand.value = static_cast<std::int64_t>(number.value);
  return true;
}

bool OperandReader::read_word(llvm::StringRef word, Operand &operand, OperandProblem &problem) const {
  if (word.empty())
    return false;
  if (read_device_word(word, operand, problem))
    return true;
  if (problem.looks_like_operand())
    return false;
  operand = Operand();
  const char first = word.front();
  const char second = word.size() > 1 ? word[1] : '\0';
  const bool number_follows = llvm::isDigit(second) || second == '-' || second == '+' || second == '.';
  if (first == 'K' && (number_follows || second == '\0'))
    return read_decimal(word, operand, problem);
  if (first == 'H' && (number_follows || second == '\0' || llvm::isHexDigit(second)))
    return read_hexadecimal(word, operand, problem);
  if (first == '"' || (first == 'E' && number_follows)) {
    problem.kind = first == '"' ? "string" : "real";
    return blame(problem, DiagId::UnsupportedConstant, word, word);
  }
  if (llvm::isDigit(first) || (first == '-' && llvm::isDigit(second)))
    return blame(problem, DiagId::ConstantSyntax, word, word);
  return blame(problem, DiagId::OperandUnreadable, word, word);
}

Operand OperandReader::read(llvm::StringRef word, SourceRange range, OperandProblem *problem) const {
  Operand operand;
  OperandProblem why;
  if (!read_word(word, operand, why)) {
    operand = Operand();
    if (problem)
      *problem = why;
  }
  operand.range = range;
  return operand;
}

bool OperandReader::goes_on(llvm::StringRef word, llvm::StringRef number) const {
  if (!family_.spaced_operands || number.empty())
    return false;
  const bool digit = llvm::isDigit(number.front());
  if (word == "K")
    return digit || (number.front() == '-' && number.size() > 1 && llvm::isDigit(number[1]));
  if (word == "H")
    return digit || (llvm::all_of(number, llvm::isHexDigit) && read(number, {}).kind == OperandKind::Invalid);
  return digit && !word.empty() && llvm::any_of(prefixes(word.front()), [&](const Prefix &prefix) { return prefix.text == word; });
}

Operand parse_operand(const FamilyInfo &family, llvm::StringRef word, SourceRange range) {
  return OperandReader(family).read(word, range);
}

}  // namespace ladderc
