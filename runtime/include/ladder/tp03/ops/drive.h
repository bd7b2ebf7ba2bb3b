// What the condition of an instruction that works over several scans does from one execution to the next.
#pragma once

#include "ladder/bit.h"

#include <cstdint>

namespace ladder::tp03 {

enum class Drive : std::uint8_t {
  Off,     ///< as before
  Stops,   ///< OFF after it was ON
  Starts,  ///< ON after it was OFF, or in the first scan
  Runs,    ///< ON as before
};

class DriveMemory {
public:
  template <class S> Drive see(bit condition, const S &sys) noexcept {
    const bit before = before_;
    before_ = condition;
    if (condition)
      return before & !sys.first_scan() ? Drive::Runs : Drive::Starts;
    return before ? Drive::Stops : Drive::Off;
  }

private:
  bit before_{};
};

}  // namespace ladder::tp03
