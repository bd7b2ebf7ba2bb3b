// The first numbers of each class are written, and special devices that are there for the program to write. Index registers mostly
// get small numbers, so that what they modify exists.
#include "stimulus.h"

#include "syntax/parser.h"

#include <algorithm>

namespace ladderc::differential {

namespace {

constexpr std::uint32_t kFew = 24;

}  // namespace

Stimulus::Stimulus(const FamilyInfo &family, const Parameters &parameters) : family_(family), parameters_(parameters) {
  for (DeviceId id = 0; id < family.devices.size(); ++id) {
    const DeviceInfo &device = family.devices[id];
    if (device.external_input)
      inputs_ = id;
    const bool is_bit = device.kind == DeviceKind::Bit;
    if (device.external_input || (!is_bit && device.kind != DeviceKind::Word))
      continue;
    Places places{id, is_bit, is_index_register(family, id), {}, 0};
    std::vector<bool> known(device.first + parameters.points[id]);
    for (const SpecialInfo &special : family.specials) {
      const auto [first_text, last_text] = special.device.split('-');
      const Operand first = parse_operand(family, first_text, {});
      if (first.device != id)
        continue;
      const Operand last = last_text.empty() ? first : parse_operand(family, last_text, {});
      for (auto n = static_cast<std::uint32_t>(first.value); n <= last.value && n < known.size(); ++n) {
        known[n] = true;
        if (special.writable && special.simulated)
          places.special.push_back(n - device.first);
      }
    }
    std::uint32_t begin = device.first;
    for (std::uint32_t n = begin; n < known.size() && n < begin + kFew; ++n)
      if (known[n])
        begin = n + 1;
    places.plain = begin - device.first;
    places_.push_back(std::move(places));
  }
}

Poke Stimulus::poke(const Places &places, std::uint32_t index, Random &random) const {
  std::uint32_t value = places.is_bit ? random.one_in(3) : static_cast<std::uint32_t>(random.next());
  if (!places.is_bit && (places.is_index ? !random.one_in(4) : random.one_in(2)))
    value = random.below(20);
  return {places.device, index, places.is_bit, static_cast<std::uint16_t>(value)};
}

std::vector<Poke> Stimulus::fill(Random &random) const {
  std::vector<Poke> pokes;
  for (const Places &places : places_)
    for (std::uint32_t n = places.plain; n < std::min(places.plain + kFew, parameters_.points[places.device]); ++n)
      pokes.push_back(poke(places, n, random));
  return pokes;
}

std::vector<Poke> Stimulus::some(Random &random) const {
  std::vector<Poke> pokes;
  for (const Places &places : places_) {
    if (!random.one_in(places.is_index ? 8 : 16))
      continue;
    if (places.special.empty()) {
      if (const std::uint32_t most = std::min(kFew, parameters_.points[places.device]))
        pokes.push_back(poke(places, random.below(most), random));
      continue;
    }
    Poke special = poke(places, random.pick(llvm::ArrayRef(places.special)), random);
    if (!places.is_bit && !family_.errors.empty() && random.one_in(2))
      special.value = random.pick(family_.errors).code;
    pokes.push_back(special);
  }
  return pokes;
}

}  // namespace ladderc::differential
