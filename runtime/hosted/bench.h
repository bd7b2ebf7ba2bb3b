// Measuring scans: `--bench`.
//
// A clock costs about as much as a short scan, so it is read around batches of scans that take some 50 microseconds; minimum,
// median and maximum are those of the batches' means. The inputs change before every scan as the stimulus says, inside the measured
// time.
#pragma once

#include "hosted/scan_times.h"
#include "hosted/stimulus.h"

#include "ladder/hosted/instance.h"

#include <cstdint>
#include <cstdio>
#include <optional>

namespace ladder::hosted {

struct BenchResult {
  ScanTimes times;
  std::uint64_t warm_up_scans = 0;
  std::uint64_t batch = 0;  ///< scans between two readings of the clock
  double stimulus = 0;      ///< nanoseconds that the stimulus alone takes before each scan
  bool stopped = false;     ///< the CPU stopped: the times mean nothing
};

/// Warms up, then measures `scans` scans, or as many as fit into half a second.
BenchResult run_bench(Instance &instance, Stimulus &stimulus, std::optional<std::uint64_t> scans);

void print_bench(const Instance &instance, const BenchResult &result, std::FILE *out);

}  // namespace ladder::hosted
