// What the parameters tell the running system. The compiler writes one constant of this type beside each program.
#pragma once

#include <cstdint>

namespace ladder::tp03 {

struct Parameters {
  std::uint32_t timer_interrupts_ms[3];  ///< period of I6xx, I7xx and I8xx as the program names them; 0: not used
};

}  // namespace ladder::tp03
