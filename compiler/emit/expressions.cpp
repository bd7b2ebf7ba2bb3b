// Planning and printing of expressions.
#include "emit/expressions.h"

#include "ir/extent.h"

#include "llvm/ADT/STLExtras.h"

#include <fmt/format.h>

#include <algorithm>

namespace ladderc::emit {

using ir::Op;
using ir::Operation;
using ir::ValueId;

namespace {

constexpr unsigned kMaxExpressionSize = 48;

bool is_edge(const Operation &o) {
  return ir::is_edge(o.op);
}
bool is_effect(const Operation &o) {
  return !ir::is_value(o.op) || is_edge(o);
}

}  // namespace

RungPlan::RungPlan(const ir::Module &module, const ir::Rung &rung, bool group_calls)
    : rung_(rung), inlined_(rung.operations.size(), false), continues_(rung.operations.size(), false), definition_(rung.values, 0),
      uses_(rung.values, 0) {
  count_uses(group_calls);
  decide(module);
}

/// Walks backwards: what a dead value uses is not used.
void RungPlan::count_uses(bool group_calls) {
  for (std::size_t i = rung_.operations.size(); i-- > 0;) {
    const Operation &o = rung_.operations[i];
    if (is_effect(o))
      effects_.push_back(i);
    if (ir::is_value(o.op))
      definition_[o.result] = i;
    if (group_calls && i > 0 && o.op == Op::Call && o.a != ir::kNoValue) {
      const Operation &before = rung_.operations[i - 1];
      continues_[i] = before.op == Op::Call && before.a == o.a;
    }
    if (continues_[i] || (!is_effect(o) && uses_[o.result] == 0))
      continue;
    for (const ValueId v : {o.a, o.b})
      if (v != ir::kNoValue)
        ++uses_[v];
  }
  std::reverse(effects_.begin(), effects_.end());
}

/// Walks backwards, so that the places where the users of a value are printed are known when it is decided.
void RungPlan::decide(const ir::Module &module) {
  std::vector<std::size_t> last_use(rung_.values, 0);
  std::vector<unsigned> size(rung_.values, 1);
  for (const Operation &o : rung_.operations)
    if (ir::is_value(o.op))
      for (const ValueId v : {o.a, o.b})
        if (v != ir::kNoValue)
          size[o.result] += size[v] > kMaxExpressionSize ? 1 : size[v];
  for (std::size_t i = rung_.operations.size(); i-- > 0;) {
    const Operation &o = rung_.operations[i];
    std::size_t printed_at = i;
    if (ir::is_value(o.op)) {
      const unsigned uses = uses_[o.result];
      if (uses == 0 && !is_edge(o)) {
        inlined_[i] = true;  // and never asked for
        continue;
      }
      const bool repeatable = o.op == Op::Constant || o.op == Op::Load || o.op == Op::Active;
      if (uses == 1 || (uses > 1 && repeatable))
        inlined_[i] = size[o.result] <= kMaxExpressionSize && may_move(module, i, last_use[o.result]);
      if (inlined_[i])
        printed_at = last_use[o.result];
    }
    for (const ValueId v : {o.a, o.b})
      if (v != ir::kNoValue && !continues_[i])
        last_use[v] = std::max(last_use[v], printed_at);
  }
}

bool RungPlan::may_move(const ir::Module &module, std::size_t from, std::size_t to) const {
  const Operation &moved = rung_.operations[from];
  if (moved.op != Op::Load && moved.op != Op::Test && !is_edge(moved))
    return true;  // works on values only
  auto conflicts = [&](const Operation &between) {
    if (ir::is_barrier(between))
      return true;
    bool conflict = false;
    ir::for_each_read(module, moved, [&](const ir::Extent &r) {
      ir::for_each_write(module, between, [&](const ir::Extent &w) { conflict |= ir::overlap(r, w); });
    });
    if (is_edge(moved))
      ir::for_each_write(module, moved, [&](const ir::Extent &w) {
        ir::for_each_read(module, between, [&](const ir::Extent &r) { conflict |= ir::overlap(r, w); });
      });
    return conflict;
  };
  if (is_edge(moved) && moved.place.kind != ir::PlaceKind::Edge) {
    // The memory is a device that anything in between may look at.
    for (std::size_t i = from + 1; i < to; ++i)
      if (conflicts(rung_.operations[i]))
        return false;
    return true;
  }
  for (auto i = std::upper_bound(effects_.begin(), effects_.end(), from); i != effects_.end() && *i < to; ++i)
    if (conflicts(rung_.operations[*i]))
      return false;
  return true;
}

std::string operand_of(const Expression &expression, Precedence at_least) {
  return expression.precedence < at_least ? "(" + expression.text + ")" : expression.text;
}

std::string arguments_text(const PlaceContext &context, const Operation &operation) {
  const InstructionInfo &info = *operation.info;
  std::string arguments;
  auto add = [&](const std::string &text) { arguments += (arguments.empty() ? "" : ", ") + text; };
  for (llvm::StringRef image : info.images)
    add(context.family.devices[find_device(context.family, image)].image.str());
  for (const ir::Place &p : operation.inputs)
    add(input_text(context, p));
  if (info.style != CallStyle::Value)
    for (const ir::Place &p : operation.outputs)
      // Blocks, runs and objects that are read, too, stand among the inputs already.
      if (!((ir::is_run(p.type) || p.kind == ir::PlaceKind::Object) && llvm::is_contained(operation.inputs, p)))
        add(output_text(context, p));
  if (info.passes_system)
    add("sys");
  return arguments;
}

std::string call_text(const PlaceContext &context, const Operation &operation) {
  const InstructionInfo &info = *operation.info;
  const std::string arguments = arguments_text(context, operation);
  if (info.function.empty())
    return arguments.empty() ? "0" : arguments;
  return fmt::format("{}::{}({})", context.family.ops.str(), info.function.str(), arguments);
}

}  // namespace ladderc::emit
