// Both clocks in one small class: a value, so that an instance can own it.
#include "ladder/hosted/clock.h"

#include <ctime>

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

Calendar system_calendar() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  auto byte = [](int number) { return static_cast<std::uint8_t>(number); };
  return {static_cast<std::uint16_t>(local.tm_year + 1900),
          byte(local.tm_mon + 1),
          byte(local.tm_mday),
          byte(local.tm_hour),
          byte(local.tm_min),
          byte(local.tm_sec),
          byte(local.tm_wday)};
}

}  // namespace ladder::hosted
