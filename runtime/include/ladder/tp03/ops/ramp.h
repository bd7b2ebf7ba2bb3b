// A register that changes evenly, scan by scan. F67 RAMP.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"

#include <cstdint>

namespace ladder::tp03 {

/// D + 1 counts 0 to n, and D = S1 + (S2 - S1) x count / n, cut towards S1: D is S1 in the execution that starts and S2 n
/// executions later. The count is the device's own, so that a run goes on where RUN finds the condition ON.
struct ramp {
  bit driven{};

  template <class Target, class S> Fault run(bit condition, word from, word to, Target d, word n, S &sys) noexcept {
    const bit before = driven;
    driven = condition;
    if (!condition)
      return Fault::None;
    if (n < 1 || d.points() < 2)
      return Fault::Range;
    const word count = sys.first_scan() ? limited(d.get(1), n) : before ? next(limited(d.get(1), n), n, sys) : word{0};
    d.set(1, count);
    d.set(0, to_word(static_cast<std::uint32_t>(from + (dword{to} - from) * count / n)));
    sys.set_complete(bit(count == n));
    return Fault::None;
  }

private:
  static constexpr word limited(word count, word n) noexcept { return count < 0 ? word{0} : count > n ? n : count; }
  /// At the end M8026 decides: stay there, or start again.
  template <class S> static word next(word count, word n, const S &sys) noexcept {
    if (count < n)
      return static_cast<word>(count + 1);
    return sys.M[8026] ? n : word{0};
  }
};

}  // namespace ladder::tp03
