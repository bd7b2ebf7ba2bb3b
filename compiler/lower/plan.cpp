// One walk over the list before the one that makes operations.
#include "lower/plan.h"

#include "llvm/ADT/STLExtras.h"

namespace ladderc::lowering {

void close_buses(std::vector<Bus> &buses, const CheckedProgram &program, const Instruction &end) {
  const bool of_level = end.info->lowering == Lowering::MasterControlReset;
  const auto level = of_level ? static_cast<unsigned>(program.list.operands_of(end)[0].value) : 0;
  llvm::erase_if(buses, [&](const Bus &bus) { return bus.has_level == of_level && (!of_level || bus.level >= level); });
}

Plan make_plan(const CheckedProgram &program) {
  Plan plan;
  std::vector<Bus> buses;
  std::uint32_t bus_count = 0;
  const std::vector<Instruction> &list = program.list.instructions;
  for (std::uint32_t i = 0; i < list.size() && list[i].info->lowering != Lowering::End; ++i) {
    const Instruction &instruction = list[i];
    const llvm::ArrayRef<Operand> operands = program.list.operands_of(instruction);
    switch (instruction.info->lowering) {
    case Lowering::MainEnd:
      plan.main_end = i;
      break;
    case Lowering::CallRoutine:
      plan.called.insert(static_cast<std::uint32_t>(operands[0].value));
      plan.calls_by_index |= operands[0].index != kNoDevice;
      break;
    case Lowering::Jump:
      if (operands[0].index == kNoDevice)
        plan.jumped.insert(static_cast<std::uint32_t>(operands[0].value));
      break;
    case Lowering::MasterControl:
      buses.push_back({static_cast<std::uint32_t>(operands[0].value), true, static_cast<unsigned>(operands[0].value)});
      break;
    case Lowering::BusStart:
      buses.push_back({program.family->max_levels + bus_count++, false, 0});
      break;
    case Lowering::MasterControlReset:
    case Lowering::BusEnd:
      close_buses(buses, program, instruction);
      break;
    case Lowering::Label:
      plan.label_buses[static_cast<std::uint32_t>(operands[0].value)] = buses;
      break;
    default:
      break;
    }
  }
  return plan;
}

}  // namespace ladderc::lowering
