// Reset, decoding, counting, mean values, annunciators and check codes: F40-F45, F47, F84, F170, F171, F188.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"

#include <cstdint>

namespace ladder::tp03 {

// ---- ZRST

namespace detail {

// A block tells where the image begins; timers and counters are reset as a whole, contacts and coils included.
inline void reset_one(WordBlock block, unsigned number) noexcept {
  static_cast<word *>(const_cast<void *>(block.origin()))[number] = 0;
}
template <class Owner> void reset_one(ValueBlock<Owner> block, unsigned number) noexcept {
  static_cast<Owner *>(const_cast<void *>(block.origin()))[number].reset();
}
template <class Owner> void reset_one(LongValueBlock<Owner> block, unsigned number) noexcept {
  static_cast<Owner *>(const_cast<void *>(block.origin()))[number].reset();
}
template <class Image> void reset_one(BitRun<Image> run, unsigned number) noexcept {
  (*run.image())[number] = off;
}

}  // namespace detail

/// Devices of one class, `first` alone where it is the higher one.
template <class Run, class System> Fault zrst(Run first, Run last, System &) noexcept {
  if (first.origin() != last.origin())
    return Fault::Operand;
  detail::reset_one(first, first.first());
  for (unsigned number = first.first() + 1; number <= last.first(); ++number)
    detail::reset_one(first, number);
  return Fault::None;
}
/// Devices of two classes.
template <class First, class Last, class System> Fault zrst(First, Last, System &) noexcept {
  return Fault::Operand;
}
template <class System> Fault zrst_mixed(System &) noexcept {
  return Fault::Operand;
}

// ---- DECO, ENCO

namespace detail {

constexpr word kMaxCodeBits = 8;      ///< of numbers that name bits of a run: 256 bits
constexpr word kMaxWordCodeBits = 4;  ///< of numbers that name bits of a word

constexpr unsigned low_bits_of(word source, word n) noexcept {
  return static_cast<unsigned>(pattern_of(source) & ((std::uint32_t{1} << n) - 1U));
}
template <class Run> unsigned low_bits_of_run(Run run, word n) noexcept {
  unsigned code = 0;
  for (unsigned i = 0; i < static_cast<unsigned>(n); ++i)
    code |= unsigned{run.get(i).value()} << i;
  return code;
}
/// ON at `code`, OFF at all other places of n bits.
template <class Run> Fault write_decoded(Run run, unsigned code, word n) noexcept {
  const unsigned count = 1U << n;
  if (count > run.points())
    return Fault::Range;
  for (unsigned i = 0; i < count; ++i)
    run.set(i, bit(i == code));
  return Fault::None;
}

}  // namespace detail

/// A number in a word, to a bit of a word.
template <class Out, class System> Fault deco(word source, word n, Out &&out, System &) noexcept {
  if (n < 0 || n > detail::kMaxWordCodeBits)
    return Fault::Range;
  if (n != 0)
    out = to_word(std::uint32_t{1} << detail::low_bits_of(source, n));
  return Fault::None;
}
/// A number in bits, to a bit of a word.
template <class Run, class Out, class System> Fault deco_bits(Run source, word n, Out &&out, System &) noexcept {
  if (n < 0 || n > detail::kMaxWordCodeBits || static_cast<unsigned>(n) > source.points())
    return Fault::Range;
  if (n != 0)
    out = to_word(std::uint32_t{1} << detail::low_bits_of_run(source, n));
  return Fault::None;
}
/// A number in a word, to one of many bits.
template <class Run, class System> Fault deco_to_bits(word source, Run destination, word n, System &) noexcept {
  if (n < 0 || n > detail::kMaxCodeBits)
    return Fault::Range;
  return n == 0 ? Fault::None : detail::write_decoded(destination, detail::low_bits_of(source, n), n);
}
/// A number in bits, to one of many bits.
template <class Source, class Destination, class System>
Fault deco_bits_to_bits(Source source, Destination destination, word n, System &) noexcept {
  if (n < 0 || n > detail::kMaxCodeBits || static_cast<unsigned>(n) > source.points())
    return Fault::Range;
  return n == 0 ? Fault::None : detail::write_decoded(destination, detail::low_bits_of_run(source, n), n);
}

/// The highest bit that is ON among the low 2^n of a word.
template <class Out, class System> Fault enco(word source, word n, Out &&out, System &) noexcept {
  if (n < 0 || n > detail::kMaxWordCodeBits)
    return Fault::Range;
  if (n == 0)
    return Fault::None;
  for (unsigned i = 1U << n; i-- > 0;)
    if ((pattern_of(source) >> i & 1U) != 0) {
      out = static_cast<word>(i);
      return Fault::None;
    }
  return Fault::Range;
}
template <class Run, class Out, class System> Fault enco_bits(Run source, word n, Out &&out, System &) noexcept {
  if (n < 0 || n > detail::kMaxCodeBits || (n != 0 && 1U << n > source.points()))
    return Fault::Range;
  if (n == 0)
    return Fault::None;
  for (unsigned i = 1U << n; i-- > 0;)
    if (source.get(i)) {
      out = static_cast<word>(i);
      return Fault::None;
    }
  return Fault::Range;
}

// ---- SUM, BON

namespace detail {

/// Counts in pairs, fours and bytes at once, and adds the bytes with one multiplication.
constexpr std::uint32_t count_ones(std::uint32_t pattern) noexcept {
  pattern -= pattern >> 1 & 0x55555555U;
  pattern = (pattern & 0x33333333U) + (pattern >> 2 & 0x33333333U);
  return ((pattern + (pattern >> 4)) & 0x0F0F0F0FU) * 0x01010101U >> 24;
}

}  // namespace detail

template <class System> word sum(word source, System &sys) noexcept {
  sys.M[8020] = bit(source == 0);
  return to_word(detail::count_ones(pattern_of(source)));
}
template <class System> dword dsum(dword source, System &sys) noexcept {
  sys.M[8020] = bit(source == 0);
  return to_dword(detail::count_ones(pattern_of(source)));
}

template <class Out, class System> Fault bon(word source, word n, Out &&out, System &) noexcept {
  if (n < 0 || n > 15)
    return Fault::Range;
  out = bit::lowest_of(pattern_of(source) >> n);
  return Fault::None;
}
template <class Out, class System> Fault dbon(dword source, word n, Out &&out, System &) noexcept {
  if (n < 0 || n > 31)
    return Fault::Range;
  out = bit::lowest_of(pattern_of(source) >> n);
  return Fault::None;
}

// ---- MEAN

inline constexpr word kMaxMeanItems = 64;

/// The mean of the items that exist, cut towards 0.
template <class Source, class Out, class System> Fault mean(Source source, word n, Out &&out, System &) noexcept {
  if (n < 1 || n > kMaxMeanItems || source.points() == 0)
    return Fault::Range;
  const unsigned wanted = static_cast<unsigned>(n), count = wanted < source.points() ? wanted : source.points();
  dword total = 0;  // 64 words cannot overflow it
  for (unsigned i = 0; i < count; ++i)
    total += source.get(i);
  out = static_cast<word>(total / static_cast<dword>(count));
  return Fault::None;
}
template <class Source, class Out, class System> Fault dmean(Source source, word n, Out &&out, System &) noexcept {
  if (n < 1 || n > kMaxMeanItems || source.points() == 0)
    return Fault::Range;
  const unsigned wanted = static_cast<unsigned>(n), count = wanted < source.points() ? wanted : source.points();
  qword total = 0;
  for (unsigned i = 0; i < count; ++i)
    total += source.get(i);
  out = static_cast<dword>(total / static_cast<qword>(count));
  return Fault::None;
}

// ---- ANR

/// The lowest annunciator that is ON becomes OFF; M8048 and D8049 follow at once while M8049 has them kept.
template <class States, class System> void anr(States &states, System &sys) noexcept {
  constexpr unsigned kFirst = 900, kEnd = States::kPoints < 1000 ? States::kPoints : 1000;
  auto next_on = [&states](unsigned number) {
    while (number < kEnd && !bit(states[number]))
      ++number;
    return number;
  };
  const unsigned lowest = next_on(kFirst);
  if (lowest >= kEnd)
    return;
  states[lowest] = off;
  if (bit(sys.M[8049])) {
    const unsigned left = next_on(lowest + 1);
    sys.M[8048] = bit(left < kEnd);
    sys.D[8049] = static_cast<word>(left < kEnd ? left : 0);
  }
}

// ---- GRY, GBIN

template <class Out, class System> Fault dgry(dword source, Out &&out, System &) noexcept {
  if (source < 0)
    return Fault::Range;
  out = to_dword(pattern_of(source) ^ pattern_of(source) >> 1);
  return Fault::None;
}
template <class Out, class System> Fault gry(word source, Out &&out, System &) noexcept {
  if (source < 0)
    return Fault::Range;
  out = to_word(pattern_of(source) ^ pattern_of(source) >> 1);
  return Fault::None;
}

namespace detail {

/// Each bit becomes the exclusive-or of itself and all higher ones.
constexpr std::uint32_t from_gray(std::uint32_t code) noexcept {
  for (unsigned shift = 1; shift < 32; shift *= 2)
    code ^= code >> shift;
  return code;
}

}  // namespace detail

template <class Out, class System> Fault gbin(word source, Out &&out, System &) noexcept {
  if (source < 0)
    return Fault::Range;
  out = to_word(detail::from_gray(pattern_of(source)));
  return Fault::None;
}
template <class Out, class System> Fault dgbin(dword source, Out &&out, System &) noexcept {
  if (source < 0)
    return Fault::Range;
  out = to_dword(detail::from_gray(pattern_of(source)));
  return Fault::None;
}

// ---- CCD, CRC

inline constexpr word kMaxCheckedBytes = 256;

namespace detail {

/// Bytes in words: two in each, the low one first, or with M8161 ON the low one alone.
template <class Source> class CheckedBytes {
public:
  CheckedBytes(Source source, word count, bool one_a_word) noexcept : source_(source), count_(count), one_a_word_(one_a_word) {}
  bool good() const noexcept {
    return count_ >= 1 && count_ <= kMaxCheckedBytes && (one_a_word_ ? count() : (count() + 1U) / 2U) <= source_.points();
  }
  unsigned count() const noexcept { return static_cast<unsigned>(count_); }
  std::uint32_t operator[](unsigned i) const noexcept {
    return one_a_word_ ? pattern_of(source_.get(i)) & 0xFFU : pattern_of(source_.get(i / 2U)) >> 8U * (i % 2U) & 0xFFU;
  }

private:
  Source source_;
  word count_;
  bool one_a_word_;
};

}  // namespace detail

/// The sum of the bytes and, behind it, their exclusive-or.
template <class Source, class Destination, class System>
Fault ccd(Source source, Destination destination, word n, System &sys) noexcept {
  const detail::CheckedBytes<Source> bytes(source, n, static_cast<bool>(bit(sys.M[8161])));
  if (!bytes.good() || destination.points() < 2)
    return Fault::Range;
  std::uint32_t total = 0, parity = 0;
  for (unsigned i = 0; i < bytes.count(); ++i) {
    total += bytes[i];
    parity ^= bytes[i];
  }
  destination.set(0, to_word(total));
  destination.set(1, to_word(parity));
  return Fault::None;
}

/// CRC-16 as MODBUS computes it; with M8161 ON its low and its high byte in two words.
template <class Source, class Destination, class System>
Fault crc(Source source, Destination destination, word n, System &sys) noexcept {
  const bool bytewise = static_cast<bool>(bit(sys.M[8161]));
  const detail::CheckedBytes<Source> bytes(source, n, bytewise);
  if (!bytes.good() || destination.points() < (bytewise ? 2U : 1U))
    return Fault::Range;
  std::uint32_t code = 0xFFFFU;
  for (unsigned i = 0; i < bytes.count(); ++i) {
    code ^= bytes[i];
    for (unsigned k = 0; k < 8; ++k)
      code = code >> 1 ^ ((code & 1U) != 0 ? 0xA001U : 0U);
  }
  destination.set(0, to_word(bytewise ? code & 0xFFU : code));
  if (bytewise)
    destination.set(1, to_word(code >> 8));
  return Fault::None;
}

}  // namespace ladder::tp03
