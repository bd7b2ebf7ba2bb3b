// Operation errors of application instructions: the codes that D8067 shows.
#pragma once

#include <cstdint>

namespace ladder::tp03 {

/// None, or why an instruction was not executed.
enum class Fault : std::uint16_t {
  None = 0,
  Operand = 6705,           ///< a device that the instruction does not allow, or operands that conflict
  Range = 6706,             ///< a device number, also after indexing, or a value out of range
  SamplingTime = 6730,      ///< PID: Ts
  InputFilter = 6732,       ///< PID: filter constant
  ProportionalGain = 6733,  ///< PID: Kp
  IntegralTime = 6734,      ///< PID: Ti
  DerivativeGain = 6735,    ///< PID: Kd
  DerivativeTime = 6736,    ///< PID: Td
  SamplingBelowScan = 6740, ///< PID: Ts is not above the scan time; the instruction goes on
};

}  // namespace ladder::tp03
