// 64 inputs per step of an xorshift generator, in the order of the table and of the numbers.
#include "hosted/stimulus.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace ladder::hosted {
namespace {

/// Neighbouring seeds give unlike sequences, and no seed gives the state 0, in which xorshift stays.
std::uint64_t mix(std::uint64_t seed) {
  seed += 0x9E3779B97F4A7C15u;
  seed = (seed ^ seed >> 30) * 0xBF58476D1CE4E5B9u;
  seed = (seed ^ seed >> 27) * 0x94D049BB133111EBu;
  seed ^= seed >> 31;
  return seed != 0 ? seed : 1;
}

/// Byte 0 of the value first, on every machine.
void store_little(unsigned char *place, std::uint64_t value) {
  if constexpr (std::endian::native == std::endian::little)
    std::memcpy(place, &value, sizeof value);
  else
    for (unsigned i = 0; i < 8; ++i)
      place[i] = static_cast<unsigned char>(value >> 8 * i);
}

/// 64 bytes of 0 or 1: each of eight rounds takes one bit out of every byte of the pattern.
void write_64_bytes(unsigned char *place, std::uint64_t bits) {
  for (unsigned round = 0; round < 8; ++round)
    store_little(place + 8 * round, bits >> round & 0x0101010101010101u);
}

void write_bytes(unsigned char *place, std::uint32_t count, std::uint64_t bits) {
  if (count == 64) {
    write_64_bytes(place, bits);
    return;
  }
  unsigned char bytes[64];
  write_64_bytes(bytes, bits);
  std::memcpy(place, bytes, count);
}

void write_packed(unsigned char *place, std::uint32_t count, std::uint64_t bits) {
  for (std::uint32_t number = 0; number < count; number += 32, bits >>= 32) {
    auto word = static_cast<std::uint32_t>(bits);
    if (count - number < 32)
      word &= (std::uint32_t{1} << (count - number)) - 1;
    std::memcpy(place + number / 8, &word, sizeof word);
  }
}

}  // namespace

Stimulus::Stimulus(StimulusKind kind) : pattern_(kind.pattern), state_(mix(kind.seed)) {}

std::uint64_t Stimulus::next_bits() {
  if (pattern_ == StimulusKind::Toggle)
    return on_ ? ~std::uint64_t{0} : 0;
  state_ ^= state_ << 13;
  state_ ^= state_ >> 7;
  state_ ^= state_ << 17;
  return state_;
}

void Stimulus::apply(const Instance &instance) {
  if (pattern_ == StimulusKind::None)
    return;
  on_ = !on_;
  const ProgramSymbols &symbols = instance.symbols();
  for (std::uint32_t index = 0; index < symbols.device_count; ++index) {
    const DeviceSymbol &symbol = symbols.devices[index];
    bool packed = symbol.shape == Shape::PackedBits;
    if (!symbol.input || (symbol.shape != Shape::Bits && !packed))
      continue;
    unsigned char *image = instance.devices().image(symbol);
    for (std::uint32_t first = 0; first < symbol.count; first += 64) {
      std::uint32_t count = std::min<std::uint32_t>(64, symbol.count - first);
      if (packed)
        write_packed(image + first / 8, count, next_bits());
      else
        write_bytes(image + first, count, next_bits());
    }
  }
}

}  // namespace ladder::hosted
