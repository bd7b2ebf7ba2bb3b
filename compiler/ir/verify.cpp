// The verifier: what every pass may rely on and must keep.
#include "ir/extent.h"
#include "ir/ir.h"

#include <fmt/format.h>

namespace ladderc::ir {

namespace {

/// Checks one rung; values are local to it.
class RungVerifier {
public:
  RungVerifier(const Module &module, const Rung &rung) : module_(module), rung_(rung), defined_(rung.values, false) {}

  std::string run() {
    for (const Operation &o : rung_.operations) {
      if (std::string problem = check(o); !problem.empty())
        return fmt::format("rung {} (step {}): {}: {}", rung_.number, rung_.step, to_text(module_, o), problem);
      if (is_value(o.op))
        defined_[o.result] = true;
    }
    return {};
  }

private:
  std::string check(const Operation &o) {
    if (is_value(o.op)) {
      if (o.result >= rung_.values)
        return "value number out of range";
      if (defined_[o.result])
        return "value defined twice";
    }
    const bool needs_a = o.op == Op::Not || is_edge(o.op) || (o.op >= Op::And && o.op <= Op::Xor) || o.op == Op::Store ||
                         o.op == Op::Set || o.op == Op::Reset || o.op == Op::Run || o.op == Op::Transfer || o.op == Op::Enter;
    const bool needs_b = o.op == Op::And || o.op == Op::AndNot || o.op == Op::Or || o.op == Op::OrNot || o.op == Op::Xor;
    if ((needs_a || o.a != kNoValue) && !usable(o.a))
      return "operand used before its definition";
    if (needs_b && !usable(o.b))
      return "operand used before its definition";
    if (o.op == Op::Test || o.op == Op::Call || o.op == Op::Run) {
      if (!o.info)
        return "no table entry";
      if (o.inputs.size() != o.info->inputs.size() || o.outputs.size() != o.info->outputs.size())
        return "operands do not match the table entry";
    }
    if (o.op == Op::Enter && (o.target >= module_.routines.size() || module_.routines[o.target].kind != RoutineKind::State))
      return "no such state routine";
    if ((o.op == Op::Loop || o.op == Op::Next) && o.target >= module_.loops)
      return "no such loop";
    if (o.op == Op::Loop && o.inputs.size() != 1)
      return "a loop has one count";
    if (o.op == Op::Load || is_edge(o.op) || o.op == Op::Store || o.op == Op::Set || o.op == Op::Reset || o.op == Op::Transfer ||
        o.op == Op::Enter)
      if (std::string problem = check(o.place); !problem.empty())
        return problem;
    for (const Place &p : o.inputs)
      if (std::string problem = check(p); !problem.empty())
        return problem;
    for (const Place &p : o.outputs)
      if (std::string problem = p.is_constant() ? "constant as output" : check(p); !problem.empty())
        return problem;
    return {};
  }

  std::string check(const Place &p) const {
    switch (p.kind) {
    case PlaceKind::Decimal:
    case PlaceKind::Hex:
      return {};
    case PlaceKind::Edge:
      return p.number < module_.edges.size() ? "" : "no such edge memory";
    case PlaceKind::Master:
      return p.number < module_.master_levels ? "" : "no such master control state";
    case PlaceKind::Label:
      return {};
    case PlaceKind::Text:
      return static_cast<std::size_t>(p.value) < module_.texts.size() ? "" : "no such text";
    default:
      return p.device < module_.family->devices.size() ? "" : "no such device class";
    }
  }

  bool usable(ValueId v) const { return v < defined_.size() && defined_[v]; }

  const Module &module_;
  const Rung &rung_;
  std::vector<bool> defined_;
};

}  // namespace

std::string verify(const Module &module) {
  for (const Routine &routine : module.routines)
    for (const Rung &rung : routine.rungs)
      if (std::string problem = RungVerifier(module, rung).run(); !problem.empty())
        return problem;
  return {};
}

}  // namespace ladderc::ir
