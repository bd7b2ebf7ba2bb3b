// Shared edges.  LD X0 / SUBP D0 D1 D2 / ADDP D3 D4 D5: each place has an edge memory of its own, but two that see the same result in
// the same rung are executed together and always hold the same. The second edge is the first one's value, and its memory is unused.
//
// Only private memories, and only where nothing between the two directs the flow: then neither is executed without the other. Linear in
// the number of operations; a rung's edges are few, so they are searched one by one.
#include "ir/extent.h"
#include "opt/pipeline.h"
#include "opt/replace.h"

namespace ladderc::opt {

void run_shared_edge(ir::Module &module, Context &context) {
  for (ir::Routine &routine : module.routines)
    for (ir::Rung &rung : routine.rungs) {
      Replacement replacement(rung);
      llvm::SmallVector<const ir::Operation *, 8> seen;
      std::vector<bool> dead(rung.operations.size(), false);
      for (std::size_t i = 0; i < rung.operations.size(); ++i) {
        ir::Operation &o = rung.operations[i];
        replacement.apply(o);
        if (ir::is_flow(o.op)) {
          seen.clear();
        } else if (ir::is_edge(o.op) && o.place.kind == ir::PlaceKind::Edge) {
          const auto *first = llvm::find_if(seen, [&](const ir::Operation *e) { return e->op == o.op && e->a == o.a; });
          if (first == seen.end())
            seen.push_back(&o);
          else if (context.may_rewrite("shared-edge", "merged")) {
            replacement.replace(o.result, (*first)->result);
            dead[i] = true;
          }
        }
      }
      std::size_t kept = 0;
      for (std::size_t i = 0; i < rung.operations.size(); ++i)
        if (!dead[i] && kept++ != i)
          rung.operations[kept - 1] = std::move(rung.operations[i]);
      rung.operations.resize(kept);
    }
}

}  // namespace ladderc::opt
