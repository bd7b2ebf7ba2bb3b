// Edges: a state compared with what the same place saw at its last execution.
//
// Each edge instruction owns one memory bit, or names a device that serves as one. The memory is updated whenever the instruction
// is executed, so an instruction that is skipped compares with the last time it was not. Memory starts OFF: a state that is ON at
// the very first execution is a rising edge.
#pragma once

#include "ladder/bit.h"

namespace ladder {

/// ON when `now` is ON and was OFF. `memory` is a `bit&` or a proxy of one.
template <class Memory> constexpr bit rising(Memory &&memory, bit now) noexcept {
  const bit before = memory;
  memory = now;
  return now & !before;
}

/// ON when `now` is OFF and was ON.
template <class Memory> constexpr bit falling(Memory &&memory, bit now) noexcept {
  const bit before = memory;
  memory = now;
  return !now & before;
}

}  // namespace ladder
