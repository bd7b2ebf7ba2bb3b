// Tables: searching and sorting. F61 SER, F69 SORT.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"

#include <type_traits>

namespace ladder::tp03 {

namespace table {

/// How many items equal `wanted`, where the first and the last of them are, and where the smallest and the largest item are. Of
/// several the last one counts.
template <class Items, class Number, class Results>
Fault search(const Items &items, Number wanted, const Results &results, unsigned n) noexcept {
  unsigned equal = 0, first = 0, last = 0, lowest = 0, highest = 0;
  Number least = items.get(0), most = least;
  for (unsigned i = 0; i < n; ++i) {
    const Number item = items.get(i);
    if (item == wanted) {
      first = equal == 0 ? i : first;
      last = i;
      ++equal;
    }
    if (item <= least) {
      least = item;
      lowest = i;
    }
    if (item >= most) {
      most = item;
      highest = i;
    }
  }
  const unsigned found[] = {equal, first, last, lowest, highest};
  for (unsigned i = 0; i < 5; ++i)
    results.set(i, static_cast<Number>(found[i]));
  return Fault::None;
}

template <class Items, class Number, class Results>
Fault checked_search(const Items &items, Number wanted, const Results &results, word n, word most) noexcept {
  if (n < 1 || n > most || static_cast<unsigned>(n) > items.points() || results.points() < 5)
    return Fault::Range;
  return search(items, wanted, results, static_cast<unsigned>(n));
}

}  // namespace table

template <class Items, class Results, class S> Fault ser(Items items, word wanted, Results d, word n, S &) noexcept {
  return table::checked_search(items, wanted, d, n, 256);
}
template <class Items, class Results, class S> Fault dser(Items items, dword wanted, Results d, word n, S &) noexcept {
  return table::checked_search(items, wanted, d, n, 128);
}

/// One row of the table is put in its place in each scan, so that m1 rows take m1 scans. The first scan copies the table; sorting
/// goes on in the copy. Rows are inserted behind those of equal key, which keeps their order.
struct sort {
  template <class Source, class Target, class S>
  Fault run(bit condition, Source s, word rows, word columns, Target d, word key, S &sys) noexcept {
    if (!condition) {
      phase_ = Phase::Idle;
      return Fault::None;
    }
    // What it was started with is what it goes on with.
    const unsigned m1 = phase_ == Phase::Idle ? size(rows) : rows_, m2 = phase_ == Phase::Idle ? size(columns) : columns_;
    if (phase_ != Phase::Done && (m1 < 1 || m1 > 32 || m2 < 1 || m2 > 6 || m1 * m2 > s.points() || m1 * m2 > d.points()))
      return Fault::Range;
    if (phase_ == Phase::Idle) {
      if (key < 1 || size(key) > m2)
        return Fault::Range;
      rows_ = m1;
      columns_ = m2;
      key_ = size(key) - 1;
      sorted_ = 1;
      copy(s, d, m1 * m2);
      phase_ = Phase::Running;
    } else if (phase_ == Phase::Running) {
      insert(d);
    }
    if (sorted_ == rows_)
      phase_ = Phase::Done;
    sys.set_complete(bit(phase_ == Phase::Done));
    return Fault::None;
  }

private:
  enum class Phase : unsigned char { Idle, Running, Done };

  static constexpr unsigned size(word number) noexcept { return number < 0 ? 0 : static_cast<unsigned>(number); }

  /// The blocks may overlap each other in part.
  template <class Source, class Target> static void copy(const Source &s, const Target &d, unsigned words) noexcept {
    bool downwards = false;
    if constexpr (std::is_same<Source, Target>::value)
      downwards = s.origin() == d.origin() && s.first() < d.first();
    for (unsigned i = 0; i < words; ++i) {
      const unsigned at = downwards ? words - 1 - i : i;
      d.set(at, s.get(at));
    }
  }

  /// The table lies column by column.
  template <class Target> void insert(const Target &d) noexcept {
    const unsigned keys = key_ * rows_;
    for (unsigned row = sorted_; row > 0 && d.get(keys + row - 1) > d.get(keys + row); --row)
      for (unsigned column = 0; column < columns_; ++column) {
        const unsigned lower = column * rows_ + row - 1;
        const word kept = d.get(lower);
        d.set(lower, d.get(lower + 1));
        d.set(lower + 1, kept);
      }
    ++sorted_;
  }

  unsigned rows_ = 0, columns_ = 0, key_ = 0;
  unsigned sorted_ = 0;  ///< so many rows are in order
  Phase phase_ = Phase::Idle;
};

}  // namespace ladder::tp03
