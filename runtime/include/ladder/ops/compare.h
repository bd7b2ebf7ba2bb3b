// Signed comparisons. Words widen to double words without a change of value, so one function serves both widths.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"

namespace ladder::ops {

constexpr bit equal(dword a, dword b) noexcept {
  return bit(a == b);
}
constexpr bit not_equal(dword a, dword b) noexcept {
  return bit(a != b);
}
constexpr bit greater(dword a, dword b) noexcept {
  return bit(a > b);
}
constexpr bit less_equal(dword a, dword b) noexcept {
  return bit(a <= b);
}
constexpr bit less(dword a, dword b) noexcept {
  return bit(a < b);
}
constexpr bit greater_equal(dword a, dword b) noexcept {
  return bit(a >= b);
}

}  // namespace ladder::ops
