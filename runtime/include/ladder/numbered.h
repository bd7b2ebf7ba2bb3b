// A device image whose numbers do not start at 0: M8000 to M8511, C200 to C255.
//
// Takes device numbers as the list writes them and hands on what lies `First` below. Numbers are constants nearly everywhere, so
// that nothing of it is left in the machine code.
#pragma once

#include <cstdint>

namespace ladder {

template <class Image, unsigned First> class Numbered {
public:
  static constexpr unsigned kFirst = First;
  static constexpr unsigned kPoints = Image::kPoints;

  constexpr decltype(auto) operator[](unsigned number) noexcept { return image_[number - First]; }
  constexpr decltype(auto) operator[](unsigned number) const noexcept { return image_[number - First]; }
  /// True where `count` numbers from `number` on exist.
  static constexpr bool has(unsigned number, unsigned count = 1) noexcept {
    return number >= First && Image::has(number - First, count);
  }

  template <unsigned K> auto word(unsigned first) const noexcept { return image_.template word<K>(first - First); }
  template <unsigned K> auto dword(unsigned first) const noexcept { return image_.template dword<K>(first - First); }
  template <unsigned K> auto digits(unsigned first) noexcept { return image_.template digits<K>(first - First); }
  template <unsigned K> auto digit_block(unsigned first) noexcept { return image_.template digit_block<K>(first - First); }
  template <unsigned K> auto digit_dblock(unsigned first) noexcept { return image_.template digit_dblock<K>(first - First); }
  constexpr auto run(unsigned first) noexcept { return image_.run(first - First); }
  constexpr auto pair(unsigned first) noexcept { return image_.pair(first - First); }
  constexpr auto quad(unsigned first) noexcept { return image_.quad(first - First); }
  constexpr auto real(unsigned first) noexcept { return image_.real(first - First); }
  constexpr auto block(unsigned first) noexcept { return image_.block(first - First); }
  constexpr auto dblock(unsigned first) noexcept { return image_.dblock(first - First); }
  constexpr void clear() noexcept { image_.clear(); }
  constexpr void clear(unsigned first, unsigned last) noexcept { image_.clear(first - First, last - First); }

private:
  Image image_{};
};

}  // namespace ladder
