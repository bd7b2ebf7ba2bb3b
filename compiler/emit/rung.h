// One rung as C++ statements.
#pragma once

#include "emit/expressions.h"
#include "emit/writer.h"

#include "llvm/ADT/StringSet.h"

#include <functional>
#include <map>
#include <memory>

namespace ladderc::emit {

class RungEmitter {
public:
  RungEmitter(const ir::Module &module, const PlaceContext &context, Writer &out, bool group_calls)
      : module_(module), context_(context), out_(out), group_calls_(group_calls) {}

  /// Called with the step of each statement before it is written: -g puts the list's line there.
  void set_before_statement(std::function<void(std::uint32_t step)> before) { before_statement_ = std::move(before); }
  /// Call before the first rung of a function: names of lines are unique within one, labels are those of its routine.
  void begin_function(const ir::Routine &routine);
  void emit(const ir::Rung &rung);

private:
  void emit_operation(const ir::Rung &rung, const RungPlan &plan, std::size_t index);
  void emit_call(const ir::Operation &o);
  void emit_run(const RungPlan &plan, const ir::Operation &o);
  void emit_memory(const ir::Operation &o, const std::string &on);
  void emit_flow(const RungPlan &plan, const ir::Operation &o);
  void emit_jump(const ir::Operation &o, const std::string &condition);
  void emit_transfer(const ir::Operation &o, const std::string &condition);
  std::string range_checks(const ir::Operation &o) const;
  bool declares_names(const RungPlan &plan) const;
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
  struct LabelPlace {
    std::uint32_t rung;
    bool used;
  };
  std::map<std::uint32_t, LabelPlace> labels_;  ///< of the routine, by number
  bool has_jumps_ = false;
  llvm::SmallVector<std::unique_ptr<Block>, 4> loops_;
  std::function<void(std::uint32_t step)> before_statement_ = [](std::uint32_t) {};
};

/// Function of a routine: `call_P10`, `interrupt_I001`, `state_S20`.
std::string routine_name(const ir::Routine &routine);
/// `P8`, `skip_0`.
std::string label_name(const ir::Module &module, const ir::Place &label);
bool has_interrupts(const ir::Module &module);

/// True where a rung may stop the scan (its function returns bool).
bool can_stop(const ir::Rung &rung);

}  // namespace ladderc::emit
