// A table that turns the called item to the called window by the shorter way. F68 ROTC.
//
// In place of this section the manual repeats that of SORT. What is here is what the instruction is known for:
// * S says which item stands at window 0. It counts the pulses of a two-phase encoder in D (A) and D + 1 (B), up where A leads, and
//   is a ring of m1 numbers; it is 0 while D + 2, item 0 at window 0, is ON. S + 1 is the called window, S + 2 the called item.
// * D + 3 to D + 7: forward fast, forward slow, stop, backward slow, backward fast; one of them is ON. Forward is where S counts
// up;
//   of two equal ways it is chosen. Slow are the last m2 divisions.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"

namespace ladder::tp03 {

struct rotc {
  bit driven{};
  bit phase_a{};

  template <class Registers, class Bits, class S>
  Fault run(bit condition, Registers s, word divisions, word slow, Bits d, S &sys) noexcept {
    const bit before = driven, a = d.points() > 0 ? d.get(0) : off;
    const bit a_changed = a ^ phase_a;
    phase_a = a;
    driven = condition;
    if (!condition) {
      if (before | sys.first_scan())
        drive(d, kNone);
      return Fault::None;
    }
    if (divisions < 2 || slow < 0 || slow > divisions || s.points() < 3 || d.points() < 8 || !within(s.get(1), divisions) ||
        !within(s.get(2), divisions))
      return Fault::Range;
    // One pulse is the edge of A with B OFF: up where A turns ON, down where it turns OFF again.
    const int step = (before & a_changed & !d.get(1)) ? (a ? 1 : -1) : 0;
    const word position = d.get(2) ? word{0} : ring(s.get(0) + step, divisions);
    s.set(0, position);
    const word ahead = ring(s.get(2) - s.get(1) - position, divisions), behind = static_cast<word>(divisions - ahead);
    if (ahead == 0)
      drive(d, kStop);
    else if (ahead <= behind)
      drive(d, ahead <= slow ? kForwardSlow : kForwardFast);
    else
      drive(d, behind <= slow ? kBackwardSlow : kBackwardFast);
    return Fault::None;
  }

private:
  static constexpr unsigned kForwardFast = 3, kForwardSlow = 4, kStop = 5, kBackwardSlow = 6, kBackwardFast = 7, kNone = 8;

  static constexpr bool within(word value, word divisions) noexcept { return value >= 0 && value < divisions; }
  static constexpr word ring(int number, word divisions) noexcept {
    const int rest = number % divisions;
    return static_cast<word>(rest < 0 ? rest + divisions : rest);
  }
  template <class Bits> static void drive(const Bits &d, unsigned output) noexcept {
    for (unsigned i = kForwardFast; i < kNone && i < d.points(); ++i)
      d.set(i, bit(i == output));
  }
};

}  // namespace ladder::tp03
