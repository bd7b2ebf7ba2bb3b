// Binary arithmetic. Results wrap silently; there is no carry and no overflow error. Names with a leading d work on double words.
#pragma once

#include "ladder/number.h"

#include <cstdint>

namespace ladder::ops {

constexpr word add(word a, word b) noexcept {
  return to_word(pattern_of(a) + pattern_of(b));
}
constexpr word sub(word a, word b) noexcept {
  return to_word(pattern_of(a) - pattern_of(b));
}
constexpr word inc(word a) noexcept {
  return to_word(pattern_of(a) + 1U);
}
constexpr word dec(word a) noexcept {
  return to_word(pattern_of(a) - 1U);
}
/// -32768 stays -32768.
constexpr word neg(word a) noexcept {
  return to_word(0U - pattern_of(a));
}
/// The full product: never overflows.
constexpr dword mul(word a, word b) noexcept {
  return dword{a} * dword{b};
}

constexpr dword dadd(dword a, dword b) noexcept {
  return to_dword(pattern_of(a) + pattern_of(b));
}
constexpr dword dsub(dword a, dword b) noexcept {
  return to_dword(pattern_of(a) - pattern_of(b));
}
constexpr dword dinc(dword a) noexcept {
  return to_dword(pattern_of(a) + 1U);
}
constexpr dword ddec(dword a) noexcept {
  return to_dword(pattern_of(a) - 1U);
}
constexpr dword dneg(dword a) noexcept {
  return to_dword(0U - pattern_of(a));
}
constexpr qword dmul(dword a, dword b) noexcept {
  return qword{a} * qword{b};
}

/// Quotient towards zero, remainder with the sign of the dividend; -32768 / -1 wraps to -32768, remainder 0. False, and nothing
/// written, when the divisor is 0.
template <class Quotient, class Remainder>
[[nodiscard]] constexpr bool div(word a, word b, Quotient &&quotient, Remainder &&remainder) noexcept {
  if (b == 0)
    return false;
  quotient = static_cast<word>(dword{a} / b);
  remainder = static_cast<word>(dword{a} % b);
  return true;
}
template <class Quotient> [[nodiscard]] constexpr bool div(word a, word b, Quotient &&quotient) noexcept {
  if (b == 0)
    return false;
  quotient = static_cast<word>(dword{a} / b);
  return true;
}

template <class Quotient, class Remainder>
[[nodiscard]] constexpr bool ddiv(dword a, dword b, Quotient &&quotient, Remainder &&remainder) noexcept {
  if (b == 0)
    return false;
  // By -1 apart: the quotient of the smallest number does not fit, and a 64-bit division is dear on small targets.
  quotient = b == -1 ? dneg(a) : a / b;
  remainder = b == -1 ? 0 : a % b;
  return true;
}
template <class Quotient> [[nodiscard]] constexpr bool ddiv(dword a, dword b, Quotient &&quotient) noexcept {
  if (b == 0)
    return false;
  quotient = b == -1 ? dneg(a) : a / b;
  return true;
}

}  // namespace ladder::ops
