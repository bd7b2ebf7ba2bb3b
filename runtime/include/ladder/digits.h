// Digits: runs of bit devices read and written as numbers.
//
// A digit is four consecutive points; K2X10 is the number in X10 to X17, X10 being bit 0. In a byte image eight points are eight
// bytes with 0 or 1 in each. On 64-bit little-endian hosts one load and one multiplication bring their lowest bits together, and
// one multiplication and a mask spread them again; elsewhere a plain loop does it. Both are always compiled so that tests can
// compare them.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"

#include <cstdint>
#include <type_traits>

namespace ladder {
namespace detail {

#if defined(__BYTE_ORDER__) && defined(__ORDER_LITTLE_ENDIAN__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
inline constexpr bool kLittleEndian = true;
#else
inline constexpr bool kLittleEndian = false;
#endif
/// A 64-bit multiplication is one instruction.
inline constexpr bool kWideMultiply = sizeof(void *) >= 8;

template <unsigned Count> constexpr std::uint32_t gather_plain(const bit *points) noexcept {
  std::uint32_t pattern = 0;
  for (unsigned i = 0; i < Count; ++i)
    pattern |= std::uint32_t{points[i].value()} << i;
  return pattern;
}

template <unsigned Count> constexpr void scatter_plain(bit *points, std::uint32_t pattern) noexcept {
  for (unsigned i = 0; i < Count; ++i)
    points[i] = bit::lowest_of(pattern >> i);
}

/// Little-endian only. Byte i (0 or 1) times 2^(56-7i) puts its bit at 56+i; no two products share a bit, so nothing carries.
inline std::uint32_t gather_eight(const bit *points) noexcept {
  std::uint64_t bytes;
  __builtin_memcpy(&bytes, points, sizeof bytes);
  return static_cast<std::uint32_t>(bytes * 0x0102040810204080U >> 56);
}

inline std::uint32_t gather_four(const bit *points) noexcept {
  std::uint32_t bytes;
  __builtin_memcpy(&bytes, points, sizeof bytes);
  return bytes * 0x01020408U >> 24 & 0xFU;
}

/// Little-endian only. Each byte gets a copy of the pattern and keeps its own bit; adding 7F moves "not zero" to the byte's top.
inline void scatter_eight(bit *points, std::uint32_t pattern) noexcept {
  const std::uint64_t own = (pattern & 0xFFU) * 0x0101010101010101U & 0x8040201008040201U;
  const std::uint64_t bytes = (own + 0x7F7F7F7F7F7F7F7FU) >> 7 & 0x0101010101010101U;
  __builtin_memcpy(static_cast<void *>(points), &bytes, sizeof bytes);
}

/// Bit i times 2^(7i) lands in byte i.
inline void scatter_four(bit *points, std::uint32_t pattern) noexcept {
  const std::uint32_t bytes = (pattern & 0xFU) * 0x00204081U & 0x01010101U;
  __builtin_memcpy(static_cast<void *>(points), &bytes, sizeof bytes);
}

template <unsigned Count> std::uint32_t gather_wide(const bit *points) noexcept {
  static_assert(Count % 4 == 0, "digits are four points");
  std::uint32_t pattern = 0;
  for (unsigned i = 0; i + 8 <= Count; i += 8)
    pattern |= gather_eight(points + i) << i;
  if (Count % 8 != 0)
    pattern |= gather_four(points + (Count - 4)) << (Count - 4);
  return pattern;
}

template <unsigned Count> void scatter_wide(bit *points, std::uint32_t pattern) noexcept {
  static_assert(Count % 4 == 0, "digits are four points");
  for (unsigned i = 0; i + 8 <= Count; i += 8)
    scatter_eight(points + i, pattern >> i);
  if (Count % 8 != 0)
    scatter_four(points + (Count - 4), pattern >> (Count - 4));
}

/// The number in `Count` points of a byte image.
template <unsigned Count> std::uint32_t gather(const bit *points) noexcept {
  if constexpr (kLittleEndian && kWideMultiply)
    return gather_wide<Count>(points);
  else
    return gather_plain<Count>(points);
}

template <unsigned Count> void scatter(bit *points, std::uint32_t pattern) noexcept {
  if constexpr (kLittleEndian && kWideMultiply)
    scatter_wide<Count>(points, pattern);
  else
    scatter_plain<Count>(points, pattern);
}

/// The low 32 bits of any integer, or of what stands for a double word, such as a pair of words.
template <class Number> constexpr std::uint32_t low_bits(Number value) noexcept {
  if constexpr (std::is_integral<Number>::value)
    return static_cast<std::uint32_t>(value);
  else
    return pattern_of(static_cast<dword>(value));
}

}  // namespace detail

/// K digits of one image from one point on. `Image` has gather_points<Count>(first) and scatter_points<Count>(first, pattern).
template <class Image, unsigned K> class Digits {
  static_assert(K >= 1 && K <= 8, "one to eight digits");

public:
  constexpr Digits(Image &image, unsigned first) noexcept : image_(&image), first_(first) {}
  constexpr Digits(const Digits &) noexcept = default;

  /// Zero-extended; four digits are signed by their pattern.
  ladder::word word() const noexcept {
    static_assert(K <= 4, "a word has four digits");
    return to_word(image_->template gather_points<4 * K>(first_));
  }
  ladder::dword dword() const noexcept { return to_dword(image_->template gather_points<4 * K>(first_)); }

  /// Writes the low 4*K bits; other points keep their state.
  template <class Integer> Digits &operator=(Integer value) noexcept {
    image_->template scatter_points<4 * K>(first_, detail::low_bits(value));
    return *this;
  }
  Digits &operator=(const Digits &other) noexcept { return *this = other.dword(); }

private:
  Image *image_;
  unsigned first_;
};

/// Digits over points that do not lie side by side: a run that crosses the end of a device class. Lowest point first.
template <class First, class... Rest> class DigitRun {
public:
  constexpr explicit DigitRun(First first, Rest... rest) noexcept : first_(first), rest_(rest...) {}
  constexpr DigitRun(const DigitRun &) noexcept = default;

  constexpr std::uint32_t pattern() const noexcept { return static_cast<bit>(first_).value() | rest_.pattern() << 1; }
  constexpr void write(std::uint32_t pattern) noexcept {
    first_ = bit::lowest_of(pattern);
    rest_.write(pattern >> 1);
  }

  constexpr ladder::word word() const noexcept {
    static_assert(sizeof...(Rest) < 16, "a word has four digits");
    return to_word(pattern());
  }
  constexpr ladder::dword dword() const noexcept {
    static_assert(sizeof...(Rest) < 32, "a double word has eight digits");
    return to_dword(pattern());
  }
  template <class Integer> constexpr DigitRun &operator=(Integer value) noexcept {
    write(detail::low_bits(value));
    return *this;
  }
  constexpr DigitRun &operator=(const DigitRun &other) noexcept { return *this = other.pattern(); }

private:
  First first_;
  DigitRun<Rest...> rest_;
};

template <class Last> class DigitRun<Last> {
public:
  constexpr explicit DigitRun(Last last) noexcept : last_(last) {}
  constexpr std::uint32_t pattern() const noexcept { return static_cast<bit>(last_).value(); }
  constexpr void write(std::uint32_t pattern) noexcept { last_ = bit::lowest_of(pattern); }

private:
  Last last_;
};

/// `digits_of(Y[0x17FE], Y[0x17FF], M[0], M[1])`: one digit, lowest point first. Takes `bit&` and proxies in any mixture.
template <class... Points> constexpr auto digits_of(Points &&...points) noexcept {
  static_assert(sizeof...(Points) % 4 == 0 && sizeof...(Points) >= 4, "digits are four points");
  return DigitRun<Points...>(points...);
}

}  // namespace ladder
