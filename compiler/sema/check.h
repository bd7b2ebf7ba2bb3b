// Sema: is this list a program of that controller?
//
// Chooses the table entry of every instruction by its operands, checks operands, ranges, placement, blocks, branches, master
// control and END, counts steps and rungs, and warns of what is legal but suspicious. All errors of a list come in one run; a wrong
// operand or rung is reported once and silences its consequences.
#pragma once

#include "sema/parameters.h"
#include "support/diagnostics.h"
#include "syntax/ast.h"

namespace ladderc {

/// A list that lowering may rely on: every instruction before and including END has `info`, all operands are valid and in range,
/// the block, branch and master control structure is closed, steps and rungs are set.
struct CheckedProgram {
  ListProgram list;
  const FamilyInfo *family = nullptr;
  llvm::StringRef model;
  Parameters parameters;
  std::uint32_t steps = 0;  ///< of the whole program, END included
  std::uint32_t rungs = 0;
  bool ok = false;  ///< false: messages have been reported and the program must not be lowered
};

CheckedProgram check(ListProgram list, llvm::StringRef model, Parameters parameters, Diagnostics &diagnostics);

/// True where a pair, quad or digit run of `words` 16-bit words (or `bits` bits) that starts at `number` crosses the end of its
/// class.
bool crosses_end(const FamilyInfo &family, const Parameters &parameters, DeviceId device, std::uint32_t number,
                 std::uint32_t count);

/// The device that lies `distance` places behind `device number` in the family's memory order (the next class of the same kind
/// where the end is crossed). kNoDevice in `device` where there is none.
struct DevicePoint {
  DeviceId device;
  std::uint32_t number;
};
DevicePoint point_behind(const FamilyInfo &family, const Parameters &parameters, DevicePoint start, std::uint32_t distance);

}  // namespace ladderc
