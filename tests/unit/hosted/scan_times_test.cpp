// Statistics of durations.
#include "hosted/scan_times.h"

#include <gtest/gtest.h>

namespace ladder::hosted::test {
namespace {

TEST(ScanTimes, NothingMeasuredIsZero) {
  ScanTimes times;
  EXPECT_EQ(times.scans(), 0u);
  EXPECT_EQ(times.min(), 0);
  EXPECT_EQ(times.median(), 0);
  EXPECT_EQ(times.max(), 0);
  EXPECT_EQ(times.mean(), 0);
}

TEST(ScanTimes, ExtremesAndMeanAreExact) {
  ScanTimes times;
  for (std::uint64_t nanoseconds : {7u, 1'000'003u, 50u})
    times.add(nanoseconds * 1000);
  EXPECT_EQ(times.scans(), 3u);
  EXPECT_EQ(times.min(), 7);
  EXPECT_EQ(times.max(), 1'000'003);
  EXPECT_DOUBLE_EQ(times.mean(), 1'000'060.0 / 3);
  EXPECT_NEAR(times.median(), 50, 0.25);
}

TEST(ScanTimes, TheMedianIsWithinHalfAPercentAtEveryMagnitude) {
  for (std::uint64_t value = 1; value < std::uint64_t{1} << 60; value *= 3) {
    ScanTimes times;
    times.add(0);
    times.add(value, 3);
    times.add(value * 4);
    EXPECT_NEAR(times.median() * 1000, static_cast<double>(value), static_cast<double>(value) * 0.005);
  }
}

TEST(ScanTimes, TheLargestValueHasABucket) {
  ScanTimes times;
  times.add(UINT64_MAX);
  EXPECT_EQ(times.median(), times.max());
}

TEST(ScanTimes, ABatchCountsAsItsScans) {
  ScanTimes times;
  times.add(10'000, 99);
  times.add(90'000, 1);
  EXPECT_EQ(times.scans(), 100u);
  EXPECT_DOUBLE_EQ(times.mean(), 10.8);
  EXPECT_NEAR(times.median(), 10, 0.05);
}

}  // namespace
}  // namespace ladder::hosted::test
