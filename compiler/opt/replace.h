// Replacing values of a rung.
#pragma once

#include "ir/ir.h"

#include <vector>

namespace ladderc::opt {

/// Collects "use B where A was used" and applies it in one walk. Chains are followed.
class Replacement {
public:
  explicit Replacement(const ir::Rung &rung) : target_(rung.values) {
    for (ir::ValueId v = 0; v < rung.values; ++v)
      target_[v] = v;
  }
  void replace(ir::ValueId old, ir::ValueId by) { target_[old] = find(by); }
  ir::ValueId find(ir::ValueId v) const {
    while (v != ir::kNoValue && target_[v] != v)
      v = target_[v];
    return v;
  }
  void apply(ir::Operation &o) const {
    o.a = find(o.a);
    o.b = find(o.b);
  }

private:
  std::vector<ir::ValueId> target_;
};

}  // namespace ladderc::opt
