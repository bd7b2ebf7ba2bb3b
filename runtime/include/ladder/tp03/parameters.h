// What the parameters and the list tell the running system. The compiler writes one constant of this type beside each program.
#pragma once

#include <cstdint>

namespace ladder::tp03 {

struct Parameters {
  std::uint32_t timer_interrupts_ms[3];  ///< period of I6xx, I7xx and I8xx as the program names them; 0: not used
  /// Bit 2n + e: the program has a routine I<n>0<e>. Edges without a routine need no place among those that wait.
  std::uint16_t input_interrupts = 0x0FFF;
};

}  // namespace ladder::tp03
