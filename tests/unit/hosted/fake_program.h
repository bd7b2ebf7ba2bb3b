// A program as ladderc could have compiled it, written by hand, whose inputs provoke what a host must handle.
//
//   X0  Y0 follows                     X4  a scan takes 3 ms and more
//   X1  D0 counts scans                X5  Y1 follows; the program then writes 1 into X5
//   X2  error 4100 at step 8, stop     X6  the program stops the CPU without an error
//   X3  error 9000 at step 12, goes on
//   D1 is the scan's clock in ms, D2:f is 1.5, D9 is latched, T0 counts scans and closes its contact at 3.
#pragma once

#include "ladder/symbols.h"

namespace ladder::hosted::test {

struct FakeTimer {
  std::int16_t value;
  unsigned char contact, coil;
};

struct FakeProgram {
  unsigned char X[32], Y[16];
  std::uint32_t B[2];   ///< packed, 40 of them
  std::uint32_t IB[3];  ///< packed inputs, 70 of them
  std::int16_t D[10];
  FakeTimer T[2], C[2];
  Status state;
  Calendar calendar;
  unsigned watchdogs;
};

extern const ProgramSymbols kFake;

/// Devices that count in octal: X and Y, 16 of each.
extern const ProgramSymbols kOctal;

}  // namespace ladder::hosted::test
