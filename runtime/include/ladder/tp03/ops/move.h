// Transfer of words, digits and octal bits: F12-F17, F81, F147.
//
// Block transfers of this family move what exists: items behind the last number of a device are left out without an error.
#pragma once

#include "ladder/blocks.h"
#include "ladder/number.h"
#include "ladder/ops/convert.h"
#include "ladder/ops/logic.h"
#include "ladder/ops/move.h"
#include "ladder/tp03/fault.h"

#include <cstdint>
#include <type_traits>

namespace ladder::tp03 {

using ops::complement;
using ops::dcomplement;

/// Most items of a block transfer.
inline constexpr word kMaxBlock = 512;

namespace detail {

/// What a proxy of words or digits reads.
template <class Proxy> std::uint32_t read(const Proxy &proxy) noexcept {
  if constexpr (std::is_convertible<Proxy, dword>::value)
    return pattern_of(static_cast<dword>(proxy));
  else
    return pattern_of(proxy.dword());
}

/// True where two operands as given to an instruction name the same device.
///
/// Words have an address. Proxies do not show theirs: the second one is the same place if and only if it follows, in every bit, a
/// change of the first.
template <class First, class Second> bool same_place(First &first, Second &second) noexcept {
  if constexpr (!std::is_same<First, Second>::value) {
    return false;
  } else if constexpr (std::is_integral<First>::value) {
    return &first == &second;
  } else {
    const std::uint32_t before = read(first);
    if (read(second) != before)
      return false;
    first = to_dword(~before);
    const bool same = read(second) == read(first);
    first = to_dword(before);
    return same;
  }
}

/// Copies `count` items that both blocks have, as if the source had been read as a whole first.
template <class Source, class Destination> void copy(Source source, Destination destination, unsigned count) noexcept {
  if constexpr (std::is_same<Source, Destination>::value) {
    (void)ops::bmov(source, destination, static_cast<word>(count));
  } else if (source.origin() != destination.origin()) {
    for (unsigned i = 0; i < count; ++i)
      destination.set(i, source.get(i));
  } else {
    // Digits of one image in groups of different length: no order of copying suits all overlaps.
    word items[kMaxBlock];
    for (unsigned i = 0; i < count; ++i)
      items[i] = source.get(i);
    for (unsigned i = 0; i < count; ++i)
      destination.set(i, items[i]);
  }
}

constexpr unsigned least(unsigned a, unsigned b) noexcept {
  return a < b ? a : b;
}

}  // namespace detail

// ---- SMOV

/// With M8168 OFF on the decimal digits of both, which must be 0-9999, with M8168 ON on groups of four bits.
template <class Out, class System> Fault smov(word source, word m1, word m2, word target, word n, Out &&out, System &sys) noexcept {
  if (m1 < 1 || m1 > 4 || n < 1 || n > 4 || m2 < 1 || m2 > m1 || m2 > n)
    return Fault::Range;
  const bool binary = static_cast<bool>(bit(sys.M[8168]));
  std::uint32_t from = pattern_of(source), into = pattern_of(target);
  if (!binary) {
    if (from > 9999 || into > 9999)
      return Fault::Range;
    from = ops::detail::bcd4(from);
    into = ops::detail::bcd4(into);
  }
  const unsigned width = 4U * static_cast<unsigned>(m2);
  const unsigned source_place = 4U * static_cast<unsigned>(m1) - width, place = 4U * static_cast<unsigned>(n) - width;
  const std::uint32_t mask = ((std::uint32_t{1} << width) - 1U) << place;
  const std::uint32_t digits = (into & ~mask) | (from >> source_place << place & mask);
  out = to_word(binary ? digits : ops::detail::bin8(digits));
  return Fault::None;
}

// ---- BMOV, FMOV

/// M8024 reverses the direction.
template <class First, class Second, class System> Fault bmov(First first, Second second, word n, System &sys) noexcept {
  if (n < 1 || n > kMaxBlock)
    return Fault::Range;
  const unsigned count = detail::least(static_cast<unsigned>(n), detail::least(first.points(), second.points()));
  if (bit(sys.M[8024]))
    detail::copy(second, first, count);
  else
    detail::copy(first, second, count);
  return Fault::None;
}

/// From inputs, which no instruction writes.
template <class Source, class Destination, class System>
Fault bmov_inputs(Source source, Destination destination, word n, System &sys) noexcept {
  if (n < 1 || n > kMaxBlock)
    return Fault::Range;
  if (bit(sys.M[8024]))
    return Fault::Operand;
  detail::copy(source, destination, detail::least(static_cast<unsigned>(n), detail::least(source.points(), destination.points())));
  return Fault::None;
}

namespace detail {

template <class Number, class Destination> Fault fill(Number source, Destination destination, word n) noexcept {
  if (n < 1 || n > kMaxBlock)
    return Fault::Range;
  const unsigned count = least(static_cast<unsigned>(n), destination.points());
  for (unsigned i = 0; i < count; ++i)
    destination.set(i, source);
  return Fault::None;
}

}  // namespace detail

template <class Destination, class System> Fault fmov(word source, Destination destination, word n, System &) noexcept {
  return detail::fill(source, destination, n);
}
template <class Destination, class System> Fault dfmov(dword source, Destination destination, word n, System &) noexcept {
  return detail::fill(source, destination, n);
}

/// To index registers as pairs: the high words lie in V, under the numbers of the low ones in Z.
template <class HighWords, class Destination, class System>
Fault dfmov_indexes(HighWords &high, dword source, Destination low, word n, System &) noexcept {
  if (n < 1 || n > kMaxBlock)
    return Fault::Range;
  const unsigned count = detail::least(static_cast<unsigned>(n), low.points());
  for (unsigned i = 0; i < count; ++i) {
    low.set(i, to_word(pattern_of(source)));
    high[low.first() + i] = to_word(pattern_of(source) >> 16);
  }
  return Fault::None;
}

// ---- SWAP, XCH

constexpr word swap(word value) noexcept {
  return to_word(pattern_of(value) << 8 | pattern_of(value) >> 8);
}
/// The bytes inside each of the two words.
constexpr dword dswap(dword value) noexcept {
  return to_dword((pattern_of(value) << 8 & 0xFF00FF00U) | (pattern_of(value) >> 8 & 0x00FF00FFU));
}

/// The values of the operands, and the operands. With M8160 ON the bytes of one device change places.
template <class First, class Second, class System>
Fault xch(word first, word second, First &&out_first, Second &&out_second, System &sys) noexcept {
  if (bit(sys.M[8160])) {
    if (!detail::same_place(out_first, out_second))
      return Fault::Operand;
    out_first = swap(first);
    return Fault::None;
  }
  out_first = second;
  out_second = first;
  return Fault::None;
}
template <class First, class Second, class System>
Fault dxch(dword first, dword second, First &&out_first, Second &&out_second, System &sys) noexcept {
  if (bit(sys.M[8160])) {
    if (!detail::same_place(out_first, out_second))
      return Fault::Operand;
    out_first = dswap(first);
    return Fault::None;
  }
  out_first = second;
  out_second = first;
  return Fault::None;
}

// ---- PRUN

namespace detail {

/// How an operand of PRUN counts its bits: X and Y in octal, M eight of each ten numbers.
enum class Numbering { Octal, Decimal };

template <class Image, unsigned K> Image &image_of(DigitBlock<Image, K> block) noexcept {
  return *static_cast<Image *>(const_cast<void *>(block.origin()));
}
template <class Image, unsigned K> Image &image_of(DigitDWordBlock<Image, K> block) noexcept {
  return *static_cast<Image *>(const_cast<void *>(block.origin()));
}
template <class Image, unsigned K> constexpr unsigned digits_in(DigitBlock<Image, K>) noexcept {
  return K;
}
template <class Image, unsigned K> constexpr unsigned digits_in(DigitDWordBlock<Image, K>) noexcept {
  return K;
}

/// How far bit i lies behind the first one.
template <Numbering N> constexpr unsigned distance(unsigned i) noexcept {
  return N == Numbering::Octal ? i : i / 8U * 10U + i % 8U;
}
/// True where the block begins at a number that ends in 0 and `bits` bits from there exist.
template <Numbering N, class Block> bool holds(Block block, unsigned bits) noexcept {
  using Image = std::remove_reference_t<decltype(image_of(block))>;
  return block.first() % (N == Numbering::Octal ? 8U : 10U) == 0 && distance<N>(bits - 1U) < Image::kPoints - block.first();
}

template <Numbering From, Numbering To, class Source, class Destination>
Fault copy_octal(Source source, Destination destination) noexcept {
  const unsigned bits = 4U * digits_in(source);
  if (digits_in(source) != digits_in(destination) || !holds<From>(source, bits) || !holds<To>(destination, bits))
    return Fault::Range;
  std::uint32_t pattern = 0;
  for (unsigned i = 0; i < bits; ++i)
    pattern |= std::uint32_t{bit(image_of(source)[source.first() + distance<From>(i)]).value()} << i;
  for (unsigned i = 0; i < bits; ++i)
    image_of(destination)[destination.first() + distance<To>(i)] = bit::lowest_of(pattern >> i);
  return Fault::None;
}

}  // namespace detail

/// X to Y; the others name their operands in the same way.
template <class Source, class Destination, class System> Fault prun_xy(Source source, Destination destination, System &) noexcept {
  return detail::copy_octal<detail::Numbering::Octal, detail::Numbering::Octal>(source, destination);
}
template <class Source, class Destination, class System> Fault prun_xm(Source source, Destination destination, System &) noexcept {
  return detail::copy_octal<detail::Numbering::Octal, detail::Numbering::Decimal>(source, destination);
}
template <class Source, class Destination, class System> Fault prun_my(Source source, Destination destination, System &) noexcept {
  return detail::copy_octal<detail::Numbering::Decimal, detail::Numbering::Octal>(source, destination);
}
template <class Source, class Destination, class System> Fault prun_mm(Source source, Destination destination, System &) noexcept {
  return detail::copy_octal<detail::Numbering::Decimal, detail::Numbering::Decimal>(source, destination);
}
template <class Source, class Destination, class System>
Fault dprun_xy(Source source, Destination destination, System &sys) noexcept {
  return prun_xy(source, destination, sys);
}
template <class Source, class Destination, class System>
Fault dprun_xm(Source source, Destination destination, System &sys) noexcept {
  return prun_xm(source, destination, sys);
}
template <class Source, class Destination, class System>
Fault dprun_my(Source source, Destination destination, System &sys) noexcept {
  return prun_my(source, destination, sys);
}
template <class Source, class Destination, class System>
Fault dprun_mm(Source source, Destination destination, System &sys) noexcept {
  return prun_mm(source, destination, sys);
}

}  // namespace ladder::tp03
