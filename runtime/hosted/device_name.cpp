// Resolving device texts. The longest prefix whose rest is a number in the class's radix wins: SD0 is no S device, BAD is B number
// AD. Of several classes with one prefix it is the one that has the number.
#include "ladder/hosted/device_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <compare>
#include <limits>
#include <optional>

namespace ladder::hosted {
namespace {

/// What stands between the prefix of a timer or counter and its number.
struct PartName {
  std::string_view letter;
  Part part;
};
constexpr std::array<PartName, 4> kTimerParts = {
    {{"", Part::Contact}, {"N", Part::Current}, {"C", Part::Coil}, {"S", Part::Contact}}};
constexpr std::array<PartName, 1> kPlainParts = {{{"", Part::Whole}}};

bool has_bits(Shape shape) {
  return shape == Shape::Bits || shape == Shape::PackedBits;
}
bool has_parts(Shape shape) {
  return shape == Shape::Timers || shape == Shape::Counters || shape == Shape::LongCounters;
}

std::uint64_t available(const DeviceSymbol &symbol) {
  return std::max(symbol.count, symbol.points);
}

int digit_value(char c) {
  if (c >= '0' && c <= '9')
    return c - '0';
  return c >= 'A' && c <= 'Z' ? c - 'A' + 10 : -1;
}

/// The number, at most the largest 32-bit number: such a one is beyond every class.
std::optional<std::uint32_t> parse_number(std::string_view text, unsigned radix) {
  if (text.empty())
    return std::nullopt;
  std::uint64_t number = 0;
  for (char c : text) {
    int digit = digit_value(c);
    if (digit < 0 || static_cast<unsigned>(digit) >= radix)
      return std::nullopt;
    number = std::min<std::uint64_t>(number * radix + static_cast<unsigned>(digit), std::numeric_limits<std::uint32_t>::max());
  }
  return static_cast<std::uint32_t>(number);
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char &c : result)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

/// One resolution of one text; `text_` stays as the user wrote it for the messages.
class Finder {
public:
  Finder(const ProgramSymbols &symbols, std::string_view text) : symbols_(symbols), text_(text) {}

  DeviceRef find();

private:
  std::string_view take_format(std::string_view rest);
  std::string_view take_word_bit(std::string_view rest);
  std::string_view take_digits(std::string_view rest);
  void take_device(std::string_view rest);
  void check_kind();
  void check_pair() const;
  void check_range() const;
  [[noreturn]] void no_device(std::string_view why = "") const {
    throw DeviceError(fmt::format("'{}' is no device of {}{}", text_, symbols_.family, why));
  }
  [[noreturn]] void refuse(std::string_view why) const { throw DeviceError(fmt::format("'{}': {}", text_, why)); }
  const DeviceSymbol &symbol() const { return symbols_.devices[ref_.device]; }

  const ProgramSymbols &symbols_;
  std::string_view text_;
  DeviceRef ref_{0, 0, Part::Whole, Format::Word, kNoBit, 0};
  std::string_view part_letter_;
  std::optional<Format> asked_;
};

DeviceRef Finder::find() {
  std::string whole = upper(text_);
  take_device(take_digits(take_word_bit(take_format(whole))));
  check_kind();
  check_range();
  return ref_;
}

std::string_view Finder::take_format(std::string_view rest) {
  std::size_t colon = rest.find(':');
  if (colon == std::string_view::npos)
    return rest;
  std::string_view name = rest.substr(colon + 1);
  if (name == "D")
    asked_ = Format::Signed;
  else if (name == "U")
    asked_ = Format::Unsigned;
  else if (name == "F")
    asked_ = Format::Float;
  else
    refuse("the formats are :d (signed), :u (unsigned) and :f (float), each of 32 bits");
  return rest.substr(0, colon);
}

std::string_view Finder::take_word_bit(std::string_view rest) {
  std::size_t dot = rest.find('.');
  if (dot == std::string_view::npos)
    return rest;
  auto bit = parse_number(rest.substr(dot + 1), 16);
  if (!bit || *bit > 15)
    refuse("a word has the bits 0 to F");
  ref_.word_bit = static_cast<std::uint8_t>(*bit);
  return rest.substr(0, dot);
}

std::string_view Finder::take_digits(std::string_view rest) {
  bool digits = rest.size() > 2 && rest[0] == 'K' && std::isdigit(static_cast<unsigned char>(rest[1])) != 0 &&
                std::isdigit(static_cast<unsigned char>(rest[2])) == 0;
  if (!digits)
    return rest;
  ref_.digits = static_cast<std::uint8_t>(rest[1] - '0');
  if (ref_.digits < 1 || ref_.digits > 8)
    refuse("digits are K1 to K8");
  return rest.substr(2);
}

/// How well a text fits a class, the weightiest first.
struct Fit {
  std::size_t length = 0;   ///< of prefix and part letter
  bool own = false;         ///< the letters are the prefix, none is a part's
  bool inside = false;      ///< the number exists; classes with one prefix differ in their numbers
  std::uint32_t start = 0;  ///< of the classes that it lies beyond, the next

  friend auto operator<=>(const Fit &, const Fit &) = default;
};

void Finder::take_device(std::string_view rest) {
  Fit best;
  std::string_view octal_prefix;
  for (std::uint32_t index = 0; index < symbols_.device_count; ++index) {
    const DeviceSymbol &candidate = symbols_.devices[index];
    std::string_view prefix = candidate.prefix;
    if (!rest.starts_with(prefix))
      continue;
    auto try_part = [&](const PartName &part) {
      std::string_view behind = rest.substr(prefix.size());
      if (!behind.starts_with(part.letter))
        return;
      behind.remove_prefix(part.letter.size());
      auto number = parse_number(behind, candidate.radix);
      if (!number && candidate.radix == 8 && parse_number(behind, 10))
        octal_prefix = prefix;
      if (!number)
        return;
      const bool behind_start = *number >= candidate.first;
      const Fit fit{prefix.size() + part.letter.size(), part.letter.empty(),
                    behind_start && *number - candidate.first < available(candidate), behind_start ? candidate.first : 0};
      if (fit <= best)
        return;
      best = fit;
      ref_.device = index;
      ref_.number = *number;
      ref_.part = part.part;
      part_letter_ = part.letter;
    };
    if (has_parts(candidate.shape))
      std::for_each(kTimerParts.begin(), kTimerParts.end(), try_part);
    else
      std::for_each(kPlainParts.begin(), kPlainParts.end(), try_part);
  }
  if (best.length == 0)
    no_device(octal_prefix.empty() ? "" : fmt::format(": {} counts in octal", octal_prefix));
}

/// Sets the format and refuses what the class cannot be read as.
void Finder::check_kind() {
  const bool long_counter = symbol().shape == Shape::LongCounters;
  if (long_counter && asked_ && part_letter_.empty())
    ref_.part = Part::Current;  // only its value has 32 bits
  if (ref_.word_bit != kNoBit) {
    if (symbol().shape != Shape::Words || ref_.digits != 0)
      refuse(fmt::format("{} is no word with bits", symbol().prefix));
    if (asked_)
      refuse("a bit of a word is not read as 32 bits");
    ref_.format = Format::Bit;
  } else if (ref_.digits != 0) {
    if (!has_bits(symbol().shape))
      refuse(fmt::format("digits are made of bit devices and {} is none", symbol().prefix));
    ref_.format = asked_.value_or(ref_.digits > 4 ? Format::Signed : Format::Word);
    if (asked_ == Format::Float && ref_.digits != 8)
      refuse("a float takes K8");
  } else if (symbol().shape == Shape::Words || ref_.part == Part::Current) {
    if (long_counter && asked_ == Format::Float)
      refuse("a counter is not read as float");
    ref_.format = asked_.value_or(long_counter ? Format::Signed : Format::Word);
    if (asked_)
      check_pair();
  } else {
    if (asked_)
      refuse("a bit is not read as 32 bits");
    ref_.format = Format::Bit;
  }
}

/// Where the high words have a class of their own, a pair has the name of its low word.
void Finder::check_pair() const {
  for (std::uint32_t index = 0; index < symbols_.device_count; ++index)
    if (symbols_.devices[index].high == ref_.device)
      refuse(fmt::format("{} has high words; a pair is named by {}", symbol().prefix, symbols_.devices[index].prefix));
}

void Finder::check_range() const {
  const bool neighbours = asked_ && symbol().shape != Shape::LongCounters && symbol().high == kNoClass;
  const std::uint64_t numbers = ref_.digits != 0 ? ref_.digits * 4u : neighbours ? 2 : 1;
  const std::uint64_t first = symbol().first, end = first + available(symbol());
  if (ref_.number >= first && ref_.number + numbers <= end)
    return;
  const std::string name = fmt::format("{}{}", symbol().prefix, part_letter_);
  if (first == end)
    refuse(fmt::format("this controller has no {}", name));
  const bool below = ref_.number < first;
  const std::string last = name + number_text(static_cast<std::uint32_t>(below ? first : end - 1), symbol().radix);
  throw DeviceError(fmt::format("'{}' lies {} {}", text_, below ? "before" : "beyond", last));
}

}  // namespace

unsigned width_of(const DeviceRef &ref) {
  if (ref.digits != 0)
    return ref.digits * 4u;
  switch (ref.format) {
  case Format::Bit:
    return 1;
  case Format::Word:
    return 16;
  case Format::Signed:
  case Format::Unsigned:
  case Format::Float:
    break;
  }
  return 32;
}

DeviceRef find_device(const ProgramSymbols &symbols, std::string_view text) {
  return Finder(symbols, text).find();
}

std::string number_text(std::uint32_t number, unsigned radix) {
  return radix == 16 ? fmt::format("{:X}", number) : radix == 8 ? fmt::format("{:o}", number) : fmt::format("{}", number);
}

}  // namespace ladder::hosted
