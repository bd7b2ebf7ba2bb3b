// Runs IR on bits.
#include "machine.h"

#include "ir/extent.h"

namespace ladderc::test {

namespace {

using ir::Op;
using ir::Operation;
using ir::Place;

class Machine {
public:
  Machine(const ir::Module &module, const Cells &cells) : module_(module) {
    outcome_.cells = cells;
    outcome_.cells["SM400"] = true;
  }

  void run_direct(const ir::Rung &rung) {
    values_.assign(rung.values, false);
    for (const Operation &o : rung.operations)
      if (ir::is_value(o.op))
        values_[o.result] = value(o, values_[o.a == ir::kNoValue ? 0 : o.a], values_[o.b == ir::kNoValue ? 0 : o.b]);
      else
        effect(o, o.a == ir::kNoValue || values_[o.a]);
  }

  /// As the emitter prints it: what is inlined is worked out where its user stands.
  void run_printed(const ir::Rung &rung, bool group_calls, bool right_first) {
    values_.assign(rung.values, false);
    const emit::RungPlan plan(module_, rung, group_calls);
    right_first_ = right_first;
    bool condition = false;
    for (std::size_t i = 0; i < rung.operations.size(); ++i) {
      if (plan.inlined(i))
        continue;
      const Operation &o = rung.operations[i];
      if (ir::is_value(o.op)) {
        values_[o.result] = printed(rung, plan, i);
        continue;
      }
      if (!plan.continues_group(i))
        condition = o.a == ir::kNoValue || expression(rung, plan, o.a);
      effect(o, condition);
    }
  }

  Outcome take() { return std::move(outcome_); }

private:
  bool expression(const ir::Rung &rung, const emit::RungPlan &plan, ir::ValueId v) {
    const std::size_t index = plan.definition(v);
    return plan.inlined(index) ? printed(rung, plan, index) : values_[v];
  }
  bool printed(const ir::Rung &rung, const emit::RungPlan &plan, std::size_t index) {
    const Operation &o = rung.operations[index];
    bool a = false, b = false;
    if (right_first_ && o.b != ir::kNoValue)
      b = expression(rung, plan, o.b);
    if (o.a != ir::kNoValue)
      a = expression(rung, plan, o.a);
    if (!right_first_ && o.b != ir::kNoValue)
      b = expression(rung, plan, o.b);
    return value(o, a, b);
  }

  bool &cell(const Place &place) { return outcome_.cells[ir::to_text(module_, place)]; }

  bool value(const Operation &o, bool a, bool b) {
    switch (o.op) {
    case Op::Constant:
      return o.constant;
    case Op::Load:
      return cell(o.place);
    case Op::Not:
      return !a;
    case Op::And:
      return a && b;
    case Op::AndNot:
      return a && !b;
    case Op::Or:
      return a || b;
    case Op::OrNot:
      return a || !b;
    case Op::Xor:
      return a != b;
    case Op::Rising:
    case Op::Falling: {
      bool &memory = cell(o.place);
      const bool edge = o.op == Op::Rising ? a && !memory : !a && memory;
      memory = a;
      return edge;
    }
    default:  // a comparison: some function of the bits that it reads
      return read_bits(o).find('1') != std::string::npos;
    }
  }

  void effect(const Operation &o, bool on) {
    switch (o.op) {
    case Op::Store:
      cell(o.place) = on;
      return;
    case Op::Set:
      cell(o.place) |= on;
      return;
    case Op::Reset:
      cell(o.place) &= !on;
      return;
    case Op::Run:
      outcome_.trace.push_back("run " + o.info->form.str() + (on ? " 1 " : " 0 ") + read_bits(o));
      return;
    default:
      if (on)
        call(o);
    }
  }

  void call(const Operation &o) {
    std::string line = "call " + o.info->form.str() + " " + read_bits(o);
    if (ir::is_barrier(o))
      for (const auto &[name, on] : outcome_.cells)
        line += on ? " " + name : "";
    outcome_.trace.push_back(line);
    if (o.inputs.size() == 1 && o.inputs[0].is_constant() && o.outputs.size() == 1 && o.outputs[0].kind == ir::PlaceKind::Digits)
      for (unsigned i = 0; i < 4u * o.outputs[0].digits; ++i)
        cell(bit_of(o.outputs[0], i)) = (o.inputs[0].value >> i & 1) != 0;
  }

  static Place bit_of(const Place &digits, unsigned i) {
    Place bit = digits;
    bit.kind = ir::PlaceKind::Bit;
    bit.number += i;
    return bit;
  }

  std::string read_bits(const Operation &o) {
    std::string text;
    for (const Place &p : o.inputs)
      if (p.kind == ir::PlaceKind::Digits)
        for (unsigned i = 0; i < 4u * p.digits; ++i)
          text += cell(bit_of(p, i)) ? '1' : '0';
    return text;
  }

  const ir::Module &module_;
  Outcome outcome_;
  std::vector<bool> values_;
  bool right_first_ = false;
};

}  // namespace

std::string to_text(const Outcome &outcome) {
  std::string text;
  for (const auto &[name, on] : outcome.cells)
    if (on)
      text += name + " ";
  for (const std::string &line : outcome.trace)
    text += "\n  " + line;
  return text;
}

Outcome run_scan(const ir::Module &module, const Cells &cells, Way way, bool group_calls) {
  Machine machine(module, cells);
  for (const ir::Rung &rung : module.routines.front().rungs)
    if (way == Way::Direct)
      machine.run_direct(rung);
    else
      machine.run_printed(rung, group_calls, way == Way::RightFirst);
  Outcome outcome = machine.take();
  // A cell that was looked at and one that was not are both OFF.
  std::erase_if(outcome.cells, [](const auto &entry) { return !entry.second; });
  return outcome;
}

}  // namespace ladderc::test
