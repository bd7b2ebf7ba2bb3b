// Names of operations and the extents of places.
#include "ir/ir.h"
#include "ir/extent.h"

namespace ladderc::ir {

bool is_value(Op op) {
  return op <= Op::Test;
}

bool tells_step(const Operation &o) {
  return o.info && (o.info->error_code != 0 || o.info->style == CallStyle::System);
}

llvm::StringRef name(Op op) {
  static constexpr llvm::StringLiteral kNames[] = {"const",  "load",    "not",  "and",   "andn", "or",    "orn",  "xor",
                                                   "rising", "falling", "test", "store", "set",  "reset", "call", "run"};
  return kNames[static_cast<unsigned>(op)];
}

std::uint32_t words_of(OperandType type) {
  switch (type) {
  case OperandType::DWord:
  case OperandType::WordTwice:
    return 2;
  case OperandType::QWord:
  case OperandType::DWordTwice:
    return 4;
  default:
    return 1;
  }
}

Extent extent(const Module &module, const Place &place) {
  Extent e;
  switch (place.kind) {
  case PlaceKind::Decimal:
  case PlaceKind::Hex:
    e.none = true;
    return e;
  case PlaceKind::Edge:
  case PlaceKind::Master:
    e.space = place.kind;
    e.first = e.last = place.number;
    return e;
  default:
    break;
  }
  e.device = place.device;
  e.first = place.number;
  std::uint32_t count = 1;
  if (place.kind == PlaceKind::Word)
    count = words_of(place.type);
  else if (place.kind == PlaceKind::Digits)
    count = 4u * place.digits;
  e.last = place.number + count - 1;
  // A block's length is known at run time only, but it does not leave its class.
  if (place.type == OperandType::WordBlock) {
    e.last = kEndOfClass;
    return e;
  }
  // A run behind the highest number of the class goes on in another class.
  if (count > 1 && e.last >= module.points_of(place.device))
    e.all = true;
  return e;
}

bool overlap(const Extent &a, const Extent &b) {
  if (a.none || b.none)
    return false;
  const bool a_private = a.space != PlaceKind::Bit, b_private = b.space != PlaceKind::Bit;
  if (a_private || b_private)
    return a.space == b.space && a.first == b.first;
  if (a.all || b.all)
    return true;
  return a.device == b.device && a.first <= b.last && b.first <= a.last;
}

bool is_barrier(const Operation &o) {
  return o.info && (o.op == Op::Call || o.op == Op::Run) &&
         (o.info->style == CallStyle::System || o.info->style == CallStyle::Status || o.info->stops_scan);
}

}  // namespace ladderc::ir
