// A program of another controller than FakeProgram's: classes that share a prefix, pairs in two classes, 32-bit counters, and a
// world beside its terminals.
//
//   D0  bytes received on port 0; each is sent back, one greater,     D4  the input of the last change between scans
//       and Z stops the CPU                                           D5  changes between scans, both directions
//   D1  the last of them                                              D6  the interrupt pointer asked for last
//   D2  potentiometer 1                                               D7  the minute of the calendar
//   D3  channel 0 of the option card                                  C235 counts rising edges of X5 between scans
//
// The first scan opens port 0 with 19200 bauds, 8 data bits, no parity, 1 stop bit.
#pragma once

#include "ladder/symbols.h"

namespace ladder::hosted::test {

struct WideTimer {
  std::int16_t value;
  unsigned char contact, coil;
  std::uint32_t rest;
};
struct WideCounter {
  std::int16_t value;
  unsigned char contact, coil, reset;
};
struct LongCounter {
  std::int32_t value;
  unsigned char contact, coil, reset;
};

struct FakeController {
  unsigned char X[16], Y[16];
  unsigned char M[10], special_M[8];
  std::uint32_t packed_S[2];  ///< S100 to S139
  std::int16_t D[10], special_D[4], V[4], Z[4];
  WideTimer T[3];
  WideCounter C[3];
  LongCounter C32[40];
  Io *io;
  Status state;
  Calendar calendar;
};

extern const ProgramSymbols kController;

}  // namespace ladder::hosted::test
