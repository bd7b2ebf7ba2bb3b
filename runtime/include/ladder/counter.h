// Counters of rising edges. The coil is the edge memory.
//
// At the set value the contact closes, and neither it nor the value changes until reset(). reset() clears the coil too, so a
// condition that is still ON counts again at the next execution. A set value below 1 acts as 1.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/edge.h"
#include "ladder/number.h"

namespace ladder {

struct Counter {
  word value = 0;
  bit contact{};
  bit coil{};

  constexpr void count_up(bit condition, word preset) noexcept {
    if (!(rising(coil, condition) & !contact))
      return;
    if (value < 32767)
      ++value;
    contact = bit(value >= (preset > 1 ? preset : 1));
  }
  /// Timers and counters are called alike; a counter needs no clock.
  template <class System> constexpr void count_up(bit condition, word preset, const System &) noexcept {
    count_up(condition, preset);
  }

  constexpr void reset() noexcept { *this = Counter{}; }
};

/// Counters 0 to N - 1.
template <unsigned N> class Counters {
public:
  static constexpr unsigned kPoints = N;

  constexpr Counter &operator[](unsigned number) noexcept { return counters_[number]; }
  constexpr const Counter &operator[](unsigned number) const noexcept { return counters_[number]; }
  /// The current values from `first` on, for block transfers.
  constexpr ValueBlock<Counter> block(unsigned first) noexcept { return {counters_, first, N}; }
  constexpr void clear() noexcept {
    for (Counter &counter : counters_)
      counter.reset();
  }
  /// Numbers `first` to `last`, for classes that are latched in part.
  constexpr void clear(unsigned first, unsigned last) noexcept {
    for (unsigned number = first; number <= last; ++number)
      counters_[number].reset();
  }

private:
  Counter counters_[N] = {};
};

}  // namespace ladder
