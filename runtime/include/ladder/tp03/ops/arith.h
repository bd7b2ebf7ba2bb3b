// Comparison into bits, BCD, arithmetic, logic and square root: F10, F11, F18-F29, F48.
//
// Names with a leading d work on double words. Sums and differences that do not fit wrap round; the flags tell it.
//
// Everything is constexpr, and so inline: GCC inlines other templates at -O2 only where they are tiny.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"
#include "ladder/ops/arith.h"
#include "ladder/ops/convert.h"
#include "ladder/ops/logic.h"
#include "ladder/tp03/fault.h"

#include <cstdint>

namespace ladder::tp03 {

using ops::ddec;
using ops::dec;
using ops::dinc;
using ops::dmul;
using ops::dneg;
using ops::dword_and;
using ops::dword_or;
using ops::dword_xor;
using ops::inc;
using ops::mul;
using ops::neg;
using ops::word_and;
using ops::word_or;
using ops::word_xor;

// ---- CMP, ZCP

namespace detail {

/// Three bits, of which one is ON: the first, the second or the third.
template <class Run> constexpr Fault write_order(Run run, bool first, bool third) noexcept {
  if (run.points() < 3)
    return Fault::Range;
  run.set(0, bit(first));
  run.set(1, bit(!first && !third));
  run.set(2, bit(third));
  return Fault::None;
}

}  // namespace detail

template <class Run, class System> constexpr Fault cmp(word a, word b, Run run, System &) noexcept {
  return detail::write_order(run, a > b, a < b);
}
template <class Run, class System> constexpr Fault dcmp(dword a, dword b, Run run, System &) noexcept {
  return detail::write_order(run, a > b, a < b);
}

/// An upper limit below the lower one counts as the lower one.
template <class Run, class System> constexpr Fault dzcp(dword low, dword high, dword value, Run run, System &) noexcept {
  return detail::write_order(run, value < low, value > (high < low ? low : high));
}
template <class Run, class System> constexpr Fault zcp(word low, word high, word value, Run run, System &sys) noexcept {
  return dzcp(low, high, value, run, sys);
}

// ---- BCD, BIN

template <class Out, class System> constexpr Fault bcd(word source, Out &&out, System &) noexcept {
  return ops::bcd(source, out) ? Fault::None : Fault::Range;
}
template <class Out, class System> constexpr Fault dbcd(dword source, Out &&out, System &) noexcept {
  return ops::dbcd(source, out) ? Fault::None : Fault::Range;
}
template <class Out, class System> constexpr Fault bin(word source, Out &&out, System &) noexcept {
  return ops::bin(source, out) ? Fault::None : Fault::Range;
}
template <class Out, class System> constexpr Fault dbin(dword source, Out &&out, System &) noexcept {
  return ops::dbin(source, out) ? Fault::None : Fault::Range;
}

// ---- ADD, SUB

namespace detail {

/// Flags of a result that is known in full. 16 bits.
template <class System> constexpr word flagged(dword full, System &sys) noexcept {
  const word stored = to_word(pattern_of(full));
  sys.set_flags(stored == 0, full<-32768, full> 32767);
  return stored;
}
/// 32 bits: the sign of `a` is that of the full result where the stored one has overflowed.
template <class System> constexpr dword flagged(dword a, dword stored, bool overflow, System &sys) noexcept {
  sys.set_flags(stored == 0, overflow && a < 0, overflow && a >= 0);
  return stored;
}

}  // namespace detail

template <class System> constexpr word add(word a, word b, System &sys) noexcept {
  return detail::flagged(dword{a} + dword{b}, sys);
}
template <class System> constexpr word sub(word a, word b, System &sys) noexcept {
  return detail::flagged(dword{a} - dword{b}, sys);
}
template <class System> constexpr dword dadd(dword a, dword b, System &sys) noexcept {
  const dword sum = ops::dadd(a, b);
  return detail::flagged(a, sum, (a < 0) == (b < 0) && (sum < 0) != (a < 0), sys);
}
template <class System> constexpr dword dsub(dword a, dword b, System &sys) noexcept {
  const dword difference = ops::dsub(a, b);
  return detail::flagged(a, difference, (a < 0) != (b < 0) && (difference < 0) != (a < 0), sys);
}

// ---- DIV

/// Digits as destination take the quotient only.
template <class Quotient, class Remainder, class System>
constexpr Fault div(word a, word b, Quotient &&quotient, Remainder &&remainder, System &) noexcept {
  return ops::div(a, b, quotient, remainder) ? Fault::None : Fault::Range;
}
template <class Quotient, class System> constexpr Fault div(word a, word b, Quotient &&quotient, System &) noexcept {
  return ops::div(a, b, quotient) ? Fault::None : Fault::Range;
}
template <class Quotient, class Remainder, class System>
constexpr Fault ddiv(dword a, dword b, Quotient &&quotient, Remainder &&remainder, System &) noexcept {
  return ops::ddiv(a, b, quotient, remainder) ? Fault::None : Fault::Range;
}
template <class Quotient, class System> constexpr Fault ddiv(dword a, dword b, Quotient &&quotient, System &) noexcept {
  return ops::ddiv(a, b, quotient) ? Fault::None : Fault::Range;
}

// ---- SQR

namespace detail {

struct Root {
  std::uint32_t root, rest;
};

/// Square root digit by digit, each of two bits of `square`: no division and no floating point.
constexpr Root square_root(std::uint32_t square) noexcept {
  std::uint32_t root = 0;
  for (std::uint32_t place = std::uint32_t{1} << 30; place != 0; place >>= 2) {
    const std::uint32_t trial = root + place;
    root >>= 1;
    if (square >= trial) {
      square -= trial;
      root += place;
    }
  }
  return {root, square};
}

}  // namespace detail

/// The integer part; borrow tells that there was a fraction.
template <class Out, class System> constexpr Fault dsqr(dword source, Out &&out, System &sys) noexcept {
  if (source < 0)
    return Fault::Range;
  const detail::Root result = detail::square_root(pattern_of(source));
  out = to_dword(result.root);
  sys.M[8020] = bit(result.root == 0);
  sys.M[8021] = bit(result.rest != 0);
  return Fault::None;
}
template <class Out, class System> constexpr Fault sqr(word source, Out &&out, System &sys) noexcept {
  dword root = 0;
  const Fault fault = dsqr(source, root, sys);
  if (fault == Fault::None)
    out = to_word(pattern_of(root));
  return fault;
}

}  // namespace ladder::tp03
