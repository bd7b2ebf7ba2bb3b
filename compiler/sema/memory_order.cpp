// Where a pair of words or a run of digits goes on when it crosses the end of its device class.
//
// The classes lie one behind the other in the controller's memory. `memory_order` numbers their places; a missing number is a gap.
// Bits go on in bit classes only: timers and counters lie in between with contacts and coils, which no run of digits may touch.
// Words go on in word classes and in the current values of timers and counters. Classes without points take no place.
#include "sema/check.h"

namespace ladderc {

namespace {

enum class Chain { None, Bits, Words };

Chain chain_of(const DeviceInfo &device) {
  if (device.memory_order == 0)
    return Chain::None;
  switch (device.kind) {
  case DeviceKind::Bit:
    return Chain::Bits;
  case DeviceKind::Word:
  case DeviceKind::Timer:
  case DeviceKind::Counter:
    return Chain::Words;
  case DeviceKind::LongCounter:
  case DeviceKind::Nesting:
  case DeviceKind::Label:
  case DeviceKind::Index:
    return Chain::None;
  }
  return Chain::None;
}

DeviceId next_class(const FamilyInfo &family, DeviceId device) {
  const DeviceInfo &from = family.devices[device];
  Chain chain = chain_of(from);
  if (chain == Chain::None)
    return kNoDevice;
  for (DeviceId id = 0; id < family.devices.size(); ++id)
    if (family.devices[id].memory_order == from.memory_order + 1 && chain_of(family.devices[id]) == chain)
      return id;
  return kNoDevice;
}

}  // namespace

bool crosses_end(const FamilyInfo &family, const Parameters &parameters, DeviceId device, std::uint32_t number,
                 std::uint32_t count) {
  return std::uint64_t(number) + count > std::uint64_t(family.devices[device].first) + parameters.points[device];
}

DevicePoint point_behind(const FamilyInfo &family, const Parameters &parameters, DevicePoint start, std::uint32_t distance) {
  DeviceId device = start.device;
  std::uint64_t place = std::uint64_t(start.number) - family.devices[device].first + distance;  // in its class
  while (device != kNoDevice && place >= parameters.points[device]) {
    if (!family.pairs_cross_classes)
      return {kNoDevice, 0};
    place -= parameters.points[device];
    device = next_class(family, device);
  }
  if (device == kNoDevice)
    return {kNoDevice, 0};
  return {device, family.devices[device].first + static_cast<std::uint32_t>(place)};
}

}  // namespace ladderc
