// The image of a word device class (D, W, SD), and its words taken two and four at a time.
//
// A 32-bit operand is two consecutive words, the lower number being the low half; a 64-bit one is four. They are proxies because a
// pair may start at any number (an int32_t there would be unaligned) and may cross from the last word of one class into the first
// of the next.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/number.h"

#include <cstdint>

namespace ladder {

/// Two words as one 32-bit number.
class WordPair {
public:
  constexpr WordPair(word &low, word &high) noexcept : low_(&low), high_(&high) {}
  constexpr WordPair(const WordPair &) noexcept = default;
  constexpr operator dword() const noexcept { return to_dword(pattern_of(*low_) | pattern_of(*high_) << 16); }
  constexpr WordPair &operator=(dword value) noexcept {
    const std::uint32_t pattern = pattern_of(value);
    *low_ = to_word(pattern);
    *high_ = to_word(pattern >> 16);
    return *this;
  }
  constexpr WordPair &operator=(const WordPair &other) noexcept { return *this = static_cast<dword>(other); }

private:
  word *low_, *high_;
};

/// Four words as one 64-bit number.
class WordQuad {
public:
  constexpr WordQuad(word &w0, word &w1, word &w2, word &w3) noexcept : words_{&w0, &w1, &w2, &w3} {}
  constexpr WordQuad(const WordQuad &) noexcept = default;
  constexpr operator qword() const noexcept {
    const std::uint32_t low = pattern_of(*words_[0]) | pattern_of(*words_[1]) << 16;
    const std::uint32_t high = pattern_of(*words_[2]) | pattern_of(*words_[3]) << 16;
    return to_qword(std::uint64_t{low} | std::uint64_t{high} << 32);
  }
  constexpr WordQuad &operator=(qword value) noexcept {
    const std::uint64_t pattern = static_cast<std::uint64_t>(value);
    for (unsigned i = 0; i < 4; ++i)
      *words_[i] = to_word(static_cast<std::uint32_t>(pattern >> 16 * i & 0xFFFFU));
    return *this;
  }
  constexpr WordQuad &operator=(const WordQuad &other) noexcept { return *this = static_cast<qword>(other); }

private:
  word *words_[4];
};

/// Words of different classes as one number, low first.
constexpr WordPair pair(word &low, word &high) noexcept {
  return {low, high};
}
constexpr WordQuad quad(word &w0, word &w1, word &w2, word &w3) noexcept {
  return {w0, w1, w2, w3};
}

/// Two words as an IEEE-754 single.
class WordReal {
public:
  constexpr WordReal(word &low, word &high) noexcept : pair_(low, high) {}
  constexpr WordReal(const WordReal &) noexcept = default;
  operator float() const noexcept {
    const dword pattern = pair_;
    float value;
    __builtin_memcpy(&value, &pattern, sizeof value);
    return value;
  }
  WordReal &operator=(float value) noexcept {
    dword pattern;
    __builtin_memcpy(&pattern, &value, sizeof pattern);
    pair_ = pattern;
    return *this;
  }
  WordReal &operator=(const WordReal &other) noexcept { return *this = static_cast<float>(other); }

private:
  WordPair pair_;
};

/// Words that do not lie side by side as one real number, low first.
constexpr WordReal real(word &low, word &high) noexcept {
  return {low, high};
}

/// N words, numbers 0 to N - 1. Numbers are not checked: the compiler knows them all.
template <unsigned N> class Words {
public:
  static constexpr unsigned kPoints = N;

  constexpr word &operator[](unsigned number) noexcept { return words_[number]; }
  constexpr const word &operator[](unsigned number) const noexcept { return words_[number]; }
  constexpr WordPair pair(unsigned first) noexcept { return {words_[first], words_[first + 1]}; }
  constexpr WordQuad quad(unsigned first) noexcept {
    return {words_[first], words_[first + 1], words_[first + 2], words_[first + 3]};
  }
  constexpr WordReal real(unsigned first) noexcept { return {words_[first], words_[first + 1]}; }
  /// True where `count` numbers from `number` on exist.
  static constexpr bool has(unsigned number, unsigned count = 1) noexcept { return number < N && count <= N - number; }
  /// Bit `place` (0-15) of a word: D0.5 is `D.bit(0, 5)`.
  constexpr WordBit bit(unsigned number, unsigned place) noexcept { return {words_[number], place}; }
  /// The words from `first` to the end of the class, for block transfers.
  constexpr WordBlock block(unsigned first) noexcept { return {words_, first, N}; }
  constexpr DWordBlock dblock(unsigned first) noexcept { return {words_, first, N}; }
  constexpr void clear() noexcept {
    for (word &each : words_)
      each = 0;
  }
  /// Numbers `first` to `last`, for classes that are latched in part.
  constexpr void clear(unsigned first, unsigned last) noexcept {
    for (unsigned number = first; number <= last; ++number)
      words_[number] = 0;
  }

private:
  word words_[N] = {};
};

/// An area without memory: reads 0, keeps nothing.
class Gap {
public:
  /// A word that is 0 now; what is written to it is forgotten.
  constexpr word &discard() noexcept {
    scratch_ = 0;
    return scratch_;
  }

private:
  word scratch_ = 0;
};

}  // namespace ladder
