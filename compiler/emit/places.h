// How places are spelt in C++.
#pragma once

#include "ir/ir.h"
#include "sema/check.h"

#include <string>

namespace ladderc::emit {

/// What the spelling needs to know beside the place: the module's devices and the allocation (where a run crosses the end of a
/// class).
struct PlaceContext {
  const FamilyInfo &family;
  const Parameters &parameters;
  llvm::ArrayRef<std::string> texts = {};  ///< of the module: string operands
};

/// `X[0x1F]`, `T[0].contact`, `D.bit(0, 5)`, `edge[3]`, `master[0]`.
std::string bit_text(const PlaceContext &context, const ir::Place &place);
/// A place that is read: `D[5]`, `D.pair(5)`, `X.word<4>(0)`, a constant.
std::string input_text(const PlaceContext &context, const ir::Place &place);
/// A place that is written. Two-result operands give two texts, joined by ", ".
std::string output_text(const PlaceContext &context, const ir::Place &place);
/// `D.has(at(20, V[0]), 2)`: whether an indexed place lies in its class.
std::string range_check(const PlaceContext &context, const ir::Place &place);
/// A timer or counter as an object: `T[0]`; an annunciator as two arguments: `F, 12`.
std::string object_text(const PlaceContext &context, const ir::Place &place);
/// Where an initial value is written: a bit, a word or a pair.
ir::Place place_of(const FamilyInfo &family, const InitialValue &value);
/// A device number as its subscript: 12, 0x1F.
std::string subscript(const DeviceInfo &device, std::uint32_t number);

}  // namespace ladderc::emit
