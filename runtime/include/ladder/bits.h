// The image of a bit device class: X, Y, M.
//
// Hosts keep a byte for every point: a contact is a load, a coil a store, and neighbours never share a read-modify-write. Small
// targets pack 32 points into a std::uint32_t. LADDER_PACKED_BITS=1 on the compiler's command line selects the packed image for the
// whole program (every file of a program must be built alike); the generated source is the same for both.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/digits.h"

#include <cstdint>

namespace ladder {

#if defined(LADDER_PACKED_BITS)
inline constexpr bool kPackedBits = (LADDER_PACKED_BITS) != 0;
#else
inline constexpr bool kPackedBits = false;
#endif

/// What both images derive from their subscript, gather_points and scatter_points.
template <class Image, unsigned N> class BitsView {
public:
  static constexpr unsigned kPoints = N;

  /// The number in K digits from `first` on, zero-extended; four digits are signed by their pattern.
  template <unsigned K> ladder::word word(unsigned first) const noexcept {
    static_assert(K >= 1 && K <= 4, "a word has four digits");
    return to_word(self().template gather_points<4 * K>(first));
  }
  template <unsigned K> ladder::dword dword(unsigned first) const noexcept {
    static_assert(K >= 1 && K <= 8, "a double word has eight digits");
    return to_dword(self().template gather_points<4 * K>(first));
  }
  /// The same digits to be assigned to.
  template <unsigned K> Digits<Image, K> digits(unsigned first) noexcept { return {self(), first}; }
  /// Consecutive groups of K digits up to the end of the class, for block transfers.
  template <unsigned K> DigitBlock<Image, K> digit_block(unsigned first) noexcept { return {self(), first}; }
  template <unsigned K> DigitDWordBlock<Image, K> digit_dblock(unsigned first) noexcept { return {self(), first}; }
  /// The bits from `first` to the end of the class.
  constexpr BitRun<Image> run(unsigned first) noexcept { return {self(), first}; }
  /// True where `count` numbers from `number` on exist.
  static constexpr bool has(unsigned number, unsigned count = 1) noexcept { return number < N && count <= N - number; }

private:
  constexpr Image &self() noexcept { return static_cast<Image &>(*this); }
  const Image &self() const noexcept { return static_cast<const Image &>(*this); }
};

/// N points, numbers 0 to N - 1. Numbers are not checked: the compiler knows them all.
template <unsigned N, bool Packed = kPackedBits> class Bits : public BitsView<Bits<N, Packed>, N> {
public:
  constexpr bit &operator[](unsigned number) noexcept { return points_[number]; }
  constexpr bit operator[](unsigned number) const noexcept { return points_[number]; }
  constexpr void clear() noexcept {
    for (bit &point : points_)
      point = off;
  }
  /// Numbers `first` to `last`, for classes that are latched in part.
  constexpr void clear(unsigned first, unsigned last) noexcept {
    for (unsigned number = first; number <= last; ++number)
      points_[number] = off;
  }

  template <unsigned Count> std::uint32_t gather_points(unsigned first) const noexcept {
    return detail::gather<Count>(points_ + first);
  }
  template <unsigned Count> void scatter_points(unsigned first, std::uint32_t pattern) noexcept {
    detail::scatter<Count>(points_ + first, pattern);
  }

private:
  bit points_[N] = {};
};

template <unsigned N> class Bits<N, true> : public BitsView<Bits<N, true>, N> {
public:
  constexpr PackedBit operator[](unsigned number) noexcept { return {cells_[number / 32], number % 32}; }
  constexpr bit operator[](unsigned number) const noexcept { return bit::lowest_of(cells_[number / 32] >> number % 32); }
  constexpr void clear() noexcept {
    for (std::uint32_t &cell : cells_)
      cell = 0;
  }
  constexpr void clear(unsigned first, unsigned last) noexcept {
    for (unsigned number = first; number <= last; ++number)
      (*this)[number] = off;
  }

  template <unsigned Count> std::uint32_t gather_points(unsigned first) const noexcept {
    const unsigned cell = first / 32, place = first % 32;
    std::uint32_t pattern = cells_[cell] >> place;
    if (place + Count > 32)  // then place is not 0, and the next cell exists because the last point does
      pattern |= cells_[cell + 1] << (32 - place);
    return pattern & kMask<Count>;
  }
  template <unsigned Count> void scatter_points(unsigned first, std::uint32_t pattern) noexcept {
    const unsigned cell = first / 32, place = first % 32;
    pattern &= kMask<Count>;
    cells_[cell] = (cells_[cell] & ~(kMask<Count> << place)) | pattern << place;
    if (place + Count > 32)
      cells_[cell + 1] = (cells_[cell + 1] & ~(kMask<Count> >> (32 - place))) | pattern >> (32 - place);
  }

private:
  template <unsigned Count> static constexpr std::uint32_t kMask = 0xFFFFFFFFU >> (32 - Count);

  std::uint32_t cells_[(N + 31) / 32] = {};
};

}  // namespace ladder
