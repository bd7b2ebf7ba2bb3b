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
//
// A state of a step ladder is a routine that the main program enters where its STL stands; what the bus carries there is the Active
// value. Subroutines and interrupt routines stand behind the last FEND. JCS is a jump to a label that the list does not name.
#include "lower/lower.h"

#include "lower/plan.h"

#include "llvm/ADT/STLExtras.h"

#include <map>

namespace ladderc {

namespace {

using ir::Op;
using ir::Operation;
using ir::Place;
using ir::PlaceKind;
using ir::ValueId;
using lowering::Bus;

class Lowerer {
public:
  explicit Lowerer(const CheckedProgram &program)
      : program_(program), list_(program.list.instructions), plan_(lowering::make_plan(program)) {
    module_.family = program.family;
    module_.name = program.parameters.program_name;
    module_.points = program.parameters.points;
    module_.routines.emplace_back().name = "main";
    module_.routines.back().rungs.reserve(program.rungs);
  }

  ir::Module run() {
    for (std::uint32_t i = 0; i < list_.size(); ++i) {
      const Instruction &instruction = list_[i];
      if (instruction.info->lowering == Lowering::End)
        break;
      current_ = &instruction;
      index_ = i;
      if (opens_routine(i))
        open_routine(i);
      if (instruction.info->lowering == Lowering::State) {
        i = open_state(i);
        continue;
      }
      if (instruction.info->lowering == Lowering::StateEnd)
        close_state();
      if (!has_rung_ || instruction.rung != rung().number)
        begin_rung(instruction, i);
      ++rung().instruction_count;
      lower(instruction);
    }
    finish_routine();
    return std::move(module_);
  }

private:
  // ---- routines
  /// A label behind the main program that is called, or the head of an interrupt routine.
  bool opens_routine(std::uint32_t index) const {
    const Instruction &instruction = list_[index];
    if (!plan_.main_end || index < *plan_.main_end)
      return false;
    if (instruction.info->lowering == Lowering::InterruptLabel)
      return true;
    if (instruction.info->lowering != Lowering::Label)
      return false;
    const auto label = static_cast<std::uint32_t>(program_.list.operands_of(instruction)[0].value);
    return plan_.called.contains(label) || (plan_.calls_by_index && !plan_.jumped.contains(label));
  }

  void open_routine(std::uint32_t index) {
    const Instruction &instruction = list_[index];
    const bool interrupt = instruction.info->lowering == Lowering::InterruptLabel;
    const Place label = operand(0);
    // A routine without its own end goes on with the next one.
    if (routine_ != 0 && !ended_ && !interrupt) {
      begin_rung(instruction, index);
      rung().instruction_count = 0;
      append(Op::Gosub).place = label;
      append(Op::Return);
    }
    finish_routine();
    ir::Routine routine;
    routine.name = ir::to_text(module_, label);
    routine.kind = interrupt ? ir::RoutineKind::Interrupt : ir::RoutineKind::Subroutine;
    routine.label = label.number;
    module_.routines.push_back(std::move(routine));
    routine_ = module_.routines.size() - 1;
    buses_.clear();
    ended_ = false;
  }

  /// The last FEND, SRET or IRET of a routine says nothing that its end does not say.
  void finish_routine() {
    has_rung_ = false;
    std::vector<ir::Rung> &rungs = module_.routines[routine_].rungs;
    if (rungs.empty() || rungs.back().operations.empty())
      return;
    const Op last = rungs.back().operations.back().op;
    if (last == Op::EndScan || last == Op::Return)
      rungs.back().operations.pop_back();
  }

  /// STL: the main program enters a routine of the state. Returns the index of the last STL of a merge.
  std::uint32_t open_state(std::uint32_t index) {
    close_state();
    begin_rung(list_[index], index);
    ir::Routine state;
    state.kind = ir::RoutineKind::State;
    std::uint32_t last = index;
    for (std::uint32_t i = index; i < list_.size() && list_[i].info->lowering == Lowering::State; ++i) {
      current_ = &list_[i];
      state.states.push_back(operand(0));
      state.name += (state.name.empty() ? "" : "_") + ir::to_text(module_, operand(0));
      ++rung().instruction_count;
      last = i;
    }
    // A state may have several regions: one that drives, one that transfers behind a merge.
    if (const unsigned regions = ++regions_[state.name]; regions > 1)
      state.name += "_" + std::to_string(regions);
    current_ = &list_[index];
    if (!states_entered_)
      append(Op::Leave);
    states_entered_ = true;
    ValueId on = load(state.states.front());
    for (const Place &other : llvm::drop_begin(state.states))
      on = binary(Op::And, on, load(other));
    if (!buses_.empty())
      on = binary(Op::And, on, load(master(buses_.back().master)));
    state.memory = new_edge();
    Operation &enter = append(Op::Enter);
    enter.place = state.memory;
    enter.a = on;
    enter.target = static_cast<std::uint32_t>(module_.routines.size());
    caller_ = routine_;
    routine_ = module_.routines.size();
    module_.routines.push_back(std::move(state));
    in_state_ = true;
    has_rung_ = false;
    return last;
  }

  void close_state() {
    if (!in_state_)
      return;
    in_state_ = false;
    routine_ = caller_;
    has_rung_ = false;
  }

  ir::Rung &rung() { return module_.routines[routine_].rungs.back(); }

  void begin_rung(const Instruction &instruction, std::uint32_t index) {
    ir::Rung &rung = module_.routines[routine_].rungs.emplace_back();
    has_rung_ = true;
    rung.number = instruction.rung;
    rung.step = instruction.step;
    rung.first_instruction = index;
    rung.range = instruction.range;
    blocks_.clear();
    branches_.clear();
    bus_condition_of_ = bus_ = active_ = pulse_ = ir::kNoValue;
  }

  // ---- building operations
  Operation &append(Op op) {
    Operation &o = rung().operations.emplace_back();
    o.op = op;
    o.step = current_->step;
    ended_ = op == Op::Return;
    if (ir::is_flow(op))
      pulse_ = ir::kNoValue;
    if (ir::is_value(op))
      o.result = rung().values++;
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
    return finish_edge(o, memory, a);
  }
  /// The edge that executes a P form. Neighbours with one condition are executed together, so that one memory serves them all.
  ValueId pulse(Execution kind, ValueId a) {
    if (pulse_ != ir::kNoValue && pulse_of_ == a && pulse_kind_ == kind)
      return pulse_;
    pulse_ = new_pulse(kind, a);
    pulse_of_ = a;
    pulse_kind_ = kind;
    return pulse_;
  }
  ValueId new_pulse(Execution kind, ValueId a) {
    const bool skips_first_scan = kind == Execution::RisingEdge && !program_.family->first_scan_pulses;
    Operation &o = append(kind == Execution::FallingEdge ? Op::Falling : skips_first_scan ? Op::Pulse : Op::Rising);
    return finish_edge(o, new_edge(), a);
  }
  static ValueId finish_edge(Operation &o, const Place &memory, ValueId a) {
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
  Place master(std::uint32_t number) {
    Place p;
    p.kind = PlaceKind::Master;
    p.number = number;
    module_.master_levels = std::max(module_.master_levels, number + 1);
    return p;
  }
  Place operand(unsigned index) {
    const Operand &operand = program_.list.operands_of(*current_)[index];
    Place place = ir::to_place(operand, current_->info->operands[index]);
    place.wide_index = current_->info->wide;
    if (place.type == OperandType::String) {
      place.value = static_cast<std::int64_t>(module_.texts.size());
      module_.texts.push_back(program_.list.texts[static_cast<std::size_t>(operand.value)]);
    }
    return place;
  }
  unsigned level(unsigned index) const { return static_cast<unsigned>(program_.list.operands_of(*current_)[index].value); }

  /// What the bus carries: the state of the innermost MC or SMCS, or that of the step ladder's state. kNoValue: always ON.
  ValueId bus() {
    if (in_state_) {
      if (active_ == ir::kNoValue)
        active_ = append(Op::Active).result;
      return active_;
    }
    if (buses_.empty())
      return ir::kNoValue;
    if (bus_ == ir::kNoValue)
      bus_ = load(master(buses_.back().master));
    return bus_;
  }

  /// The result that an output-type instruction acts on. An output at the head of a state, before any contact, follows the bus.
  ValueId condition() {
    if (blocks_.empty())
      return bus();
    const ValueId result = blocks_.back();
    if (bus_condition_of_ == result)
      return bus_condition_;
    bus_condition_of_ = result;
    bus_condition_ = result;
    if (const ValueId on = bus(); on != ir::kNoValue)
      bus_condition_ = binary(Op::And, result, on);
    return bus_condition_;
  }

  // ---- instructions
  void lower(const Instruction &instruction) {
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
    case Lowering::StateEnd:
      return;
    case Lowering::Label:
    case Lowering::InterruptLabel:
    case Lowering::Jump:
    case Lowering::CallRoutine:
    case Lowering::Return:
    case Lowering::InterruptReturn:
    case Lowering::MainEnd:
    case Lowering::Loop:
    case Lowering::LoopEnd:
    case Lowering::Skip:
    case Lowering::SkipEnd:
      return lower_flow(info);
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
    case Lowering::StoreInverted: {
      const ValueId on = bus();
      const ValueId inverse = blocks_.empty()        ? constant(false)
                              : on == ir::kNoValue ? unary(Op::Not, blocks_.back())
                                                   : binary(Op::AndNot, on, blocks_.back());
      return effect(Op::Store, operand(0), inverse);
    }
    case Lowering::Transfer:
      return lower_transfer(info);
    case Lowering::MasterControl:
      return open_bus({level(0), true, level(0)}, info.operands.size() > 1);
    case Lowering::BusStart:
      return open_bus({program_.family->max_levels + bus_count_++, false, 0}, false);
    case Lowering::MasterControlReset:
    case Lowering::BusEnd:
      close_buses(buses_, program_, *current_);
      return;
    case Lowering::CallWithResult: {
      ValueId on = condition();
      if (info.edge != Execution::EveryScan)
        on = edge(info.edge, new_edge(), on);
      Operation &o = append(Op::Run);
      o.info = &info;
      o.a = on;
      return fill_operands(o, info);
    }
    default: {
      ValueId on = info.placement == Placement::Alone ? ir::kNoValue : condition();
      if (info.execution == Execution::RisingEdge || info.execution == Execution::FallingEdge)
        on = pulse(info.execution, on);
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

  /// SET S and OUT S: in a state, a transfer to another one.
  void lower_transfer(const InstructionInfo &info) {
    const Place target = operand(0);
    const ir::Routine &routine = module_.routines[routine_];
    if (!in_state_)
      return effect(info.transfer_outside == Lowering::Store ? Op::Store : Op::Set, target, condition());
    if (llvm::is_contained(routine.states, target))
      return effect(Op::Set, target, condition());
    const llvm::SmallVector<Place, 1> sources = routine.states;
    const ValueId on = condition();
    Operation &o = append(Op::Transfer);
    o.place = target;
    o.a = on;
    o.inputs.assign(sources.begin(), sources.end());
  }

  /// MC and SMCS. The condition of an inner bus contains the outer one.
  void open_bus(const Bus &opened, bool has_device) {
    const ValueId on = condition();
    effect(Op::Store, master(opened.master), on);
    if (has_device)
      effect(Op::Store, operand(1), on);
    buses_.push_back(opened);
    bus_condition_of_ = bus_ = ir::kNoValue;
  }

  // ---- program flow
  void lower_flow(const InstructionInfo &info) {
    switch (info.lowering) {
    case Lowering::Label:
      append(Op::Label).place = operand(0);
      return;
    case Lowering::Jump:
    case Lowering::CallRoutine:
      return lower_branch(info);
    case Lowering::Return:
    case Lowering::InterruptReturn:
      append(Op::Return);
      return;
    case Lowering::MainEnd:
      append(Op::EndScan);
      return;
    case Lowering::Loop: {
      Operation &o = append(Op::Loop);
      o.target = module_.loops++;
      o.inputs.push_back(operand(0));
      open_loops_.push_back(o.target);
      return;
    }
    case Lowering::LoopEnd:
      append(Op::Next).target = open_loops_.pop_back_val();
      return;
    case Lowering::Skip: {
      const ValueId on = condition();
      Operation &o = append(Op::Jump);
      o.a = on;
      o.place.kind = PlaceKind::Label;
      o.place.number = ir::kHiddenLabel + skips_;
      return;
    }
    case Lowering::SkipEnd: {
      Operation &o = append(Op::Label);
      o.place.kind = PlaceKind::Label;
      o.place.number = ir::kHiddenLabel + skips_++;
      return;
    }
    default:
      return;  // InterruptLabel: the routine's head says it
    }
  }

  void lower_branch(const InstructionInfo &info) {
    ValueId on = condition();
    if (info.execution == Execution::RisingEdge)
      on = pulse(info.execution, on);
    const Place target = operand(0);
    if (info.lowering == Lowering::Jump && !target.is_indexed())
      // A jump into the range of an MC or SMCS finds it switched on.
      for (const Bus &bus : plan_.label_buses[target.number])
        if (llvm::none_of(buses_, [&](const Bus &open) { return open.master == bus.master; }))
          effect(Op::Set, master(bus.master), on);
    Operation &o = append(info.lowering == Lowering::Jump ? Op::Jump : Op::Gosub);
    o.place = target;
    o.a = on;
  }

  void fill_operands(Operation &o, const InstructionInfo &info) {
    for (std::uint8_t i : info.inputs)
      o.inputs.push_back(operand(i));
    for (std::uint8_t i : info.outputs)
      o.outputs.push_back(operand(i));
  }

  ValueId constant(bool state) {
    Operation &o = append(Op::Constant);
    o.constant = state;
    return o.result;
  }

  const CheckedProgram &program_;
  const std::vector<Instruction> &list_;
  ir::Module module_;
  std::size_t routine_ = 0, caller_ = 0;
  const Instruction *current_ = nullptr;
  std::uint32_t index_ = 0;
  bool has_rung_ = false, in_state_ = false, states_entered_ = false;
  bool ended_ = false;  ///< the last operation was a Return
  lowering::Plan plan_;
  std::map<std::string, unsigned> regions_;  ///< of each state, by its routine's name
  std::uint32_t bus_count_ = 0, skips_ = 0;
  llvm::SmallVector<std::uint32_t, 8> open_loops_;
  llvm::SmallVector<ValueId, 16> blocks_;
  llvm::SmallVector<ValueId, 16> branches_;
  ValueId pulse_ = ir::kNoValue, pulse_of_ = ir::kNoValue;  ///< the last P form's edge in this rung, and its condition
  Execution pulse_kind_ = Execution::RisingEdge;
  std::vector<Bus> buses_;
  ValueId bus_ = ir::kNoValue, active_ = ir::kNoValue;  ///< loaded in this rung
  ValueId bus_condition_of_ = ir::kNoValue;             ///< `bus_condition_` is this value with the bus
  ValueId bus_condition_ = ir::kNoValue;
};

}  // namespace

ir::Module lower(const CheckedProgram &program) {
  return Lowerer(program).run();
}

}  // namespace ladderc
