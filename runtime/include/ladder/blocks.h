// Runs of words as block transfers see them: where they start, how many words follow up to the end of the device class, and word i.
//
// Every block has points(), origin(), first(), get(i) and set(i, value). Two blocks of one origin and one type may overlap; first()
// then tells which lies higher.
#pragma once

#include "ladder/number.h"

namespace ladder {

/// Words side by side: `D.block(10)`.
class WordBlock {
public:
  constexpr WordBlock(word *words, unsigned first, unsigned count) noexcept
      : words_(words), first_(first), points_(count - first) {}
  constexpr unsigned points() const noexcept { return points_; }
  constexpr const void *origin() const noexcept { return words_; }
  constexpr unsigned first() const noexcept { return first_; }
  constexpr word get(unsigned i) const noexcept { return words_[first_ + i]; }
  constexpr void set(unsigned i, word value) const noexcept { words_[first_ + i] = value; }

private:
  word *words_;
  unsigned first_, points_;
};

/// The current values of consecutive timers or counters: `T.block(0)`.
template <class Owner> class ValueBlock {
public:
  constexpr ValueBlock(Owner *owners, unsigned first, unsigned count) noexcept
      : owners_(owners), first_(first), points_(count - first) {}
  constexpr unsigned points() const noexcept { return points_; }
  constexpr const void *origin() const noexcept { return owners_; }
  constexpr unsigned first() const noexcept { return first_; }
  constexpr word get(unsigned i) const noexcept { return owners_[first_ + i].value; }
  constexpr void set(unsigned i, word value) const noexcept { owners_[first_ + i].value = value; }

private:
  Owner *owners_;
  unsigned first_, points_;
};

/// Consecutive groups of K digits, one group a word: `M.digit_block<2>(0)` is M0-M7, M8-M15, ...
template <class Image, unsigned K> class DigitBlock {
  static_assert(K >= 1 && K <= 4, "a word has four digits");

public:
  constexpr DigitBlock(Image &image, unsigned first) noexcept : image_(&image), first_(first) {}
  constexpr unsigned points() const noexcept { return (Image::kPoints - first_) / (4 * K); }
  constexpr const void *origin() const noexcept { return image_; }
  constexpr unsigned first() const noexcept { return first_; }
  word get(unsigned i) const noexcept { return image_->template word<K>(first_ + i * 4 * K); }
  void set(unsigned i, word value) const noexcept { image_->template digits<K>(first_ + i * 4 * K) = value; }

private:
  Image *image_;
  unsigned first_;
};

}  // namespace ladder
