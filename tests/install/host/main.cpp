// Runs the mixer with the start button held, as the command line of a program made by `ladderc build` would.
#include "mixer.h"

#include <ladder/hosted/program_main.h>

namespace works {
extern const ladder::ProgramSymbols kMixerSymbols;
}

int main() {
  char name[] = "embed", clock[] = "--virtual", time[] = "--scan-time=100ms", scans[] = "--scans=30", start[] = "--set=X0=1",
       watch[] = "--watch=C0,Y11", quiet[] = "--quiet";
  char *arguments[] = {name, clock, time, scans, start, watch, quiet};
  return ladder::hosted::program_main(7, arguments, works::kMixerSymbols);
}
