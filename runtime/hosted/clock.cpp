// Both clocks in one small class: a value, so that an instance can own it.
#include "ladder/hosted/clock.h"

namespace ladder::hosted {

Clock Clock::real() {
  Clock clock;
  clock.real_ = true;
  clock.start_ = std::chrono::steady_clock::now();
  return clock;
}

Clock Clock::virtual_steps(Micros step) {
  Clock clock;
  clock.step_ = step;
  return clock;
}

std::uint64_t Clock::now() const {
  if (!real_)
    return virtual_now_;
  auto passed = std::chrono::steady_clock::now() - start_;
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(passed).count());
}

}  // namespace ladder::hosted
