// Numbers: device numbers, digit counts, constants, and how far an operand reaches.
//
// A pair of words or a run of digits is not stopped by the end of its device class: DMOV to the last D writes the first W too. The
// manual says so, hence this is a warning; where nothing usable lies behind the class it is an error. Block instructions check
// their range when they run, which is foreseen here where the length is a constant.
#include "sema/operands.h"

#include "sema/check.h"
#include "sema/names.h"

#include "fmt/format.h"

namespace ladderc::sema {

namespace {

struct Range {
  std::int64_t min, max;
};

bool is_32_bit(OperandType type) {
  return type == OperandType::DWord || type == OperandType::QWord || type == OperandType::DWordTwice;
}

bool is_data(OperandType type) {
  switch (type) {
  case OperandType::Word:
  case OperandType::DWord:
  case OperandType::QWord:
  case OperandType::WordTwice:
  case OperandType::DWordTwice:
  case OperandType::WordBlock:
    return true;
  default:
    return false;
  }
}

std::uint32_t words_of(OperandType type) {
  switch (type) {
  case OperandType::DWord:
  case OperandType::WordTwice:
    return 2;
  case OperandType::QWord:
  case OperandType::DWordTwice:
    return 4;
  default:
    return 1;
  }
}

unsigned max_digits(OperandType type) {
  return is_32_bit(type) ? 8 : 4;
}

class OperandChecker {
public:
  OperandChecker(const Context &context, InstructionIndex index, Resolved &resolved)
      : context_(context), index_(index), info_(*context.instruction(index).info), operands_(context.operands(index)),
        resolved_(resolved) {}

  void run() {
    for (unsigned k = 0; k < operands_.size(); ++k)
      if (resolved_.good(k) && !check(info_.operands[k], operands_[k]))
        resolved_.bad |= std::uint64_t(1) << k;
    check_equal_digits();
    check_blocks();
  }

private:
  bool check(const OperandInfo &info, const Operand &operand);
  bool check_number(const Operand &operand);
  bool check_digits(const OperandInfo &info, const Operand &operand);
  bool check_constant(const OperandInfo &info, const Operand &operand);
  bool check_end(const OperandInfo &info, const Operand &operand);
  void check_equal_digits();
  void check_blocks();

  DiagBuilder report(DiagId id, const Operand &operand) const {
    DiagBuilder builder = context_.report(id, index_, operand.range);
    builder.arg("operand", context_.text(operand.range));
    return builder;
  }
  std::uint32_t points(const Operand &operand) const { return context_.parameters.points[operand.device]; }
  std::string last_of(const Operand &operand) const { return device_name(context_.family, operand.device, points(operand) - 1); }

  const Context &context_;
  InstructionIndex index_;
  const InstructionInfo &info_;
  llvm::ArrayRef<Operand> operands_;
  Resolved &resolved_;
};

bool OperandChecker::check(const OperandInfo &info, const Operand &operand) {
  switch (operand.kind) {
  case OperandKind::Decimal:
  case OperandKind::Hexadecimal:
    return check_constant(info, operand);
  case OperandKind::Digits:
    return check_digits(info, operand) && check_number(operand) && check_end(info, operand);
  case OperandKind::BitOfWord:
    return check_number(operand);
  case OperandKind::Device:
    return info.type == OperandType::Level /* master.cpp */ || (check_number(operand) && check_end(info, operand));
  case OperandKind::Text:
  case OperandKind::Invalid:
    break;
  }
  return false;
}

bool OperandChecker::check_number(const Operand &operand) {
  if (static_cast<std::uint64_t>(operand.value) < points(operand))
    return true;
  llvm::StringRef prefix = context_.family.devices[operand.device].prefix;
  if (points(operand) == 0)
    report(DiagId::DeviceNotAllocated, operand).arg("prefix", prefix);
  else
    report(DiagId::DeviceOutOfRange, operand).arg("last", last_of(operand)).arg("prefix", prefix);
  return false;
}

bool OperandChecker::check_digits(const OperandInfo &info, const Operand &operand) {
  if (operand.digits >= 1 && operand.digits <= max_digits(info.type))
    return true;
  report(DiagId::DigitCount, operand)
      .arg("count", operand.digits)
      .arg("mnemonic", info_.spelling)
      .arg("max", max_digits(info.type))
      .arg("name", info.name);
  return false;
}

/// H constants are bit patterns: they must fit the width and then count as the signed number of that pattern.
bool OperandChecker::check_constant(const OperandInfo &info, const Operand &operand) {
  unsigned width = is_32_bit(info.type) ? 32 : 16;
  std::int64_t top = std::int64_t(1) << (width - 1);
  Range natural{-top, top - 1};
  bool own_range = info.min != 0 || info.max != 0;
  Range range = own_range ? Range{info.min, info.max} : natural;
  bool hexadecimal = operand.kind == OperandKind::Hexadecimal;
  std::int64_t value = operand.value;
  bool fits = true;
  if (hexadecimal) {
    fits = value >= 0 && value < 2 * top;
    if (fits && value >= top)
      value -= 2 * top;
  }
  if (fits && value >= range.min && value <= range.max)
    return true;
  std::string min = fmt::format("K{}", range.min), max = fmt::format("K{}", range.max);
  if (hexadecimal) {
    min = fmt::format("H{:X}", own_range ? range.min : 0);
    max = fmt::format("H{:X}", own_range ? range.max : 2 * top - 1);
  }
  report(DiagId::ConstantRange, operand).arg("min", min).arg("max", max).arg("mnemonic", info_.spelling).arg("name", info.name);
  return false;
}

/// Pairs, quads and digit runs over the end of their class.
bool OperandChecker::check_end(const OperandInfo &info, const Operand &operand) {
  if (info.type == OperandType::WordBlock)
    return true;  // never crosses: check_blocks
  std::uint32_t count = extent(info, operand);
  std::uint32_t number = static_cast<std::uint32_t>(operand.value);
  if (!crosses_end(context_.family, context_.parameters, operand.device, number, count))
    return true;
  bool goes_on = point_behind(context_.family, context_.parameters, {operand.device, number}, count - 1).device != kNoDevice;
  DiagBuilder builder = report(goes_on ? DiagId::CrossesDeviceEnd : DiagId::RunsOffMemory, operand);
  builder.arg("count", count).arg("unit", operand.kind == OperandKind::Digits ? "bits" : "words").arg("last", last_of(operand));
  if (goes_on) {
    DevicePoint next = point_behind(context_.family, context_.parameters, {operand.device, points(operand) - 1}, 1);
    builder.arg("next", device_name(context_.family, next.device, next.number));
  }
  return goes_on;
}

void OperandChecker::check_equal_digits() {
  if (!info_.equal_digits || !resolved_.good(0) || !resolved_.good(1))
    return;
  const Operand &source = operands_[0], &destination = operands_[1];
  if (source.kind != OperandKind::Digits || destination.kind != OperandKind::Digits || source.digits == destination.digits)
    return;
  report(DiagId::DigitsUnequal, destination).arg("other", context_.text(source.range)).arg("mnemonic", info_.spelling);
  resolved_.bad |= 2;
}

/// Blocks whose length, the last operand, is a constant.
void OperandChecker::check_blocks() {
  if (!resolved_.all_good() || operands_.empty())
    return;
  const Operand &length = operands_.back();
  if (length.kind != OperandKind::Decimal && length.kind != OperandKind::Hexadecimal)
    return;
  for (unsigned k = 0; k + 1 < operands_.size(); ++k) {
    const Operand &operand = operands_[k];
    if (info_.operands[k].type != OperandType::WordBlock || operand.device == kNoDevice)
      continue;
    std::uint64_t count = static_cast<std::uint64_t>(length.value) * extent(info_.operands[k], operand);
    if (static_cast<std::uint64_t>(operand.value) + count <= points(operand))
      continue;
    report(DiagId::BlockBeyondEnd, operand)
        .arg("count", static_cast<long long>(count))
        .arg("unit", operand.kind == OperandKind::Digits ? "bits" : "words")
        .arg("last", last_of(operand))
        .arg("mnemonic", info_.spelling);
  }
}

}  // namespace

std::uint32_t extent(const OperandInfo &info, const Operand &operand) {
  if (operand.kind == OperandKind::Digits)
    return operand.digits * 4u;
  return operand.kind == OperandKind::Device && is_data(info.type) ? words_of(info.type) : 1;
}

void check_operands(const Context &context, InstructionIndex index, Resolved &resolved) {
  if (resolved.shape_fits)
    OperandChecker(context, index, resolved).run();
}

}  // namespace ladderc::sema
