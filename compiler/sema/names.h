// How messages name devices and what may stand in an operand position.
#pragma once

#include "syntax/ast.h"

#include <string>

namespace ladderc::sema {

/// "X1F": the number in the radix of its class.
std::string device_name(const FamilyInfo &family, DeviceId device, std::uint64_t number);

/// "T0-T39", or "T5" where the run is one number.
std::string run_name(const FamilyInfo &family, DeviceId device, std::uint32_t first, std::uint32_t last);

/// "T0-T39 and T196-T255"; long lists are cut.
std::string numbers_text(const FamilyInfo &family, DeviceId device, llvm::ArrayRef<ModelNumbers> runs);

/// "a, b or c".
std::string joined(llvm::ArrayRef<std::string> parts, llvm::StringRef last_word);

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
