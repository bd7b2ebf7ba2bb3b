// Device numbers are few, so that rungs meet at the same devices; some lie at the end of their class, where pairs of words and runs
// of digits go on in the next one. Special devices that the system keeps are read, not written.
#include "generate/operand_maker.h"

#include "sema/check.h"
#include "sema/operands.h"
#include "syntax/parser.h"

#include <fmt/format.h>

#include <algorithm>

namespace ladderc::generate {

namespace {

constexpr unsigned kTries = 40;
constexpr std::int64_t kPage = 100;  ///< page numbers and set values stay below

bool is_32_bit(OperandType type) {
  return type == OperandType::DWord || type == OperandType::QWord || type == OperandType::DWordTwice;
}

}  // namespace

OperandMaker::OperandMaker(const GenerateOptions &options, Random &random)
    : options_(options), family_(*options.family), random_(random), interesting_(family_.devices.size()),
      read_only_(family_.devices.size()) {
  for (DeviceId id = 0; id < family_.devices.size(); ++id)
    if (points(id) > 0)
      allocated_ |= DeviceSet(1) << id;
  for (const SpecialInfo &special : family_.specials) {
    const auto [first_text, last_text] = special.device.split('-');
    const Operand first = parse_operand(family_, first_text, {});
    const Operand last = last_text.empty() ? first : parse_operand(family_, last_text, {});
    if (first.kind != OperandKind::Device)
      continue;
    std::vector<bool> &read_only = read_only_[first.device];
    read_only.resize(std::max<std::size_t>(read_only.size(), static_cast<std::size_t>(last.value) + 1));
    for (std::int64_t n = first.value; n <= last.value; ++n) {
      read_only[static_cast<std::size_t>(n)] = !special.writable;
      if (special.simulated)
        interesting_[first.device].push_back(static_cast<std::uint32_t>(n));
    }
  }
}

bool OperandMaker::possible(const InstructionInfo &info) const {
  return std::all_of(info.operands.begin(), info.operands.end(), [&](const OperandInfo &o) {
    return o.decimal || o.hexadecimal || ((o.devices | o.word_bits | o.digits) & allocated_) != 0;
  });
}

/// Large classes of the program's own are likelier than the rest.
DeviceId OperandMaker::device_of(DeviceSet set) {
  set &= allocated_;
  unsigned total = 0;
  auto weight = [&](DeviceId id) { return family_.devices[id].points >= 4096 && interesting_[id].empty() ? 5u : 2u; };
  for (DeviceId id = 0; id < family_.devices.size(); ++id)
    total += contains(set, id) ? weight(id) : 0;
  unsigned at = random_.below(total);
  for (DeviceId id = 0; id < family_.devices.size() && total; ++id) {
    if (!contains(set, id))
      continue;
    if (at < weight(id))
      return id;
    at -= weight(id);
  }
  return kNoDevice;
}

/// Chooses the number; false where the operand then would reach beyond all memory or into what is the system's.
bool OperandMaker::take_number(const OperandInfo &info, Operand &operand) {
  const DeviceInfo &device = family_.devices[operand.device];
  const std::uint32_t all = points(operand.device);
  const std::vector<std::uint32_t> &special = interesting_[operand.device];
  const std::uint32_t few = device.kind == DeviceKind::Timer || device.kind == DeviceKind::Counter ? 6 : 24;
  if (!special.empty())
    operand.value = random_.one_in(3) ? 1000 + random_.below(few) : random_.pick(llvm::ArrayRef(special));
  else if (random_.one_in(16))
    operand.value = static_cast<std::int64_t>(all) - 1 - random_.below(std::min<std::uint32_t>(all, 6));
  else
    operand.value = random_.below(std::min(all, few));
  return in_place(info, operand);
}

bool OperandMaker::in_place(const OperandInfo &info, const Operand &operand) const {
  const std::uint32_t count = sema::extent(family_, info, operand), number = static_cast<std::uint32_t>(operand.value);
  if (operand.value < 0 || operand.value >= points(operand.device))
    return false;
  if (info.type != OperandType::WordBlock && crosses_end(family_, options_.parameters, operand.device, number, count) &&
      point_behind(family_, options_.parameters, {operand.device, number}, count - 1).device == kNoDevice)
    return false;
  return info.dir == Direction::In || may_write(operand, count);
}

bool OperandMaker::may_write(const Operand &operand, std::uint32_t count) const {
  for (std::uint32_t i = 0; i < count; ++i) {
    const DevicePoint p =
        point_behind(family_, options_.parameters, {operand.device, static_cast<std::uint32_t>(operand.value)}, i);
    if (p.device != kNoDevice && p.number < read_only_[p.device].size() && read_only_[p.device][p.number])
      return false;
  }
  return true;
}

Operand OperandMaker::constant(const OperandInfo &info) {
  Operand o;
  o.kind = info.hexadecimal && (!info.decimal || random_.one_in(3)) ? OperandKind::Hexadecimal : OperandKind::Decimal;
  const std::int64_t top = std::int64_t(1) << (is_32_bit(info.type) ? 31 : 15);
  const bool own_range = (info.min != 0 || info.max != 0) && (info.min != -top || info.max != top - 1);
  if (own_range)
    o.value = random_.between(info.min, random_.one_in(8) ? info.max : std::min(info.max, info.min + kPage));
  else if (o.kind == OperandKind::Hexadecimal)
    o.value = random_.between(0, 2 * top - 1);
  else if (random_.one_in(4))
    o.value = random_.pick<std::int64_t>({0, 1, -1, top - 1, -top, 1 - top});
  else if (random_.one_in(3))
    o.value = random_.between(-top, top - 1);
  else
    o.value = random_.between(-10, 20);
  return o;
}

std::optional<Operand> OperandMaker::try_operand(const OperandInfo &info) {
  const bool takes_constant = info.decimal || info.hexadecimal;
  const DeviceSet ways[] = {info.devices & allocated_, info.word_bits & allocated_, info.digits & allocated_};
  std::vector<unsigned> choices;
  for (unsigned way = 0; way < 3; ++way)
    if (ways[way])
      choices.insert(choices.end(), way == 0 ? 4 : 1, way);
  if (takes_constant)
    choices.insert(choices.end(), 2, 3);
  if (choices.empty())
    return std::nullopt;
  const unsigned way = random_.pick(llvm::ArrayRef(choices));
  if (way == 3)
    return constant(info);
  Operand o;
  o.device = device_of(ways[way]);
  o.kind = way == 0 ? OperandKind::Device : way == 1 ? OperandKind::BitOfWord : OperandKind::Digits;
  if (way == 1)
    o.bit = static_cast<std::uint8_t>(random_.below(16));
  if (way == 2)
    o.digits = static_cast<std::uint8_t>(1 + random_.below(is_32_bit(info.type) ? 8 : 4));
  if (!take_number(info, o))
    return std::nullopt;
  return o;
}

std::optional<Operand> OperandMaker::operand(const OperandInfo &info) {
  for (unsigned i = 0; i < kTries; ++i)
    if (auto o = try_operand(info))
      return o;
  return std::nullopt;
}

/// Two blocks of one class, close to each other.
void OperandMaker::overlap_blocks(const InstructionInfo &info, std::vector<Operand> &operands) {
  if (operands.size() < 2 || info.operands[0].type != OperandType::WordBlock || info.operands[1].type != OperandType::WordBlock)
    return;
  Operand moved = operands[0];
  moved.value += random_.between(-3, 3);
  if (in_place(info.operands[1], moved))
    operands[1] = moved;
}

/// Digit counts that must agree do, and blocks of a length that the list tells stay in their class.
void OperandMaker::fit_blocks(const InstructionInfo &info, std::vector<Operand> &operands, bool tame) {
  if (random_.one_in(2))
    overlap_blocks(info, operands);
  if (info.equal_digits && operands[0].kind == OperandKind::Digits && operands[1].kind == OperandKind::Digits)
    operands[1].digits = operands[0].digits;
  std::uint32_t most = UINT32_MAX;
  for (std::size_t k = 0; k < operands.size(); ++k)
    if (info.operands[k].type == OperandType::WordBlock) {
      std::uint32_t end = points(operands[k].device);
      const std::vector<bool> &read_only = read_only_[operands[k].device];
      if (info.operands[k].dir != Direction::In)
        for (std::size_t n = static_cast<std::size_t>(operands[k].value); n < std::min<std::size_t>(end, read_only.size()); ++n)
          if (read_only[n])
            end = static_cast<std::uint32_t>(n);
      const std::uint32_t room = end - std::min(end, static_cast<std::uint32_t>(operands[k].value));
      most = std::min(most, room / sema::extent(family_, info.operands[k], operands[k]));
    }
  Operand &length = operands.back();
  const bool told = length.kind == OperandKind::Decimal || length.kind == OperandKind::Hexadecimal;
  if (most == UINT32_MAX || (!told && !tame))
    return;
  length.kind = OperandKind::Decimal;
  length.value = random_.below(std::min<std::uint32_t>(most, 8) + 1);
}

std::optional<std::vector<std::string>> OperandMaker::make(const InstructionInfo &info, bool tame) {
  std::vector<Operand> operands;
  for (const OperandInfo &o : info.operands) {
    const auto made = operand(o);
    if (!made)
      return std::nullopt;
    operands.push_back(*made);
  }
  if (!operands.empty())
    fit_blocks(info, operands, tame);
  std::vector<std::string> texts;
  for (const Operand &o : operands)
    texts.push_back(text(o));
  // What makes an instruction fail is its last source: a divisor, a number to convert.
  bool has_block = false;
  for (const OperandInfo &o : info.operands)
    has_block |= o.type == OperandType::WordBlock;
  if (tame && info.error_code && !has_block)
    for (std::size_t k = info.operands.size(); k-- > 0;)
      if (info.operands[k].dir == Direction::In) {
        texts[k] = tame_constant(info.operands[k].type);
        break;
      }
  return texts;
}

std::string OperandMaker::tame_constant(OperandType type) {
  const unsigned low = 1 + random_.below(9);
  const unsigned middle = random_.below(is_32_bit(type) ? 100000 : 100);
  return fmt::format("H{}{}{}", random_.below(2), middle, low);
}

std::string OperandMaker::text(const Operand &o) const {
  auto device = [&] {
    const DeviceInfo &d = family_.devices[o.device];
    return d.prefix.str() + (d.radix == 16  ? fmt::format("{:X}", o.value)
                             : d.radix == 8 ? fmt::format("{:o}", o.value)
                                            : fmt::format("{}", o.value));
  };
  switch (o.kind) {
  case OperandKind::Decimal:
    return fmt::format("K{}", o.value);
  case OperandKind::Hexadecimal:
    return fmt::format("H{:X}", o.value);
  case OperandKind::BitOfWord:
    return fmt::format("{}.{:X}", device(), o.bit);
  case OperandKind::Digits:
    return fmt::format("K{}{}", o.digits, device());
  default:
    return device();
  }
}

}  // namespace ladderc::generate
