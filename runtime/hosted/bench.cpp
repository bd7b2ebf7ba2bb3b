// The measuring loop touches nothing but the program, its inputs and the clock.
#include "hosted/bench.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>

namespace ladder::hosted {
namespace {

using SteadyClock = std::chrono::steady_clock;
using Nanoseconds = std::chrono::nanoseconds;

constexpr Nanoseconds kWarmUp = std::chrono::milliseconds(20);
constexpr Nanoseconds kMeasured = std::chrono::milliseconds(500);
constexpr Nanoseconds kBatch = std::chrono::microseconds(50);

Nanoseconds run_batch(Instance &instance, Stimulus &stimulus, std::uint64_t scans) {
  auto begin = SteadyClock::now();
  for (std::uint64_t i = 0; i < scans; ++i) {
    stimulus.apply(instance);
    instance.scan();
  }
  return SteadyClock::now() - begin;
}

double time_stimulus(const Instance &instance, Stimulus &stimulus) {
  constexpr int kTimes = 1000;
  auto begin = SteadyClock::now();
  for (int i = 0; i < kTimes; ++i)
    stimulus.apply(instance);
  return std::chrono::duration<double, std::nano>(SteadyClock::now() - begin).count() / kTimes;
}

std::uint64_t count(Nanoseconds time) {
  return static_cast<std::uint64_t>(std::max<Nanoseconds::rep>(time.count(), 1));
}

}  // namespace

BenchResult run_bench(Instance &instance, Stimulus &stimulus, std::optional<std::uint64_t> scans) {
  BenchResult result;
  // Batches double until one is long enough to be measured: that warms up and finds the size at once.
  result.batch = 1;
  for (auto start = SteadyClock::now();;) {
    Nanoseconds time = run_batch(instance, stimulus, result.batch);
    result.warm_up_scans += result.batch;
    if (SteadyClock::now() - start >= kWarmUp)
      break;
    if (time < kBatch)
      result.batch *= 2;
  }
  if (scans)
    result.batch = std::min(result.batch, *scans);
  auto start = SteadyClock::now();
  while (scans ? result.times.scans() < *scans : SteadyClock::now() - start < kMeasured) {
    std::uint64_t batch = scans ? std::min(result.batch, *scans - result.times.scans()) : result.batch;
    result.times.add(count(run_batch(instance, stimulus, batch)) * 1000 / batch, batch);
    if (instance.stopped_by_itself())
      break;
  }
  result.stimulus = time_stimulus(instance, stimulus);
  result.stopped = instance.stopped_by_itself();
  return result;
}

void print_bench(const Instance &instance, const BenchResult &result, std::FILE *out) {
  const ScanTimes &times = result.times;
  std::uint32_t instructions = instance.symbols().instructions;
  nlohmann::ordered_json line = {{"program", instance.symbols().name},
                                 {"unit", "ns"},
                                 {"min", times.min()},
                                 {"median", times.median()},
                                 {"max", times.max()},
                                 {"mean", times.mean()},
                                 {"scans", times.scans()},
                                 {"stimulus", result.stimulus},
                                 {"batch", result.batch},
                                 {"warm_up_scans", result.warm_up_scans},
                                 {"instructions", instructions},
                                 {"ns_per_instruction", instructions == 0 ? 0 : times.median() / instructions}};
  fmt::print(out, "{}\n", line.dump());
}

}  // namespace ladder::hosted
