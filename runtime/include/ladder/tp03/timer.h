// Timers of the TP03: each measures its own time since its coil came ON.
//
// The clock of a timer is looked at only where its coil instruction is executed: it advances by the time since the scan before, and
// its contact switches there. An execution that finds the coil newly ON starts at 0, a second one in the same scan does not
// advance, and the first one after scans in which it was skipped goes on where it stood. Only the timers for routines (T192-T199)
// and the accumulating ones of 1 ms (T246-T249) keep time by themselves, see System.
//
// A set value of 0 or below closes the contact at the coil instruction of the next scan.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/number.h"

#include <cstdint>

namespace ladder::tp03 {

struct Timer {
  word value = 0;  ///< whole units
  bit contact{};
  bit coil{};
  std::uint32_t rest_us = 0;  ///< time beyond the whole units
  word preset = 0;            ///< of the last execution, for timers that keep time by themselves
  std::uint16_t scan = 0;     ///< number of the scan that the time is kept up to

  /// 100 ms, 10 ms and 1 ms timers: coil OFF clears value and contact.
  template <class System> constexpr void on_delay_100ms(bit condition, word set, const System &sys) noexcept {
    on_delay<100000>(condition, set, sys);
  }
  template <class System> constexpr void on_delay_10ms(bit condition, word set, const System &sys) noexcept {
    on_delay<10000>(condition, set, sys);
  }
  template <class System> constexpr void on_delay_1ms(bit condition, word set, const System &sys) noexcept {
    on_delay<1000>(condition, set, sys);
  }
  /// Accumulating timers: coil OFF holds value and contact, only reset() clears them.
  template <class System> constexpr void accumulate_100ms(bit condition, word set, const System &sys) noexcept {
    accumulate<100000>(condition, set, sys);
  }
  /// T246-T249: the value has been kept by advance(); here the contact switches.
  template <class System> constexpr void accumulate_1ms(bit condition, word set, const System &sys) noexcept {
    const std::uint16_t now = static_cast<std::uint16_t>(sys.scan_number());
    preset = set;
    if (condition & coil & bit(now != scan) & bit(value >= limit()))
      contact = on;
    coil = condition;
    scan = now;
  }

  // Timers are OFF or have expired in most scans: only that stands in the program, the rest is a call.
  template <std::uint32_t Unit, class System> constexpr void on_delay(bit condition, word set, const System &sys) noexcept {
    if (!condition)
      reset();
    else if (!contact)  // expired, the coil is ON already
      measure<Unit>(set, sys);
  }

  template <std::uint32_t Unit, class System> constexpr void accumulate(bit condition, word set, const System &sys) noexcept {
    if (condition)
      measure<Unit>(set, sys);
    else
      coil = off;
  }

  /// The coil is ON. One copy for all timers of a unit, because programs have hundreds of them.
  template <std::uint32_t Unit, class System> [[gnu::noinline]] constexpr void measure(word set, const System &sys) noexcept {
    if (contact) {
      coil = on;
      return;
    }
    const std::uint16_t now = static_cast<std::uint16_t>(sys.scan_number());
    const std::uint16_t passed = static_cast<std::uint16_t>(now - scan);
    const bool running = static_cast<bool>(coil);
    preset = set;
    scan = now;
    coil = on;
    if (running && passed != 0)
      advance<Unit>(passed == 1 ? sys.elapsed_us() : 0, true);
  }

  /// Time passes. Timers that keep time by themselves close their contact elsewhere.
  template <std::uint32_t Unit> constexpr void advance(std::uint32_t elapsed_us, bool switches) noexcept {
    if (contact)
      return;
    const dword last = limit();
    dword reached = value;
    if (elapsed_us < Unit - rest_us) {  // most scans are shorter than a unit: no division
      rest_us += elapsed_us;
      if (!switches || reached < last)
        return;
    } else {
      const std::uint32_t after_first = elapsed_us - (Unit - rest_us);
      reached += static_cast<dword>(after_first / Unit + 1);
      rest_us = after_first % Unit;
    }
    if (reached >= last) {
      reached = last;  // also where the program has written more
      contact |= bit(switches);
    }
    value = static_cast<word>(reached);
  }

  constexpr void reset() noexcept {
    value = 0;
    contact = off;
    coil = off;
    rest_us = 0;
  }

  constexpr word limit() const noexcept { return preset > 0 ? preset : word{0}; }
};

/// Timers 0 to N - 1.
template <unsigned N> class Timers {
public:
  static constexpr unsigned kPoints = N;

  constexpr Timer &operator[](unsigned number) noexcept { return timers_[number]; }
  constexpr const Timer &operator[](unsigned number) const noexcept { return timers_[number]; }
  static constexpr bool has(unsigned number, unsigned count = 1) noexcept { return number < N && count <= N - number; }
  /// The current values from `first` on.
  constexpr ValueBlock<Timer> block(unsigned first) noexcept { return {timers_, first, N}; }
  constexpr ValuePairBlock<Timer> dblock(unsigned first) noexcept { return {timers_, first, N}; }
  constexpr void clear() noexcept {
    for (Timer &timer : timers_)
      timer.reset();
  }
  constexpr void clear(unsigned first, unsigned last) noexcept {
    for (unsigned number = first; number <= last; ++number)
      timers_[number].reset();
  }

private:
  Timer timers_[N] = {};
};

}  // namespace ladder::tp03
