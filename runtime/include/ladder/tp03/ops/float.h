// Floating point of the TP03: IEEE-754 singles in register pairs, and decimal numbers as mantissa and exponent.
//
// What every function here does alike: operands that are infinite or no number fail (the controller cannot make such patterns, but
// a program can write them), and then nothing is written. Results are kept among 0 and the normal numbers, see real::store().
// Nothing depends on how a compiler treats NaN beyond comparisons being false, so -ffast-math is not for programs that use this
// header.
//
// Square root and trigonometry are calls of sqrtf, sinf, cosf, tanf, asinf, acosf and atanf: programs with DESQR or DSIN ... DATAN
// link a C mathematics library, or firmware supplies those that it uses. Nothing else here needs a library.
#pragma once

#include "ladder/number.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/ops/arith.h"

#include <cstdint>
#include <limits>

namespace ladder::tp03 {
namespace real {

inline constexpr float kLargest = std::numeric_limits<float>::max();
inline constexpr float kSmallest = std::numeric_limits<float>::min();
inline constexpr double kPi = 3.14159265358979323846;

/// Neither infinite nor NaN.
constexpr bool is_finite(float value) noexcept {
  return value >= -kLargest && value <= kLargest;
}

/// Writes a result and its flags. Below the smallest normal number: 0 with borrow, and no zero flag, because the exact result is
/// not 0. Beyond the largest: the largest of that sign, with carry. A zero is stored without sign, so that its words are 0 for
/// other instructions too. `vanished`: the exact result is not 0, even if `result` is.
template <class Out, class S> void store(float result, bool vanished, Out &&out, S &sys) noexcept {
  const float size = result < 0 ? -result : result;
  const bool carry = size > kLargest;
  const bool borrow = size < kSmallest && (size > 0 || vanished);
  if (carry)
    result = result < 0 ? -kLargest : kLargest;
  out = size < kSmallest ? 0.0F : result;
  sys.set_flags(size < kSmallest && !borrow, borrow, carry);
}

/// value * 10^exponent. Exact powers of ten only, so that -22 to 22 are one correctly rounded operation.
constexpr double scaled(double value, int exponent) noexcept {
  constexpr double kPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  for (; exponent > 22; exponent -= 22)
    value *= kPowers[22];
  for (; exponent < -22; exponent += 22)
    value /= kPowers[22];
  return exponent >= 0 ? value * kPowers[exponent] : value / kPowers[-exponent];
}

/// floor(log10(value)) of a normal number, or one less: from its binary exponent, log10(2) being a little above 1233/4096.
inline int decimal_exponent(float value) noexcept {
  std::uint32_t pattern;
  __builtin_memcpy(&pattern, &value, sizeof pattern);
  const int binary = static_cast<int>(pattern >> 23 & 0xFFU) - 127;
  return binary >= 0 ? binary * 1233 / 4096 : -((-binary * 1233 + 4095) / 4096);
}

}  // namespace real

// ---- integers

/// F49 FLT: to the nearest single, to the even one of two equally near.
constexpr float flt(word source) noexcept {
  return static_cast<float>(source);
}
constexpr float dflt(dword source) noexcept {
  return static_cast<float>(source);
}

/// F129 INT: the fraction is cut off, with the borrow flag. Out of range: the nearest integer, with the carry flag alone.
template <class Out, class S> Fault integer(float source, Out &&out, S &sys) noexcept {
  if (!real::is_finite(source))
    return Fault::Range;
  const bool carry = source >= 32768.0F || source <= -32769.0F;
  const dword value = !carry ? static_cast<dword>(source) : source < 0 ? -32768 : 32767;
  out = static_cast<word>(value);
  sys.set_flags(value == 0, !carry && static_cast<float>(value) != source, carry);
  return Fault::None;
}
template <class Out, class S> Fault dinteger(float source, Out &&out, S &sys) noexcept {
  if (!real::is_finite(source))
    return Fault::Range;
  const bool carry = source >= 2147483648.0F || source < -2147483648.0F;
  const dword limit = source < 0 ? std::numeric_limits<dword>::min() : std::numeric_limits<dword>::max();
  const dword value = carry ? limit : static_cast<dword>(source);
  out = value;
  sys.set_flags(value == 0, !carry && static_cast<float>(value) != source, carry);
  return Fault::None;
}

// ---- comparison

/// F110 ECMP: D is a > b, D+1 is a = b, D+2 is a < b.
template <class Run, class S> Fault ecmp(float a, float b, Run d, S &) noexcept {
  if (!real::is_finite(a) || !real::is_finite(b))
    return Fault::Range;
  return detail::write_order(d, a > b, a < b);
}

/// F111 EZCP: D is below the zone, D+1 inside, limits included, D+2 above. A lower limit above the upper one is both.
template <class Run, class S> Fault ezcp(float low, float high, float value, Run d, S &) noexcept {
  if (!real::is_finite(low) || !real::is_finite(high) || !real::is_finite(value))
    return Fault::Range;
  const bool below = value < low;
  return detail::write_order(d, below, value > (high < low ? low : high));
}

// ---- decimal numbers

/// F118 EBCD: mantissa of four digits and exponent. Rounded to the nearest, so that what EBIN made comes back; that is at most
/// 3402 x 10^35, the largest binary number, which would round to 3403, counts as too large.
template <class Block, class S> Fault ebcd(float source, Block d, S &sys) noexcept {
  if (!real::is_finite(source))
    return Fault::Range;
  const float size = source < 0 ? -source : source;
  dword mantissa = 0;
  int exponent = 0;
  if (size >= real::kSmallest) {
    exponent = real::decimal_exponent(size) - 3;
    double digits = real::scaled(static_cast<double>(size), -exponent);
    while (digits >= 9999.5)
      digits = real::scaled(static_cast<double>(size), -++exponent);
    mantissa = static_cast<dword>(digits + 0.5);
  }
  const bool carry = exponent == 35 && mantissa > 3402;
  if (carry)
    mantissa = 3402;
  d.set(0, static_cast<word>(source < 0 ? -mantissa : mantissa));
  d.set(1, static_cast<word>(exponent));
  sys.set_flags(size == 0, size > 0 && mantissa == 0, carry);
  return Fault::None;
}

/// F119 EBIN: mantissa x 10^exponent. With mantissa 0 the exponent means nothing.
template <class Block, class Out, class S> Fault ebin(Block source, Out &&out, S &sys) noexcept {
  const dword mantissa = source.get(0);
  const dword exponent = mantissa == 0 ? 0 : source.get(1);
  const dword size = mantissa < 0 ? -mantissa : mantissa;
  if ((size != 0 && size < 1000) || size > 9999 || exponent < -41 || exponent > 35)
    return Fault::Range;
  // The smallest decimal number is the smallest binary one cut to four digits, which is a little less.
  const double value = size == 1175 && exponent == -41 ? static_cast<double>(real::kSmallest)
                                                       : real::scaled(static_cast<double>(size), static_cast<int>(exponent));
  // Out of range the conversion would be undefined.
  const bool beyond = value > static_cast<double>(real::kLargest);
  const float result = beyond ? std::numeric_limits<float>::infinity() : static_cast<float>(value);
  real::store(mantissa < 0 ? -result : result, false, out, sys);
  return Fault::None;
}

// ---- arithmetic

/// F120 EADD
template <class Out, class S> Fault eadd(float a, float b, Out &&out, S &sys) noexcept {
  if (!real::is_finite(a) || !real::is_finite(b))
    return Fault::Range;
  real::store(a + b, false, out, sys);
  return Fault::None;
}
/// F121 ESUB
template <class Out, class S> Fault esub(float a, float b, Out &&out, S &sys) noexcept {
  if (!real::is_finite(a) || !real::is_finite(b))
    return Fault::Range;
  real::store(a - b, false, out, sys);
  return Fault::None;
}
/// F122 EMUL
template <class Out, class S> Fault emul(float a, float b, Out &&out, S &sys) noexcept {
  if (!real::is_finite(a) || !real::is_finite(b))
    return Fault::Range;
  real::store(a * b, a != 0 && b != 0, out, sys);
  return Fault::None;
}
/// F123 EDIV: fails where the divisor is 0.
template <class Out, class S> Fault ediv(float a, float b, Out &&out, S &sys) noexcept {
  if (!real::is_finite(a) || !real::is_finite(b) || b == 0)
    return Fault::Range;
  real::store(a / b, a != 0, out, sys);
  return Fault::None;
}
/// F127 ESQR: fails below 0.
template <class Out, class S> Fault esqr(float source, Out &&out, S &sys) noexcept {
  if (!real::is_finite(source) || source < 0)
    return Fault::Range;
  real::store(__builtin_sqrtf(source), false, out, sys);
  return Fault::None;
}

// ---- trigonometry, angles in radians

/// F130 SIN
template <class Out, class S> Fault sin(float angle, Out &&out, S &sys) noexcept {
  if (!real::is_finite(angle))
    return Fault::Range;
  real::store(__builtin_sinf(angle), false, out, sys);
  return Fault::None;
}
/// F131 COS
template <class Out, class S> Fault cos(float angle, Out &&out, S &sys) noexcept {
  if (!real::is_finite(angle))
    return Fault::Range;
  real::store(__builtin_cosf(angle), false, out, sys);
  return Fault::None;
}
/// F132 TAN
template <class Out, class S> Fault tan(float angle, Out &&out, S &sys) noexcept {
  if (!real::is_finite(angle))
    return Fault::Range;
  real::store(__builtin_tanf(angle), false, out, sys);
  return Fault::None;
}
/// F133 ASIN: -pi/2 to pi/2; fails outside of -1 to 1.
template <class Out, class S> Fault asin(float source, Out &&out, S &sys) noexcept {
  if (!(source >= -1 && source <= 1))
    return Fault::Range;
  real::store(__builtin_asinf(source), false, out, sys);
  return Fault::None;
}
/// F134 ACOS: 0 to pi; fails outside of -1 to 1.
template <class Out, class S> Fault acos(float source, Out &&out, S &sys) noexcept {
  if (!(source >= -1 && source <= 1))
    return Fault::Range;
  real::store(__builtin_acosf(source), false, out, sys);
  return Fault::None;
}
/// F135 ATAN: -pi/2 to pi/2.
template <class Out, class S> Fault atan(float source, Out &&out, S &sys) noexcept {
  if (!real::is_finite(source))
    return Fault::Range;
  real::store(__builtin_atanf(source), false, out, sys);
  return Fault::None;
}
/// F136 RAD: degrees to radians. In double, so that the rounded factor does not show in the last digit.
template <class Out, class S> Fault rad(float degrees, Out &&out, S &sys) noexcept {
  if (!real::is_finite(degrees))
    return Fault::Range;
  real::store(static_cast<float>(static_cast<double>(degrees) * (real::kPi / 180)), degrees != 0, out, sys);
  return Fault::None;
}
/// F137 DEG: radians to degrees.
template <class Out, class S> Fault deg(float radians, Out &&out, S &sys) noexcept {
  if (!real::is_finite(radians))
    return Fault::Range;
  const double degrees = static_cast<double>(radians) * (180 / real::kPi);
  constexpr double kMost = static_cast<double>(real::kLargest);
  // Out of range the conversion would be undefined.
  const bool beyond = degrees > kMost || degrees < -kMost;
  const float overflow = radians < 0 ? -std::numeric_limits<float>::infinity() : std::numeric_limits<float>::infinity();
  real::store(beyond ? overflow : static_cast<float>(degrees), false, out, sys);
  return Fault::None;
}

}  // namespace ladder::tp03
