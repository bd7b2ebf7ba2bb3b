// What the system makes of the host's clock: timer ticks, clock relays, seconds.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"

#include <cstdint>

namespace ladder::melsec_qs {

/// Whole units of elapsed time; what is short of a unit is carried to the next scan.
class TickCounter {
public:
  constexpr void restart(std::uint32_t unit_us) noexcept {
    unit_us_ = unit_us;
    rest_us_ = 0;
    ticks_ = 0;
  }
  constexpr void advance(std::uint32_t elapsed_us) noexcept {
    if (elapsed_us < unit_us_ - rest_us_) {  // most scans are shorter than a unit: no division
      rest_us_ += elapsed_us;
      ticks_ = 0;
      return;
    }
    const std::uint32_t after_first = elapsed_us - (unit_us_ - rest_us_);
    const std::uint32_t more = after_first / unit_us_;
    rest_us_ = after_first % unit_us_;
    ticks_ = more >= 32767 ? word{32767} : static_cast<word>(more + 1);  // a timer holds no more
  }
  constexpr word ticks() const noexcept { return ticks_; }
  constexpr std::uint32_t unit_us() const noexcept { return unit_us_; }

private:
  std::uint32_t unit_us_ = 1, rest_us_ = 0;
  word ticks_ = 0;
};

/// Splits elapsed time into seconds.
class SecondCounter {
public:
  constexpr void restart() noexcept { rest_us_ = 0; }
  /// The number of seconds that ended.
  constexpr std::uint32_t advance(std::uint32_t elapsed_us) noexcept {
    if (elapsed_us < kSecond - rest_us_) {
      rest_us_ += elapsed_us;
      return 0;
    }
    const std::uint32_t after_first = elapsed_us - (kSecond - rest_us_);
    rest_us_ = after_first % kSecond;
    return after_first / kSecond + 1;
  }
  /// Microseconds since the last second ended.
  constexpr std::uint32_t rest_us() const noexcept { return rest_us_; }

private:
  static constexpr std::uint32_t kSecond = 1000000;

  std::uint32_t rest_us_ = 0;
};

/// SM414: n seconds OFF, n seconds ON. The relay stands still while n is below 1, which the register's range excludes.
class Flicker {
public:
  constexpr void restart() noexcept { *this = Flicker{}; }
  constexpr void second_passed(word n) noexcept {
    if (n < 1)
      return;
    if (++seconds_ >= n) {
      seconds_ = 0;
      state_ = !state_;
    }
  }
  constexpr bit state() const noexcept { return state_; }

private:
  dword seconds_ = 0;
  bit state_{};
};

}  // namespace ladder::melsec_qs
