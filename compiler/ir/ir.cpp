// Names of operations and the extents of places.
#include "ir/ir.h"
#include "ir/extent.h"

#include "llvm/ADT/STLExtras.h"

namespace ladderc::ir {

bool is_value(Op op) {
  return op <= Op::Test;
}

bool is_conditional(Op op) {
  return op == Op::Set || op == Op::Reset || op == Op::Call || op == Op::Transfer || op == Op::Jump || op == Op::Gosub;
}

bool is_flow(Op op) {
  return op >= Op::Transfer;
}

bool tells_step(const Operation &o) {
  return o.info &&
         (o.info->error_code != 0 || o.info->style == CallStyle::System || o.info->style == CallStyle::Memory || is_indexed(o));
}

bool is_indexed(const Operation &o) {
  auto indexed = [](const Place &p) { return p.is_indexed() && !p.is_constant(); };
  return llvm::any_of(o.inputs, indexed) || llvm::any_of(o.outputs, indexed);
}

llvm::StringRef name(Op op) {
  static constexpr llvm::StringLiteral kNames[] = {"const",  "load",    "not",  "and",   "andn", "or",    "orn",  "xor",
                                                   "rising", "falling", "pulse", "active", "test", "store", "set", "reset",
                                                   "call", "run", "transfer", "label", "jump", "gosub", "loop", "next", "enter",
                                                   "leave", "return", "endscan"};
  return kNames[static_cast<unsigned>(op)];
}

std::uint32_t words_of(OperandType type) {
  switch (type) {
  case OperandType::DWord:
  case OperandType::WordTwice:
  case OperandType::Real:
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
  case PlaceKind::Text:
  case PlaceKind::Label:
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
  if (module.family->devices[place.device].kind == DeviceKind::Label) {
    e.none = true;
    return e;
  }
  e.device = place.device;
  e.first = place.number;
  if (place.is_indexed()) {  // anywhere in its class
    e.first = module.family->devices[place.device].first;
    e.last = kEndOfClass;
    return e;
  }
  const DeviceInfo &device = module.family->devices[place.device];
  std::uint32_t count = 1;
  if (place.kind == PlaceKind::Word)
    count = device.kind == DeviceKind::LongCounter ? (words_of(place.type) + 1) / 2 : words_of(place.type);
  else if (place.kind == PlaceKind::Digits)
    count = 4u * place.digits;
  e.last = place.number + count - 1;
  // A block's length is known at run time only, but it does not leave its class.
  if (is_run(place.type)) {
    if (place.count == 0)
      e.last = kEndOfClass;
    else
      e.last = place.number + place.count * (place.kind == PlaceKind::Digits ? 4u * place.digits : 1u) *
                                  (place.type == OperandType::DWordBlock && device.kind == DeviceKind::Word ? 2u : 1u) - 1;
    return e;
  }
  // The high word of a pair of index registers lies in another class.
  if (count > 1 && device.high_words != kNoDevice)
    e.all = true;
  // A run behind the highest number of the class goes on in another class.
  if (count > 1 && e.last >= device.first + module.points_of(place.device))
    e.all = true;
  return e;
}

llvm::SmallVector<Extent, 2> index_extents(const Module &module, const Place &place) {
  llvm::SmallVector<Extent, 2> extents;
  for (DeviceId device = place.index; device != kNoDevice;
       device = place.wide_index ? module.family->devices[device].high_words : kNoDevice) {
    Extent e;
    e.device = device;
    e.first = e.last = place.index_number;
    extents.push_back(e);
  }
  return extents;
}

llvm::SmallVector<Extent, 2> system_extents(const Module &module) {
  llvm::SmallVector<Extent, 2> extents;
  for (const auto &[id, device] : llvm::enumerate(module.family->devices))
    if (device.image.starts_with("sys.")) {
      Extent e;
      e.device = static_cast<DeviceId>(id);
      e.last = kEndOfClass;
      extents.push_back(e);
    }
  return extents;
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
  if (is_flow(o.op))
    return true;
  if (!o.info || (o.op != Op::Call && o.op != Op::Run))
    return false;
  // An error that the system is told by the function itself does not end the scan; then it writes special devices and no more.
  const bool may_end_scan = o.info->stops_scan || (o.info->style == CallStyle::Status && !o.info->passes_system);
  return may_end_scan || o.info->style == CallStyle::System || !o.info->images.empty();
}

}  // namespace ladderc::ir
