// Bits and words of the program's image, by shape, and of the side store behind it.
//
// The object is foreign memory: everything is copied bytewise, so that no type of the program needs to be known here.
#include "ladder/hosted/device_access.h"

#include "ladder/counter.h"
#include "ladder/timer.h"

#include <cstddef>
#include <cstring>

namespace ladder::hosted {
namespace {

static_assert(sizeof(Timer) == 4 && sizeof(bit) == 1 && sizeof(Timer::value) == 2);
static_assert(sizeof(Counter) == sizeof(Timer) && offsetof(Counter, value) == offsetof(Timer, value) &&
              offsetof(Counter, contact) == offsetof(Timer, contact) && offsetof(Counter, coil) == offsetof(Timer, coil));

std::uint64_t side_key(const DeviceRef &ref, std::uint32_t number) {
  return std::uint64_t{ref.device} << 40 | std::uint64_t{static_cast<unsigned char>(ref.part)} << 32 | number;
}

std::size_t timer_bit(const DeviceRef &ref, std::uint32_t number) {
  std::size_t member = ref.part == Part::Coil ? offsetof(Timer, coil) : offsetof(Timer, contact);
  return number * sizeof(Timer) + member;
}

std::size_t word_offset(const DeviceRef &ref, std::uint32_t number) {
  return ref.part == Part::Current ? number * sizeof(Timer) + offsetof(Timer, value) : number * sizeof(std::uint16_t);
}

struct PackedPlace {
  std::size_t offset;
  std::uint32_t mask;
};
PackedPlace packed_bit(std::uint32_t number) {
  return {number / 32 * sizeof(std::uint32_t), std::uint32_t{1} << number % 32};
}

template <typename T> T load(const unsigned char *place) {
  T value;
  std::memcpy(&value, place, sizeof value);
  return value;
}

template <typename T> void store(unsigned char *place, T value) {
  std::memcpy(place, &value, sizeof value);
}

}  // namespace

bool DeviceAccess::read_bit(const DeviceRef &ref, std::uint32_t number) const {
  if (number >= symbol(ref).count) {
    auto found = side_store_.find(side_key(ref, number));
    return found != side_store_.end() && found->second != 0;
  }
  const unsigned char *start = image(symbol(ref));
  switch (symbol(ref).shape) {
  case Shape::Bits:
    return start[number] != 0;
  case Shape::PackedBits: {
    auto [offset, mask] = packed_bit(number);
    return (load<std::uint32_t>(start + offset) & mask) != 0;
  }
  case Shape::Timers:
  case Shape::Counters:
    return start[timer_bit(ref, number)] != 0;
  case Shape::Words:
    break;  // a bit of a word is read through its word
  }
  return false;
}

void DeviceAccess::write_bit(const DeviceRef &ref, std::uint32_t number, bool bit) {
  if (number >= symbol(ref).count) {
    side_store_[side_key(ref, number)] = bit;
    return;
  }
  unsigned char *start = image(symbol(ref));
  switch (symbol(ref).shape) {
  case Shape::Bits:
    start[number] = bit;
    break;
  case Shape::PackedBits: {
    auto [offset, mask] = packed_bit(number);
    auto word = load<std::uint32_t>(start + offset);
    store<std::uint32_t>(start + offset, bit ? word | mask : word & ~mask);
    break;
  }
  case Shape::Timers:
  case Shape::Counters:
    start[timer_bit(ref, number)] = bit;
    break;
  case Shape::Words:
    break;
  }
}

std::uint16_t DeviceAccess::read_word(const DeviceRef &ref, std::uint32_t number) const {
  if (number < symbol(ref).count)
    return load<std::uint16_t>(image(symbol(ref)) + word_offset(ref, number));
  auto found = side_store_.find(side_key(ref, number));
  return found == side_store_.end() ? std::uint16_t{0} : found->second;
}

void DeviceAccess::write_word(const DeviceRef &ref, std::uint32_t number, std::uint16_t word) {
  if (number < symbol(ref).count)
    store<std::uint16_t>(image(symbol(ref)) + word_offset(ref, number), word);
  else
    side_store_[side_key(ref, number)] = word;
}

Value DeviceAccess::read(const DeviceRef &ref) const {
  Value value{ref.format, 0};
  if (ref.digits != 0) {
    for (unsigned bit = 0; bit < ref.digits * 4u; ++bit)
      value.bits |= std::uint32_t{read_bit(ref, ref.number + bit)} << bit;
  } else if (ref.word_bit != kNoBit) {
    value.bits = read_word(ref, ref.number) >> ref.word_bit & 1u;
  } else if (ref.format == Format::Bit) {
    value.bits = read_bit(ref, ref.number);
  } else {
    value.bits = read_word(ref, ref.number);
    if (ref.format != Format::Word)
      value.bits |= std::uint32_t{read_word(ref, ref.number + 1)} << 16;
  }
  return value;
}

void DeviceAccess::write(const DeviceRef &ref, const Value &value) {
  if (ref.digits != 0) {
    for (unsigned bit = 0; bit < ref.digits * 4u; ++bit)
      write_bit(ref, ref.number + bit, (value.bits >> bit & 1u) != 0);
  } else if (ref.word_bit != kNoBit) {
    unsigned mask = 1u << ref.word_bit, word = read_word(ref, ref.number);
    write_word(ref, ref.number, static_cast<std::uint16_t>(value.bits != 0 ? word | mask : word & ~mask));
  } else if (ref.format == Format::Bit) {
    write_bit(ref, ref.number, value.bits != 0);
  } else {
    write_word(ref, ref.number, static_cast<std::uint16_t>(value.bits));
    if (ref.format != Format::Word)
      write_word(ref, ref.number + 1, static_cast<std::uint16_t>(value.bits >> 16));
  }
}

}  // namespace ladder::hosted
