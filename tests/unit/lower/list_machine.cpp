// Runs the bit instructions of a list as the manual tells it.
#include "list_machine.h"

#include "ir/ir.h"

#include <gtest/gtest.h>

namespace ladderc::test {

namespace {

class ListMachine {
public:
  ListMachine(const CheckedProgram &program, const Cells &cells) : program_(program), cells_(cells) {
    module_.family = program.family;
  }

  Cells run() {
    for (const Instruction &i : program_.list.instructions)
      step(i);
    std::erase_if(cells_, [](const auto &entry) { return !entry.second; });
    return cells_;
  }

private:
  struct Region {
    std::int64_t level;
    bool on;
  };

  bool &device(const Instruction &i, unsigned operand) {
    return cells_[ir::to_text(module_, ir::to_place(program_.list.operands_of(i)[operand], OperandType::Bit))];
  }
  bool edge(Execution kind, bool &memory, bool now) {
    const bool edge = kind == Execution::RisingEdge ? now && !memory : !now && memory;
    memory = now;
    return edge;
  }
  bool &own_memory() { return cells_["edge" + std::to_string(next_edge_++)]; }
  /// An output acts on the result and on the innermost region.
  bool condition() const { return blocks_.back() && (regions_.empty() || regions_.back().on); }

  void contact(const Instruction &i) {
    bool on = device(i, 0);
    if (i.info->edge != Execution::EveryScan)
      on = edge(i.info->edge, own_memory(), on);
    on ^= i.info->negated;
    if (i.info->placement == Placement::Start)
      blocks_.push_back(on);
    else
      blocks_.back() = i.info->placement == Placement::Series ? blocks_.back() && on : blocks_.back() || on;
  }

  void step(const Instruction &i) {
    // An LD behind an output opens a new rung where no branch is open and no join follows; sema has decided that.
    if (i.rung != rung_) {
      rung_ = i.rung;
      blocks_.clear();
      branches_.clear();
    }
    switch (i.info->lowering) {
    case Lowering::Contact:
      return contact(i);
    case Lowering::AndBlock:
    case Lowering::OrBlock: {
      const bool second = blocks_.back();
      blocks_.pop_back();
      blocks_.back() = i.info->lowering == Lowering::AndBlock ? blocks_.back() && second : blocks_.back() || second;
      return;
    }
    case Lowering::PushBranch:
      return branches_.push_back(blocks_.back());
    case Lowering::ReadBranch:
      blocks_.back() = branches_.back();
      return;
    case Lowering::PopBranch:
      blocks_.back() = branches_.back();
      return branches_.pop_back();
    case Lowering::Invert:
      blocks_.back() = !blocks_.back();
      return;
    case Lowering::EdgeOfResult:
      blocks_.back() = edge(i.info->edge, own_memory(), blocks_.back());
      return;
    case Lowering::EdgeRelay:
      blocks_.back() = edge(i.info->edge, device(i, 0), blocks_.back());
      return;
    default:
      return output(i);
    }
  }

  void output(const Instruction &i) {
    switch (i.info->lowering) {
    case Lowering::Store:
      device(i, 0) = condition();
      return;
    case Lowering::Set:
      device(i, 0) |= condition();
      return;
    case Lowering::Reset:
      device(i, 0) &= !condition();
      return;
    case Lowering::PulseStore: {
      const bool pulse = edge(i.info->edge, own_memory(), condition());
      device(i, 0) = pulse;
      return;
    }
    case Lowering::Toggle:
      if (edge(i.info->edge, own_memory(), condition()))
        device(i, 0) = !device(i, 0);
      return;
    case Lowering::MasterControl: {
      const bool on = condition();
      device(i, 1) = on;
      regions_.push_back({program_.list.operands_of(i)[0].value, on});
      return;
    }
    case Lowering::MasterControlReset:
      while (!regions_.empty() && regions_.back().level >= program_.list.operands_of(i)[0].value)
        regions_.pop_back();
      return;
    case Lowering::Nothing:
    case Lowering::End:
      return;
    default:
      ADD_FAILURE() << "the machine does not know " << i.info->form.str();
    }
  }

  const CheckedProgram &program_;
  ir::Module module_;
  Cells cells_;
  std::vector<bool> blocks_, branches_;
  std::vector<Region> regions_;
  unsigned next_edge_ = 0;
  std::uint32_t rung_ = 0;
};

}  // namespace

Cells run_list(const CheckedProgram &program, const Cells &cells) {
  return ListMachine(program, cells).run();
}

}  // namespace ladderc::test
