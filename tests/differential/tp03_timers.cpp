// Timers and counters.
#include "tp03_interpreter.h"

#include <algorithm>

namespace ladderc::differential {

namespace {

/// Timers with a rule of their own: 1 ms in the background, and those that keep what they have.
bool counts_in_background(std::int64_t timer) {
  return timer >= 246 && timer <= 249;
}
bool accumulates(std::int64_t timer) {
  return timer >= 246 && timer <= 255;
}
std::uint32_t unit_us(std::int64_t timer) {
  return timer < 200 || (timer >= 250 && timer <= 255) ? 100'000 : timer <= 245 ? 10'000 : 1'000;
}

}  // namespace

/// A timer knows time only where its coil is executed, and once in a scan.
void Tp03Interpreter::drive_timer(const Operand &timer, std::int64_t preset, bool on) {
  DeviceArray &a = arrays_[timer.device];
  const std::uint64_t n = place(timer);
  Timer &t = timers_[timer.value];
  t.preset = std::max<std::int64_t>(preset, 0);
  const bool went_on = on && a.coil[n];
  a.coil[n] = on;
  if (!on && !accumulates(timer.value)) {
    a.value[n] = 0;
    a.on[n] = 0;
    t.rest_us = 0;
    return;
  }
  const std::uint64_t passed = scan_ - t.last_scan;
  t.last_scan = scan_;
  if (!went_on || passed == 0)
    return;
  if (!counts_in_background(timer.value))
    advance(timer, passed == 1 ? elapsed_us_ : 0, true);
  else if (static_cast<std::int16_t>(a.value[n]) >= t.preset)
    a.on[n] = 1;
}

void Tp03Interpreter::advance(const Operand &timer, std::uint32_t elapsed, bool switches) {
  DeviceArray &a = arrays_[timer.device];
  const std::uint64_t n = place(timer);
  Timer &t = timers_[timer.value];
  if (a.on[n])
    return;
  const std::uint64_t time = std::uint64_t(t.rest_us) + elapsed;
  const auto units = static_cast<std::int64_t>(time / unit_us(timer.value));
  t.rest_us = static_cast<std::uint32_t>(time % unit_us(timer.value));
  std::int64_t value = static_cast<std::int16_t>(a.value[n]);
  if (units > 0)
    value = std::min(value + units, t.preset);
  if (switches && value >= t.preset) {
    value = t.preset;
    a.on[n] = 1;
  }
  a.value[n] = static_cast<std::uint16_t>(value);
}

void Tp03Interpreter::drive_counter(std::size_t i, const Operand &counter, std::int64_t preset, bool on) {
  DeviceArray &a = arrays_[counter.device];
  const std::uint64_t n = place(counter);
  const bool pulse = edge(i, 'P', on);
  a.coil[n] = pulse;
  if (!pulse || reset_coils_[{counter.device, counter.value}])
    return;
  if (!a.wide.empty()) {
    ++a.wide[n];
    if (static_cast<std::int32_t>(a.wide[n]) == preset)
      a.on[n] = 1;
    return;
  }
  if (a.on[n])
    return;
  const std::int64_t set = std::max<std::int64_t>(preset, 1);
  const std::int64_t value = std::min<std::int64_t>(static_cast<std::int16_t>(a.value[n]) + 1, set);
  a.value[n] = static_cast<std::uint16_t>(value);
  a.on[n] = value >= set;
}

void Tp03Interpreter::reset_counter(const Operand &counter, bool on) {
  reset_coils_[{counter.device, counter.value}] = on;
  if (!on)
    return;
  DeviceArray &a = arrays_[counter.device];
  a.on[place(counter)] = 0;
  if (!a.wide.empty())
    a.wide[place(counter)] = 0;
  else
    a.value[place(counter)] = 0;
}

}  // namespace ladderc::differential
