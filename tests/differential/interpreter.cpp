// The stacks and the sequence instructions.
//
// The block stack is never cleared: LD puts a result on it, everything else works on the top.
#include "interpreter.h"

#include <algorithm>

namespace ladderc::differential {

Interpreter::Interpreter(const CheckedProgram &program)
    : program_(program), memory_(*program.family, program.parameters), system_(*program.family, program.parameters, memory_),
      edges_(program.list.instructions.size()) {
  for (const Instruction &i : program.list.instructions)
    decoded_.push_back(decode_mnemonic(i.info->spelling.str()));
}

void Interpreter::power_on() {
  memory_.clear();
  edges_.assign(edges_.size(), 0);
  system_.power_on();
  memory_.write_initial_values();
}

void Interpreter::set_run(bool run) {
  const bool was_running = system_.running();
  system_.set_run(run);
  if (!was_running && system_.running())
    memory_.write_initial_values();
}

void Interpreter::scan(std::uint32_t now_us) {
  if (!system_.begin_scan(now_us))
    return;
  blocks_.clear();
  branches_.clear();
  regions_.clear();
  for (std::size_t i = 0; i < decoded_.size() && decoded_[i].action != Action::End; ++i)
    if (!execute(i))
      return;
  system_.end_scan();
}

bool Interpreter::edge(char kind, std::uint8_t &memory, bool now) {
  const bool before = memory != 0;
  memory = now;
  return kind == 'P' ? now && !before : !now && before;
}

/// What an output acts on: the result, if all masters are ON.
bool Interpreter::condition() const {
  return blocks_.back() && std::all_of(regions_.begin(), regions_.end(), [](const Region &r) { return r.on; });
}

bool Interpreter::execute(std::size_t index) {
  const Decoded &d = decoded_[index];
  switch (d.action) {
  case Action::Contact:
  case Action::Compare:
    contact(d, index);
    return true;
  case Action::AndBlock:
  case Action::OrBlock: {
    const bool second = blocks_.back();
    blocks_.pop_back();
    const bool first = blocks_.back();
    blocks_.back() = d.action == Action::AndBlock ? first && second : first || second;
    return true;
  }
  case Action::Push:
    branches_.push_back(blocks_.back());
    return true;
  case Action::Read:
    blocks_.back() = branches_.back();
    return true;
  case Action::Pop:
    blocks_.back() = branches_.back();
    branches_.pop_back();
    return true;
  case Action::Invert:
    blocks_.back() = !blocks_.back();
    return true;
  case Action::EdgeOfResult:
    blocks_.back() = edge(d.edge, edges_[index], blocks_.back());
    return true;
  case Action::EdgeRelay: {
    const Operand &relay = operands(index)[0];
    blocks_.back() = edge(d.edge, memory_.bit(relay.device, static_cast<std::uint64_t>(relay.value)), blocks_.back());
    return true;
  }
  default:
    return output(d, index);
  }
}

void Interpreter::contact(const Decoded &d, std::size_t index) {
  bool on = d.action == Action::Compare ? compare(d, index) : memory_.read_bit(operands(index)[0]);
  if (d.edge != ' ')
    on = edge(d.edge, edges_[index], on);
  on ^= d.negated;
  if (d.join == 'L')
    blocks_.push_back(on);
  else
    blocks_.back() = d.join == 'A' ? blocks_.back() && on : blocks_.back() || on;
}

bool Interpreter::output(const Decoded &d, std::size_t index) {
  if (d.action == Action::Nothing)
    return true;
  if (d.action == Action::MasterReset) {
    while (!regions_.empty() && regions_.back().level >= operands(index)[0].value)
      regions_.pop_back();
    return true;
  }
  const bool on = condition();
  switch (d.action) {
  case Action::Out:
  case Action::OutFast:
    out(d, index, on);
    return true;
  case Action::Set:
    set(index, on, true);
    return true;
  case Action::Reset:
    set(index, on, false);
    return true;
  case Action::Pulse:
    memory_.write_bit(operands(index)[0], edge(d.edge, edges_[index], on));
    return true;
  case Action::Toggle:
    if (edge('P', edges_[index], on))
      memory_.write_bit(operands(index)[0], !memory_.read_bit(operands(index)[0]));
    return true;
  case Action::Master:
    memory_.write_bit(operands(index)[1], on);
    regions_.push_back({operands(index)[0].value, on});
    return true;
  case Action::Abort:
    if (on)
      system_.abort(static_cast<std::uint16_t>(memory_.read(operands(index)[0], 1)), program_.list.instructions[index].step);
    return !on;
  default:
    return !(d.pulsed ? edge('P', edges_[index], on) : on) || word(d, index);
  }
}

void Interpreter::out(const Decoded &d, std::size_t index, bool on) {
  const Operand &o = operands(index)[0];
  const std::string device = o.kind == OperandKind::BitOfWord ? "" : prefix(o);
  if (device == "T" || device == "ST") {
    const unsigned ticks = d.action == Action::OutFast ? system_.high_ticks() : system_.low_ticks();
    drive_timer(o, operands(index)[1], ticks, device == "ST", on);
  } else if (device == "C") {
    drive_counter(o, operands(index)[1], on);
  } else if (device == "F") {
    const auto number = static_cast<unsigned>(o.value);
    if (on)
      system_.annunciator_on(number, program_.list.instructions[index].step);
    else
      system_.annunciator_off(number);
  } else {
    memory_.write_bit(o, on);
  }
}

void Interpreter::set(std::size_t index, bool on, bool to) {
  const Operand &o = operands(index)[0];
  const std::string device = o.kind == OperandKind::BitOfWord ? "" : prefix(o);
  const auto number = static_cast<std::size_t>(o.value);
  if (device == "F") {
    if (!edge('P', edges_[index], on))
      return;
    if (to)
      system_.annunciator_on(static_cast<unsigned>(number), program_.list.instructions[index].step);
    else
      system_.annunciator_reset(static_cast<unsigned>(number));
    return;
  }
  if (!on)
    return;
  DeviceArray &array = memory_.array(o.device);
  if (device == "T" || device == "ST" || device == "C")
    array.on[number] = array.coil[number] = 0, array.value[number] = 0;
  else if (device == "D" || device == "W" || device == "SD" || device == "SW")
    memory_.write(o, 0, 1);
  else
    memory_.write_bit(o, to);
}

void Interpreter::drive_timer(const Operand &timer, const Operand &preset, unsigned ticks, bool retentive, bool on) {
  const auto number = static_cast<std::size_t>(timer.value);
  DeviceArray &t = memory_.array(timer.device);
  // The set value is read before the timer moves. A negative one, which the manual forbids, counts as 0.
  const std::int64_t set_value = std::max<std::int64_t>(memory_.read(preset, 1), 0);
  t.coil[number] = on;
  if (on && !t.on[number]) {
    const std::int64_t value = static_cast<std::int16_t>(t.value[number]) + static_cast<std::int64_t>(ticks);
    t.on[number] = value >= set_value;
    t.value[number] = static_cast<std::uint16_t>(std::min<std::int64_t>(value, set_value));
  } else if (!on && !retentive) {
    t.on[number] = 0;
    t.value[number] = 0;
  }
}

void Interpreter::drive_counter(const Operand &counter, const Operand &preset, bool on) {
  const auto number = static_cast<std::size_t>(counter.value);
  DeviceArray &c = memory_.array(counter.device);
  const std::int64_t set_value = std::max<std::int64_t>(memory_.read(preset, 1), 1);
  const bool counts = on && !c.coil[number];
  c.coil[number] = on;
  if (!counts || c.on[number])
    return;
  const std::int64_t value = std::min<std::int64_t>(static_cast<std::int16_t>(c.value[number]) + 1, 32767);
  c.value[number] = static_cast<std::uint16_t>(value);
  c.on[number] = value >= set_value;
}

}  // namespace ladderc::differential
