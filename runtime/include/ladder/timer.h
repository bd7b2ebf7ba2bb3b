// On-delay timers that advance only where their instruction is executed.
//
// Time is measured between scans in whole ticks, and each execution with the condition ON adds the ticks of the last completed
// scan: twice in a scan counts twice, and the first execution after OFF counts already. So a set value below one scan closes the
// contact in the same scan. At the set value the contact closes and the value stands still there; a set value that is raised
// afterwards does not open the contact again.
//
// A set value of 0 closes at once. A negative one, which controllers refuse as a constant but which a register may hold at run
// time, acts as 0: that is what "value >= set value" says, and a delay that is never over would be the worse surprise.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/number.h"

namespace ladder {

struct Timer {
  word value = 0;
  bit contact{};
  bit coil{};

  /// Condition OFF: value 0, contact OFF. `system` tells the ticks.
  template <class System> constexpr void on_delay_low(bit condition, word preset, const System &system) noexcept {
    on_delay(condition, preset, system.low_ticks());
  }
  template <class System> constexpr void on_delay_high(bit condition, word preset, const System &system) noexcept {
    on_delay(condition, preset, system.high_ticks());
  }
  /// Condition OFF: value and contact stay; only reset() clears them.
  template <class System> constexpr void retentive_low(bit condition, word preset, const System &system) noexcept {
    accumulate(condition, preset, system.low_ticks());
  }
  template <class System> constexpr void retentive_high(bit condition, word preset, const System &system) noexcept {
    accumulate(condition, preset, system.high_ticks());
  }

  constexpr void on_delay(bit condition, word preset, word ticks) noexcept {
    accumulate(condition, preset, ticks);
    if (!coil) {
      value = 0;
      contact = off;
    }
  }

  constexpr void accumulate(bit condition, word preset, word ticks) noexcept {
    coil = condition;
    if (!(condition & !contact))
      return;
    const dword sum = dword{value} + ticks;
    const dword limit = preset > 0 ? preset : 0;
    contact = bit(sum >= limit);
    value = static_cast<word>(sum >= limit ? limit : sum);  // the limit is at most 32767, so this saturates too
  }

  constexpr void reset() noexcept { *this = Timer{}; }
};

/// Timers 0 to N - 1.
template <unsigned N> class Timers {
public:
  static constexpr unsigned kPoints = N;

  constexpr Timer &operator[](unsigned number) noexcept { return timers_[number]; }
  constexpr const Timer &operator[](unsigned number) const noexcept { return timers_[number]; }
  /// The current values from `first` on, for block transfers.
  constexpr ValueBlock<Timer> block(unsigned first) noexcept { return {timers_, first, N}; }
  constexpr void clear() noexcept {
    for (Timer &timer : timers_)
      timer.reset();
  }
  /// Numbers `first` to `last`, for classes that are latched in part.
  constexpr void clear(unsigned first, unsigned last) noexcept {
    for (unsigned number = first; number <= last; ++number)
      timers_[number].reset();
  }

private:
  Timer timers_[N] = {};
};

}  // namespace ladder
