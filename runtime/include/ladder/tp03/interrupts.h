// Requests of interrupt routines: who waits, who is next.
//
// A request is the number of a pointer: I<n>0<e> is n * 100 + e, I6xx and its kind 600 + xx, I010-I060 10 to 60. The program asks
// for the next one at places where it can be interrupted. Earlier requests go first, of those at one time the one with the lower
// number.
//
// Requests that cannot be served, because interrupts are disabled or a routine runs, wait; eight find a place, further ones are
// lost. A timer that ran out several times in one long scan is served as often: on a controller its routine would have run in
// between.
#pragma once

#include "ladder/bit.h"
#include "ladder/tp03/parameters.h"

#include <cstdint>

namespace ladder::tp03 {

class Interrupts {
public:
  static constexpr unsigned kWaiting = 8;
  static constexpr unsigned kTimers = 3;
  static constexpr unsigned kInputInhibit = 8050, kTimerInhibit = 8056, kCounterInhibit = 8059;  ///< M

  /// The change to RUN: disabled, nobody waits, timers begin.
  constexpr void restart(const Parameters &parameters) noexcept {
    *this = Interrupts{};
    for (unsigned i = 0; i < kTimers; ++i) {
      const std::uint32_t ms = parameters.timer_interrupts_ms[i];
      timers_[i].period_us = ms <= 99 ? ms * 1000 : 0;
      timers_[i].pointer = static_cast<std::uint16_t>(600 + 100 * i + (ms <= 99 ? ms : 0));
    }
    edges_ = parameters.input_interrupts;
  }

  constexpr void enable() noexcept { enabled_ = true; }
  constexpr void disable() noexcept { enabled_ = false; }
  /// Between a next() that gave a pointer and the one after it.
  constexpr bool routine_running() const noexcept { return running_; }

  /// A terminal went ON or OFF.
  template <class M> void edge(unsigned input, bool state, const M &m) noexcept {
    const std::uint32_t edges = edges_;
    if (input < 6 && (edges >> (2 * input + state) & 1U) != 0)
      raise(input * 100 + state, m);
  }
  template <class M> void raise(unsigned pointer, const M &m) noexcept {
    if (!m[inhibit_of(pointer)])
      hold(pointer);
  }

  /// Time passes, before the inputs of the scan are looked at.
  template <class M> void advance(std::uint32_t elapsed_us, const M &m) noexcept {
    hold_timers(m);  // of the scan before, which did not ask
    for (Timer &timer : timers_)
      if (timer.period_us != 0)
        timer.since_us = elapsed_us > ~timer.since_us ? ~std::uint32_t{0} : timer.since_us + elapsed_us;
    if (!enabled_)
      hold_timers(m);
    older_ = count_;
  }

  /// The pointer of the next routine, or -1. The routine given before has ended.
  template <class M> int next(const M &m) noexcept {
    running_ = false;
    if (!enabled_)
      return -1;
    int pointer = -1;
    if (older_ > 0) {
      --older_;
      pointer = first();
    } else {
      pointer = due(m);
      if (pointer < 0 && count_ > 0)
        pointer = first();
    }
    running_ = pointer >= 0;
    return pointer;
  }

private:
  struct Timer {
    std::uint32_t period_us = 0;  ///< 0: not used
    std::uint32_t since_us = 0;   ///< time since it ran out last; a whole period and more: it is due
    std::uint16_t pointer = 0;
  };

  static constexpr unsigned inhibit_of(unsigned pointer) noexcept {
    if (pointer >= 600)
      return kTimerInhibit + (pointer < 800 ? (pointer - 600) / 100 : 2);
    return pointer % 100 <= 1 ? kInputInhibit + pointer / 100 : kCounterInhibit;
  }

  void hold(unsigned pointer) noexcept {
    if (count_ < kWaiting)
      waiting_[count_++] = static_cast<std::uint16_t>(pointer);
  }
  int first() noexcept {
    const int pointer = waiting_[0];
    --count_;
    for (unsigned i = 0; i < count_; ++i)
      waiting_[i] = waiting_[i + 1];
    return pointer;
  }

  /// The timer that ran out first, or -1.
  template <class M> int due(const M &m) noexcept {
    for (unsigned i = 0; i < kTimers; ++i)
      if (timers_[i].period_us != 0 && m[kTimerInhibit + i])
        timers_[i].since_us %= timers_[i].period_us;
    Timer *oldest = nullptr;
    for (Timer &timer : timers_)
      if (timer.period_us != 0 && timer.since_us >= timer.period_us &&
          (oldest == nullptr || timer.since_us - timer.period_us > oldest->since_us - oldest->period_us))
        oldest = &timer;
    if (oldest == nullptr)
      return -1;
    oldest->since_us -= oldest->period_us;
    return oldest->pointer;
  }
  template <class M> void hold_timers(const M &m) noexcept {
    while (count_ < kWaiting) {
      const int pointer = due(m);
      if (pointer < 0)
        break;
      hold(static_cast<unsigned>(pointer));
    }
    for (Timer &timer : timers_)
      if (timer.period_us != 0)
        timer.since_us %= timer.period_us;
  }

  Timer timers_[kTimers] = {};
  std::uint16_t waiting_[kWaiting] = {};
  std::uint16_t edges_ = 0;
  std::uint8_t count_ = 0;
  std::uint8_t older_ = 0;  ///< so many of those that wait came before the timers that are due now
  bool enabled_ = false, running_ = false;
};

}  // namespace ladder::tp03
