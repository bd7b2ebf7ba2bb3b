// Redundant loads.  LD X0 / AND X1 / OUT Y0 / LD ... in one rung: the second contact of X0 is the first one's value, as long as
// nothing in between can have written X0.
//
// Works inside a rung: a rung's contacts are read together by a person, and values do not outlive their rung. A rung has few loads,
// so the list of known ones is searched linearly; it is capped to keep monstrous rungs linear.
#include "ir/extent.h"
#include "opt/pipeline.h"
#include "opt/replace.h"

namespace ladderc::opt {

namespace {

constexpr std::size_t kMaxKnown = 64;

struct Known {
  ir::Place place;
  ir::Extent extent;
  ir::ValueId value;
};

void forget_written(const ir::Module &module, const ir::Operation &o, llvm::SmallVectorImpl<Known> &known) {
  if (ir::is_barrier(o)) {
    known.clear();
    return;
  }
  ir::for_each_write(module, o, [&](const ir::Extent &written) {
    llvm::erase_if(known, [&](const Known &k) { return ir::overlap(k.extent, written); });
  });
}

}  // namespace

void run_redundant_load(ir::Module &module, Context &context) {
  for (ir::Routine &routine : module.routines)
    for (ir::Rung &rung : routine.rungs) {
      Replacement replacement(rung);
      llvm::SmallVector<Known, 16> known;
      for (ir::Operation &o : rung.operations) {
        replacement.apply(o);
        if (o.op == ir::Op::Load) {
          const auto *found = llvm::find_if(known, [&](const Known &k) { return k.place == o.place; });
          if (found != known.end()) {
            if (context.may_rewrite("redundant-load", "removed"))
              replacement.replace(o.result, found->value);
          } else if (known.size() < kMaxKnown) {
            known.push_back({o.place, ir::extent(module, o.place), o.result});
          }
        } else {
          forget_written(module, o, known);
        }
      }
    }
}

}  // namespace ladderc::opt
