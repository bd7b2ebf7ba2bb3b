// How messages name devices and what may stand in an operand position.
#pragma once

#include "syntax/ast.h"

#include <string>

namespace ladderc::sema {

/// "X1F": the number in the radix of its class.
std::string device_name(const FamilyInfo &family, DeviceId device, std::uint64_t number);

/// What one or several operand positions take together.
struct Allowed {
  DeviceSet devices = 0, word_bits = 0, digits = 0;
  bool decimal = false, hexadecimal = false;

  void add(const OperandInfo &operand);
};

/// "D, W, Dn.b, KnX or a K or H constant".
std::string allowed_text(const FamilyInfo &family, const Allowed &allowed);

/// "MOV S D"; a name of several words is joined by hyphens.
std::string shape_text(const InstructionInfo &info);

}  // namespace ladderc::sema
