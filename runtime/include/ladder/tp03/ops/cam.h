// Cam controls: outputs that follow the value of a counter. F62 ABSD, F63 INCD.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/number.h"
#include "ladder/tp03/counter.h"
#include "ladder/tp03/fault.h"

namespace ladder::tp03 {

namespace cam {

/// Tables in bit devices consist of full words at numbers that are multiples of 16.
template <class Table> constexpr bool is_table(const Table &) noexcept {
  return true;
}
template <class Image, unsigned K> constexpr bool is_table(const DigitBlock<Image, K> &table) noexcept {
  return K == 4 && table.first() % 16 == 0;
}
template <class Image, unsigned K> constexpr bool is_table(const DigitDWordBlock<Image, K> &table) noexcept {
  return K == 8 && table.first() % 16 == 0;
}

/// `rows` rows of `columns` numbers, and as many outputs as rows.
template <class Table, class Outputs> bool fits(const Table &table, const Outputs &outputs, word rows, unsigned columns) noexcept {
  return is_table(table) && rows >= 1 && rows <= 64 && static_cast<unsigned>(rows) * columns <= table.points() &&
         static_cast<unsigned>(rows) <= outputs.points();
}

}  // namespace cam

/// Each row of the table is a rise and a fall. The chart that would show the limits themselves is not in the manual: ON at the
/// rise, OFF at the fall. A rise that is not below its fall is a cam across the zero point.
template <class Table, class Count, class Outputs, class S>
Fault absd(Table table, const Count &counter, Outputs d, word n, S &) noexcept {
  if (!cam::fits(table, d, n, 2))
    return Fault::Range;
  const auto value = counter.value;
  for (unsigned i = 0; i < static_cast<unsigned>(n); ++i) {
    const auto rise = table.get(2 * i), fall = table.get(2 * i + 1);
    const bool risen = value >= rise, fallen = value >= fall;
    d.set(i, bit(rise < fall ? risen && !fallen : risen || !fallen));
  }
  return Fault::None;
}
template <class Table, class Count, class Outputs, class S>
Fault dabsd(Table table, const Count &counter, Outputs d, word n, S &sys) noexcept {
  return absd(table, counter, d, n, sys);
}

/// Stages one after the other: the first of two counters counts within the stage, the second counts the stages. Both are devices,
/// so that a latched pair goes on after a power failure; the memory here only tells when the condition changes.
struct incd {
  bit driven{};

  /// `c` is the whole image of the counters, of which `pair` names two.
  template <class Counters, class Table, class Pair, class Outputs, class S>
  Fault run(bit condition, Counters &c, Table table, Pair pair, Outputs d, word n, S &sys) noexcept {
    const bit before = driven | sys.first_scan();
    driven = condition;
    if (!(condition | before))
      return Fault::None;
    if (!cam::fits(table, d, n, 1) || pair.points() < 2) {
      driven = off;
      return condition ? Fault::Range : Fault::None;
    }
    Counter &counter = c[pair.first()], &stages = c[pair.first() + 1];
    if (!condition | !before) {
      counter.clear();
      stages.clear();
    }
    if (condition)
      sys.set_complete(advance(table, counter, stages, n));
    for (unsigned i = 0; i < static_cast<unsigned>(n); ++i)
      d.set(i, condition & bit(static_cast<unsigned>(stages.value) == i));
    return Fault::None;
  }

private:
  /// ON where the last stage has ended.
  template <class Table> static bit advance(const Table &table, Counter &counter, Counter &stages, word n) noexcept {
    if (stages.value < 0 || stages.value >= n)
      stages.clear();  // nobody but the program can have written that
    if (counter.value < table.get(static_cast<unsigned>(stages.value)))
      return off;
    counter.clear();
    ++stages.value;
    if (stages.value < n)
      return off;
    stages.clear();
    return on;
  }
};

}  // namespace ladder::tp03
