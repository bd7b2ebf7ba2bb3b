// Program flow as C++ statements: labels, jumps, loops, calls and states.
//
// A jump is a goto: the lists jump as they like, and a reader who has the list beside the output finds the same labels in both. END
// and FEND are the function's return.
#include "emit/layout.h"
#include "emit/rung.h"

namespace ladderc::emit {

using ir::Op;
using ir::Operation;

std::string routine_name(const ir::Routine &routine) {
  switch (routine.kind) {
  case ir::RoutineKind::Main:
    return "main_program";
  case ir::RoutineKind::Subroutine:
    return "call_" + routine.name;
  case ir::RoutineKind::Interrupt:
    return "interrupt_" + routine.name;
  case ir::RoutineKind::State:
    return "state_" + routine.name;
  }
  return "";
}

std::string label_name(const ir::Module &module, const ir::Place &label) {
  if (label.number >= ir::kHiddenLabel)
    return fmt::format("skip_{}", label.number - ir::kHiddenLabel);
  return ir::to_text(module, label);
}

void RungEmitter::emit_flow(const RungPlan &plan, const Operation &o) {
  const std::string condition = o.a == ir::kNoValue ? "" : expression(plan, o.a).text;
  const std::string guard = condition.empty() ? "" : fmt::format("if ({}) ", condition);
  switch (o.op) {
  case Op::Label:
    if (labels_[o.place.number].used)
      out_.left(label_name(module_, o.place) + ":;", 1);
    return;
  case Op::Jump:
    return emit_jump(o, condition);
  case Op::Gosub:
    if (o.place.is_indexed())
      return out_.statement(fmt::format("{}call({}, {});", guard, number_text(context_, o.place), o.step));
    return out_.statement(fmt::format("{}call_{}();", guard, label_name(module_, o.place)));
  case Op::Loop: {
    const std::string checks = range_checks(o);
    const std::string count = checks.empty() ? input_text(context_, o.inputs.front())
                                             : fmt::format("sys.in_range({}, {}) ? {} : word{{1}}", checks, o.step,
                                                           input_text(context_, o.inputs.front()));
    loops_.push_back(std::make_unique<Block>(
        out_, fmt::format("for (passes[{0}] = sys.passes({1}); passes[{0}] > 0; --passes[{0}]) {{", o.target, count)));
    return;
  }
  case Op::Next:
    if (!loops_.empty())
      loops_.pop_back();
    return;
  case Op::Transfer:
    return emit_transfer(o, condition);
  case Op::Enter:
    return out_.statement(fmt::format("if (const bit active = {}; {}::entered({}, active)) {}(active);", condition,
                                      context_.family.ns.str(), bit_text(context_, o.place),
                                      routine_name(module_.routines[o.target])));
  case Op::Leave:
    return out_.text("leave_states();");
  case Op::Return:
  case Op::EndScan:
    return out_.text("return;");
  default:
    return;
  }
}

void RungEmitter::emit_jump(const Operation &o, const std::string &condition) {
  if (o.place.is_indexed()) {
    std::optional<Block> guard;
    if (!condition.empty())
      guard.emplace(out_, fmt::format("if ({}) {{", condition));
    const Block table(out_, fmt::format("switch ({}) {{", number_text(context_, o.place)));
    for (const auto &[number, label] : labels_)
      if (number < ir::kHiddenLabel) {
        ir::Place target = o.place;
        target.number = number;
        target.index = kNoDevice;
        const std::string back = label.rung <= rung_->number ? "if (!sys.may_jump_back()) return; " : "";
        out_.text(fmt::format("case {}: {}goto {};", number, back, label_name(module_, target)));
      }
    if (context_.family.end_label >= 0)
      out_.text(fmt::format("case {}: return;", context_.family.end_label));
    out_.text(fmt::format("default: sys.no_such_label({});", o.step));
    return;
  }
  const std::string guard = condition.empty() ? "" : fmt::format("if ({}) ", condition);
  const auto label = labels_.find(o.place.number);
  if (label == labels_.end())  // the label that means END
    return out_.statement(guard + "return;");
  const std::string name = label_name(module_, o.place);
  if (label->second.rung > rung_->number)
    return out_.statement(fmt::format("{}goto {};", guard, name));
  const Block back(out_, condition.empty() ? "{" : guard + "{");
  out_.text("if (!sys.may_jump_back()) return;  // the watchdog of a loop without end");
  out_.text(fmt::format("goto {};", name));
}

void RungEmitter::emit_transfer(const Operation &o, const std::string &condition) {
  const DeviceInfo &device = context_.family.devices[o.place.device];
  std::string numbers = subscript(device, o.place.number);
  for (const ir::Place &source : o.inputs)
    numbers += ", " + subscript(device, source.number);
  out_.statement(fmt::format("if (sys.transfer({})) states.transfer({}, {});", condition, device.image.str(), numbers));
}

}  // namespace ladderc::emit
