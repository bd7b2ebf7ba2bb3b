// Date arithmetic of a controller's clock: 1980 to 2079, one second at a time.
#pragma once

#include "ladder/scan_types.h"

#include <cstdint>

namespace ladder::calendar {

inline constexpr std::uint16_t kFirstYear = 1980;
inline constexpr std::uint16_t kLastYear = 2079;

constexpr bool is_leap(unsigned year) noexcept {
  return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
}

/// Days of month 1-12.
constexpr unsigned days_in_month(unsigned year, unsigned month) noexcept {
  if (month == 2)
    return is_leap(year) ? 29 : 28;
  return month == 4 || month == 6 || month == 9 || month == 11 ? 30 : 31;
}

/// 0 Sunday to 6 Saturday, of a date of the Gregorian calendar with month 1-12.
constexpr unsigned weekday_of(unsigned year, unsigned month, unsigned day) noexcept {
  // Counted from March the leap day is the last of its year, and the months' lengths grow by a regular pattern.
  const unsigned years = month < 3 ? year - 1 : year;
  const unsigned months = (month + 9) % 12;
  const unsigned days = 365 * years + years / 4 - years / 100 + years / 400 + (153 * months + 2) / 5 + day;
  return (days + 2) % 7;
}

/// Whether all fields but the weekday are a point in time that the clock can hold.
constexpr bool is_valid(const Calendar &time) noexcept {
  return time.year >= kFirstYear && time.year <= kLastYear && time.month >= 1 && time.month <= 12 && time.day >= 1 &&
         time.day <= days_in_month(time.year, time.month) && time.hour < 24 && time.minute < 60 && time.second < 60;
}

/// Midnight of 1 January 2000, where a clock that was never set starts.
inline constexpr Calendar kUnset{2000, 1, 1, 0, 0, 0, 6};

/// One second later. The end of 2079 is followed by 1980.
constexpr void tick(Calendar &time) noexcept {
  if (++time.second < 60)
    return;
  time.second = 0;
  if (++time.minute < 60)
    return;
  time.minute = 0;
  if (++time.hour < 24)
    return;
  time.hour = 0;
  if (++time.day > days_in_month(time.year, time.month)) {
    time.day = 1;
    if (++time.month > 12) {
      time.month = 1;
      time.year = time.year >= kLastYear ? kFirstYear : static_cast<std::uint16_t>(time.year + 1);
    }
  }
  time.weekday = static_cast<std::uint8_t>(weekday_of(time.year, time.month, time.day));
}

/// Two BCD digits of 0-99.
constexpr unsigned bcd2(unsigned value) noexcept {
  return value + 6 * (value / 10);
}

}  // namespace ladder::calendar
