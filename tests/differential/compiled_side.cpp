// Reading and writing the images of a program object.
#include "compiled_side.h"

#include <cstring>
#include <new>

namespace ladderc::differential {

namespace {

template <class T> T load(const unsigned char *at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

}  // namespace

CompiledSide::CompiledSide(const ladder::ProgramSymbols &symbols, const FamilyInfo &family, const Parameters &parameters)
    : symbols_(symbols), family_(family), parameters_(parameters),
      memory_(::operator new (symbols.size, std::align_val_t{symbols.alignment}), Release{symbols.alignment}),
      symbol_(family.devices.size()), arrays_(family.devices.size()) {
  for (std::uint32_t i = 0; i < symbols.device_count; ++i) {
    const ladder::DeviceSymbol &s = symbols.devices[i];
    const DeviceId id = find_device(family, s.prefix, s.first);
    symbol_[id] = &s;
    const bool wide = s.shape == ladder::Shape::LongCounters;
    const bool parts = wide || s.shape == ladder::Shape::Timers || s.shape == ladder::Shape::Counters;
    if (wide)
      arrays_[id].wide.resize(s.points);
    else if (parts || s.shape == ladder::Shape::Words)
      arrays_[id].value.resize(s.points);
    if (parts || s.shape != ladder::Shape::Words)
      arrays_[id].on.resize(s.points);
    if (parts)
      arrays_[id].coil.resize(s.points);
  }
  symbols_.construct(object());
}

void CompiledSide::power_on() {
  for (DeviceId id = 0; id < arrays_.size(); ++id)
    clear_unlatched(arrays_[id], id, family_, parameters_);
  symbols_.power_on(object());
  write_initial_values();
}

void CompiledSide::set_run(bool run) {
  const bool was_running = status().running;
  symbols_.set_mode(object(), run ? ladder::Mode::Run : ladder::Mode::Stop);
  if (!was_running && status().running)
    write_initial_values();
}

/// Only for points that the program has no memory for: the others it writes itself, and read() shows them.
void CompiledSide::write_initial_values() {
  for (const InitialValue &initial : parameters_.initial_values)
    write_initial_value(initial, family_, [&](DeviceId id) -> DeviceArray & { return arrays_[id]; });
}

bool CompiledSide::input(std::size_t number, bool on) {
  if (symbols_.input == nullptr)
    return false;
  symbols_.input(object(), static_cast<unsigned>(number), on);
  return true;
}

std::size_t CompiledSide::count(DeviceId id) const {
  return symbol_[id] ? symbol_[id]->count : 0;
}

void CompiledSide::poke_bit(DeviceId id, std::size_t number, bool on) {
  const ladder::DeviceSymbol &s = *symbol_[id];
  arrays_[id].on[number] = on;
  if (number >= s.count)
    return;
  if (s.shape == ladder::Shape::Bits) {
    object()[s.offset + number] = on;
    return;
  }
  unsigned char *cell = object() + s.offset + number / 32 * 4;
  const auto before = load<std::uint32_t>(cell);
  const std::uint32_t after = (before & ~(1u << number % 32)) | std::uint32_t(on) << number % 32;
  std::memcpy(cell, &after, sizeof after);
}

void CompiledSide::poke_word(DeviceId id, std::size_t number, std::uint16_t value) {
  arrays_[id].value[number] = value;
  if (number < symbol_[id]->count)
    std::memcpy(object() + symbol_[id]->offset + number * sizeof value, &value, sizeof value);
}

const DeviceArray &CompiledSide::read(DeviceId id) {
  DeviceArray &a = arrays_[id];
  if (!symbol_[id])
    return a;
  const ladder::DeviceSymbol &s = *symbol_[id];
  const unsigned char *image = object() + s.offset;
  const std::size_t stride = s.stride ? s.stride : s.shape == ladder::Shape::LongCounters ? 8 : 4;
  auto part = [&](std::uint32_t n, std::size_t distance) { return image[n * stride + distance] != 0; };
  for (std::uint32_t n = 0; n < s.count && n < s.points; ++n)
    switch (s.shape) {
    case ladder::Shape::Bits:
      a.on[n] = image[n];
      break;
    case ladder::Shape::PackedBits:
      a.on[n] = load<std::uint32_t>(image + n / 32 * 4) >> n % 32 & 1;
      break;
    case ladder::Shape::Words:
      a.value[n] = load<std::uint16_t>(image + n * 2);
      break;
    case ladder::Shape::Timers:
    case ladder::Shape::Counters:
      a.value[n] = load<std::uint16_t>(image + n * stride);
      a.on[n] = part(n, 2);
      a.coil[n] = part(n, 3);
      break;
    case ladder::Shape::LongCounters:
      a.wide[n] = load<std::uint32_t>(image + n * stride);
      a.on[n] = part(n, 4);
      a.coil[n] = part(n, 5);
      break;
    }
  return a;
}

}  // namespace ladderc::differential
