// A program is a row of parts. A part is a rung, or one of these, with parts in between:
//
//     condition MC  ... MCR       in the main program, not in loops and states; the inner levels may be left to the outer MCR
//     condition SMCS ... SMCR     not in states
//     condition JCS ... JCR
//     condition CJ  ... label     also out of loops, seldom backwards, to END, or over a FEND
//     FOR ... NEXT                few times, so that a scan ends
//     STL ... STL ... RET         in the main program; the states set each other
//
// Behind FEND stand the subroutines, which call those behind them only, and the interrupt routines. Which of all that a list has is
// what the family has an instruction for.
#include "generate/program_maker.h"

#include <fmt/format.h>

#include <algorithm>

namespace ladderc::generate {

namespace {

constexpr unsigned kMostDepth = 3;
constexpr unsigned kMostLoops = 2;

}  // namespace

std::string ProgramMaker::list() {
  const GenerateOptions &options = rungs_.options();
  rungs_.text() = fmt::format("; ladderc generate --family={} --profile={} --seed={} --rungs={}\n", options.family->id.str(),
                              name(options.profile).str(), options.seed, options.rungs);
  if (find(Lowering::CallRoutine) && random().one_in(2))
    for (unsigned n = 1 + random().below(4); n > 0; --n)
      if (const std::string label = new_label(Lowering::Label); !label.empty())
        routines_.push_back(label);
  interrupts_ = find(Lowering::InterruptLabel) && random().one_in(3);
  for (unsigned n = interrupts_ ? 1 + random().below(2) : 0; n > 0; --n)
    alone();
  while (rungs_.rungs() < options.rungs)
    part({});
  routines();
  if (const InstructionInfo *end = find(Lowering::End))
    rungs_.line(*end, {});
  return std::move(rungs_.text());
}

/// One more part around.
ProgramMaker::Place ProgramMaker::inside(const Place &place) {
  Place inner = place;
  ++inner.depth;
  return inner;
}

std::vector<ProgramMaker::Part> ProgramMaker::possible_parts(const Place &place) const {
  std::vector<Part> parts;
  auto add = [&](Part part, Lowering lowering, unsigned weight) {
    if (find(lowering))
      parts.insert(parts.end(), weight, part);
  };
  const bool in_main = !place.apart && place.loops == 0 && !place.in_state;
  if (place.depth < kMostDepth) {
    if (in_main && !place.in_master)
      add(Part::Master, Lowering::MasterControl, 4);
    if (!place.in_state && !place.in_bus)
      add(Part::Bus, Lowering::BusStart, 3);
    if (!place.in_skip)
      add(Part::Skip, Lowering::Skip, 3);
    add(Part::JumpForward, Lowering::Jump, 4);
    if (place.loops < (place.apart ? 1 : kMostLoops))
      add(Part::Loop, Lowering::Loop, 2);
    if (place.loops == 0 && place.depth == 0)
      add(Part::JumpBack, Lowering::Jump, 1);
    if (in_main)
      add(Part::Ladder, Lowering::State, 5);
  }
  if (place.routine < routines_.size())
    add(Part::Call, Lowering::CallRoutine, 4);
  if (!place.exit.empty())
    add(Part::Exit, Lowering::Jump, 6);
  if (!place.apart && !place.in_state && rungs_.options().family->end_label >= 0)
    add(Part::JumpToEnd, Lowering::Jump, 1);
  if (place.depth == 0 && !place.apart) {
    add(Part::Alone, Lowering::InterruptLabel, 1);
    add(Part::MainEnd, Lowering::MainEnd, 1);
  }
  return parts;
}

void ProgramMaker::parts(const Place &place, unsigned most) {
  for (unsigned n = random().below(most + 1); n > 0; --n)
    part(place);
}

void ProgramMaker::part(const Place &place) {
  if (!random().one_in(4))
    return rungs_.rung();
  const std::vector<Part> possible = possible_parts(place);
  if (possible.empty())
    return rungs_.rung();
  switch (random().pick(llvm::ArrayRef(possible))) {
  case Part::Rung:
    return rungs_.rung();
  case Part::Master:
    (void)master(place, 0);
    return;
  case Part::Bus:
    return bus(place);
  case Part::Skip:
    return skip(place);
  case Part::JumpForward:
    return jump_forward(place, false);
  case Part::MainEnd:
    return jump_forward(place, true);
  case Part::JumpBack:
    return jump_back(place);
  case Part::JumpToEnd:
    rungs_.condition(1);
    return jump(rungs_.operands().device_text(find(Lowering::Jump)->operands.front(),
                                              static_cast<std::uint32_t>(rungs_.options().family->end_label)),
                true);
  case Part::Exit:
    rungs_.condition(1);
    return jump(place.exit, false);
  case Part::Call:
    return call(place);
  case Part::Loop:
    return loop(place);
  case Part::Ladder:
    return ladder(place);
  case Part::Alone:
    return alone();
  }
}

void ProgramMaker::alone() {
  if (const InstructionInfo *info = rungs_.catalogue().pick_alone(random()))
    rungs_.line(*info, {});
}

// ---------------------------------------------------------------------------------------------- ranges

/// Levels from `first_level` on are free; returns the first that is so afterwards.
unsigned ProgramMaker::master(const Place &place, unsigned first_level) {
  const InstructionInfo &begin = *find(Lowering::MasterControl);
  const InstructionInfo *end = find(Lowering::MasterControlReset);
  const unsigned level = first_level + random().below(2);
  if (!end || level >= rungs_.options().family->max_levels) {
    rungs_.rung();
    return first_level;
  }
  rungs_.condition(1);
  if (random().one_in(4))
    rungs_.output();
  const auto made = rungs_.operands().make(begin, true);
  if (!made) {
    rungs_.output();
    return first_level;
  }
  std::vector<std::string> operands = *made;
  std::string level_text;
  for (std::size_t k = 0; k < operands.size(); ++k)
    if (begin.operands[k].type == OperandType::Level)
      operands[k] = level_text = rungs_.operands().device_text(begin.operands[k], level);
  rungs_.line(begin, operands);
  if (random().one_in(4)) {  // goes on behind MC, under the new master already
    rungs_.more(0);
    rungs_.output();
  }
  Place inner = inside(place);
  inner.in_master = true;
  const std::string label = exit_label(inner);
  unsigned free = level + 1;
  for (unsigned n = random().below(4); n > 0; --n) {
    if (inner.depth < kMostDepth && random().one_in(4))
      free = master(inner, free);
    else
      part(inner);
  }
  if (first_level != 0 && label.empty() && random().one_in(3))
    return free;  // the outer MCR closes this region too
  rungs_.line(*end, level_text);
  place_label(label);
  return first_level;
}

/// Now and then, a label behind the range that is being opened, for jumps out of it.
std::string ProgramMaker::exit_label(Place &inner) {
  if (!find(Lowering::Jump) || !random().one_in(4))
    return {};
  const std::string label = new_label(Lowering::Label);
  if (!label.empty())
    inner.exit = label;
  return label;
}

void ProgramMaker::bus(const Place &place) {
  range(place, *find(Lowering::BusStart), *find(Lowering::BusEnd));
}

void ProgramMaker::skip(const Place &place) {
  range(place, *find(Lowering::Skip), *find(Lowering::SkipEnd));
}

/// One end serves several beginnings; a rung with contacts of its own follows each of them.
void ProgramMaker::range(const Place &place, const InstructionInfo &begin, const InstructionInfo &end) {
  Place inner = inside(place);
  (begin.lowering == Lowering::Skip ? inner.in_skip : inner.in_bus) = true;
  const std::string label = exit_label(inner);
  for (unsigned n = 1 + random().one_in(3); n > 0; --n) {
    rungs_.condition(1);
    if (random().one_in(4))
      rungs_.output();
    rungs_.line(begin, {});
    rungs_.rung();
    parts(inner, 3);
  }
  rungs_.line(end, {});
  place_label(label);
}

// ---------------------------------------------------------------------------------------------- jumps, routines, loops

std::string ProgramMaker::new_label(Lowering lowering) {
  const InstructionInfo *info = find(lowering);
  if (!info)
    return {};
  Uses &uses = rungs_.operands().uses();
  for (DeviceId id = 0; id < rungs_.options().family->devices.size(); ++id) {
    if (!contains(info->operands.front().devices, id))
      continue;
    const std::vector<std::uint32_t> free = uses.free_labels(id);
    if (free.empty())
      return {};
    const std::uint32_t number = random().pick(llvm::ArrayRef(free));
    uses.take_label(id, number);
    return rungs_.operands().device_text(info->operands.front(), number);
  }
  return {};
}

void ProgramMaker::place_label(const std::string &label) {
  if (!label.empty())
    rungs_.line(*find(Lowering::Label), label);
}

/// Behind a condition.
void ProgramMaker::jump(const std::string &label, bool seldom) {
  if (seldom)
    rungs_.guard();
  rungs_.line(*rungs_.catalogue().pick(random(), Lowering::Jump), label);
}

void ProgramMaker::jump_forward(const Place &place, bool over_main_end) {
  const std::string label = new_label(Lowering::Label);
  if (label.empty())
    return rungs_.rung();
  const Place inner = inside(place);
  rungs_.condition(1);
  jump(label, false);
  parts(inner, 3);
  if (random().one_in(3)) {
    rungs_.condition(1);
    jump(label, false);
    parts(inner, 2);
  }
  if (over_main_end)
    rungs_.line(*find(Lowering::MainEnd), {});
  place_label(label);
}

void ProgramMaker::jump_back(const Place &place) {
  const std::string label = new_label(Lowering::Label);
  if (label.empty())
    return rungs_.rung();
  Place inner = inside(place);
  inner.loops = kMostLoops;
  place_label(label);
  parts(inner, 2);
  rungs_.condition(1);
  jump(label, true);
}

void ProgramMaker::call(const Place &place) {
  rungs_.condition(1);
  const std::size_t routine = place.routine + random().below(static_cast<std::uint32_t>(routines_.size() - place.routine));
  rungs_.line(*rungs_.catalogue().pick(random(), Lowering::CallRoutine), routines_[routine]);
}

void ProgramMaker::loop(const Place &place) {
  const InstructionInfo &begin = *find(Lowering::Loop);
  Place inner = inside(place);
  ++inner.loops;
  const std::string label = exit_label(inner);
  rungs_.line(begin, rungs_.operands().small_count(begin.operands.front(), place.apart || place.loops != 0));
  rungs_.rung();
  parts(inner, 2);
  rungs_.line(*find(Lowering::LoopEnd), {});
  place_label(label);
}

/// Subroutines, and interrupt routines behind them. A subroutine may go on in the next one.
void ProgramMaker::routines() {
  if (routines_.empty() && !interrupts_)
    return;
  Place place;
  place.apart = true;
  place.depth = 1;
  rungs_.line(*find(Lowering::MainEnd), {});
  for (std::size_t k = 0; k < routines_.size(); ++k) {
    place.routine = static_cast<unsigned>(k) + 1;
    place_label(routines_[k]);
    rungs_.rung();
    parts(place, 3);
    if (k + 1 == routines_.size() || !random().one_in(6))
      rungs_.line(*find(Lowering::Return), {});
  }
  place.routine = static_cast<unsigned>(routines_.size());
  for (unsigned n = interrupts_ ? 1 + random().below(3) : 0; n > 0; --n) {
    const std::string label = new_label(Lowering::InterruptLabel);
    if (label.empty())
      return;
    rungs_.line(*find(Lowering::InterruptLabel), label);
    rungs_.rung();
    parts(place, 2);
    rungs_.line(*find(Lowering::InterruptReturn), {});
  }
}

// ---------------------------------------------------------------------------------------------- states

void ProgramMaker::ladder(const Place &place) {
  const InstructionInfo &begin = *find(Lowering::State);
  const DeviceId device = device_of(begin.operands.front());
  const std::uint32_t first = rungs_.options().family->devices[device].first + random().below(20);
  const std::uint32_t most = rungs_.options().parameters.points[device];
  states_.clear();
  for (unsigned n = 0; n < 2 + random().below(3) && first + n < most; ++n)
    states_.push_back(first + n);
  rungs_.condition(1);
  transfer();
  for (std::size_t k = 0; k < states_.size(); ++k)
    state(place, k);
  rungs_.line(*find(Lowering::StateEnd), {});
  states_.clear();
}

/// The state, now and then a merge with the one before it; outputs without contacts, then parts, then the way to other states.
void ProgramMaker::state(const Place &place, std::size_t index) {
  const InstructionInfo &begin = *find(Lowering::State);
  auto text = [&](std::size_t k) { return rungs_.operands().device_text(begin.operands.front(), states_[k]); };
  if (index > 0 && random().one_in(6))
    rungs_.line(begin, text(index - 1));
  rungs_.line(begin, text(index));
  for (unsigned n = random().below(3); n > 0; --n)
    rungs_.output();
  Place inner = inside(place);
  inner.in_state = true;
  inner.exit.clear();
  parts(inner, 2);
  for (unsigned n = random().below(3); n > 0; --n) {
    rungs_.condition(0);
    transfer();
  }
}

/// Behind a condition: SET or OUT of one of the ladder's states.
void ProgramMaker::transfer() {
  const InstructionInfo *info = rungs_.catalogue().pick(random(), Lowering::Transfer);
  if (!info)
    return rungs_.output();
  rungs_.line(*info, rungs_.operands().device_text(info->operands.front(), random().pick(llvm::ArrayRef(states_))));
}

DeviceId ProgramMaker::device_of(const OperandInfo &info) const {
  for (DeviceId id = 0; id < rungs_.options().family->devices.size(); ++id)
    if (contains(info.devices, id))
      return id;
  return kNoDevice;
}

}  // namespace ladderc::generate
