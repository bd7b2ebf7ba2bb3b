// Characters: F76 ASC, F82 ASCI, F83 HEX, F192 TEXT.
//
// M8161 OFF puts two characters into a word, the first into the low byte; ON puts one into the low byte of each word.
#pragma once

#include "ladder/number.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/ops/segments.h"

#include <cstdint>

namespace ladder::tp03 {
namespace detail {

inline constexpr unsigned kByteMode = 8161;
inline constexpr unsigned kMostDigits = 256;

/// Words that `count` characters occupy.
constexpr unsigned words_of(unsigned count, bool bytes) noexcept {
  return bytes ? count : (count + 1) / 2;
}
template <class Block> std::uint8_t character(const Block &block, unsigned i, bool bytes) noexcept {
  const std::uint32_t pattern = pattern_of(block.get(bytes ? i : i / 2));
  return static_cast<std::uint8_t>(bytes || i % 2 == 0 ? pattern : pattern >> 8);
}
/// The other byte of a word stays, but is 0 where a word has one character only.
template <class Block> void set_character(const Block &block, unsigned i, std::uint8_t character, bool bytes) noexcept {
  if (bytes)
    return block.set(i, to_word(character));
  const std::uint32_t old = pattern_of(block.get(i / 2));
  block.set(i / 2, to_word(i % 2 == 0 ? (old & 0xFF00U) | character : (old & 0xFFU) | std::uint32_t{character} << 8));
}

constexpr std::uint8_t hex_character(std::uint32_t digit) noexcept {
  return static_cast<std::uint8_t>(digit < 10 ? '0' + digit : 'A' + (digit - 10));
}
/// The digit, or a number above 15.
constexpr std::uint32_t hex_digit(std::uint8_t character) noexcept {
  if (character >= '0' && character <= '9')
    return character - std::uint32_t{'0'};
  return character >= 'A' && character <= 'F' ? character - std::uint32_t{'A'} + 10 : 0xFF;
}

}  // namespace detail

// ---------------------------------------------------------------------------------------------- F76
/// Eight characters; a shorter text ends with zeros.
template <class Block, class S> Fault asc(const char *text, unsigned length, Block d, S &sys) noexcept {
  constexpr unsigned kCharacters = 8;
  const bool bytes = static_cast<bool>(static_cast<bit>(sys.M[detail::kByteMode]));
  if (length > kCharacters || detail::words_of(kCharacters, bytes) > d.points())
    return Fault::Range;
  for (unsigned i = 0; i < kCharacters; ++i)
    detail::set_character(d, i, i < length ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{0}, bytes);
  return Fault::None;
}

// ---------------------------------------------------------------------------------------------- F82, F83
/// The n lowest digits of the source, the highest of them first. Source and target may overlap.
template <class Source, class Block, class S> Fault asci(Source source, Block d, word n, S &sys) noexcept {
  const auto from = detail::block_of(source);
  const bool bytes = static_cast<bool>(static_cast<bit>(sys.M[detail::kByteMode]));
  if (n < 1 || static_cast<unsigned>(n) > detail::kMostDigits)
    return Fault::Range;
  const unsigned count = static_cast<unsigned>(n), words = (count + 3) / 4;
  if (words > from.points() || detail::words_of(count, bytes) > d.points())
    return Fault::Range;
  std::uint32_t patterns[detail::kMostDigits / 4];
  for (unsigned i = 0; i < words; ++i)
    patterns[i] = pattern_of(from.get(i));
  for (unsigned i = 0; i < count; ++i) {
    const unsigned digit = count - 1 - i;
    detail::set_character(d, i, detail::hex_character(patterns[digit / 4] >> 4 * (digit % 4) & 0xFU), bytes);
  }
  return Fault::None;
}

/// The reverse: n characters become a number, right-aligned in as many words as it takes.
template <class Source, class Block, class S> Fault hex(Source source, Block d, word n, S &sys) noexcept {
  const auto from = detail::block_of(source);
  const bool bytes = static_cast<bool>(static_cast<bit>(sys.M[detail::kByteMode]));
  if (n < 1 || static_cast<unsigned>(n) > detail::kMostDigits)
    return Fault::Range;
  const unsigned count = static_cast<unsigned>(n), words = (count + 3) / 4;
  if (detail::words_of(count, bytes) > from.points() || words > d.points())
    return Fault::Range;
  std::uint32_t patterns[detail::kMostDigits / 4] = {};
  for (unsigned i = 0; i < count; ++i) {
    const std::uint32_t digit = detail::hex_digit(detail::character(from, i, bytes));
    if (digit > 0xF)
      return Fault::Range;
    const unsigned place = count - 1 - i;
    patterns[place / 4] |= digit << 4 * (place % 4);
  }
  for (unsigned i = 0; i < words; ++i)
    d.set(i, to_word(patterns[i]));
  return Fault::None;
}

// ---------------------------------------------------------------------------------------------- F192
/// Asks the operator panel for one or two texts. The panel reads the numbers of registers, not their contents.
template <class Block, class S> void show_text(word file, Block shown, word lines, S &sys) noexcept {
  constexpr unsigned kFile = 8280, kRequest = 8284, kRegister = 8295;
  constexpr word kAsks = 13;
  const unsigned count = lines == 2 ? 2 : 1;
  for (unsigned line = 0; line < count; ++line) {
    sys.D[kFile + line] = to_word(pattern_of(file) + line);
    sys.D[kRegister + line] = to_word(shown.first());
  }
  sys.D[kRequest] = kAsks;
}

}  // namespace ladder::tp03
