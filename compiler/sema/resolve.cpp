// Which entry of the instruction table a list line is.
//
// Several entries share a spelling: OUT M0, OUT T0 K10, OUT F1; OUT T0 and OUT T200; + S D and + S1 S2 D. First the number of
// operands decides, then the device classes and numbers. Entries that the model lacks come last. Where nothing fits, the message is
// about the entry that the author most likely meant: one with the right number of operands, unless only one of another length
// agrees in the first operand (OUT T0 lacks its set value and is no bad OUT of a bit).
#include "sema/resolve.h"

#include "sema/names.h"
#include "sema/operands.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/Twine.h"

#include <tuple>

namespace ladderc::sema {

namespace {

bool is_constant(const Operand &operand) {
  return operand.kind == OperandKind::Decimal || operand.kind == OperandKind::Hexadecimal;
}

bool is_timer_or_counter(const FamilyInfo &family, DeviceId device) {
  if (device == kNoDevice)
    return false;
  const DeviceKind kind = family.devices[device].kind;
  return kind == DeviceKind::Timer || kind == DeviceKind::Counter || kind == DeviceKind::LongCounter;
}

bool is_word(OperandType type) {
  return type == OperandType::Word || type == OperandType::WordTwice || type == OperandType::WordBlock;
}

bool is_on_model(const InstructionInfo &info, llvm::StringRef model) {
  return info.models.empty() || llvm::is_contained(info.models, model);
}

/// An unreadable operand has its message already and fits anywhere.
bool fits(const OperandInfo &info, const Operand &operand) {
  switch (operand.kind) {
  case OperandKind::Device:
    return contains(info.devices, operand.device);
  case OperandKind::BitOfWord:
    return contains(info.word_bits, operand.device);
  case OperandKind::Digits:
    return contains(info.digits, operand.device);
  case OperandKind::Decimal:
    return info.decimal;
  case OperandKind::Hexadecimal:
    return info.hexadecimal;
  case OperandKind::Text:
    return info.type == OperandType::String;
  case OperandKind::Invalid:
    return true;
  }
  return false;
}

/// Of several entries for one device class, the number of the device chooses.
bool fits_with_number(const OperandInfo &info, const Operand &operand) {
  return fits(info, operand) && (operand.kind != OperandKind::Device || takes_number(info, operand.value));
}

/// How well the operands agree with an entry. The first one weighs most: it tells a timer from an output.
struct Agreement {
  bool first = false;
  bool on_model = false;
  unsigned count = 0;
  unsigned numbers = 0;  ///< of them with a number that fits too

  bool operator>(const Agreement &other) const {
    return std::tie(first, on_model, count, numbers) > std::tie(other.first, other.on_model, other.count, other.numbers);
  }
};

Agreement agreement(const Context &context, const InstructionInfo &info, llvm::ArrayRef<Operand> operands) {
  Agreement result;
  result.on_model = is_on_model(info, context.model);
  for (auto [expected, operand] : llvm::zip(info.operands, operands)) {
    result.count += fits(expected, operand);
    result.numbers += fits_with_number(expected, operand);
  }
  result.first = !operands.empty() && !info.operands.empty() && fits(info.operands.front(), operands.front());
  return result;
}

struct Choice {
  const InstructionInfo *info = nullptr;
  Agreement agreement;

  void offer(const InstructionInfo &candidate, Agreement agrees) {
    if (!info || agrees > agreement) {
      info = &candidate;
      agreement = agrees;
    }
  }
};

class Resolver {
public:
  Resolver(const Context &context, InstructionIndex index)
      : context_(context), index_(index), instruction_(context.instruction(index)), operands_(context.operands(index)) {}

  Resolved run();

private:
  void report_model();
  void report_count();
  void report_class(unsigned position);
  Allowed bits_of_words() const;
  Allowed allowed_at(unsigned position) const;
  bool is_set_value(unsigned position) const;
  std::uint64_t check_index_registers() const;

  const Context &context_;
  InstructionIndex index_;
  Instruction &instruction_;
  llvm::ArrayRef<Operand> operands_;
};

Resolved Resolver::run() {
  if (!instruction_.info)
    return {};
  if (!is_on_model(*instruction_.info, context_.model)) {
    report_model();
    return {true, false, 0};
  }
  if (instruction_.info->operands.size() != operands_.size()) {
    if (!llvm::any_of(operands_, [](const Operand &o) { return o.kind == OperandKind::Invalid; }))
      report_count();
    return {true, false, 0};
  }
  Resolved result{true, true, check_index_registers()};
  for (unsigned k = 0; k < operands_.size(); ++k) {
    bool fitting = fits(instruction_.info->operands[k], operands_[k]);
    if (!fitting && result.good(k))
      report_class(k);
    if (!fitting || operands_[k].kind == OperandKind::Invalid)
      result.bad |= std::uint64_t(1) << k;
  }
  return result;
}

/// Reports the operands with an index register where the family has none; their bits.
std::uint64_t Resolver::check_index_registers() const {
  std::uint64_t bad = 0;
  if (context_.family.has_index_registers)
    return bad;
  for (unsigned k = 0; k < operands_.size(); ++k) {
    if (operands_[k].index == kNoDevice)
      continue;
    context_.report(DiagId::IndexRegister, index_, operands_[k].range)
        .arg("operand", context_.text(operands_[k].range))
        .arg("family", context_.family.title);
    bad |= std::uint64_t(1) << k;
  }
  return bad;
}

void Resolver::report_model() {
  llvm::SmallVector<std::string, 4> models;
  for (llvm::StringRef model : instruction_.info->models)
    models.push_back(model.str());
  context_.report(DiagId::NotOnModel, index_)
      .arg("model", context_.model)
      .arg("mnemonic", instruction_.info->spelling)
      .arg("models", joined(models, "and"));
}

void Resolver::report_count() {
  llvm::SmallVector<std::string, 4> shapes;
  for (const InstructionInfo *candidate : instruction_.candidates)
    if (std::string shape = shape_text(*candidate); !llvm::is_contained(shapes, shape))
      shapes.push_back(std::move(shape));
  std::size_t count = operands_.size();
  std::string text = count == 0 ? "no operand" : count == 1 ? "one operand" : std::to_string(count) + " operands";
  context_.report(DiagId::OperandCount, index_)
      .arg("mnemonic", instruction_.info->spelling)
      .arg("count", text)
      .arg("shapes", llvm::join(shapes, " or "));
}

/// What the entries of this length take at a position, given the operands before it.
Allowed Resolver::allowed_at(unsigned position) const {
  Allowed allowed;
  allowed.add(instruction_.info->operands[position]);
  for (const InstructionInfo *candidate : instruction_.candidates) {
    if (candidate->operands.size() != operands_.size())
      continue;
    bool same_beginning = true;
    for (unsigned k = 0; k < position; ++k)
      same_beginning &= fits(candidate->operands[k], operands_[k]);
    if (same_beginning)
      allowed.add(candidate->operands[position]);
  }
  return allowed;
}

bool Resolver::is_set_value(unsigned position) const {
  for (unsigned k = 0; k < position; ++k) {
    OperandType type = instruction_.info->operands[k].type;
    if (type == OperandType::Timer || type == OperandType::Counter || type == OperandType::LongCounter)
      return true;
  }
  return false;
}

void Resolver::report_class(unsigned position) {
  const OperandInfo &expected = instruction_.info->operands[position];
  const Operand &operand = operands_[position];
  Allowed allowed = allowed_at(position);
  bool plain = operand.kind == OperandKind::Device;
  bool writes = expected.dir != Direction::In;
  DiagId id = DiagId::OperandClass;
  if (is_constant(operand) && writes)
    id = DiagId::ConstantDestination;
  else if (operand.kind == OperandKind::Hexadecimal && allowed.decimal)
    id = DiagId::HexConstant;
  else if (operand.kind == OperandKind::BitOfWord && is_timer_or_counter(context_.family, operand.device))
    id = DiagId::TimerCounterBit;
  else if (plain && is_word(expected.type) && context_.device(operand).kind == DeviceKind::LongCounter && !is_set_value(position))
    id = DiagId::LongCounterInWord;
  else if (is_set_value(position))
    id = DiagId::SetValue;
  else if (plain && writes && (expected.type == OperandType::Bit || expected.type == OperandType::Annunciator) &&
           is_timer_or_counter(context_.family, operand.device))
    id = DiagId::TimerCounterOutput;
  else if (plain && contains(allowed.word_bits, operand.device))
    id = DiagId::WordForBit;
  else if (plain && contains(allowed.digits, operand.device))
    id = DiagId::BitForWord;

  if (id == DiagId::TimerCounterBit)
    allowed = bits_of_words();
  const bool word = is_word(expected.type);
  const std::pair<llvm::StringRef, std::string> args[] = {
      {"operand", context_.text(operand.range).str()},
      {"mnemonic", instruction_.info->spelling.str()},
      {"name", expected.name.str()},
      {"allowed", allowed_text(context_.family, allowed)},
      {"device", context_.text(operands_.front().range).str()},
      {"decimal", "K" + std::to_string(operand.value)},
      {"digits", word ? "4" : "8"},
      {"bits", word ? "16" : "32"},
  };
  DiagBuilder builder = context_.report(id, index_, operand.range);
  for (const auto &[name, value] : args)
    if (info(id).message.contains(("{" + name + "}").str()))
      builder.arg(name, value);
}

Allowed Resolver::bits_of_words() const {
  Allowed allowed;
  for (DeviceId device = 0; device < context_.family.devices.size(); ++device)
    if (context_.family.devices[device].bit_of_word)
      allowed.word_bits |= DeviceSet(1) << device;
  return allowed;
}

}  // namespace

void choose_entry(const Context &context, InstructionIndex index) {
  Instruction &instruction = context.instruction(index);
  llvm::ArrayRef<Operand> operands = context.operands(index);
  Choice same_count, other_count;
  for (const InstructionInfo *candidate : instruction.candidates) {
    Choice &choice = candidate->operands.size() == operands.size() ? same_count : other_count;
    choice.offer(*candidate, agreement(context, *candidate, operands));
  }
  bool other_is_meant = !same_count.info || (other_count.agreement.first && !same_count.agreement.first);
  instruction.info = other_is_meant && other_count.info ? other_count.info : same_count.info;
}

Resolved match_operands(const Context &context, InstructionIndex index) {
  return Resolver(context, index).run();
}

}  // namespace ladderc::sema
