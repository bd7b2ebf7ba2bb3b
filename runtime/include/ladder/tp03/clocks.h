// What the system makes of the host's clock: clock relays, scan times, the real-time clock.
//
// All of it goes on in STOP. Where the manual is silent:
// * The clock relays are OFF in the first half of their period, begin at power-on, and are looked at once a scan.
// * The weekday follows from the date, whatever was written to D8019.
// * The real-time clock survives power-off; one that was never set starts at the beginning of 2000.
#pragma once

#include "ladder/bit.h"
#include "ladder/calendar.h"
#include "ladder/number.h"
#include "ladder/scan_types.h"

#include <cstdint>

namespace ladder::tp03 {

/// M8011-M8014: 10 ms, 100 ms, 1 s and 1 min.
class ClockRelays {
public:
  constexpr void restart() noexcept { us_ = 0; }
  template <class M> void advance(std::uint32_t elapsed_us, M &m) noexcept {
    us_ += elapsed_us % kMinute;  // below two minutes, far from the end of the type
    us_ %= kMinute;
    m[8011] = second_half<10000>();
    m[8012] = second_half<100000>();
    m[8013] = second_half<1000000>();
    m[8014] = second_half<kMinute>();
  }

private:
  static constexpr std::uint32_t kMinute = 60000000;

  template <std::uint32_t Period> constexpr bit second_half() const noexcept { return bit(us_ % Period >= Period / 2); }

  std::uint32_t us_ = 0;  ///< since the last whole minute
};

/// D8010-D8012: last, shortest and longest scan since RUN in units of 0.1 ms, from the beginning of one scan to that of the next,
/// so that the waiting of a constant scan counts.
class ScanTimes {
public:
  constexpr void restart() noexcept { *this = ScanTimes{}; }
  template <class D> void measure(std::uint32_t us, D &d) noexcept {
    if (us < shortest_us_)
      shortest_us_ = us;
    if (us > longest_us_)
      longest_us_ = us;
    d[8010] = tenths(us);
    d[8011] = tenths(shortest_us_);
    d[8012] = tenths(longest_us_);
  }

private:
  static constexpr word tenths(std::uint32_t us) noexcept { return us < 3276700 ? static_cast<word>(us / 100) : word{32767}; }

  std::uint32_t shortest_us_ = 0xFFFFFFFFU, longest_us_ = 0;
};

/// The real-time clock, D8013-D8019 and M8015.
///
/// M8015 OFF: the registers show the clock. ON: the clock stands, the registers are the program's; when it goes OFF again they
/// become the time, unless there is no such date.
class RealTimeClock {
public:
  static constexpr std::uint16_t kFirstYear = 2000, kLastYear = 2099;

  constexpr const Calendar &now() const noexcept { return now_; }

  constexpr bool set(Calendar time) noexcept {
    if (time.year < kFirstYear || time.year > kLastYear || !is_valid(time))
      return false;
    time.weekday = static_cast<std::uint8_t>(calendar::weekday_of(time.year, time.month, time.day));
    now_ = time;
    rest_us_ = 0;
    return true;
  }

  constexpr void advance(std::uint32_t elapsed_us) noexcept {
    if (setting_)
      return;
    std::uint32_t seconds = elapsed_us / kSecond;
    rest_us_ += elapsed_us % kSecond;
    if (rest_us_ >= kSecond) {
      rest_us_ -= kSecond;
      ++seconds;
    }
    for (; seconds > 0; --seconds)
      tick();
  }

  /// Before and after the program: looks at M8015, fills or takes the registers.
  template <class M, class D> void exchange(const M &m, D &d) noexcept {
    if (m[8015]) {
      setting_ = true;
      return;
    }
    if (setting_) {
      setting_ = false;
      take(d);
    }
    show(d);
  }

  template <class D> void show(D &d) const noexcept {
    d[8013] = now_.second;
    d[8014] = now_.minute;
    d[8015] = now_.hour;
    d[8016] = now_.day;
    d[8017] = now_.month;
    d[8018] = static_cast<word>(now_.year);
    d[8019] = now_.weekday;
  }

  /// M8015 is cleared with the other relays at power-on: what was begun before is void.
  constexpr void forget_setting() noexcept { setting_ = false; }

private:
  static constexpr std::uint32_t kSecond = 1000000;

  /// calendar::is_valid() knows years up to 2079; leap years repeat after 80 of them until 2099.
  static constexpr bool is_valid(Calendar time) noexcept {
    if (time.year > calendar::kLastYear)
      time.year = static_cast<std::uint16_t>(time.year - 80);
    return calendar::is_valid(time);
  }

  constexpr void tick() noexcept {
    const std::uint16_t year = now_.year;
    calendar::tick(now_);
    if (now_.year >= kFirstYear)
      return;
    now_.year = year < kLastYear ? static_cast<std::uint16_t>(year + 1) : kFirstYear;  // calendar::tick() goes from 2079 to 1980
    now_.weekday = static_cast<std::uint8_t>(calendar::weekday_of(now_.year, now_.month, now_.day));
  }

  template <class D> void take(const D &d) noexcept {
    for (unsigned number = 8013; number <= 8017; ++number)
      if (d[number] < 0 || d[number] > 59)  // fits the fields; set() knows the rest
        return;
    const auto field = [&d](unsigned number) { return static_cast<std::uint8_t>(d[number]); };
    set({static_cast<std::uint16_t>(d[8018]), field(8017), field(8016), field(8015), field(8014), field(8013), 0});
  }

  Calendar now_ = calendar::kUnset;
  std::uint32_t rest_us_ = 0;  ///< since the last whole second
  bool setting_ = false;       ///< M8015 was ON
};

}  // namespace ladder::tp03
