// Index registers: D20V0 is the D whose number is 20 and what V0 holds.
#pragma once

#include "ladder/number.h"

#include <cstdint>

namespace ladder {

/// The number that the register leads to. Wraps around below 0, which no image has().
constexpr unsigned at(unsigned number, dword index) noexcept {
  return number + static_cast<unsigned>(index);
}

/// An indexed constant: K30V0.
constexpr word plus(word constant, word index) noexcept {
  return to_word(pattern_of(constant) + pattern_of(index));
}
constexpr dword plus(dword constant, dword index) noexcept {
  return to_dword(pattern_of(constant) + pattern_of(index));
}

}  // namespace ladder
