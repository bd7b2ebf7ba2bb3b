// Dates from 1980 to 2079.
#include "ladder/calendar.h"

#include <gtest/gtest.h>

using namespace ladder;
using namespace ladder::calendar;

namespace {

Calendar after(Calendar time) {
  tick(time);
  return time;
}

void expect_time(const Calendar &t, int year, int month, int day, int hour, int minute, int second, int weekday) {
  EXPECT_EQ(t.year, year);
  EXPECT_EQ(t.month, month);
  EXPECT_EQ(t.day, day);
  EXPECT_EQ(t.hour, hour);
  EXPECT_EQ(t.minute, minute);
  EXPECT_EQ(t.second, second);
  EXPECT_EQ(t.weekday, weekday);
}

}  // namespace

TEST(Calendar, LeapYears) {
  static_assert(is_leap(2000) && is_leap(2024) && is_leap(1980));
  static_assert(!is_leap(1900) && !is_leap(2100) && !is_leap(2023));
  EXPECT_EQ(days_in_month(2024, 2), 29u);
  EXPECT_EQ(days_in_month(2023, 2), 28u);
  unsigned days = 0;
  for (unsigned month = 1; month <= 12; ++month)
    days += days_in_month(2023, month);
  EXPECT_EQ(days, 365u);
}

TEST(Calendar, KnownWeekdays) {
  static_assert(weekday_of(2000, 1, 1) == 6);
  EXPECT_EQ(weekday_of(2006, 9, 25), 1u);
  EXPECT_EQ(weekday_of(2024, 2, 29), 4u);
  EXPECT_EQ(weekday_of(1980, 1, 1), 2u);
  EXPECT_EQ(weekday_of(2079, 12, 31), 0u);
}

TEST(Calendar, WeekdaysFollowEachOtherForAHundredYears) {
  Calendar day{kFirstYear, 1, 1, 23, 59, 59, 2};
  unsigned weekday = day.weekday;
  unsigned days = 0;
  while (!(day.year == kLastYear && day.month == 12 && day.day == 31)) {
    tick(day);
    weekday = (weekday + 1) % 7;
    ++days;
    ASSERT_EQ(day.weekday, weekday) << day.year << "-" << int{day.month} << "-" << int{day.day};
    ASSERT_TRUE(is_valid(day));
    day.hour = 23;
    day.minute = 59;
    day.second = 59;
  }
  EXPECT_EQ(days, 36524u) << "100 years with 25 leap days, less the first day";
}

TEST(Calendar, CarriesFromSecondsToYears) {
  expect_time(after({2024, 5, 6, 7, 8, 9, 1}), 2024, 5, 6, 7, 8, 10, 1);
  expect_time(after({2024, 5, 6, 7, 8, 59, 1}), 2024, 5, 6, 7, 9, 0, 1);
  expect_time(after({2024, 5, 6, 7, 59, 59, 1}), 2024, 5, 6, 8, 0, 0, 1);
  expect_time(after({2024, 2, 28, 23, 59, 59, 3}), 2024, 2, 29, 0, 0, 0, 4);
  expect_time(after({2024, 2, 29, 23, 59, 59, 4}), 2024, 3, 1, 0, 0, 0, 5);
  expect_time(after({2023, 12, 31, 23, 59, 59, 0}), 2024, 1, 1, 0, 0, 0, 1);
  expect_time(after({2079, 12, 31, 23, 59, 59, 0}), 1980, 1, 1, 0, 0, 0, 2);
}

TEST(Calendar, RefusesWhatIsNoTime) {
  EXPECT_TRUE(is_valid({2024, 2, 29, 23, 59, 59, 0}));
  EXPECT_FALSE(is_valid({2023, 2, 29, 0, 0, 0, 0}));
  EXPECT_FALSE(is_valid({1979, 1, 1, 0, 0, 0, 0}));
  EXPECT_FALSE(is_valid({2080, 1, 1, 0, 0, 0, 0}));
  EXPECT_FALSE(is_valid({2024, 0, 1, 0, 0, 0, 0}));
  EXPECT_FALSE(is_valid({2024, 13, 1, 0, 0, 0, 0}));
  EXPECT_FALSE(is_valid({2024, 1, 0, 0, 0, 0, 0}));
  EXPECT_FALSE(is_valid({2024, 1, 1, 24, 0, 0, 0}));
  EXPECT_FALSE(is_valid({2024, 1, 1, 0, 60, 0, 0}));
  EXPECT_FALSE(is_valid({2024, 1, 1, 0, 0, 60, 0}));
}

TEST(Calendar, TwoDigitsOfBcd) {
  EXPECT_EQ(bcd2(0), 0x00u);
  EXPECT_EQ(bcd2(9), 0x09u);
  EXPECT_EQ(bcd2(10), 0x10u);
  EXPECT_EQ(bcd2(99), 0x99u);
}
