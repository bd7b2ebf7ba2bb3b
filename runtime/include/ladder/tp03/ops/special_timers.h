// Timers inside instructions: F46 ANS, F64 TTMR, F65 STMR.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/timer.h"

#include <cstdint>

namespace ladder::tp03 {

/// An annunciator comes ON when its cause has lasted for m x 100 ms, and stays ON. The timer does all of it, so nothing is kept
/// here.
struct ans {
  template <class Target, class S> Fault run(bit condition, Timer &timer, word m, Target d, S &sys) noexcept {
    if (condition & bit(d.first() < 900 || d.first() > 999))
      return Fault::Range;
    timer.on_delay_100ms(condition, m, sys);
    if (timer.contact)
      d.set(0, on);
    return Fault::None;
  }
};

/// The time that a button is held: in D + 1 as units of 100 ms, in D as seconds x 10^n. Both stop at 32767.
struct ttmr {
  bit driven{};
  std::uint32_t last_us = 0;  ///< when it was measured last
  std::uint32_t rest_us = 0;  ///< beyond whole hundredths
  std::uint32_t hundredths = 0;

  template <class Target, class S> Fault run(bit condition, Target d, word n, S &sys) noexcept {
    const bit before = driven;
    driven = condition;
    if (condition & bit(n < 0 || n > 2 || d.points() < 2))
      return Fault::Range;
    if (!condition) {
      if (before | sys.first_scan())  // D + 1 may be latched
        d.set(1, 0);
      return Fault::None;
    }
    const std::uint32_t now = sys.now_us();
    if (before & !sys.first_scan())
      pass(now - last_us);
    else
      hundredths = rest_us = 0;
    last_us = now;
    d.set(1, limited(hundredths / 10));
    d.set(0, limited(n == 0 ? hundredths / 100 : n == 1 ? hundredths / 10 : hundredths));
    return Fault::None;
  }

private:
  static constexpr std::uint32_t kMost = 327679;  ///< hundredths beyond which no register tells more

  void pass(std::uint32_t elapsed_us) noexcept {
    if (elapsed_us < 10000U - rest_us) {
      rest_us += elapsed_us;
      return;
    }
    const std::uint32_t after_first = elapsed_us - (10000U - rest_us);
    const std::uint32_t total = hundredths + after_first / 10000U + 1;
    hundredths = total < kMost ? total : kMost;
    rest_us = after_first % 10000U;
  }
  static constexpr word limited(std::uint32_t value) noexcept { return to_word(value < 32767 ? value : 32767U); }
};

/// Four outputs made of one condition and one timer, which runs m x 100 ms after each change of the condition. The chart is not in
/// the manual; D + 2 and D + 3 follow its use for flicker: D + 3 opens the condition, and D + 1 and D + 2 take turns.
struct stmr {
  bit driven{};
  bit released{};  ///< the time after the condition went OFF is running
  bit delayed{};   ///< D + 3

  template <class Outputs, class S> Fault run(bit condition, Timer &timer, word m, Outputs d, S &sys) noexcept {
    if (sys.first_scan())
      *this = stmr{};
    if (m < 1 || d.points() < 4)
      return condition ? Fault::Range : Fault::None;
    if (condition != driven) {
      driven = condition;
      released = !condition;
      timer.on_delay_100ms(off, m, sys);
    }
    timer.on_delay_100ms(condition | released, m, sys);
    const bit over = timer.contact;
    delayed |= condition & over;
    if (over & !condition) {
      delayed = released = off;
      timer.on_delay_100ms(off, m, sys);
    }
    d.set(0, condition | released);
    d.set(1, released);
    d.set(2, condition & !over);
    d.set(3, delayed);
    return Fault::None;
  }
};

}  // namespace ladder::tp03
