// A random contact program in two forms: as a mnemonic list and as the C++ that one would write by hand for the same rungs.
#pragma once

#include <cstdint>
#include <string>

namespace ladderc::bench {

struct ContactProgram {
  std::string list;        ///< melsec-qs, END included
  std::string hand_header; ///< struct Hand: byte arrays and one function for 64 rungs
  std::string hand_source;
  unsigned instructions = 0;
};

/// `rungs` (at most 2,500) rungs of contacts in series and parallel with blocks, each driving one coil. The same seed gives the same program everywhere.
ContactProgram make_contact_program(unsigned rungs, std::uint64_t seed);

constexpr unsigned kInputs = 512, kOutputs = 1024, kRelays = 2048;  ///< device numbers that the program uses

}  // namespace ladderc::bench
