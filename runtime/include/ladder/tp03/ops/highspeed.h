// Direct input and output, comparisons with high-speed counters, pulse density (F50, F52-F56).
//
// The comparisons are entered in sys.high_speed under the address of their object while they are ON, and act from there.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/number.h"
#include "ladder/tp03/counter.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/high_speed.h"

#include <cstdint>

namespace ladder::tp03 {

// F50 REF

/// `points` of the base unit can be refreshed.
template <class Run> constexpr bool can_refresh(const Run &run, word n, unsigned points) noexcept {
  return (n == 8 || n == 16) && run.first() % 8 == 0 && run.first() < points;
}
template <class Run> constexpr unsigned refreshed(const Run &run, word n, unsigned points) noexcept {
  const unsigned wanted = static_cast<unsigned>(n), left = points - run.first();
  const unsigned some = wanted < left ? wanted : left;
  return some < run.points() ? some : run.points();
}

/// The state of an input at this moment, or in this scan where the host knows no more.
template <class Run, class System> bit input_now(const Run &inputs, unsigned i, System &sys) noexcept {
  const int state = sys.io().input(inputs.first() + i);
  return state < 0 ? inputs.get(i) : bit(state != 0);
}

template <class Run, class System> Fault refresh_inputs(Run inputs, word n, System &sys) noexcept {
  constexpr unsigned kPoints = 16;
  if (!can_refresh(inputs, n, kPoints))
    return Fault::Range;
  for (unsigned i = 0; i < refreshed(inputs, n, kPoints); ++i)
    inputs.set(i, input_now(inputs, i, sys));
  return Fault::None;
}

template <class Run, class System> Fault refresh_outputs(Run outputs, word n, System &sys) noexcept {
  constexpr unsigned kPoints = 8;
  if (!can_refresh(outputs, n, kPoints))
    return Fault::Range;
  if (sys.outputs_enabled())
    for (unsigned i = 0; i < refreshed(outputs, n, kPoints); ++i)
      sys.io().output(outputs.first() + i, static_cast<bool>(outputs.get(i)));
  return Fault::None;
}

// F52 MTR

/// `Row` bits from the beginning of one row of the table to that of the next.
template <unsigned Row> class MatrixReader {
public:
  static constexpr std::uint32_t kColumnUs = 20000;
  static constexpr unsigned kRowBits = 8;

  template <class In, class Out, class Table, class System>
  Fault run(bit condition, In inputs, Out outputs, Table table, word n, System &sys) noexcept {
    const unsigned columns = n > 0 ? static_cast<unsigned>(n) : 0;
    if (columns < 2 || columns > 8 || inputs.points() < kRowBits || outputs.points() < columns ||
        table.points() < (columns - 1) * Row + kRowBits)
      return condition ? Fault::Range : Fault::None;
    if (!condition) {
      if (running_)
        show(outputs, columns, columns, sys);
      running_ = off;
      return Fault::None;
    }
    const std::uint32_t now_us = sys.now_us(), epoch = sys.high_speed.epoch();
    bit complete{};
    if (!running_ || epoch != epoch_) {
      running_ = on;
      epoch_ = epoch;
      column_ = 0;
      since_us_ = now_us;
    } else if (now_us - since_us_ >= kColumnUs) {
      since_us_ = now_us;
      for (unsigned i = 0; i < kRowBits && column_ < columns; ++i)
        table.set(column_ * Row + i, input_now(inputs, i, sys));
      complete = bit(++column_ >= columns);
      if (complete)
        column_ = 0;
    }
    show(outputs, columns, column_, sys);
    sys.set_complete(complete);
    return Fault::None;
  }

private:
  template <class Out, class System>
  static void show(const Out &outputs, unsigned columns, unsigned selected, System &sys) noexcept {
    for (unsigned i = 0; i < columns; ++i) {
      outputs.set(i, bit(i == selected));
      if (sys.outputs_enabled())
        sys.io().output(outputs.first() + i, i == selected);
    }
  }

  std::uint32_t since_us_ = 0, epoch_ = 0;
  unsigned column_ = 0;
  bit running_{};
};
using ReadMatrix = MatrixReader<10>;
using ReadMatrixToOutputs = MatrixReader<8>;

// F53-F55

/// Enters a comparison while its condition is ON, or takes it out; `fill` completes the entry.
template <class System, class Fill>
Fault compare_at_count(const void *place, bit condition, LongCounter &counter, System &sys, Fill fill) noexcept {
  if (!condition) {
    sys.high_speed.leave(place);
    return Fault::None;
  }
  CountComparison *entry = sys.high_speed.enter(place);
  if (entry == nullptr)
    return Fault::Operand;
  entry->counter = &counter;
  fill(*entry);
  return Fault::None;
}

template <class Run> void set_target(CountComparison &entry, unsigned i, const Run &run) noexcept {
  entry.targets[i] = Run(*run.image(), run.first() + i);
}

/// F53, F54 on a bit.
template <CountComparison::Action What, bool Terminal> struct BitAtCount {
  template <class Run, class System> Fault run(bit condition, dword value, LongCounter &counter, Run target, System &sys) noexcept {
    return compare_at_count(this, condition, counter, sys, [&](CountComparison &entry) {
      entry.action = What;
      entry.value = value;
      set_target(entry, 0, target);
      if (Terminal)
        entry.terminal = target.first();
    });
  }
};
using SetAtCount = BitAtCount<CountComparison::Action::Set, false>;
using SetOutputAtCount = BitAtCount<CountComparison::Action::Set, true>;
using ResetAtCount = BitAtCount<CountComparison::Action::Reset, false>;
using ResetOutputAtCount = BitAtCount<CountComparison::Action::Reset, true>;

/// F53 with an interrupt pointer.
struct InterruptAtCount {
  template <class System> Fault run(bit condition, dword value, LongCounter &counter, int pointer, System &sys) noexcept {
    return compare_at_count(this, condition, counter, sys, [&](CountComparison &entry) {
      entry.action = CountComparison::Action::Interrupt;
      entry.value = value;
      entry.pointer = static_cast<std::uint16_t>(pointer);
    });
  }
};

/// F54 on the counter itself.
struct ClearAtCount {
  template <class System>
  Fault run(bit condition, dword value, LongCounter &counter, const LongCounter &cleared, System &sys) noexcept {
    if (condition && &cleared != &counter) {
      sys.high_speed.leave(this);
      return Fault::Operand;
    }
    return compare_at_count(this, condition, counter, sys, [&](CountComparison &entry) {
      entry.action = CountComparison::Action::Clear;
      entry.value = value;
    });
  }
};

/// F55.
template <bool Terminal> struct CountInZone {
  template <class Run, class System>
  Fault run(bit condition, dword lower, dword upper, LongCounter &counter, Run targets, System &sys) noexcept {
    if (condition && targets.points() < CountComparison::kTargets) {
      sys.high_speed.leave(this);
      return Fault::Range;
    }
    return compare_at_count(this, condition, counter, sys, [&](CountComparison &entry) {
      const bool fresh = entry.action == CountComparison::Action::None;
      entry.action = CountComparison::Action::Zone;
      entry.value = lower;
      entry.upper = upper < lower ? lower : upper;
      for (unsigned i = 0; i < CountComparison::kTargets; ++i)
        set_target(entry, i, targets);
      if (Terminal)
        entry.terminal = targets.first();
      if (fresh)
        HighSpeed::show_zone(entry, sys);
    });
  }
};
using ZoneOfCount = CountInZone<false>;
using ZoneOfCountToOutputs = CountInZone<true>;

// F56 SPD

class PulseDensity {
public:
  template <class In, class Block, class System>
  Fault run(bit condition, In input, word window_ms, Block results, System &sys) noexcept {
    if (!condition) {
      running_ = off;
      return Fault::None;
    }
    if (window_ms <= 0 || input.first() >= HighSpeed::kInputs || results.points() < 3)
      return Fault::Range;
    const std::uint32_t now_us = sys.now_us(), rises = sys.high_speed.rises(input.first());
    const std::uint32_t window_us = static_cast<std::uint32_t>(window_ms) * 1000, epoch = sys.high_speed.epoch();
    if (!running_ || epoch != epoch_) {
      running_ = on;
      epoch_ = epoch;
      since_us_ = now_us;
      rises_ = rises;
    }
    const std::uint32_t passed_us = now_us - since_us_;
    if (const std::uint32_t ended = passed_us / window_us; ended > 0) {
      results.set(0, to_word((rises - rises_) / ended));
      since_us_ += ended * window_us;
      rises_ = rises;
    }
    results.set(1, to_word(rises - rises_));
    results.set(2, to_word((window_us - (now_us - since_us_) + 999) / 1000));
    return Fault::None;
  }

private:
  std::uint32_t since_us_ = 0, rises_ = 0;  ///< at the beginning of the window
  std::uint32_t epoch_ = 0;
  bit running_{};
};

}  // namespace ladder::tp03
