// What instructions of the TP03 that last several scans ask of the system, moved scan by scan.
#pragma once

#include "ladder/image.h"
#include "ladder/numbered.h"

#include <cstdint>

struct ScanningSystem {
  ladder::Numbered<ladder::Bits<512>, 8000> M;

  /// Begins the next scan, `us` microseconds behind the one before.
  void scan(std::uint32_t us = 10000) {
    elapsed = scans == 0 ? 0 : us;
    now += elapsed;
    M[8002] = ladder::bit(scans == 0);
    ++scans;
  }
  /// RUN begins once more.
  void restart() { scans = 0; }

  std::uint32_t elapsed_us() const noexcept { return elapsed; }
  std::uint32_t now_us() const noexcept { return now; }
  std::uint32_t scan_number() const noexcept { return scans; }
  ladder::bit first_scan() const noexcept { return M[8002]; }
  void set_complete(ladder::bit state) noexcept { M[8029] = state; }

  std::uint32_t elapsed = 0, now = 0, scans = 0;
};
