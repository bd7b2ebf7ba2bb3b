// The states of a step ladder: which ones a transfer has left.
//
// A transfer switches the new state ON at once. The one that it comes from stays ON to the end of the scan and is switched OFF before
// the next one begins, unless another transfer has entered it again; its coils are switched off where the first state of the program
// stands, before any other state is executed, so that an output that the new state drives as well stays ON without a gap.
#pragma once

#include "ladder/bits.h"

namespace ladder::tp03 {

/// States 0 to N - 1.
template <unsigned N> class States {
public:
  /// From `sources` to `target`. `s` is the image of the states.
  template <class S, class... Sources> constexpr void transfer(S &s, unsigned target, Sources... sources) noexcept {
    s[target] = on;
    left_[target] = off;
    ((left_[static_cast<unsigned>(sources)] = on), ...);
    any_ = true;
  }

  /// Before the program: the states that were left go OFF.
  template <class S> constexpr void begin_scan(S &s) noexcept {
    if (!any_)
      return;
    any_ = false;
    pending_ = true;
    for (unsigned number = 0; number < N; ++number)
      if (static_cast<bit>(left_[number])) {
        s[number] = off;
        left_[number] = off;
      }
  }

  /// True once after begin_scan() has switched states off.
  constexpr bool take_left() noexcept {
    const bool result = pending_;
    pending_ = false;
    return result;
  }

  constexpr void clear() noexcept { *this = States{}; }

private:
  Bits<N> left_;
  bool any_ = false, pending_ = false;
};

/// Whether a state's routine is to be executed: while it is ON, and once more to switch off what it drove. `memory` is its last state.
template <class Memory> constexpr bool entered(Memory &&memory, bit now) noexcept {
  const bit before = memory;
  memory = now;
  return static_cast<bool>(before | now);
}

/// Whether a state is OFF that its last execution found ON.
template <class Memory> constexpr bool left(Memory &&memory, bit now) noexcept {
  const bit before = memory;
  if (!(before & !now))
    return false;
  memory = off;
  return true;
}

}  // namespace ladder::tp03
