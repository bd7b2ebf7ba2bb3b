// A QS controller without a program: tests call what a program would call.
#pragma once

#include "ladder/melsec_qs.h"
#include "printing.h"

namespace plant {

inline constexpr ladder::melsec_qs::Parameters kParameters{
    "MIXER   ", 100000, 10000, 20000, 200000, {6144, 6144, 6144, 0, 2048, 1024, 1536, 1024, 0, 512, 16, 512, 6144, 2048, 1536}};

struct Plant {
  ladder::melsec_qs::System<> sys;
  ladder::Bits<1024> F;
  ladder::Micros now = 0;

  Plant() { sys.power_on(kParameters); }

  /// A scan without a program; the clock moves after it.
  bool scan(ladder::Micros us = 10000) {
    const bool ran = sys.begin_scan(now);
    if (ran)
      sys.end_scan(F);
    now += us;
    return ran;
  }
  void scans(int count, ladder::Micros us = 10000) {
    for (int i = 0; i < count; ++i)
      scan(us);
  }
  ladder::bit sm(unsigned number) const { return sys.SM[number]; }
  ladder::word sd(unsigned number) const { return sys.SD[number]; }
  /// The pattern of a special register, as BCD values are read.
  unsigned hex(unsigned number) const { return ladder::pattern_of(sys.SD[number]); }
};

}  // namespace plant
