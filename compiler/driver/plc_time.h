// How long the real CPU takes for a scan, by the manual's timing table.
#pragma once

#include "sema/check.h"

namespace ladderc::driver {

struct PlcTime {
  double instructions_us = 0;  ///< every condition ON, as the table's "executed" rows have it
  double end_us = 0;           ///< END processing and I/O refresh
  unsigned unknown = 0;        ///< instructions for which the table has no row
  double total_us() const { return instructions_us + end_us; }
};

PlcTime plc_time(const CheckedProgram &program);

}  // namespace ladderc::driver
