// Dead values: contacts and connections whose result nobody uses any more, left over by other passes.
//
// An edge is kept: it renews its memory. Value numbers are made dense again. One backward and one forward walk.
#include "opt/pipeline.h"

namespace ladderc::opt {

void run_dead_value(ir::Module &module, Context &context) {
  for (ir::Routine &routine : module.routines)
    for (ir::Rung &rung : routine.rungs) {
      std::vector<bool> used(rung.values, false), keep(rung.operations.size(), true);
      for (std::size_t i = rung.operations.size(); i-- > 0;) {
        const ir::Operation &o = rung.operations[i];
        const bool renews_memory = o.op == ir::Op::Rising || o.op == ir::Op::Falling;
        if (ir::is_value(o.op) && !renews_memory && !used[o.result] && context.may_rewrite("dead-value", "removed")) {
          keep[i] = false;
          continue;
        }
        for (ir::ValueId v : {o.a, o.b})
          if (v != ir::kNoValue)
            used[v] = true;
      }
      std::vector<ir::ValueId> number(rung.values, ir::kNoValue);
      ir::ValueId next = 0;
      std::size_t kept = 0;
      for (std::size_t i = 0; i < rung.operations.size(); ++i) {
        if (!keep[i])
          continue;
        ir::Operation o = std::move(rung.operations[i]);
        for (ir::ValueId *v : {&o.a, &o.b})
          if (*v != ir::kNoValue)
            *v = number[*v];
        if (ir::is_value(o.op))
          o.result = number[o.result] = next++;
        rung.operations[kept++] = std::move(o);
      }
      rung.operations.resize(kept);
      rung.values = next;
    }
}

}  // namespace ladderc::opt
