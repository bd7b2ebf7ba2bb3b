// Rotation, shift registers and queues: F30-F39.
//
// A shift register of n1 places takes n2 new ones in from S, which may lie inside the register: `SFTLP M15 M0 K16 K1` is a ring. S
// counts as it was before, so the register is rotated in place first, which loses nothing, and only then the places that have come
// round are overwritten; what S had in the register is found where the rotation has put it. No copy of S is needed.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/digits.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"

#include <cstdint>
#include <type_traits>

namespace ladder::tp03 {

namespace shifting {

/// Digits of an operand that is written; 0: no digits.
template <class Out> inline constexpr unsigned kDigits = 0;
template <class Image, unsigned K> inline constexpr unsigned kDigits<Digits<Image, K>> = K;

/// Four digits for a word, eight for a double word, or no digits: rotations turn the full width only.
template <class Number, class Out> constexpr bool is_full_width() noexcept {
  constexpr unsigned digits = kDigits<std::remove_cv_t<std::remove_reference_t<Out>>>;
  return digits == 0 || digits == 2 * sizeof(Number);
}

/// The low `Width` bits of a ring of Width bits, turned left by `n`, 0 to Width.
template <unsigned Width> constexpr std::uint64_t turn_left(std::uint64_t ring, unsigned n) noexcept {
  constexpr std::uint64_t mask = ~std::uint64_t{0} >> (64 - Width);
  return (ring << n | ring >> (Width - n)) & mask;
}

template <class Number> constexpr Number number_of(std::uint64_t pattern) noexcept {
  if constexpr (sizeof(Number) == sizeof(word))
    return to_word(static_cast<std::uint32_t>(pattern));
  else
    return to_dword(static_cast<std::uint32_t>(pattern));
}

/// D turned left by n. Carry is bit 0 afterwards, or, for a turn to the right, the top bit.
template <class Number, class Out, class S> Fault rotate(Number value, word n, bool right, Out &&out, S &sys) noexcept {
  constexpr unsigned width = 8 * sizeof(Number);
  if (!is_full_width<Number, Out>())
    return Fault::Operand;
  if (n < 0 || n > static_cast<word>(width))
    return Fault::Range;
  if (n == 0)
    return Fault::None;
  const unsigned places = static_cast<unsigned>(n);
  const std::uint64_t turned = turn_left<width>(pattern_of(value), right ? width - places : places);
  out = number_of<Number>(turned);
  sys.M[8022] = bit((turned >> (right ? width - 1 : 0) & 1U) != 0);
  return Fault::None;
}

/// The same in a ring of one bit more: carry lies above the top bit.
template <class Number, class Out, class S> Fault rotate_carry(Number value, word n, bool right, Out &&out, S &sys) noexcept {
  constexpr unsigned width = 8 * sizeof(Number);
  if (!is_full_width<Number, Out>())
    return Fault::Operand;
  if (n < 0 || n > static_cast<word>(width))
    return Fault::Range;
  if (n == 0)
    return Fault::None;
  const unsigned places = static_cast<unsigned>(n);
  const bit carry = sys.M[8022];
  const std::uint64_t ring = std::uint64_t{pattern_of(value)} | std::uint64_t{carry.value()} << width;
  const std::uint64_t turned = turn_left<width + 1>(ring, right ? width + 1 - places : places);
  out = number_of<Number>(turned);
  sys.M[8022] = bit((turned >> width & 1U) != 0);
  return Fault::None;
}

// ---- shift registers

/// By how much first() grows from one element to the next.
template <class Run> inline constexpr int kStride = 1;
template <class Image, unsigned K> inline constexpr int kStride<DigitBlock<Image, K>> = 4 * K;

template <class Run> void reverse(const Run &run, unsigned begin, unsigned end) noexcept {
  for (; begin + 1 < end; ++begin, --end) {
    const auto kept = run.get(begin);
    run.set(begin, run.get(end - 1));
    run.set(end - 1, kept);
  }
}

/// S and D are parts of one memory.
template <class Source, class Target> bool share_memory(const Source &s, const Target &d) noexcept {
  if constexpr (std::is_same<Source, Target>::value)
    return s.origin() == d.origin();
  else
    return false;
}

/// Shift right moves towards D, and S enters at the far end; shift left moves away from D.
template <class Source, class Target> Fault shift(const Source &s, const Target &d, word length, word count, bool right) noexcept {
  if (length < 1 || count < 1 || count > length)
    return Fault::Range;
  const unsigned n1 = static_cast<unsigned>(length), n2 = static_cast<unsigned>(count);
  if (n1 > d.points() || n2 > s.points())
    return Fault::Range;

  // Place p of the register turns up at p - turn, and what would be below 0 at the far end.
  const unsigned turn = right ? n2 : n1 - n2, hole = right ? n1 - n2 : 0;
  const bool shared = share_memory(s, d);
  const int distance = static_cast<int>(s.first()) - static_cast<int>(d.first());
  if (shared && distance % kStride<Target> != 0 && distance < static_cast<int>(n1) * kStride<Target> &&
      -distance < static_cast<int>(n2) * kStride<Target>)
    return Fault::Operand;  // digit groups that overlap each other in part
  const int offset = distance / kStride<Target>;

  reverse(d, 0, turn);
  reverse(d, turn, n1);
  reverse(d, 0, n1);
  // Some of S may itself lie in the hole: fill it in the order in which each place is read before it is overwritten.
  const bool ascending = offset >= (right ? 0 : static_cast<int>(turn));
  for (unsigned i = 0; i < n2; ++i) {
    const unsigned j = ascending ? i : n2 - 1 - i;
    const int p = offset + static_cast<int>(j);
    if (shared && p >= 0 && p < static_cast<int>(n1)) {
      const unsigned place = static_cast<unsigned>(p);
      d.set(hole + j, d.get(place >= turn ? place - turn : place + n1 - turn));
    } else {
      d.set(hole + j, s.get(j));
    }
  }
  return Fault::None;
}

}  // namespace shifting

// ---- ROR, ROL: M8022 is the bit that went round last. n = 0, of which the manual says nothing, changes nothing.
template <class Out, class S> Fault ror(word value, word n, Out &&out, S &sys) noexcept {
  return shifting::rotate(value, n, true, out, sys);
}
template <class Out, class S> Fault dror(dword value, word n, Out &&out, S &sys) noexcept {
  return shifting::rotate(value, n, true, out, sys);
}
template <class Out, class S> Fault rol(word value, word n, Out &&out, S &sys) noexcept {
  return shifting::rotate(value, n, false, out, sys);
}
template <class Out, class S> Fault drol(dword value, word n, Out &&out, S &sys) noexcept {
  return shifting::rotate(value, n, false, out, sys);
}

// ---- RCR, RCL: M8022 is part of the ring.
template <class Out, class S> Fault rcr(word value, word n, Out &&out, S &sys) noexcept {
  return shifting::rotate_carry(value, n, true, out, sys);
}
template <class Out, class S> Fault drcr(dword value, word n, Out &&out, S &sys) noexcept {
  return shifting::rotate_carry(value, n, true, out, sys);
}
template <class Out, class S> Fault rcl(word value, word n, Out &&out, S &sys) noexcept {
  return shifting::rotate_carry(value, n, false, out, sys);
}
template <class Out, class S> Fault drcl(dword value, word n, Out &&out, S &sys) noexcept {
  return shifting::rotate_carry(value, n, false, out, sys);
}

// ---- SFTR, SFTL, WSFR, WSFL
template <class Source, class Target, class S> Fault sftr(Source s, Target d, word n1, word n2, S &) noexcept {
  return shifting::shift(s, d, n1, n2, true);
}
template <class Source, class Target, class S> Fault sftl(Source s, Target d, word n1, word n2, S &) noexcept {
  return shifting::shift(s, d, n1, n2, false);
}
template <class Source, class Target, class S> Fault wsfr(Source s, Target d, word n1, word n2, S &) noexcept {
  return shifting::shift(s, d, n1, n2, true);
}
template <class Source, class Target, class S> Fault wsfl(Source s, Target d, word n1, word n2, S &) noexcept {
  return shifting::shift(s, d, n1, n2, false);
}

// ---- SFWR, SFRD: the first word counts the items behind it.

/// The manual refuses a write when the pointer "exceeds n - 1"; as there are n - 1 places, n - 1 items are full already.
template <class Queue, class S> Fault sfwr(word item, Queue queue, word n, S &sys) noexcept {
  if (n < 2 || static_cast<unsigned>(n) > queue.points() || queue.get(0) < 0)
    return Fault::Range;
  const word items = queue.get(0);
  const bool full = items >= n - 1;
  sys.M[8022] = bit(full);
  if (full)
    return Fault::None;
  queue.set(static_cast<unsigned>(items) + 1, item);
  queue.set(0, to_word(pattern_of(items) + 1U));
  return Fault::None;
}

/// All places move up, also those behind the last item; the last place keeps its value.
template <class Queue, class Out, class S> Fault sfrd(Queue queue, word n, Out &&out, S &sys) noexcept {
  if (n < 2 || static_cast<unsigned>(n) > queue.points() || queue.get(0) < 0)
    return Fault::Range;
  const word items = queue.get(0);
  sys.M[8020] = bit(items == 0);
  if (items == 0)
    return Fault::None;
  const word item = queue.get(1);
  for (unsigned i = 1; i + 1 < static_cast<unsigned>(n); ++i)
    queue.set(i, queue.get(i + 1));
  queue.set(0, to_word(pattern_of(items) - 1U));
  out = item;
  return Fault::None;
}

}  // namespace ladder::tp03
