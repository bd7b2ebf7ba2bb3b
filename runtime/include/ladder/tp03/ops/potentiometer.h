// Knobs: F85 VRRD, F86 VRSC and F89 EPSC. A position is 0 to 1023.
#pragma once

#include "ladder/number.h"
#include "ladder/tp03/fault.h"

#include <cstdint>

namespace ladder::tp03 {
namespace detail {

inline constexpr std::uint32_t kFullScale = 1023;

constexpr std::uint32_t position(std::uint16_t raw) noexcept {
  return raw < kFullScale ? raw : kFullScale;
}
/// The part of `span` that the position makes, to the nearest; half of one is rounded up.
constexpr std::uint32_t part_of(std::uint32_t span, std::uint32_t position) noexcept {
  return (2 * span * position + kFullScale) / (2 * kFullScale);
}

}  // namespace detail

/// Knobs 0 and 1 of the unit, 2 to 7 of the function card.
template <class Out, class S> Fault vrrd(word number, Out &&d, S &sys) noexcept {
  if (number < 0 || number > 7)
    return Fault::Range;
  d = to_word(detail::position(sys.io().potentiometer(static_cast<unsigned>(number))));
  return Fault::None;
}

/// The same knobs in ten steps.
template <class Out, class S> Fault vrsc(word number, Out &&d, S &sys) noexcept {
  if (number < 0 || number > 7)
    return Fault::Range;
  d = to_word(detail::part_of(10, detail::position(sys.io().potentiometer(static_cast<unsigned>(number)))));
  return Fault::None;
}

/// A channel of the expansion card, from `low` to `high`.
template <class Out, class S> Fault epsc(word channel, word low, word high, Out &&d, S &sys) noexcept {
  if (channel < 0 || channel > 5 || high < low)
    return Fault::Range;
  const std::uint32_t span = pattern_of(dword{high}) - pattern_of(dword{low});
  const std::uint32_t position = detail::position(sys.io().option_input(static_cast<unsigned>(channel)));
  d = to_word(pattern_of(dword{low}) + detail::part_of(span, position));
  return Fault::None;
}

}  // namespace ladder::tp03
