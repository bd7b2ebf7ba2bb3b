// The symbolic stack machine.
//
//     LD X0 / OR Y5 / ANI X1 / OUT Y5      %0 = load X0   %1 = load Y5   %2 = or %0, %1   %3 = load X1   %4 = andn %2, %3   store
//     Y5, %4
//
// The block stack and the branch stack of the controller hold results; here they hold value numbers, and walking the list once
// leaves no stack. A load is made where its contact stands, so that it sees what the rung has written before it.
//
// Master control: MC stores its condition in master control state n. Inside the region every output-type instruction acts on
// (result and state of the innermost open level); contacts, INV and the like do not see it (an INV in the region must not turn an
// OUT on while the master is off). The condition of an inner MC contains the outer one, so the innermost state is enough. Edge
// memories of P forms and PLS see the condition with the master in it; those of edge contacts follow their device, those of MEP,
// MEF, EGP and EGF the plain result.
#include "lower/lower.h"

namespace ladderc {

namespace {

using ir::Op;
using ir::Operation;
using ir::Place;
using ir::PlaceKind;
using ir::ValueId;

class Lowerer {
public:
  explicit Lowerer(const CheckedProgram &program) : program_(program) {
    module_.family = program.family;
    module_.name = program.parameters.program_name;
    module_.points = program.parameters.points;
    module_.routines.push_back({"main", {}});
    module_.routines.back().rungs.reserve(program.rungs);
  }

  ir::Module run() {
    const std::vector<Instruction> &list = program_.list.instructions;
    for (std::uint32_t i = 0; i < list.size(); ++i) {
      const Instruction &instruction = list[i];
      if (instruction.info->lowering == Lowering::End)
        break;
      if (!rung_ || instruction.rung != rung_->number)
        begin_rung(instruction, i);
      ++rung_->instruction_count;
      lower(instruction);
    }
    return std::move(module_);
  }

private:
  void begin_rung(const Instruction &instruction, std::uint32_t index) {
    std::vector<ir::Rung> &rungs = module_.routines.front().rungs;
    rung_ = &rungs.emplace_back();
    rung_->number = instruction.rung;
    rung_->step = instruction.step;
    rung_->first_instruction = index;
    rung_->range = instruction.range;
    blocks_.clear();
    branches_.clear();
    master_condition_of_ = ir::kNoValue;
  }

  // ---- building operations
  Operation &append(Op op) {
    Operation &o = rung_->operations.emplace_back();
    o.op = op;
    o.step = current_->step;
    if (ir::is_value(op))
      o.result = rung_->values++;
    return o;
  }
  ValueId load(const Place &place) {
    Operation &o = append(Op::Load);
    o.place = place;
    return o.result;
  }
  ValueId unary(Op op, ValueId a) {
    Operation &o = append(op);
    o.a = a;
    return o.result;
  }
  ValueId binary(Op op, ValueId a, ValueId b) {
    Operation &o = append(op);
    o.a = a;
    o.b = b;
    return o.result;
  }
  ValueId edge(Execution kind, const Place &memory, ValueId a) {
    Operation &o = append(kind == Execution::FallingEdge ? Op::Falling : Op::Rising);
    o.place = memory;
    o.a = a;
    return o.result;
  }
  void effect(Op op, const Place &place, ValueId a) {
    Operation &o = append(op);
    o.place = place;
    o.a = a;
  }
  Place new_edge() {
    Place p;
    p.kind = PlaceKind::Edge;
    p.number = static_cast<std::uint32_t>(module_.edges.size());
    module_.edges.push_back({current_->step});
    return p;
  }
  static Place master(unsigned level) {
    Place p;
    p.kind = PlaceKind::Master;
    p.number = level;
    return p;
  }
  Place operand(unsigned index) const {
    return ir::to_place(program_.list.operands_of(*current_)[index], current_->info->operands[index].type);
  }
  unsigned level(unsigned index) const { return static_cast<unsigned>(program_.list.operands_of(*current_)[index].value); }

  /// The result that an output-type instruction acts on.
  ValueId condition() {
    const ValueId result = blocks_.back();
    if (open_levels_.empty())
      return result;
    if (master_condition_of_ != result) {
      master_condition_of_ = result;
      master_condition_ = binary(Op::And, result, load(master(open_levels_.back())));
    }
    return master_condition_;
  }

  // ---- instructions
  void lower(const Instruction &instruction) {
    current_ = &instruction;
    const InstructionInfo &info = *instruction.info;
    switch (info.lowering) {
    case Lowering::Contact:
    case Lowering::CompareContact:
      return lower_contact(info);
    case Lowering::AndBlock:
    case Lowering::OrBlock: {
      const ValueId second = blocks_.pop_back_val();
      blocks_.back() = binary(info.lowering == Lowering::AndBlock ? Op::And : Op::Or, blocks_.back(), second);
      return;
    }
    case Lowering::PushBranch:
      branches_.push_back(blocks_.back());
      return;
    case Lowering::ReadBranch:
      restore_branch();
      return;
    case Lowering::PopBranch:
      restore_branch();
      branches_.pop_back();
      return;
    case Lowering::Invert:
      blocks_.back() = unary(Op::Not, blocks_.back());
      return;
    case Lowering::EdgeOfResult:
      blocks_.back() = edge(info.edge, new_edge(), blocks_.back());
      return;
    case Lowering::EdgeRelay:
      blocks_.back() = edge(info.edge, operand(0), blocks_.back());
      return;
    case Lowering::Nothing:
    case Lowering::End:
      return;
    default:
      return lower_output(info);
    }
  }

  /// MRD and MPP: the branch's result takes the place of whatever the branch before left in the block that MPS was in.
  void restore_branch() { blocks_.back() = branches_.back(); }

  void lower_contact(const InstructionInfo &info) {
    ValueId value;
    if (info.lowering == Lowering::CompareContact) {
      Operation &o = append(Op::Test);
      o.info = &info;
      value = o.result;
      fill_operands(o, info);
    } else {
      value = load(operand(0));
      if (info.edge != Execution::EveryScan)
        value = edge(info.edge, new_edge(), value);
    }
    const bool negated = info.negated;
    switch (info.placement) {
    case Placement::Series:
      blocks_.back() = binary(negated ? Op::AndNot : Op::And, blocks_.back(), value);
      break;
    case Placement::Parallel:
      blocks_.back() = binary(negated ? Op::OrNot : Op::Or, blocks_.back(), value);
      break;
    default:
      blocks_.push_back(negated ? unary(Op::Not, value) : value);
    }
  }

  void lower_output(const InstructionInfo &info) {
    switch (info.lowering) {
    case Lowering::Store:
      return effect(Op::Store, operand(0), condition());
    case Lowering::Set:
      return effect(Op::Set, operand(0), condition());
    case Lowering::Reset:
      return effect(Op::Reset, operand(0), condition());
    case Lowering::PulseStore: {
      const ValueId on = condition();
      return effect(Op::Store, operand(0), edge(info.edge, new_edge(), on));
    }
    case Lowering::Toggle:
      return lower_toggle(info);
    case Lowering::MasterControl:
      return lower_master_control();
    case Lowering::MasterControlReset: {
      const unsigned closed = level(0);
      while (!open_levels_.empty() && open_levels_.back() >= closed)
        open_levels_.pop_back();
      return;
    }
    case Lowering::CallWithResult: {
      const ValueId on = condition();
      Operation &o = append(Op::Run);
      o.info = &info;
      o.a = on;
      return fill_operands(o, info);
    }
    default: {
      ValueId on = condition();
      if (info.execution == Execution::RisingEdge || info.execution == Execution::FallingEdge)
        on = edge(info.execution, new_edge(), on);
      Operation &o = append(Op::Call);
      o.info = &info;
      o.a = on;
      return fill_operands(o, info);
    }
    }
  }

  /// FF: the device changes on the edge.
  void lower_toggle(const InstructionInfo &info) {
    const ValueId on = edge(info.edge, new_edge(), condition());
    const ValueId now = load(operand(0));
    effect(Op::Store, operand(0), binary(Op::Xor, now, on));
  }

  void lower_master_control() {
    const ValueId on = condition();
    const unsigned opened = level(0);
    open_levels_.push_back(opened);
    module_.master_levels = std::max<std::uint8_t>(module_.master_levels, static_cast<std::uint8_t>(opened + 1));
    effect(Op::Store, master(opened), on);
    effect(Op::Store, operand(1), on);
    master_condition_of_ = ir::kNoValue;
  }

  void fill_operands(Operation &o, const InstructionInfo &info) {
    for (std::uint8_t i : info.inputs)
      o.inputs.push_back(operand(i));
    for (std::uint8_t i : info.outputs)
      o.outputs.push_back(operand(i));
  }

  const CheckedProgram &program_;
  ir::Module module_;
  ir::Rung *rung_ = nullptr;
  const Instruction *current_ = nullptr;
  llvm::SmallVector<ValueId, 16> blocks_;
  llvm::SmallVector<ValueId, 16> branches_;
  llvm::SmallVector<unsigned, 16> open_levels_;
  ValueId master_condition_of_ = ir::kNoValue;  ///< `master_condition_` is this value with the master's state
  ValueId master_condition_ = ir::kNoValue;
};

}  // namespace

ir::Module lower(const CheckedProgram &program) {
  return Lowerer(program).run();
}

}  // namespace ladderc
