// Counters of the TP03: 16 bits upwards, 32 bits in both directions.
//
// OUT C hands a pulse in (its place in the list has an edge memory of its own). RST C drives a reset coil: while it is ON, value
// and contact are 0 and pulses do not count; a RST that is skipped leaves it as it is.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/number.h"

#include <cstdint>

namespace ladder::tp03 {

struct Counter {
  word value = 0;
  bit contact{};
  bit coil{};
  bit reset_coil{};

  /// A pulse counts one up to the set value (K0 acts as K1), where the contact closes and the value stands still. A value that was
  /// written above the set value becomes the set value with the next pulse.
  /// `pulse` is a bit or a RisingEdge.
  template <class Pulse, class System> constexpr void count_up(Pulse pulse, word preset, const System &) noexcept {
    if (!static_cast<bool>(pulse)) {  // in most scans
      coil = off;
      return;
    }
    coil = on;
    if (reset_coil | contact)
      return;
    const word set = preset > 1 ? preset : word{1};
    if (value < set)
      ++value;
    if (value >= set) {
      value = set;
      contact = on;
    }
  }
  template <class System> constexpr void drive_reset(bit condition, const System &) noexcept {
    reset_coil = condition;
    if (condition)
      clear();
  }
  constexpr void clear() noexcept {
    value = 0;
    contact = off;
  }
  constexpr void reset() noexcept { *this = Counter{}; }
};

struct LongCounter {
  dword value = 0;
  bit contact{};
  bit coil{};
  bit reset_coil{};
  dword preset = 0;  ///< of the last execution; high-speed counters compare between scans

  /// C200-C234: a pulse counts one up or, with the direction relay ON, down; the value is a ring.
  constexpr void count(bit pulse, dword set, bit down) noexcept {
    coil = pulse;
    preset = set;
    if (pulse & !reset_coil)
      step(down);
  }
  /// One count. The contact closes on the way up to the set value and opens on the way down from it.
  constexpr void step(bit down) noexcept {
    const dword before = value;
    value = to_dword(down ? pattern_of(before) - 1U : pattern_of(before) + 1U);
    if (!down && value == preset)
      contact = on;
    else if (down && before == preset)
      contact = off;
  }
  template <class System> constexpr void drive_reset(bit condition, const System &) noexcept {
    reset_coil = condition;
    if (condition)
      clear();
  }
  constexpr void clear() noexcept {
    value = 0;
    contact = off;
  }
  constexpr void reset() noexcept { *this = LongCounter{}; }
};

/// Counters 0 to N - 1.
template <unsigned N> class Counters {
public:
  static constexpr unsigned kPoints = N;

  constexpr Counter &operator[](unsigned number) noexcept { return counters_[number]; }
  constexpr const Counter &operator[](unsigned number) const noexcept { return counters_[number]; }
  static constexpr bool has(unsigned number, unsigned count = 1) noexcept { return number < N && count <= N - number; }
  constexpr ValueBlock<Counter> block(unsigned first) noexcept { return {counters_, first, N}; }
  constexpr ValuePairBlock<Counter> dblock(unsigned first) noexcept { return {counters_, first, N}; }
  constexpr void clear() noexcept {
    for (Counter &counter : counters_)
      counter.reset();
  }
  constexpr void clear(unsigned first, unsigned last) noexcept {
    for (unsigned number = first; number <= last; ++number)
      counters_[number].reset();
  }

private:
  Counter counters_[N] = {};
};

/// 32-bit counters 0 to N - 1; images of controllers number them from 200 on (Numbered).
template <unsigned N> class LongCounters {
public:
  static constexpr unsigned kPoints = N;

  constexpr LongCounter &operator[](unsigned number) noexcept { return counters_[number]; }
  constexpr const LongCounter &operator[](unsigned number) const noexcept { return counters_[number]; }
  static constexpr bool has(unsigned number, unsigned count = 1) noexcept { return number < N && count <= N - number; }
  constexpr LongValueBlock<LongCounter> dblock(unsigned first) noexcept { return {counters_, first, N}; }
  constexpr void clear() noexcept {
    for (LongCounter &counter : counters_)
      counter.reset();
  }
  constexpr void clear(unsigned first, unsigned last) noexcept {
    for (unsigned number = first; number <= last; ++number)
      counters_[number].reset();
  }

private:
  LongCounter counters_[N] = {};
};

}  // namespace ladder::tp03
