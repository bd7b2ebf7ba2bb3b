// Times of day as three words (hour, minute, second), and the controller's clock as seven.
#pragma once

#include "ladder/bit.h"
#include "ladder/calendar.h"
#include "ladder/number.h"
#include "ladder/scan_types.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/ops/arith.h"

#include <cstdint>

namespace ladder::tp03 {
namespace time_of_day {

inline constexpr dword kDay = 86400;

/// Seconds since midnight, or -1 for what is no time of day.
constexpr dword seconds(word hour, word minute, word second) noexcept {
  if (hour < 0 || hour > 23 || minute < 0 || minute > 59 || second < 0 || second > 59)
    return -1;
  return hour * dword{3600} + minute * 60 + second;
}
template <class Block> constexpr dword read(const Block &block) noexcept {
  return seconds(block.get(0), block.get(1), block.get(2));
}
template <class Block> constexpr void write(const Block &block, dword seconds) noexcept {
  block.set(0, static_cast<word>(seconds / 3600));
  block.set(1, static_cast<word>(seconds / 60 % 60));
  block.set(2, static_cast<word>(seconds % 60));
}

}  // namespace time_of_day

/// F160 TCMP: D is hour:minute:second later than the time in S, D+1 equal, D+2 earlier.
template <class Block, class Run, class S> Fault tcmp(word hour, word minute, word second, Block source, Run d, S &) noexcept {
  const dword given = time_of_day::seconds(hour, minute, second);
  const dword time = time_of_day::read(source);
  if (given < 0 || time < 0)
    return Fault::Range;
  return detail::write_order(d, given > time, given < time);
}

/// F161 TZCP: D is before the zone, D+1 inside, limits included, D+2 behind. A lower limit later than the upper one is both.
template <class Low, class High, class Block, class Run, class S>
Fault tzcp(Low lower, High upper, Block source, Run d, S &) noexcept {
  const dword low = time_of_day::read(lower);
  const dword high = time_of_day::read(upper);
  const dword time = time_of_day::read(source);
  if (low < 0 || high < 0 || time < 0)
    return Fault::Range;
  const bool before = time < low;
  return detail::write_order(d, before, time > (high < low ? low : high));
}

/// F162 TADD: a sum of 24 hours or more goes on at 0:00:00, with M8022. M8020 tells 0:00:00.
template <class First, class Second, class Block, class S>
constexpr Fault tadd(First first, Second second, Block d, S &sys) noexcept {
  const dword a = time_of_day::read(first);
  const dword b = time_of_day::read(second);
  if (a < 0 || b < 0)
    return Fault::Range;
  const bool carry = a + b >= time_of_day::kDay;
  const dword sum = carry ? a + b - time_of_day::kDay : a + b;
  time_of_day::write(d, sum);
  sys.M[8020] = bit(sum == 0);
  sys.M[8022] = bit(carry);
  return Fault::None;
}

/// F163 TSUB: a difference below 0 gets 24 hours, with M8022. M8020 tells 0:00:00.
template <class First, class Second, class Block, class S>
constexpr Fault tsub(First first, Second second, Block d, S &sys) noexcept {
  const dword a = time_of_day::read(first);
  const dword b = time_of_day::read(second);
  if (a < 0 || b < 0)
    return Fault::Range;
  const bool below = a < b;
  const dword difference = below ? a - b + time_of_day::kDay : a - b;
  time_of_day::write(d, difference);
  sys.M[8020] = bit(difference == 0);
  sys.M[8022] = bit(below);
  return Fault::None;
}

/// F166 TRD: year, month, day, hour, minute, second, weekday.
template <class Block, class S> constexpr void trd(Block d, S &sys) noexcept {
  const Calendar now = sys.calendar();
  d.set(0, static_cast<word>(now.year));
  d.set(1, now.month);
  d.set(2, now.day);
  d.set(3, now.hour);
  d.set(4, now.minute);
  d.set(5, now.second);
  d.set(6, now.weekday);
}

/// F167 TWR: the same seven words into the clock. Fails where they are no date of 2000 to 2099, no time of day or no weekday.
template <class Block, class S> constexpr Fault twr(Block source, S &sys) noexcept {
  const word year = source.get(0), month = source.get(1), day = source.get(2), weekday = source.get(6);
  const bool date = year >= 2000 && year <= 2099 && month >= 1 && month <= 12 && day >= 1 &&
                    day <= static_cast<word>(calendar::days_in_month(static_cast<unsigned>(year), static_cast<unsigned>(month)));
  if (!date || weekday < 0 || weekday > 6 || time_of_day::seconds(source.get(3), source.get(4), source.get(5)) < 0)
    return Fault::Range;
  const auto byte = [](word value) constexpr noexcept {
    return static_cast<std::uint8_t>(value);
  };
  const Calendar time{static_cast<std::uint16_t>(year),
                      byte(month),
                      byte(day),
                      byte(source.get(3)),
                      byte(source.get(4)),
                      byte(source.get(5)),
                      byte(weekday)};
  return sys.set_calendar(time) ? Fault::None : Fault::Range;
}

}  // namespace ladder::tp03
