// A host of its own: it writes the inputs, runs scans, takes the outputs, and decides what time it is.
#include "mixer.h"

#include <cstdint>
#include <cstdio>

int main() {
  plant::Mixer mixer;
  mixer.power_on();
  for (std::uint32_t scan = 1; scan <= 24; ++scan) {
    mixer.X[0] = ladder::bit{scan % 8 == 2};  // somebody presses start now and then
    const bool before = static_cast<bool>(mixer.Y[0x10]);
    mixer.scan(scan * 100'000);  // microseconds: a scan every 100 ms
    const bool motor = static_cast<bool>(mixer.Y[0x10]), lamp = static_cast<bool>(mixer.Y[0x11]);
    if (motor != before || lamp)
      std::printf("scan %2u: motor %s, %d batches%s\n", static_cast<unsigned>(scan), motor ? "on" : "off", int{mixer.C[0].value},
                  lamp ? ", done" : "");
    if (lamp)
      return 0;
  }
  return 1;
}
