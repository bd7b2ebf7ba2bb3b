// One rung as C++ statements.
#pragma once

#include "emit/expressions.h"
#include "emit/writer.h"

#include "llvm/ADT/StringSet.h"

#include <functional>

namespace ladderc::emit {

class RungEmitter {
public:
  RungEmitter(const ir::Module &module, const PlaceContext &context, Writer &out, bool group_calls)
      : module_(module), context_(context), out_(out), group_calls_(group_calls) {}

  /// Called with the step of each statement before it is written: -g puts the list's line there.
  void set_before_statement(std::function<void(std::uint32_t step)> before) { before_statement_ = std::move(before); }
  /// Call before the first rung of a function: names of lines are unique within one.
  void begin_function() { names_.clear(); }
  void emit(const ir::Rung &rung);

private:
  void emit_operation(const ir::Rung &rung, const RungPlan &plan, std::size_t index);
  void emit_call(const ir::Operation &o);
  void emit_run(const RungPlan &plan, const ir::Operation &o);
  const ir::Operation *inversion_of(const RungPlan &plan, const ir::Operation &store) const;
  bool always(const RungPlan &plan, ir::ValueId v) const;
  Expression expression(const RungPlan &plan, ir::ValueId v);
  Expression operation_text(const RungPlan &plan, const ir::Operation &o);
  std::string line_name(std::uint32_t step);

  const ir::Module &module_;
  const PlaceContext &context_;
  Writer &out_;
  bool group_calls_;
  const ir::Rung *rung_ = nullptr;
  std::vector<std::string> value_names_;
  llvm::StringSet<> names_;
  std::function<void(std::uint32_t step)> before_statement_ = [](std::uint32_t) {};
};

/// True where a rung may stop the scan (its function returns bool).
bool can_stop(const ir::Rung &rung);

}  // namespace ladderc::emit
