// The list of annunciators in SD62-SD79: who is ON, in the order of detection.
//
// SD63 counts the entries, SD64-SD79 hold them, SD62 repeats the oldest. An annunciator is entered once. When one of sixteen
// entries is removed, an annunciator that is ON without an entry moves in; the manual does not say which of several, here it is the
// lowest number.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"

namespace ladder::melsec_qs {

/// Stands for the annunciators of a program that uses none.
struct NoAnnunciators {
  static constexpr unsigned kPoints = 0;
  bit none{};
  constexpr bit &operator[](unsigned) noexcept { return none; }
};

/// A view of the special registers as that list.
template <class SpecialRegisters> class AnnunciatorList {
public:
  static constexpr unsigned kCapacity = 16;

  constexpr explicit AnnunciatorList(SpecialRegisters &registers) noexcept : sd_(registers) {}

  /// The program could have written the register, so it is not trusted.
  constexpr unsigned count() const noexcept {
    const word n = sd_[63];
    return n < 0 ? 0U : n > word{kCapacity} ? kCapacity : static_cast<unsigned>(n);
  }
  constexpr bool contains(unsigned number) const noexcept { return find(number) < count(); }
  constexpr unsigned oldest() const noexcept { return pattern_of(sd_[kFirst]); }

  /// Enters a number unless it is there or the list is full.
  constexpr void enter(unsigned number) noexcept {
    const unsigned n = count();
    if (n == kCapacity || contains(number))
      return;
    sd_[kFirst + n] = to_word(number);
    store_count(n + 1);
  }

  /// Removes a number; `f` tells who may move in. The annunciator itself must be OFF already.
  template <class F> constexpr void remove(unsigned number, F &f) noexcept {
    const unsigned n = count();
    const unsigned place = find(number);
    if (place >= n)
      return;
    for (unsigned i = place; i + 1 < n; ++i)
      sd_[kFirst + i] = sd_[kFirst + i + 1];
    sd_[kFirst + n - 1] = 0;
    store_count(n - 1);
    if (n == kCapacity)
      refill(f);
  }

private:
  static constexpr unsigned kFirst = 64;

  constexpr unsigned find(unsigned number) const noexcept {
    unsigned place = 0;
    for (const unsigned n = count(); place < n && pattern_of(sd_[kFirst + place]) != number;)
      ++place;
    return place;
  }
  constexpr void store_count(unsigned n) noexcept {
    sd_[63] = to_word(n);
    sd_[62] = sd_[kFirst];
  }
  template <class F> constexpr void refill(F &f) noexcept {
    for (unsigned number = 0; number < F::kPoints; ++number) {
      if (static_cast<bit>(f[number]) && !contains(number)) {
        enter(number);
        return;
      }
    }
  }

  SpecialRegisters &sd_;
};

}  // namespace ladder::melsec_qs
