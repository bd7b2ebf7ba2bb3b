// The generator's own random numbers: the same seed gives the same list on every machine, which the standard library's
// distributions do not promise.
#pragma once

#include "llvm/ADT/ArrayRef.h"

#include <cstdint>

namespace ladderc {

/// SplitMix64.
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// 0 to limit - 1; 0 where limit is 0.
  std::uint32_t below(std::uint32_t limit) { return limit ? static_cast<std::uint32_t>((next() >> 32) * limit >> 32) : 0; }
  /// min to max, both included.
  std::int64_t between(std::int64_t min, std::int64_t max) {
    return min + static_cast<std::int64_t>(next() % (static_cast<std::uint64_t>(max - min) + 1));
  }
  bool one_in(std::uint32_t n) { return below(n) == 0; }
  template <class T> const T &pick(llvm::ArrayRef<T> from) { return from[below(static_cast<std::uint32_t>(from.size()))]; }

private:
  std::uint64_t state_;
};

}  // namespace ladderc
