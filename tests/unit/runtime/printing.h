// How GoogleTest shows the runtime's values in messages.
#pragma once

#include "ladder/bit.h"

#include <ostream>

namespace ladder {

inline std::ostream &operator<<(std::ostream &out, bit state) {
  return out << (state ? "ON" : "OFF");
}

}  // namespace ladder
