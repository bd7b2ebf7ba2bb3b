// Logic on all bits of a word or double word.
#pragma once

#include "ladder/number.h"

namespace ladder::ops {

constexpr word word_and(word a, word b) noexcept {
  return to_word(pattern_of(a) & pattern_of(b));
}
constexpr word word_or(word a, word b) noexcept {
  return to_word(pattern_of(a) | pattern_of(b));
}
constexpr word word_xor(word a, word b) noexcept {
  return to_word(pattern_of(a) ^ pattern_of(b));
}
constexpr word word_xnor(word a, word b) noexcept {
  return to_word(~(pattern_of(a) ^ pattern_of(b)));
}
constexpr word complement(word a) noexcept {
  return to_word(~pattern_of(a));
}

constexpr dword dword_and(dword a, dword b) noexcept {
  return to_dword(pattern_of(a) & pattern_of(b));
}
constexpr dword dword_or(dword a, dword b) noexcept {
  return to_dword(pattern_of(a) | pattern_of(b));
}
constexpr dword dword_xor(dword a, dword b) noexcept {
  return to_dword(pattern_of(a) ^ pattern_of(b));
}
constexpr dword dword_xnor(dword a, dword b) noexcept {
  return to_dword(~(pattern_of(a) ^ pattern_of(b)));
}
constexpr dword dcomplement(dword a) noexcept {
  return to_dword(~pattern_of(a));
}

}  // namespace ladder::ops
