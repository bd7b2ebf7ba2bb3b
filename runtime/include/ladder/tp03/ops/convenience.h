// Convenience instructions: F46, F60-F69.
#pragma once

#include "ladder/bit.h"
#include "ladder/tp03/ops/cam.h"
#include "ladder/tp03/ops/ist.h"
#include "ladder/tp03/ops/ramp.h"
#include "ladder/tp03/ops/rotary_table.h"
#include "ladder/tp03/ops/sort.h"
#include "ladder/tp03/ops/special_timers.h"

namespace ladder::tp03 {

/// F66 ALT
constexpr bit alt(bit state) noexcept {
  return !state;
}

}  // namespace ladder::tp03
