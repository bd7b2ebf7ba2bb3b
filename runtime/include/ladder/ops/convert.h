// Binary to packed BCD and back, all digits at once.
//
// The conversions work on lanes of one register: two numbers below 100 become two pairs of digits with one multiplication, and
// pairs of digits join to numbers by subtracting what their place value is short of a power of two (16t+u - 6t = 10t+u). No loop,
// no division beyond one by a constant.
#pragma once

#include "ladder/number.h"

#include <cstdint>

namespace ladder::ops {
namespace detail {

/// Four BCD digits of 0-9999.
constexpr std::uint32_t bcd4(std::uint32_t value) noexcept {
  const std::uint32_t hundreds = value * 5243U >> 19;  // value / 100 for values below 10000
  const std::uint32_t lanes = (value - 100U * hundreds) | hundreds << 16;
  const std::uint32_t tens = lanes * 103U >> 10 & 0x000F000FU;  // each lane / 10 for lanes below 100
  const std::uint32_t digits = lanes + 6U * tens;
  return (digits & 0xFFU) | digits >> 16 << 8;
}

/// Whether all digits are 0-9: A to F have bit 3 and one of bits 2 and 1.
constexpr bool is_bcd(std::uint32_t digits) noexcept {
  return (digits & (digits << 1 | digits << 2) & 0x88888888U) == 0;
}

/// The number in eight good digits.
constexpr std::uint32_t bin8(std::uint32_t digits) noexcept {
  const std::uint32_t bytes = digits - 6U * (digits >> 4 & 0x0F0F0F0FU);   // four lanes of 0-99
  const std::uint32_t halves = bytes - 156U * (bytes >> 8 & 0x00FF00FFU);  // two lanes of 0-9999
  return halves - 55536U * (halves >> 16);
}

}  // namespace detail

/// False, and nothing written, when `source` is not in 0-9999.
template <class Out> [[nodiscard]] constexpr bool bcd(word source, Out &&out) noexcept {
  if (source < 0 || source > 9999)
    return false;
  out = to_word(detail::bcd4(pattern_of(source)));
  return true;
}

/// False, and nothing written, when `source` is not in 0-99999999.
template <class Out> [[nodiscard]] constexpr bool dbcd(dword source, Out &&out) noexcept {
  if (source < 0 || source > 99999999)
    return false;
  const std::uint32_t value = pattern_of(source);
  const std::uint32_t high = value / 10000U;
  out = to_dword(detail::bcd4(value - high * 10000U) | detail::bcd4(high) << 16);
  return true;
}

/// False, and nothing written, when a digit of `source` is not 0-9.
template <class Out> [[nodiscard]] constexpr bool bin(word source, Out &&out) noexcept {
  if (!detail::is_bcd(pattern_of(source)))
    return false;
  out = to_word(detail::bin8(pattern_of(source)));
  return true;
}
template <class Out> [[nodiscard]] constexpr bool dbin(dword source, Out &&out) noexcept {
  if (!detail::is_bcd(pattern_of(source)))
    return false;
  out = to_dword(detail::bin8(pattern_of(source)));
  return true;
}

}  // namespace ladder::ops
