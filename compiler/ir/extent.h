// Which devices a place covers, for passes and the emitter that must know whether two places overlap.
#pragma once

#include "ir/ir.h"

namespace ladderc::ir {

/// `last` of a block, whose length is known at run time only.
constexpr std::uint32_t kEndOfClass = ~std::uint32_t{0};

/// A run of numbers of one device class. `all`: may be anything (a run that crosses the end of its class).
struct Extent {
  DeviceId device = kNoDevice;
  PlaceKind space = PlaceKind::Bit;  ///< Edge and Master are spaces of their own; every device place is in the Bit space
  std::uint32_t first = 0, last = 0;
  bool all = false;
  bool none = false;  ///< a constant
};

Extent extent(const Module &module, const Place &place);
bool overlap(const Extent &a, const Extent &b);

/// How many consecutive numbers of its class an operand of that type takes.
std::uint32_t words_of(OperandType type);

/// True where the operation can stop the program or lets the runtime look at any device.
bool is_barrier(const Operation &operation);

/// Calls `f` with the extent of every place that the operation reads (writes). Barriers are not expanded.
template <class F> void for_each_read(const Module &m, const Operation &o, F f) {
  if (o.op == Op::Load || o.op == Op::Rising || o.op == Op::Falling || o.op == Op::Set || o.op == Op::Reset)
    f(extent(m, o.place));
  for (const Place &p : o.inputs)
    f(extent(m, p));
  if (o.op == Op::Run || (o.info && o.info->style == CallStyle::Method))
    for (const Place &p : o.outputs)
      f(extent(m, p));
}
template <class F> void for_each_write(const Module &m, const Operation &o, F f) {
  if (o.op == Op::Store || o.op == Op::Set || o.op == Op::Reset || o.op == Op::Rising || o.op == Op::Falling)
    f(extent(m, o.place));
  for (const Place &p : o.outputs)
    f(extent(m, p));
}

}  // namespace ladderc::ir
