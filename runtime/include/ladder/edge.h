// Edges: a state compared with what the same place saw at its last execution.
//
// Each edge instruction owns one memory bit, or names a device that serves as one. The memory is updated whenever the instruction
// is executed, so an instruction that is skipped compares with the last time it was not. Memory starts OFF: a state that is ON at
// the very first execution is a rising edge.
#pragma once

#include "ladder/bit.h"

namespace ladder {

/// The result of rising(): a bit, made without branches, in expressions; two branches where something is done on an edge only,
/// which is cheaper because edges are rare.
class RisingEdge {
public:
  constexpr RisingEdge(bit before, bit now) noexcept : before_(before), now_(now) {}
  constexpr operator bit() const noexcept { return now_ & !before_; }
  explicit constexpr operator bool() const noexcept { return static_cast<bool>(now_) && !before_; }
  constexpr bit operator!() const noexcept { return !static_cast<bit>(*this); }

private:
  bit before_, now_;
};

/// ON when `now` is ON and was OFF. `memory` is a `bit&` or a proxy of one.
template <class Memory> constexpr RisingEdge rising(Memory &&memory, bit now) noexcept {
  const bit before = memory;
  memory = now;
  return {before, now};
}

/// ON when `now` is OFF and was ON.
template <class Memory> constexpr bit falling(Memory &&memory, bit now) noexcept {
  const bit before = memory;
  memory = now;
  return !now & before;
}

}  // namespace ladder
