// Dead coils.  OUT Y3 ... OUT Y3: the first store is dropped when nobody can look in between.
//
// "Nobody" is: no contact or operand that covers Y3 in between, no operation that can stop the program or lets the runtime look
// around, no other store that only may cover it. Double coils are legal (the last one executed wins) and common in plants: the
// warning is sema's, this pass only saves the store. The value of the last store of a scan is never dropped, so hosts see no
// difference. One backward walk over the routine with the set of devices that will be overwritten before they are seen.
#include "ir/extent.h"
#include "opt/pipeline.h"

#include "llvm/ADT/DenseSet.h"

namespace ladderc::opt {

namespace {

using Key = std::uint64_t;

/// Only whole bits of bit devices are tracked. Bits of words and timers' contacts are left alone.
bool trackable(const ir::Module &module, const ir::Place &place) {
  return place.kind == ir::PlaceKind::Bit && module.family->devices[place.device].kind == DeviceKind::Bit;
}
Key key(const ir::Place &place) {
  return (Key{place.device} << 32) | place.number;
}

void forget(const ir::Extent &e, llvm::DenseSet<Key> &overwritten) {
  if (e.none || e.space != ir::PlaceKind::Bit || overwritten.empty())
    return;
  if (e.all || e.last - e.first > 64) {
    overwritten.clear();
    return;
  }
  for (std::uint32_t n = e.first; n <= e.last; ++n)
    overwritten.erase((Key{e.device} << 32) | n);
}

}  // namespace

void run_dead_coil(ir::Module &module, Context &context) {
  for (ir::Routine &routine : module.routines) {
    llvm::DenseSet<Key> overwritten;
    for (ir::Rung &rung : llvm::reverse(routine.rungs)) {
      std::vector<bool> dead(rung.operations.size(), false);
      bool any = false;
      for (std::size_t i = rung.operations.size(); i-- > 0;) {
        const ir::Operation &o = rung.operations[i];
        if (o.op == ir::Op::Store && trackable(module, o.place)) {
          if (overwritten.contains(key(o.place))) {
            if (context.may_rewrite("dead-coil", "removed"))
              any = dead[i] = true;
          } else {
            overwritten.insert(key(o.place));
          }
          continue;
        }
        if (ir::is_barrier(o)) {
          overwritten.clear();
          continue;
        }
        ir::for_each_read(module, o, [&](const ir::Extent &e) { forget(e, overwritten); });
        ir::for_each_write(module, o, [&](const ir::Extent &e) { forget(e, overwritten); });
      }
      if (!any)
        continue;
      std::size_t kept = 0;
      for (std::size_t i = 0; i < rung.operations.size(); ++i)
        if (!dead[i])
          rung.operations[kept++] = std::move(rung.operations[i]);
      rung.operations.resize(kept);
    }
  }
}

}  // namespace ladderc::opt
