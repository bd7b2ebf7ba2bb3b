// What the PC parameters tell the running system. The compiler writes one constant of this type beside each program.
#pragma once

#include "ladder/number.h"

#include <cstdint>

namespace ladder::melsec_qs {

struct Parameters {
  char name[9];                    ///< program file, eight characters padded with blanks: "MAIN    "
  std::uint32_t low_unit_us;       ///< tick of low-speed timers, 1-1000 ms
  std::uint32_t high_unit_us;      ///< tick of high-speed timers, 0.1-100 ms
  std::uint32_t constant_scan_us;  ///< the host keeps it; here it is the set value in the report of error 5010
  std::uint32_t watchdog_us;       ///< the host watches it; here it is the set value in the report of error 5001
  word points[15];                 ///< allocation as SD290-SD304 show it: X Y M - B F SB V - T ST C D W SW
};

}  // namespace ladder::melsec_qs
