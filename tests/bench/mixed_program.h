// A random TP03 program in two forms: as a mnemonic list, and as the C++ that one would write by hand for it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ladderc::bench {

/// Instructions of each kind in a list.
struct Mix {
  unsigned contacts = 0;  ///< contacts, connections and coils
  unsigned timing = 0;    ///< OUT T, OUT C, RST C, RST T
  unsigned words = 0;     ///< transfer, arithmetic and comparison
  unsigned all() const { return contacts + timing + words; }
};

struct MixedProgram {
  std::string list;
  std::vector<std::string> functions;  ///< of struct Hand (mixed_plain.h), 64 rungs each: `void Hand::rungs_0() { ... }`
  unsigned places_of_edges = 0;        ///< memories of edge contacts
  unsigned places_of_pulses = 0;       ///< memories of P forms, which do not act in the first scan
  unsigned rungs = 0, relays = 0;
  Mix mix;  ///< END is among the contacts
};

/// `instructions` (10,000 at most) instructions: 70 of 100 contacts, 10 timers and counters, 20 words. The same seed gives the same
/// program everywhere.
MixedProgram make_mixed_program(unsigned instructions, std::uint64_t seed);

}  // namespace ladderc::bench
