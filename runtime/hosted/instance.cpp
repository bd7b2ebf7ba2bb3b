// The program object lives in memory of its own, as large and as aligned as its table says, and is plain data: it needs no
// destruction.
#include "ladder/hosted/instance.h"

#include <algorithm>
#include <new>

namespace ladder::hosted {

void Instance::Release::operator()(void *memory) const {
  ::operator delete (memory, std::align_val_t{alignment});
}

Instance::Instance(const ProgramSymbols &symbols, Clock clock)
    : symbols_(&symbols), memory_(::operator new (symbols.size, std::align_val_t{symbols.alignment}), Release{symbols.alignment}),
      devices_(symbols, memory_.get()), clock_(clock) {
  symbols_->construct(object());
}

void Instance::power_on() {
  devices_.clear_side_store();
  symbols_->power_on(object());
}

bool Instance::connect(Io *io) {
  if (symbols_->connect == nullptr)
    return false;
  symbols_->connect(object(), io);
  return true;
}

void Instance::pulse(const DeviceRef &ref, std::uint64_t count) {
  if (!symbols_->devices[ref.device].input || ref.format != Format::Bit)
    throw DeviceError("only an input terminal gets pulses");
  if (symbols_->input == nullptr)
    throw DeviceError("the program looks at its inputs in scans only");
  const bool before = get(ref).bits != 0;
  for (; count > 0; --count) {
    symbols_->input(object(), ref.number, !before);
    symbols_->input(object(), ref.number, before);
  }
}

void Instance::interrupt(unsigned pointer) {
  if (symbols_->interrupt == nullptr)
    throw DeviceError("the program has no interrupt routines");
  symbols_->interrupt(object(), pointer);
}

void Instance::scan() {
  for (const auto &[ref, value] : held_)
    devices_.write(ref, value);
  symbols_->scan(object(), static_cast<Micros>(clock_.now()));
  clock_.scan_done();
  ++scans_;
}

void Instance::set(const DeviceRef &ref, const Value &value) {
  devices_.write(ref, value);
  if (!symbols_->devices[ref.device].input)
    return;
  std::erase_if(held_, [&](const auto &held) { return held.first == ref; });
  held_.emplace_back(ref, value);
}

bool Instance::stopped_by_itself() const {
  Status now = status();
  return now.mode == Mode::Run && !now.running;
}

}  // namespace ladder::hosted
