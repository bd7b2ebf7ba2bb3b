// One state, ON or OFF, as a type of its own.
//
// Ladder logic combines states with `&`, `|`, `^` and `!`, never with numbers. `bool` would promote to int in such expressions and
// is undefined when a host copies another byte than 0 or 1 into it; `bit` is one byte that holds 0 or 1, combines without branches,
// and converts to bool only where a condition asks for it. Memory of zeros is OFF.
#pragma once

#include <cstdint>
#include <type_traits>

namespace ladder {

class bit {
public:
  constexpr bit() noexcept = default;
  /// A cast, because GCC makes jumps of `state ? 1 : 0`.
  explicit constexpr bit(bool state) noexcept : value_(static_cast<std::uint8_t>(state)) {}

  /// The lowest bit of a pattern.
  static constexpr bit lowest_of(std::uint32_t pattern) noexcept {
    bit result;
    result.value_ = static_cast<std::uint8_t>(pattern & 1U);
    return result;
  }

  explicit constexpr operator bool() const noexcept { return value_ != 0; }

  /// 0 or 1.
  constexpr std::uint8_t value() const noexcept { return value_; }

  constexpr bit &operator&=(bit other) noexcept {
    value_ = static_cast<std::uint8_t>(value_ & other.value_);
    return *this;
  }
  constexpr bit &operator|=(bit other) noexcept {
    value_ = static_cast<std::uint8_t>(value_ | other.value_);
    return *this;
  }
  constexpr bit &operator^=(bit other) noexcept {
    value_ = static_cast<std::uint8_t>(value_ ^ other.value_);
    return *this;
  }

private:
  std::uint8_t value_ = 0;
};

static_assert(sizeof(bit) == 1 && std::is_trivially_copyable<bit>::value, "images of bits are copied as bytes");

// Not members, so that the proxies for single bits of a word take part through their conversion to `bit`.
constexpr bit operator&(bit a, bit b) noexcept {
  return a &= b;
}
constexpr bit operator|(bit a, bit b) noexcept {
  return a |= b;
}
constexpr bit operator^(bit a, bit b) noexcept {
  return a ^= b;
}
constexpr bit operator!(bit a) noexcept {
  return bit(a.value() == 0);
}
constexpr bool operator==(bit a, bit b) noexcept {
  return a.value() == b.value();
}
constexpr bool operator!=(bit a, bit b) noexcept {
  return a.value() != b.value();
}

inline constexpr bit off{};
inline constexpr bit on{true};

/// One bit inside a larger cell, as if it were a `bit&`. Lives as long as the expression that makes it.
template <class Cell> class CellBit {
public:
  constexpr CellBit(Cell &cell, unsigned place) noexcept : cell_(&cell), place_(place) {}
  constexpr CellBit(const CellBit &) noexcept = default;

  constexpr operator bit() const noexcept { return bit::lowest_of(pattern() >> place_); }
  explicit constexpr operator bool() const noexcept { return (pattern() >> place_ & 1U) != 0; }

  /// A member, because the free operator would compete with the built-in one for bool.
  constexpr bit operator!() const noexcept { return bit::lowest_of(~pattern() >> place_); }

  constexpr CellBit &operator=(bit state) noexcept {
    const std::uint32_t others = pattern() & ~(std::uint32_t{1} << place_);
    *cell_ = static_cast<Cell>(others | std::uint32_t{state.value()} << place_);
    return *this;
  }
  constexpr CellBit &operator=(const CellBit &other) noexcept { return *this = static_cast<bit>(other); }
  constexpr CellBit &operator&=(bit state) noexcept { return *this = *this & state; }
  constexpr CellBit &operator|=(bit state) noexcept { return *this = *this | state; }
  constexpr CellBit &operator^=(bit state) noexcept { return *this = *this ^ state; }

private:
  constexpr std::uint32_t pattern() const noexcept { return static_cast<std::make_unsigned_t<Cell>>(*cell_); }

  Cell *cell_;
  unsigned place_;
};

using PackedBit = CellBit<std::uint32_t>;  ///< a point of a packed image
using WordBit = CellBit<std::int16_t>;     ///< a bit of a word device: D0.5

}  // namespace ladder
