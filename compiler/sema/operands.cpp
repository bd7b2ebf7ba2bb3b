// Numbers: device numbers, digit counts, constants, and how far an operand reaches.
//
// A pair of words or a run of digits is not stopped by the end of its device class: DMOV to the last D writes the first W too. The
// manual says so, hence this is a warning; where nothing usable lies behind the class it is an error. Block instructions check
// their range when they run, which is foreseen here where the length is a constant.
#include "sema/operands.h"

#include "sema/check.h"
#include "sema/names.h"

#include "fmt/format.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

namespace ladderc::sema {

namespace {

struct Range {
  std::int64_t min, max;
};

bool is_32_bit(OperandType type) {
  switch (type) {
  case OperandType::DWord:
  case OperandType::QWord:
  case OperandType::DWordTwice:
  case OperandType::DWordBlock:
  case OperandType::Real:
    return true;
  default:
    return false;
  }
}

bool is_block(OperandType type) {
  return type == OperandType::WordBlock || type == OperandType::DWordBlock || type == OperandType::BitRun;
}

bool is_data(OperandType type) {
  return type == OperandType::Word || type == OperandType::WordTwice || type == OperandType::WordBlock || is_32_bit(type);
}

std::uint32_t words_of(OperandType type) {
  switch (type) {
  case OperandType::DWord:
  case OperandType::WordTwice:
  case OperandType::DWordBlock:
  case OperandType::Real:
    return 2;
  case OperandType::QWord:
  case OperandType::DWordTwice:
    return 4;
  default:
    return 1;
  }
}

/// A 32-bit counter holds two words under one number, and so does an index register whose high words are another class.
std::uint32_t numbers_of(const DeviceInfo &device, OperandType type) {
  const std::uint32_t words = words_of(type);
  const bool wide = device.kind == DeviceKind::LongCounter || (device.high_words != kNoDevice && words > 1);
  return wide ? (words + 1) / 2 : words;
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
  bool check_number(const OperandInfo &info, const Operand &operand);
  bool check_index(const OperandInfo &info, const Operand &operand);
  bool check_text(const Operand &operand);
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
  std::uint32_t last_number(const Operand &operand) const { return context_.device(operand).first + points(operand) - 1; }
  std::string last_of(const Operand &operand) const { return device_name(context_.family, operand.device, last_number(operand)); }

  const Context &context_;
  InstructionIndex index_;
  const InstructionInfo &info_;
  llvm::ArrayRef<Operand> operands_;
  Resolved &resolved_;
};

bool OperandChecker::check(const OperandInfo &info, const Operand &operand) {
  if (operand.index != kNoDevice && !check_index(info, operand))
    return false;
  switch (operand.kind) {
  case OperandKind::Decimal:
  case OperandKind::Hexadecimal:
    return check_constant(info, operand);
  case OperandKind::Digits:
    return check_digits(info, operand) && check_number(info, operand) && check_end(info, operand);
  case OperandKind::BitOfWord:
    return check_number(info, operand);
  case OperandKind::Device:
    if (info.type == OperandType::Level || context_.device(operand).kind == DeviceKind::Label)
      return true;  // master.cpp, labels.cpp
    return check_number(info, operand) && check_end(info, operand);
  case OperandKind::Text:
    return check_text(operand);
  case OperandKind::Invalid:
    break;
  }
  return false;
}

/// The number exists, and it is one of those that this position takes.
bool OperandChecker::check_number(const OperandInfo &info, const Operand &operand) {
  const DeviceInfo &device = context_.device(operand);
  if (!context_.exists(operand)) {
    const bool allocated = llvm::any_of(context_.family.devices, [](const DeviceInfo &d) { return d.points_register >= 0; });
    if (!allocated)
      report(DiagId::NoSuchDevice, operand)
          .arg("model", context_.model)
          .arg("numbers", numbers_text(context_.family, operand.device, existing_numbers(device, context_.model, points(operand))));
    else if (points(operand) == 0)
      report(DiagId::DeviceNotAllocated, operand).arg("prefix", device.prefix);
    else
      report(DiagId::DeviceOutOfRange, operand).arg("last", last_of(operand)).arg("prefix", device.prefix);
    return false;
  }
  if (takes_number(info, operand.value))
    return true;
  report(DiagId::OperandNumber, operand)
      .arg("mnemonic", info_.spelling)
      .arg("name", info.name)
      .arg("allowed", run_name(context_.family, operand.device, info.first, info.last));
  return false;
}

/// An index register may stand here, exists, and is the low word of a pair where the instruction has 32 bits.
bool OperandChecker::check_index(const OperandInfo &info, const Operand &operand) {
  if (!info.indexable || (operand.device != kNoDevice && is_index_register(context_.family, operand.device))) {
    report(DiagId::NotIndexable, operand).arg("mnemonic", info_.spelling).arg("name", info.name);
    return false;
  }
  Operand index;
  index.device = operand.index;
  index.value = operand.index_number;
  const std::string name = device_name(context_.family, index.device, operand.index_number);
  if (!context_.exists(index)) {
    context_.report(DiagId::NoSuchDevice, index_, operand.range)
        .arg("operand", name)
        .arg("model", context_.model)
        .arg("numbers",
             numbers_text(context_.family, index.device, existing_numbers(context_.device(index), context_.model, points(index))));
    return false;
  }
  const bool wide = info_.wide || llvm::any_of(info_.operands, [](const OperandInfo &o) { return is_32_bit(o.type); });
  if (!wide || context_.device(index).high_words != kNoDevice)
    return true;
  for (DeviceId low = 0; low < context_.family.devices.size(); ++low)
    if (context_.family.devices[low].high_words == index.device)
      report(DiagId::IndexNotPair, operand)
          .arg("index", name)
          .arg("mnemonic", info_.spelling)
          .arg("pair", device_name(context_.family, low, operand.index_number));
  return false;
}

bool OperandChecker::check_text(const Operand &operand) {
  constexpr std::size_t kMostCharacters = 8;
  llvm::StringRef text = context_.list.texts[static_cast<std::size_t>(operand.value)];
  if (!llvm::all_of(text, [](char c) { return llvm::isPrint(c); })) {
    (void)report(DiagId::TextCharacter, operand);
    return false;
  }
  if (!text.empty() && text.size() <= kMostCharacters)
    return true;
  report(DiagId::TextLength, operand)
      .arg("count", static_cast<long long>(text.size()))
      .arg("mnemonic", info_.spelling)
      .arg("max", static_cast<long long>(kMostCharacters));
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
  bool own_range = (info.min != 0 || info.max != 0) && (info.min != natural.min || info.max != natural.max);
  // With an index register the value is known at run time only.
  Range range = own_range && operand.index == kNoDevice ? Range{info.min, info.max} : natural;
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
  if (operand.index != kNoDevice)
    return true;  // known at run time only
  if (is_block(info.type) && info.count == 0)
    return true;  // never crosses: check_blocks
  std::uint32_t count = extent(context_.family, info, operand);
  if (info.count != 0)
    count *= info.count;
  std::uint32_t number = static_cast<std::uint32_t>(operand.value);
  if (!crosses_end(context_.family, context_.parameters, operand.device, number, count))
    return true;
  bool goes_on = point_behind(context_.family, context_.parameters, {operand.device, number}, count - 1).device != kNoDevice;
  DiagBuilder builder = report(goes_on ? DiagId::CrossesDeviceEnd : DiagId::RunsOffMemory, operand);
  const bool bits = operand.kind == OperandKind::Digits || info.type == OperandType::BitRun;
  builder.arg("count", count).arg("unit", bits ? "bits" : "words").arg("last", last_of(operand));
  if (goes_on) {
    DevicePoint next = point_behind(context_.family, context_.parameters, {operand.device, last_number(operand)}, 1);
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

/// Blocks whose length, the last operand, is a constant. Where the program goes on behind the error, it is the program's business.
void OperandChecker::check_blocks() {
  if (!resolved_.all_good() || operands_.empty() || !context_.family.errors_stop)
    return;
  const Operand &length = operands_.back();
  if (length.kind != OperandKind::Decimal && length.kind != OperandKind::Hexadecimal)
    return;
  for (unsigned k = 0; k + 1 < operands_.size(); ++k) {
    const Operand &operand = operands_[k];
    if (info_.operands[k].type != OperandType::WordBlock || operand.device == kNoDevice)
      continue;
    std::uint64_t count = static_cast<std::uint64_t>(length.value) * extent(context_.family, info_.operands[k], operand);
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

bool takes_number(const OperandInfo &info, std::int64_t number) {
  return (info.first == 0 && info.last == 0) || (number >= info.first && number <= info.last);
}

std::uint32_t extent(const FamilyInfo &family, const OperandInfo &info, const Operand &operand) {
  if (operand.kind == OperandKind::Digits)
    return operand.digits * 4u;
  return operand.kind == OperandKind::Device && is_data(info.type) ? numbers_of(family.devices[operand.device], info.type) : 1;
}

void check_operands(const Context &context, InstructionIndex index, Resolved &resolved) {
  if (resolved.shape_fits)
    OperandChecker(context, index, resolved).run();
}

}  // namespace ladderc::sema
