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

/// True for a block or run that is handed over with its end, not by value.
constexpr bool is_run(OperandType type) {
  return type == OperandType::WordBlock || type == OperandType::DWordBlock || type == OperandType::BitRun ||
         type == OperandType::BitTarget;
}

/// How many consecutive numbers of its class an operand of that type takes.
std::uint32_t words_of(OperandType type);

/// The special devices, which an instruction that knows the system may write as flags and errors.
llvm::SmallVector<Extent, 2> system_extents(const Module &module);

/// The index registers of the place: one, or two where it is 32 bits wide.
llvm::SmallVector<Extent, 2> index_extents(const Module &module, const Place &place);

/// True for the operations that compare with a memory and renew it.
constexpr bool is_edge(Op op) { return op == Op::Rising || op == Op::Falling || op == Op::Pulse; }

/// True where the operation can stop the program or lets the runtime look at any device.
bool is_barrier(const Operation &operation);

/// Calls `f` with the extent of every place that the operation reads (writes). Barriers are not expanded.
template <class F> void for_each_read(const Module &m, const Operation &o, F f) {
  if (o.op == Op::Load || is_edge(o.op) || o.op == Op::Set || o.op == Op::Reset)
    f(extent(m, o.place));
  auto read = [&](const Place &p) {
    f(extent(m, p));
    if (p.is_indexed())
      for (const Extent &e : index_extents(m, p))
        f(e);
  };
  for (const Place &p : o.inputs)
    read(p);
  for (const Place &p : o.outputs)
    if (p.is_indexed())
      for (const Extent &e : index_extents(m, p))
        f(e);
  if (o.op == Op::Run || (o.info && o.info->style == CallStyle::Method))
    for (const Place &p : o.outputs)
      f(extent(m, p));
}
template <class F> void for_each_write(const Module &m, const Operation &o, F f) {
  if (o.op == Op::Store || o.op == Op::Set || o.op == Op::Reset || is_edge(o.op))
    f(extent(m, o.place));
  for (const Place &p : o.outputs)
    f(extent(m, p));
  if (o.info && o.info->passes_system)
    for (const Extent &e : system_extents(m))
      f(e);
}

}  // namespace ladderc::ir
