// Durations of scans: minimum, maximum, mean and median of any number of them in a fixed amount of memory.
//
// A histogram whose buckets grow with the value (128 to each power of two) gives the median within half a percent; the others are
// exact. Picoseconds, because a mean over a batch of short scans is not a whole number of nanoseconds.
#pragma once

#include <cstdint>
#include <vector>

namespace ladder::hosted {

class ScanTimes {
public:
  void add(std::uint64_t picoseconds, std::uint64_t scans = 1);

  /// Nanoseconds; 0 when nothing was added.
  double min() const { return static_cast<double>(min_) / 1000; }
  double max() const { return static_cast<double>(max_) / 1000; }
  double mean() const { return scans_ == 0 ? 0 : sum_ / static_cast<double>(scans_) / 1000; }
  double median() const;
  std::uint64_t scans() const { return scans_; }

private:
  std::uint64_t min_ = 0, max_ = 0, scans_ = 0;
  double sum_ = 0;
  std::vector<std::uint64_t> buckets_;
};

}  // namespace ladder::hosted
