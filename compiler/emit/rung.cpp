// One rung as C++ statements.
//
// `&` and `|`, not `&&` and `||`: bits are values and every contact is read. `if` stands only where instructions are executed
// conditionally. A call that may fail returns from its function with what the system says (false: the CPU has stopped).
#include "emit/rung.h"

#include "emit/layout.h"

#include "syntax/parser.h"

#include <optional>

namespace ladderc::emit {

using ir::Op;
using ir::Operation;

bool can_stop(const ir::Rung &rung) {
  return llvm::any_of(rung.operations, [](const Operation &o) {
    return o.info && ((o.info->error_code != 0 && !o.info->passes_system) || o.info->stops_scan);
  });
}

bool has_interrupts(const ir::Module &module) {
  return llvm::any_of(module.routines, [](const ir::Routine &r) { return r.kind == ir::RoutineKind::Interrupt; });
}

std::string RungEmitter::line_name(std::uint32_t step) {
  std::string name = fmt::format("line_{}", step);
  for (char suffix = 'b'; !names_.insert(name).second; ++suffix)
    name = suffix <= 'z' ? fmt::format("line_{}{}", step, suffix) : name + "x";
  return name;
}

void RungEmitter::begin_function(const ir::Routine &routine) {
  names_.clear();
  labels_.clear();
  has_jumps_ = false;
  for (const ir::Rung &rung : routine.rungs)
    for (const Operation &o : rung.operations) {
      if (o.op == Op::Label)
        labels_[o.place.number] = {rung.number, false};
      has_jumps_ |= o.op == Op::Jump;
    }
  for (const ir::Rung &rung : routine.rungs)
    for (const Operation &o : rung.operations)
      if (o.op == Op::Jump)
        for (auto &[number, label] : labels_)
          label.used |= number == o.place.number || (o.place.is_indexed() && number < ir::kHiddenLabel);
}

void RungEmitter::emit(const ir::Rung &rung) {
  rung_ = &rung;
  value_names_.assign(rung.values, {});
  const RungPlan plan(module_, rung, group_calls_);
  // A jump may not cross the declaration of a name.
  std::optional<Block> scope;
  if (has_jumps_ && declares_names(plan))
    scope.emplace(out_, "{");
  for (std::size_t i = 0; i < rung.operations.size(); ++i) {
    if (plan.inlined(i))
      continue;
    const Operation &o = rung.operations[i];
    before_statement_(o.step);
    if (o.op != Op::Call || o.a == ir::kNoValue) {
      emit_operation(rung, plan, i);
      continue;
    }
    const Block guard = out_.block(fmt::format("if ({})", expression(plan, o.a).text));
    emit_call(o);
    while (i + 1 < rung.operations.size() && plan.continues_group(i + 1)) {
      before_statement_(rung.operations[++i].step);
      emit_call(rung.operations[i]);
    }
  }
}

bool RungEmitter::declares_names(const RungPlan &plan) const {
  for (std::size_t i = 0; i < rung_->operations.size(); ++i) {
    const Operation &o = rung_->operations[i];
    if (!plan.inlined(i) && ir::is_value(o.op) && plan.uses(o.result) > 0)
      return true;
  }
  return false;
}

void RungEmitter::emit_operation(const ir::Rung &rung, const RungPlan &plan, std::size_t index) {
  const Operation &o = rung.operations[index];
  switch (o.op) {
  case Op::Store:
    if (const Operation *change = inversion_of(plan, o))
      return out_.statement(fmt::format("{} ^= {};", bit_text(context_, o.place), expression(plan, change->b).text));
    return out_.statement(fmt::format("{} = {};", bit_text(context_, o.place), expression(plan, o.a).text));
  case Op::Set:
    if (always(plan, o.a))
      return out_.statement(bit_text(context_, o.place) + " = on;");
    return out_.statement(fmt::format("{} |= {};", bit_text(context_, o.place), expression(plan, o.a).text));
  case Op::Reset:
    if (always(plan, o.a))
      return out_.statement(bit_text(context_, o.place) + " = off;");
    return out_.statement(
        fmt::format("{} &= !{};", bit_text(context_, o.place), operand_of(expression(plan, o.a), Precedence::Not)));
  case Op::Call:
    return emit_call(o);
  case Op::Run:
    return emit_run(plan, o);
  default:
    if (ir::is_flow(o.op))
      return emit_flow(plan, o);
    break;
  }
  const std::string text = operation_text(plan, o).text;
  if (plan.uses(o.result) == 0)
    return out_.statement(text + ";");  // an edge whose result nobody needs still renews its memory
  value_names_[o.result] = line_name(o.step);
  out_.statement(fmt::format("const bit {} = {};", value_names_[o.result], text));
}

std::string RungEmitter::range_checks(const Operation &o) const {
  std::string checks;
  auto add = [&](const ir::Place &p) {
    if (p.is_indexed() && !p.is_constant() && p.kind != ir::PlaceKind::Label)
      if (const std::string check = range_check(context_, p); checks.find(check) == std::string::npos)
        checks += (checks.empty() ? "" : " && ") + check;
  };
  for (const ir::Place &p : o.inputs)
    add(p);
  for (const ir::Place &p : o.outputs)
    add(p);
  return checks;
}

void RungEmitter::emit_call(const Operation &o) {
  const std::string checks = range_checks(o);
  const std::string guard = checks.empty() ? "" : fmt::format("if (sys.in_range({}, {})) ", checks, o.step);
  const InstructionInfo &info = *o.info;
  switch (info.style) {
  case CallStyle::Value:
    return out_.statement(fmt::format("{}{} = {};", guard, output_text(context_, o.outputs.front()), call_text(context_, o)));
  case CallStyle::Status: {
    if (!context_.family.errors_stop)
      return out_.statement(fmt::format("{}sys.check({}, {});", guard, call_text(context_, o), o.step));
    const std::string mask =
        info.error_mask.empty()
            ? ""
            : " && !" + bit_text(context_, ir::to_place(parse_operand(context_.family, info.error_mask, {}), OperandType::Bit));
    return out_.statement(
        fmt::format("if (!{}{}) return sys.operation_error({}, {});", call_text(context_, o), mask, info.error_code, o.step));
  }
  case CallStyle::Method: {
    std::string arguments;
    for (const ir::Place &p : o.inputs)
      arguments += (arguments.empty() ? "" : ", ") + input_text(context_, p);
    return out_.statement(
        fmt::format("{}{}.{}({});", guard, object_text(context_, o.outputs.front()), info.function.str(), arguments));
  }
  case CallStyle::System: {
    std::string arguments;
    for (const ir::Place &p : o.outputs)
      arguments += object_text(context_, p) + ", ";
    for (const ir::Place &p : o.inputs)
      arguments += input_text(context_, p) + ", ";
    // The step goes into the error information.
    out_.statement(fmt::format("{}{}sys.{}({}{});", guard, info.stops_scan ? "return " : "", info.function.str(), arguments, o.step));
    if (info.category == "interrupt" && has_interrupts(module_))
      out_.text("run_interrupts();");  // those that were held follow at once
    return;
  }
  default:
    return out_.statement(guard + call_text(context_, o) + ";");
  }
}

void RungEmitter::emit_run(const RungPlan &plan, const Operation &o) {
  const InstructionInfo &info = *o.info;
  std::string on = expression(plan, o.a).text;
  if (info.style == CallStyle::Memory)
    return emit_memory(o, on);
  std::string inputs;
  for (const ir::Place &p : o.inputs)
    inputs += ", " + input_text(context_, p);
  const std::string object = object_text(context_, o.outputs.front());
  if (info.style == CallStyle::Method)
    return out_.statement(fmt::format("{}.{}({}{}, sys);", object, info.function.str(), on, inputs));
  // A counter does not know its number, which its direction relay and its inputs have.
  const std::string number =
      o.outputs.front().type == OperandType::LongCounter ? fmt::format(", {}", o.outputs.front().number) : "";
  return out_.statement(fmt::format("sys.{}({}{}, {}{}, {});", info.function.str(), object, number, on, inputs, o.step));
}

/// An instruction with a memory of its own sees its condition ON and OFF.
void RungEmitter::emit_memory(const Operation &o, const std::string &on) {
  const std::string object = memory_name(*o.info, o.step);
  const std::string rest = arguments_text(context_, o);
  auto call = [&](const std::string &condition) {
    const std::string text = fmt::format("{}.run({}, {})", object, condition, rest);
    return o.info->error_code ? fmt::format("sys.check({}, {});", text, o.step) : text + ";";
  };
  const std::string checks = range_checks(o);
  if (checks.empty())
    return out_.statement(call(on));
  const Block scope = out_.block("");
  out_.statement(fmt::format("const bit on_{} = {};", o.step, on));
  out_.statement(fmt::format("if (sys.in_range({0}, {1}, on_{1})) {2}", checks, o.step, call(fmt::format("on_{}", o.step))));
}

/// The exclusive or of `store P, (load P) ^ x`, which is written `P ^= x`; else null.
const Operation *RungEmitter::inversion_of(const RungPlan &plan, const Operation &store) const {
  const std::size_t index = plan.definition(store.a);
  const Operation &change = rung_->operations[index];
  if (change.op != Op::Xor || !plan.inlined(index) || !plan.inlined(plan.definition(change.a)))
    return nullptr;
  const Operation &before = rung_->operations[plan.definition(change.a)];
  return before.op == Op::Load && before.place == store.place ? &change : nullptr;
}

bool RungEmitter::always(const RungPlan &plan, ir::ValueId v) const {
  const Operation &o = rung_->operations[plan.definition(v)];
  return o.op == Op::Constant && o.constant;
}

Expression RungEmitter::expression(const RungPlan &plan, ir::ValueId v) {
  if (!value_names_[v].empty())
    return {value_names_[v], Precedence::Primary};
  return operation_text(plan, rung_->operations[plan.definition(v)]);
}

Expression RungEmitter::operation_text(const RungPlan &plan, const Operation &o) {
  // g++ warns of `!a & b`, which with numbers would often be a mistake: an operand in front gets parentheses around its `!`.
  auto in_front = [](const Expression &e, std::string text) { return e.precedence == Precedence::Not ? "(" + text + ")" : text; };
  auto binary = [&](const char *sign, Precedence precedence, bool invert_second) -> Expression {
    const Expression first = expression(plan, o.a);
    const std::string a = in_front(first, operand_of(first, precedence));
    const std::string b = operand_of(expression(plan, o.b), invert_second ? Precedence::Not : precedence);
    return {fmt::format("{} {} {}{}", a, sign, invert_second ? "!" : "", b), precedence};
  };
  switch (o.op) {
  case Op::Constant:
    return {o.constant ? "on" : "off"};
  case Op::Load:
    return {bit_text(context_, o.place)};
  case Op::Not:
    return {"!" + operand_of(expression(plan, o.a), Precedence::Not), Precedence::Not};
  case Op::And:
    return binary("&", Precedence::And, false);
  case Op::AndNot:
    return binary("&", Precedence::And, true);
  case Op::Or:
  case Op::OrNot: {
    // Compilers ask for parentheses around `&` inside of `|`. Each side is written once: chains of OR are long.
    auto side = [](const Expression &e, bool invert) {
      const bool bare = !invert && e.precedence == Precedence::Or;
      return (invert ? "!" : "") + (bare ? e.text : operand_of(e, Precedence::Not));
    };
    const Expression first = expression(plan, o.a), second = expression(plan, o.b);
    return {in_front(first, side(first, false)) + " | " + side(second, o.op == Op::OrNot), Precedence::Or};
  }
  case Op::Xor:
    return {fmt::format("{} ^ {}", operand_of(expression(plan, o.a), Precedence::Not),
                        operand_of(expression(plan, o.b), Precedence::Not)),
            Precedence::Xor};
  case Op::Rising:
  case Op::Falling:
  case Op::Pulse:
    return {fmt::format("{}({}, {})",
                        o.op == Op::Rising    ? "rising"
                        : o.op == Op::Falling ? "falling"
                                              : "sys.pulse",
                        bit_text(context_, o.place), expression(plan, o.a).text)};
  case Op::Active:
    return {"active"};
  default:
    return {call_text(context_, o)};
  }
}

}  // namespace ladderc::emit
