// Runs of words as block transfers see them: where they start, how many words follow up to the end of the device class, and word i.
//
// Every block has points(), origin(), first(), get(i) and set(i, value). Two blocks of one origin and one type may overlap; first()
// then tells which lies higher.
#pragma once

#include "ladder/bit.h"
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

/// Pairs of words side by side, low word first: `D.dblock(10)` is (D11, D10), (D13, D12), ...
class DWordBlock {
public:
  constexpr DWordBlock(word *words, unsigned first, unsigned count) noexcept
      : words_(words), first_(first), points_((count - first) / 2) {}
  constexpr unsigned points() const noexcept { return points_; }
  constexpr const void *origin() const noexcept { return words_; }
  constexpr unsigned first() const noexcept { return first_; }
  constexpr dword get(unsigned i) const noexcept {
    return to_dword(pattern_of(words_[first_ + 2 * i]) | pattern_of(words_[first_ + 2 * i + 1]) << 16);
  }
  constexpr void set(unsigned i, dword value) const noexcept {
    words_[first_ + 2 * i] = to_word(pattern_of(value));
    words_[first_ + 2 * i + 1] = to_word(pattern_of(value) >> 16);
  }

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

/// The same with values of 16 bits taken two at a time: pairs of timers or counters.
template <class Owner> class ValuePairBlock {
public:
  constexpr ValuePairBlock(Owner *owners, unsigned first, unsigned count) noexcept
      : owners_(owners), first_(first), points_((count - first) / 2) {}
  constexpr unsigned points() const noexcept { return points_; }
  constexpr const void *origin() const noexcept { return owners_; }
  constexpr unsigned first() const noexcept { return first_; }
  constexpr dword get(unsigned i) const noexcept {
    return to_dword(pattern_of(owners_[first_ + 2 * i].value) | pattern_of(owners_[first_ + 2 * i + 1].value) << 16);
  }
  constexpr void set(unsigned i, dword value) const noexcept {
    owners_[first_ + 2 * i].value = to_word(pattern_of(value));
    owners_[first_ + 2 * i + 1].value = to_word(pattern_of(value) >> 16);
  }

private:
  Owner *owners_;
  unsigned first_, points_;
};

/// The current values of consecutive 32-bit counters.
template <class Owner> class LongValueBlock {
public:
  constexpr LongValueBlock(Owner *owners, unsigned first, unsigned count) noexcept
      : owners_(owners), first_(first), points_(count - first) {}
  constexpr unsigned points() const noexcept { return points_; }
  constexpr const void *origin() const noexcept { return owners_; }
  constexpr unsigned first() const noexcept { return first_; }
  constexpr dword get(unsigned i) const noexcept { return owners_[first_ + i].value; }
  constexpr void set(unsigned i, dword value) const noexcept { owners_[first_ + i].value = value; }

private:
  Owner *owners_;
  unsigned first_, points_;
};

/// Consecutive groups of K digits as 32-bit numbers.
template <class Image, unsigned K> class DigitDWordBlock {
  static_assert(K >= 1 && K <= 8, "a double word has eight digits");

public:
  constexpr DigitDWordBlock(Image &image, unsigned first) noexcept : image_(&image), first_(first) {}
  constexpr unsigned points() const noexcept { return (Image::kPoints - first_) / (4 * K); }
  constexpr const void *origin() const noexcept { return image_; }
  constexpr unsigned first() const noexcept { return first_; }
  dword get(unsigned i) const noexcept { return image_->template dword<K>(first_ + i * 4 * K); }
  void set(unsigned i, dword value) const noexcept { image_->template digits<K>(first_ + i * 4 * K) = value; }

private:
  Image *image_;
  unsigned first_;
};

/// Consecutive bits: `M.run(10)` is M10, M11, ...
template <class Image> class BitRun {
public:
  constexpr BitRun(Image &image, unsigned first) noexcept : image_(&image), first_(first) {}
  constexpr unsigned points() const noexcept { return Image::kPoints - first_; }
  constexpr const void *origin() const noexcept { return image_; }
  constexpr unsigned first() const noexcept { return first_; }
  constexpr Image *image() const noexcept { return image_; }
  constexpr bit get(unsigned i) const noexcept { return (*image_)[first_ + i]; }
  constexpr void set(unsigned i, bit state) const noexcept { (*image_)[first_ + i] = state; }

private:
  Image *image_;
  unsigned first_;
};

/// One bit that is written later, when the expression that named it is long gone: by an interrupt, by a running output. Nothing is
/// written before a bit is named. Refers to the image, so the program object must stay where it is while it is in use.
class BitTarget {
public:
  constexpr BitTarget() noexcept = default;
  template <class Image> constexpr BitTarget(BitRun<Image> run) noexcept
      : image_(run.image()), number_(run.first()), write_([](void *image, unsigned number, bit state) noexcept {
          (*static_cast<Image *>(image))[number] = state;
        }) {}
  void operator=(bit state) const noexcept {
    if (write_ != nullptr)
      write_(image_, number_, state);
  }
  constexpr bool operator==(const BitTarget &other) const noexcept {
    return image_ == other.image_ && number_ == other.number_;
  }

private:
  void *image_ = nullptr;
  unsigned number_ = 0;
  void (*write_)(void *, unsigned, bit) = nullptr;
};

}  // namespace ladder
