// Bucket B holds the values v with v >> e in 128..255, B = 128 e + (v >> e); values below 256 have a bucket each.
#include "hosted/scan_times.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace ladder::hosted {
namespace {

constexpr unsigned kSteps = 128;

unsigned exponent_of(std::uint64_t value) {
  return value < 2 * kSteps ? 0 : static_cast<unsigned>(std::bit_width(value)) - 8;
}

std::size_t bucket_of(std::uint64_t value) {
  return std::size_t{kSteps} * exponent_of(value) + (value >> exponent_of(value));
}

/// The middle of the bucket.
std::uint64_t value_of(std::size_t bucket) {
  if (bucket < 2 * kSteps)
    return bucket;
  auto exponent = static_cast<unsigned>(bucket / kSteps - 1);
  return ((std::uint64_t{bucket % kSteps + kSteps} << exponent) | (std::uint64_t{1} << exponent >> 1));
}

constexpr std::size_t kBuckets = kSteps * 58;

}  // namespace

void ScanTimes::add(std::uint64_t picoseconds, std::uint64_t scans) {
  if (scans == 0)
    return;
  buckets_.resize(kBuckets);
  buckets_[bucket_of(picoseconds)] += scans;
  min_ = scans_ == 0 ? picoseconds : std::min(min_, picoseconds);
  max_ = std::max(max_, picoseconds);
  sum_ += static_cast<double>(picoseconds) * static_cast<double>(scans);
  scans_ += scans;
}

double ScanTimes::median() const {
  std::uint64_t passed = 0;
  for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
    passed += buckets_[bucket];
    if (passed * 2 >= scans_)
      return static_cast<double>(std::clamp(value_of(bucket), min_, max_)) / 1000;
  }
  return 0;
}

}  // namespace ladder::hosted
