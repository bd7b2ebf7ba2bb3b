// Device numbers are few, so that rungs meet at the same devices; some lie at the end of their class, where pairs of words and runs
// of digits go on in the next one. Special devices that the system keeps are read, not written. Where instructions are made for
// certain numbers of a class (timers of several speeds, annunciators), the first numbers of each such run are used.
#include "generate/operand_maker.h"

#include "sema/check.h"
#include "sema/names.h"
#include "sema/operands.h"
#include "syntax/parser.h"

#include <fmt/format.h>

#include <algorithm>

namespace ladderc::generate {

namespace {

constexpr unsigned kTries = 40;
constexpr std::int64_t kPage = 100;  ///< page numbers and set values stay below
constexpr std::int64_t kLength = 8;  ///< lengths mostly stay below
constexpr std::uint32_t kFew = 24;   ///< so many plain special devices

bool is_32_bit(OperandType type) {
  return type == OperandType::DWord || type == OperandType::QWord || type == OperandType::DWordTwice || type == OperandType::Real ||
         type == OperandType::DWordBlock;
}

bool is_block(OperandType type) {
  return type == OperandType::WordBlock || type == OperandType::DWordBlock || type == OperandType::BitRun;
}

}  // namespace

OperandMaker::OperandMaker(const GenerateOptions &options, Random &random)
    : options_(options), family_(*options.family), random_(random), uses_(family_, options.model, options.parameters),
      interesting_(family_.devices.size()), plain_(family_.devices.size()), runs_(family_.devices.size()),
      read_only_(family_.devices.size()) {
  std::vector<std::vector<bool>> special_numbers(family_.devices.size());
  for (DeviceId id = 0; id < family_.devices.size(); ++id) {
    if (points(id) > 0 && family_.devices[id].kind != DeviceKind::Label)
      allocated_ |= DeviceSet(1) << id;
    runs_[id].push_back(family_.devices[id].first);
    special_numbers[id].resize(family_.devices[id].first + points(id));
  }
  allocated_ &= ~options.without;
  for (const SpecialInfo &special : family_.specials) {
    const auto [first_text, last_text] = special.device.split('-');
    const Operand first = parse_operand(family_, first_text, {});
    const Operand last = last_text.empty() ? first : parse_operand(family_, last_text, {});
    if (first.kind != OperandKind::Device)
      continue;
    std::vector<bool> &read_only = read_only_[first.device], &known = special_numbers[first.device];
    read_only.resize(std::max<std::size_t>(read_only.size(), static_cast<std::size_t>(last.value) + 1));
    known.resize(std::max(known.size(), read_only.size()));
    for (std::int64_t n = first.value; n <= last.value; ++n) {
      read_only[static_cast<std::size_t>(n)] = !special.writable;
      known[static_cast<std::size_t>(n)] = true;
      if (special.simulated)
        interesting_[first.device].push_back(static_cast<std::uint32_t>(n));
    }
  }
  for (DeviceId id = 0; id < family_.devices.size(); ++id) {
    std::uint32_t begin = family_.devices[id].first;
    for (std::uint32_t n = begin; n < special_numbers[id].size() && n < begin + kFew; ++n)
      if (special_numbers[id][n])
        begin = n + 1;
    plain_[id] = begin;
  }
  for (const InstructionInfo &info : family_.instructions)
    for (const OperandInfo &o : info.operands)
      for (DeviceId id = 0; id < family_.devices.size() && o.first != 0; ++id)
        if (contains(o.devices, id) && o.first <= last(id) &&
            std::find(runs_[id].begin(), runs_[id].end(), o.first) == runs_[id].end())
          runs_[id].push_back(o.first);
}

bool OperandMaker::possible(const InstructionInfo &info) const {
  return std::all_of(info.operands.begin(), info.operands.end(), [&](const OperandInfo &o) {
    return o.decimal || o.hexadecimal || o.type == OperandType::String || ((o.devices | o.word_bits | o.digits) & allocated_) != 0;
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

/// One of the first few of a run, or one of the last.
std::uint32_t OperandMaker::number_from(std::uint32_t first, std::uint32_t last, std::uint32_t few) {
  const std::uint32_t all = last - first + 1;
  return random_.one_in(16) ? last - random_.below(std::min<std::uint32_t>(all, 6)) : first + random_.below(std::min(all, few));
}

/// Chooses the number; false where the operand then would reach beyond all memory or into what is the system's.
bool OperandMaker::take_number(const OperandInfo &info, Operand &operand) {
  const DeviceInfo &device = family_.devices[operand.device];
  const std::vector<std::uint32_t> &special = interesting_[operand.device], &runs = runs_[operand.device];
  const bool parts =
      device.kind == DeviceKind::Timer || device.kind == DeviceKind::Counter || device.kind == DeviceKind::LongCounter;
  const std::uint32_t few = (parts ? 6 : 24) / static_cast<std::uint32_t>(std::min<std::size_t>(runs.size(), 2));
  const std::uint32_t all = last(operand.device);
  if (!special.empty())
    operand.value = random_.one_in(3) ? plain_[operand.device] + random_.below(kFew) : random_.pick(llvm::ArrayRef(special));
  else if (info.last != 0)
    operand.value = info.first <= all ? number_from(info.first, std::min(info.last, all), few) : -1;
  else
    operand.value = number_from(runs.size() > 1 ? random_.pick(llvm::ArrayRef(runs)) : runs.front(), all, few);
  return in_place(info, operand);
}

bool OperandMaker::in_place(const OperandInfo &info, const Operand &operand) const {
  const std::uint32_t count = sema::extent(family_, info, operand) * std::max<std::uint32_t>(info.count, 1);
  const std::uint32_t number = static_cast<std::uint32_t>(operand.value);
  if (operand.value < 0 || !number_exists(family_.devices[operand.device], options_.model, points(operand.device), number) ||
      !sema::takes_number(info, operand.value))
    return false;
  if ((!is_block(info.type) || info.count != 0) && crosses_end(family_, options_.parameters, operand.device, number, count) &&
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
  o.value = constant_value(info, o.kind == OperandKind::Hexadecimal);
  return o;
}

std::int64_t OperandMaker::constant_value(const OperandInfo &info, bool hexadecimal) {
  const std::int64_t top = std::int64_t(1) << (is_32_bit(info.type) ? 31 : 15);
  const bool own_range = (info.min != 0 || info.max != 0) && (info.min != -top || info.max != top - 1);
  if (own_range) {
    // A length that reaches over the end stops no CPU here, so that most of them must not.
    if (!family_.errors_stop && !random_.one_in(3))
      return random_.between(info.min, std::min(info.max, info.min + kLength));
    return random_.between(info.min, random_.one_in(8) ? info.max : std::min(info.max, info.min + kPage));
  }
  if (hexadecimal)
    return random_.between(0, 2 * top - 1);
  if (random_.one_in(4))
    return random_.pick<std::int64_t>({0, 1, -1, top - 1, -top, 1 - top});
  return random_.one_in(3) ? random_.between(-top, top - 1) : random_.between(-10, 20);
}

std::optional<Operand> OperandMaker::try_operand(const OperandInfo &info) {
  if (info.type == OperandType::String) {
    Operand o;
    o.kind = OperandKind::Text;
    return o;
  }
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
  if (operands.size() < 2 || !is_block(info.operands[0].type) || info.operands[0].type != info.operands[1].type)
    return;
  Operand moved = operands[0];
  const DeviceSet fits = moved.kind == OperandKind::Digits ? info.operands[1].digits : info.operands[1].devices;
  if (!contains(fits, moved.device))
    return;
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
  if (!family_.errors_stop)
    return;  // a block that does not fit is an error that the program goes on behind
  std::uint32_t most = UINT32_MAX;
  for (std::size_t k = 0; k < operands.size(); ++k)
    if (info.operands[k].type == OperandType::WordBlock) {
      std::uint32_t end = last(operands[k].device) + 1;
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
  modify(info, operands);
  if (!uses_.take(info, operands))
    return std::nullopt;
  std::vector<std::string> texts;
  for (const Operand &o : operands)
    texts.push_back(o.kind == OperandKind::Text ? some_text() : text(o));
  // What makes an instruction fail is its last source: a divisor, a number to convert.
  bool has_block = false;
  for (const OperandInfo &o : info.operands)
    has_block |= o.type == OperandType::WordBlock;
  if (tame && family_.errors_stop && info.error_code && !has_block)
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

/// Index registers at operands that take them: of the pairs in instructions with 32 bits.
void OperandMaker::modify(const InstructionInfo &info, std::vector<Operand> &operands) {
  if (!family_.has_index_registers || operands.empty() || !random_.one_in(6))
    return;
  bool wide = info.wide;
  for (const OperandInfo &o : info.operands)
    wide |= is_32_bit(o.type);
  std::vector<DeviceId> registers;
  for (DeviceId id = 0; id < family_.devices.size(); ++id)
    if (points(id) > 0 && is_index_register(family_, id) && (!wide || family_.devices[id].high_words != kNoDevice))
      registers.push_back(id);
  if (registers.empty())
    return;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    Operand &o = operands[k];
    const bool itself = o.device != kNoDevice && is_index_register(family_, o.device);
    if (!info.operands[k].indexable || itself || o.kind == OperandKind::Text || random_.one_in(2))
      continue;
    o.index = random_.pick(llvm::ArrayRef(registers));
    o.index_number = static_cast<std::uint8_t>(random_.below(std::min<std::uint32_t>(points(o.index), 3)));
  }
}

std::string OperandMaker::device_text(const OperandInfo &info, std::uint32_t number) const {
  for (DeviceId id = 0; id < family_.devices.size(); ++id)
    if (contains(info.devices, id))
      return sema::device_name(family_, id, number);
  return {};
}

std::string OperandMaker::small_count(const OperandInfo &info, bool constant) {
  if ((constant || random_.one_in(2)) && info.decimal)
    return fmt::format("K{}", 1 + random_.below(4));
  for (unsigned i = 0; i < kTries; ++i) {
    Operand o;
    o.kind = OperandKind::Digits;
    o.digits = 1;
    o.device = device_of(info.digits);
    if (o.device != kNoDevice && take_number(info, o))
      return text(o);
  }
  return fmt::format("K{}", 1 + random_.below(4));
}

/// One to eight characters, some of them marks that a list gives a meaning.
std::string OperandMaker::some_text() {
  std::string text = "\"";
  for (unsigned n = 1 + random_.below(8); n > 0; --n)
    text += "ABCXYZabc0189 ;+-/"[random_.below(18)];
  return text + "\"";
}

std::string OperandMaker::text(const Operand &o) const {
  auto device = [&] { return sema::device_name(family_, o.device, static_cast<std::uint64_t>(o.value)); };
  const std::string index = o.index == kNoDevice ? "" : sema::device_name(family_, o.index, o.index_number);
  switch (o.kind) {
  case OperandKind::Decimal:
    return fmt::format("K{}{}", o.value, index);
  case OperandKind::Hexadecimal:
    return fmt::format("H{:X}{}", o.value, index);
  case OperandKind::BitOfWord:
    return fmt::format("{}.{:X}", device(), o.bit);
  case OperandKind::Digits:
    return fmt::format("K{}{}{}", o.digits, device(), index);
  default:
    return device() + index;
  }
}

}  // namespace ladderc::generate
