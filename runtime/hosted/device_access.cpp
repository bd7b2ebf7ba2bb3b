// Bits and words of the program's image, by shape, and of the side store behind it.
//
// The object is foreign memory: everything is copied bytewise, so that no type of the program needs to be known here.
#include "ladder/hosted/device_access.h"

#include <cstddef>
#include <cstring>

namespace ladder::hosted {
namespace {

std::uint64_t side_key(const DeviceRef &ref, std::uint32_t number) {
  return std::uint64_t{ref.device} << 40 | std::uint64_t{static_cast<unsigned char>(ref.part)} << 32 | number;
}

/// Bytes from number to number of a table that says nothing about it.
std::size_t packed_stride(Shape shape) {
  switch (shape) {
  case Shape::Bits:
  case Shape::PackedBits:
    break;
  case Shape::Words:
    return 2;
  case Shape::Timers:
  case Shape::Counters:
    return 4;
  case Shape::LongCounters:
    return 8;
  }
  return 1;
}

/// Where one part of a number lies within what the image has for the number.
std::size_t part_offset(Shape shape, Part part) {
  const std::size_t value_size = shape == Shape::LongCounters ? 4 : 2;
  return part == Part::Contact ? value_size : part == Part::Coil ? value_size + 1 : 0;
}

struct PackedPlace {
  std::size_t offset;
  std::uint32_t mask;
};
PackedPlace packed_bit(std::uint32_t index) {
  return {index / 32 * sizeof(std::uint32_t), std::uint32_t{1} << index % 32};
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

unsigned char *DeviceAccess::place(const DeviceRef &ref, std::uint32_t number) const {
  const DeviceSymbol &of = symbol(ref);
  if (number - of.first >= of.count)
    return nullptr;
  if (of.shape == Shape::PackedBits)
    return image(of) + packed_bit(number - of.first).offset;
  const std::size_t stride = of.stride != 0 ? of.stride : packed_stride(of.shape);
  return image(of) + (number - of.first) * stride + part_offset(of.shape, ref.part);
}

std::uint32_t DeviceAccess::read_side(const DeviceRef &ref, std::uint32_t number) const {
  auto found = side_store_.find(side_key(ref, number));
  return found == side_store_.end() ? 0 : found->second;
}

bool DeviceAccess::read_bit(const DeviceRef &ref, std::uint32_t number) const {
  const unsigned char *byte = place(ref, number);
  if (byte == nullptr)
    return read_side(ref, number) != 0;
  if (symbol(ref).shape == Shape::PackedBits)
    return (load<std::uint32_t>(byte) & packed_bit(number - symbol(ref).first).mask) != 0;
  return *byte != 0;
}

void DeviceAccess::write_bit(const DeviceRef &ref, std::uint32_t number, bool bit) {
  unsigned char *byte = place(ref, number);
  if (byte == nullptr) {
    side_store_[side_key(ref, number)] = bit;
  } else if (symbol(ref).shape == Shape::PackedBits) {
    const std::uint32_t mask = packed_bit(number - symbol(ref).first).mask;
    auto cell = load<std::uint32_t>(byte);
    store<std::uint32_t>(byte, bit ? cell | mask : cell & ~mask);
  } else {
    *byte = bit;
  }
}

std::uint16_t DeviceAccess::read_word(const DeviceRef &ref, std::uint32_t number) const {
  const unsigned char *word = place(ref, number);
  return word != nullptr ? load<std::uint16_t>(word) : static_cast<std::uint16_t>(read_side(ref, number));
}

void DeviceAccess::write_word(const DeviceRef &ref, std::uint32_t number, std::uint16_t value) {
  if (unsigned char *word = place(ref, number))
    store<std::uint16_t>(word, value);
  else
    side_store_[side_key(ref, number)] = value;
}

DeviceAccess::High DeviceAccess::high_word(const DeviceRef &ref) const {
  High high{ref, ref.number + 1};
  if (const std::uint32_t other = symbol(ref).high; other != kNoClass) {
    high.ref.device = other;
    high.number = ref.number;
  }
  return high;
}

std::uint32_t DeviceAccess::read_double(const DeviceRef &ref) const {
  if (symbol(ref).shape == Shape::LongCounters) {
    const unsigned char *value = place(ref, ref.number);
    return value != nullptr ? load<std::uint32_t>(value) : read_side(ref, ref.number);
  }
  const High high = high_word(ref);
  return read_word(ref, ref.number) | std::uint32_t{read_word(high.ref, high.number)} << 16;
}

void DeviceAccess::write_double(const DeviceRef &ref, std::uint32_t value) {
  if (symbol(ref).shape == Shape::LongCounters) {
    if (unsigned char *whole = place(ref, ref.number))
      store<std::uint32_t>(whole, value);
    else
      side_store_[side_key(ref, ref.number)] = value;
    return;
  }
  const High high = high_word(ref);
  write_word(ref, ref.number, static_cast<std::uint16_t>(value));
  write_word(high.ref, high.number, static_cast<std::uint16_t>(value >> 16));
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
    value.bits = ref.format == Format::Word ? read_word(ref, ref.number) : read_double(ref);
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
  } else if (ref.format == Format::Word) {
    write_word(ref, ref.number, static_cast<std::uint16_t>(value.bits));
  } else {
    write_double(ref, value.bits);
  }
}

}  // namespace ladder::hosted
