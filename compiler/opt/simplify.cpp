// Boolean simplification, one walk per rung from first to last operation; operands are simple already when their user is looked at.
//
//     constants     x and 1 = x    x and 0 = 0    x or 0 = x     x or 1 = 1     not const
//     idempotence   x and x = x    x or x = x     x andn x = 0   x orn x = 1
//     complement    x and not x = 0               x or not x = 1
//     inversion     not not x = x                 x and not y = x andn y        x or not y = x orn y
//     absorption    x and (x or y) = x            x or (x and y) = x
//     factoring     (x and y) or (x and z) = x and (y or z)   where both products have no other user
//     effects       `set P if 0` and calls with condition 0 go away; a condition 1 becomes no condition
//
// Edges are never touched: their memory is an effect. Values are replaced, not moved, so loads stay where their contacts stand.
#include "opt/pipeline.h"
#include "opt/replace.h"

namespace ladderc::opt {

namespace {

using ir::Op;
using ir::Operation;
using ir::ValueId;

class RungSimplifier {
public:
  RungSimplifier(ir::Rung &rung, Context &context)
      : rung_(rung), context_(context), replacement_(rung), definition_(rung.values, nullptr), uses_(rung.values, 0) {}

  void run() {
    for (const Operation &o : rung_.operations)
      for (ValueId v : {o.a, o.b})
        if (v != ir::kNoValue)
          ++uses_[v];
    for (Operation &o : rung_.operations) {
      replacement_.apply(o);
      if (!ir::is_value(o.op))
        continue;
      // A rule may enable another one; every rule makes the operation smaller.
      while (apply(o)) {
      }
      definition_[o.result] = &o;
    }
    simplify_effects();
  }

private:
  const Operation *def(ValueId v) const { return v == ir::kNoValue ? nullptr : definition_[v]; }
  bool is_constant(ValueId v, bool value) const { return def(v) && def(v)->op == Op::Constant && def(v)->constant == value; }
  bool is_not_of(ValueId v, ValueId x) const { return def(v) && def(v)->op == Op::Not && def(v)->a == x; }
  bool allowed(llvm::StringRef rule) { return context_.may_rewrite("simplify", rule); }

  bool become_value(Operation &o, ValueId v, llvm::StringRef rule) {
    // An operation whose users all go elsewhere is dead; it stays until dead-value takes it.
    if (replacement_.find(o.result) != o.result || !allowed(rule))
      return false;
    replacement_.replace(o.result, v);
    uses_[v] += uses_[o.result];
    return false;
  }
  bool become_constant(Operation &o, bool value, llvm::StringRef rule) {
    if (!allowed(rule))
      return false;
    o.op = Op::Constant;
    o.constant = value;
    o.a = o.b = ir::kNoValue;
    return false;
  }
  bool become(Operation &o, Op op, ValueId a, ValueId b, llvm::StringRef rule) {
    if (!allowed(rule))
      return false;
    o.op = op;
    o.a = a;
    o.b = b;
    return true;
  }

  bool apply(Operation &o) {
    switch (o.op) {
    case Op::Not:
      return apply_not(o);
    case Op::And:
      return apply_and(o);
    case Op::Or:
      return apply_or(o);
    case Op::AndNot:
      if (is_constant(o.b, false) || is_constant(o.a, false))
        return become_value(o, o.a, "constant");
      if (is_constant(o.b, true) || o.a == o.b)
        return become_constant(o, false, "constant");
      if (is_constant(o.a, true))
        return become(o, Op::Not, o.b, ir::kNoValue, "constant");
      if (def(o.b) && def(o.b)->op == Op::Not)
        return become(o, Op::And, o.a, def(o.b)->a, "inversion");
      return false;
    case Op::OrNot:
      if (is_constant(o.b, true) || is_constant(o.a, true))
        return become_value(o, o.a, "constant");
      if (is_constant(o.b, false) || o.a == o.b)
        return become_constant(o, true, "constant");
      if (is_constant(o.a, false))
        return become(o, Op::Not, o.b, ir::kNoValue, "constant");
      if (def(o.b) && def(o.b)->op == Op::Not)
        return become(o, Op::Or, o.a, def(o.b)->a, "inversion");
      return false;
    default:
      return false;
    }
  }

  bool apply_not(Operation &o) {
    const Operation *a = def(o.a);
    if (a && a->op == Op::Constant)
      return become_constant(o, !a->constant, "constant");
    if (a && a->op == Op::Not)
      return become_value(o, a->a, "inversion");
    return false;
  }

  bool apply_and(Operation &o) {
    if (is_constant(o.a, false) || is_constant(o.b, false) || is_not_of(o.a, o.b) || is_not_of(o.b, o.a))
      return become_constant(o, false, "constant");
    if (is_constant(o.b, true) || o.a == o.b)
      return become_value(o, o.a, "constant");
    if (is_constant(o.a, true))
      return become_value(o, o.b, "constant");
    if (absorbs(o.a, Op::Or, o.b))
      return become_value(o, o.a, "absorption");
    if (absorbs(o.b, Op::Or, o.a))
      return become_value(o, o.b, "absorption");
    if (def(o.b) && def(o.b)->op == Op::Not)
      return become(o, Op::AndNot, o.a, def(o.b)->a, "inversion");
    return false;
  }

  bool apply_or(Operation &o) {
    if (is_constant(o.a, true) || is_constant(o.b, true) || is_not_of(o.a, o.b) || is_not_of(o.b, o.a))
      return become_constant(o, true, "constant");
    if (is_constant(o.b, false) || o.a == o.b)
      return become_value(o, o.a, "constant");
    if (is_constant(o.a, false))
      return become_value(o, o.b, "constant");
    if (absorbs(o.a, Op::And, o.b))
      return become_value(o, o.a, "absorption");
    if (absorbs(o.b, Op::And, o.a))
      return become_value(o, o.b, "absorption");
    if (def(o.b) && def(o.b)->op == Op::Not)
      return become(o, Op::OrNot, o.a, def(o.b)->a, "inversion");
    return factor(o);
  }

  /// True where `other` is (x op y) or (y op x), so that x with it is x.
  bool absorbs(ValueId x, Op op, ValueId other) const {
    const Operation *d = def(other);
    return d && d->op == op && (d->a == x || d->b == x);
  }

  /// (x and y) or (x and z): the second product becomes (y or z), the sum x and that. Only where nobody else uses the products.
  bool factor(Operation &o) {
    const Operation *p = def(o.a);
    Operation *q = const_cast<Operation *>(def(o.b));
    if (!p || !q || p == q || p->op != Op::And || q->op != Op::And || uses_[o.a] != 1 || uses_[o.b] != 1)
      return false;
    for (auto [x, y] : {std::pair{p->a, p->b}, {p->b, p->a}})
      for (auto [u, z] : {std::pair{q->a, q->b}, {q->b, q->a}})
        if (x == u && p < q) {
          if (!allowed("factoring"))
            return false;
          q->op = Op::Or;
          q->a = y;
          q->b = z;
          o.op = Op::And;
          o.a = x;
          return true;
        }
    return false;
  }

  void simplify_effects() {
    // Definitions are pointers into the rung, so nothing may move before all conditions have been looked at.
    std::vector<bool> never(rung_.operations.size(), false);
    for (std::size_t i = 0; i < rung_.operations.size(); ++i) {
      Operation &o = rung_.operations[i];
      const bool conditional = o.op == Op::Set || o.op == Op::Reset || o.op == Op::Call;
      if (!conditional || o.a == ir::kNoValue)
        continue;
      if (is_constant(o.a, false))
        never[i] = allowed("never-executed");
      else if (o.op == Op::Call && is_constant(o.a, true) && allowed("always-executed"))
        o.a = ir::kNoValue;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < never.size(); ++i)
      if (!never[i] && kept++ != i)
        rung_.operations[kept - 1] = std::move(rung_.operations[i]);
    rung_.operations.resize(kept);
  }

  ir::Rung &rung_;
  Context &context_;
  Replacement replacement_;
  std::vector<Operation *> definition_;
  std::vector<unsigned> uses_;
};

}  // namespace

void run_simplify(ir::Module &module, Context &context) {
  for (ir::Routine &routine : module.routines)
    for (ir::Rung &rung : routine.rungs)
      RungSimplifier(rung, context).run();
}

}  // namespace ladderc::opt
