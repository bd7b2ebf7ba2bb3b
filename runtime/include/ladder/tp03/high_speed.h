// High-speed counters C235-C254, and what acts when they reach a value (F53-F55).
//
// They count edges of the inputs X0-X5, which are fixed for each counter, whenever the system hears of an edge: at the beginning of
// a scan, or between scans where the host sees more than the image does. OUT C enables a counter for as long as its condition is
// ON, also in scans that skip it. An instruction that compares takes one of six places while it is driven, and acts at the count
// itself.
//
// Pointers to counters and targets are kept, so the program object must stay where it is while it runs.
//
// Where the manual is silent:
// * Inputs that are ON when RUN begins are no edges.
// * A phase with B: B rising while A is ON counts up, B falling while A is ON counts down, one count a period.
// * A reset input that is ON holds the counter at 0, as RST does.
// * A seventh comparison is not accepted: error 6705.
// * Neither a reset nor a value that the program writes is a count, so nothing is compared then.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/number.h"
#include "ladder/tp03/counter.h"

#include <cstdint>

namespace ladder::tp03 {

/// Which inputs a counter looks at.
struct HighSpeedInputs {
  enum class Kind : std::uint8_t { None, OneInput, UpAndDown, TwoPhases };
  static constexpr std::uint8_t kNo = 0xFF;

  Kind kind = Kind::None;
  std::uint8_t first = kNo;   ///< counts; counts up; A
  std::uint8_t second = kNo;  ///< counts down; B
  std::uint8_t reset = kNo;
  std::uint8_t start = kNo;
};

namespace detail {

constexpr std::uint8_t kNoInput = HighSpeedInputs::kNo;
constexpr HighSpeedInputs one_input(std::uint8_t input, std::uint8_t reset = kNoInput, std::uint8_t start = kNoInput) noexcept {
  return {HighSpeedInputs::Kind::OneInput, input, kNoInput, reset, start};
}
constexpr HighSpeedInputs up_and_down(std::uint8_t up, std::uint8_t down, std::uint8_t reset = kNoInput,
                                      std::uint8_t start = kNoInput) noexcept {
  return {HighSpeedInputs::Kind::UpAndDown, up, down, reset, start};
}
constexpr HighSpeedInputs two_phases(std::uint8_t a, std::uint8_t b, std::uint8_t reset = kNoInput,
                                     std::uint8_t start = kNoInput) noexcept {
  return {HighSpeedInputs::Kind::TwoPhases, a, b, reset, start};
}

}  // namespace detail

/// What an instruction has asked to be done when a counter reaches a value.
struct CountComparison {
  enum class Action : std::uint8_t {
    None,
    Set,        ///< target := ON
    Reset,      ///< target := OFF
    Clear,      ///< the counter itself becomes 0
    Interrupt,  ///< the routine of `pointer` is requested
    Zone,       ///< three targets: below, inside, above `value` to `upper`
  };
  static constexpr unsigned kTargets = 3;
  static constexpr unsigned kNoTerminal = 0xFFFFFFFFU;

  const void *place = nullptr;  ///< the instruction; null: nobody's
  LongCounter *counter = nullptr;
  dword value = 0, upper = 0;
  BitTarget targets[kTargets];
  unsigned terminal = kNoTerminal;  ///< number of the first output, where the targets are outputs
  std::uint16_t pointer = 0;
  Action action = Action::None;
};

class HighSpeed {
public:
  static constexpr unsigned kFirst = 235, kCounters = 20;
  static constexpr unsigned kInputs = 6;
  static constexpr unsigned kComparisons = 6;

  /// RUN begins or ends: nobody counts or compares.
  constexpr void restart() noexcept {
    const std::uint32_t epoch = epoch_ + 1;
    *this = HighSpeed{};
    epoch_ = epoch;
  }
  /// Changes with restart(): what an instruction remembers from before is over.
  std::uint32_t epoch() const noexcept { return epoch_; }

  /// OUT C235-C254.
  void enable(LongCounter &counter, unsigned number, bit condition) noexcept {
    if (number < kFirst || number - kFirst >= kCounters)
      return;
    const std::uint32_t mask = std::uint32_t{1} << (number - kFirst);
    counters_[number - kFirst] = &counter;
    enabled_ = condition ? enabled_ | mask : enabled_ & ~mask;
  }

  /// The comparison of an instruction; one without action is new. Null where all places are taken.
  CountComparison *enter(const void *place) noexcept {
    CountComparison *found = find(place);
    if (found == nullptr)
      found = find(nullptr);
    if (found != nullptr)
      found->place = place;
    return found;
  }
  void leave(const void *place) noexcept {
    if (CountComparison *found = find(place); found != nullptr)
      *found = CountComparison{};
  }

  /// Rising edges of an input since the start, a number that wraps around.
  std::uint32_t rises(unsigned input) const noexcept { return input < kInputs ? rises_[input] : 0; }

  /// The present state of an input; true where it is another one than before. `sys` has relays M, raise(), io() and
  /// outputs_enabled().
  template <class System> bool look(unsigned input, bit state, System &sys) noexcept {
    if (input >= kInputs)
      return false;
    const std::uint32_t mask = std::uint32_t{1} << input;
    const bool known = (known_ & mask) != 0, before = (levels_ & mask) != 0;
    known_ |= mask;
    levels_ = state ? levels_ | mask : levels_ & ~mask;
    if (!known || before == static_cast<bool>(state))
      return false;
    rises_[input] += state.value();
    for (std::uint32_t left = enabled_, i = 0; left != 0; left >>= 1, ++i)
      if ((left & 1U) != 0)
        edge(i, input, state, sys);
    return true;
  }

  /// What `value` is to the three outputs of DHSZ, written at once.
  template <class System> static void show_zone(const CountComparison &zone, System &sys) noexcept {
    const dword value = zone.counter->value;
    write(zone, 0, bit(value < zone.value), sys);
    write(zone, 1, bit(value >= zone.value && value <= zone.upper), sys);
    write(zone, 2, bit(value > zone.upper), sys);
  }

private:
  static constexpr HighSpeedInputs kTable[kCounters] = {
      detail::one_input(0),             // C235
      detail::one_input(1),             // C236
      detail::one_input(2),             // C237
      detail::one_input(3),             // C238
      detail::one_input(4),             // C239
      detail::one_input(5),             // C240
      detail::one_input(0, 1),          // C241
      detail::one_input(2, 3),          // C242
      detail::one_input(4, 5),          // C243
      detail::one_input(0, 1, 4),       // C244
      detail::one_input(2, 3, 5),       // C245
      detail::up_and_down(0, 1),        // C246
      detail::up_and_down(0, 1, 2),     // C247
      detail::up_and_down(3, 4, 5),     // C248
      detail::up_and_down(0, 1, 2, 5),  // C249
      HighSpeedInputs{},                // C250 does not exist
      detail::two_phases(0, 1),         // C251
      detail::two_phases(0, 1, 2),      // C252
      detail::two_phases(2, 3, 4),      // C253
      detail::two_phases(0, 1, 2, 5),   // C254
  };

  CountComparison *find(const void *place) noexcept {
    for (CountComparison &each : comparisons_)
      if (each.place == place)
        return &each;
    return nullptr;
  }

  bool is_on(std::uint8_t input) const noexcept { return input < kInputs && (levels_ >> input & 1U) != 0; }

  template <class System> void edge(unsigned index, unsigned input, bit state, System &sys) noexcept {
    const HighSpeedInputs &inputs = kTable[index];
    LongCounter &counter = *counters_[index];
    if (input == inputs.reset && state)
      counter.clear();
    if (is_on(inputs.reset) || counter.reset_coil || (inputs.start != HighSpeedInputs::kNo && !is_on(inputs.start)))
      return;
    const unsigned relay = 8000 + kFirst + index;  // M8235-M8254
    using Kind = HighSpeedInputs::Kind;
    if (inputs.kind == Kind::OneInput) {
      if (input == inputs.first && state)
        count(counter, sys.M[relay], sys);
      return;
    }
    bit down{};
    if (inputs.kind == Kind::UpAndDown) {
      down = bit(input == inputs.second);
      if (!state || (input != inputs.first && input != inputs.second))
        return;
    } else {
      down = !state;
      if (input != inputs.second || !is_on(inputs.first))
        return;
    }
    sys.M[relay] = down;
    count(counter, down, sys);
  }

  template <class System> void count(LongCounter &counter, bit down, System &sys) noexcept {
    counter.step(down);
    const dword reached = counter.value;
    for (const CountComparison &each : comparisons_) {
      if (each.place == nullptr || each.counter != &counter)
        continue;
      if (each.action == CountComparison::Action::Zone)
        show_zone(each, sys);
      else if (each.value == reached)
        act(each, sys);
    }
  }

  template <class System> static void act(const CountComparison &comparison, System &sys) noexcept {
    using Action = CountComparison::Action;
    switch (comparison.action) {
    case Action::Set:
      write(comparison, 0, on, sys);
      break;
    case Action::Reset:
      write(comparison, 0, off, sys);
      break;
    case Action::Clear:
      comparison.counter->clear();
      break;
    case Action::Interrupt:
      sys.raise(comparison.pointer);
      break;
    case Action::None:
    case Action::Zone:
      break;
    }
  }

  /// Outputs go straight to their terminals.
  template <class System> static void write(const CountComparison &comparison, unsigned target, bit state, System &sys) noexcept {
    comparison.targets[target] = state;
    if (comparison.terminal != CountComparison::kNoTerminal && sys.outputs_enabled())
      sys.io().output(comparison.terminal + target, static_cast<bool>(state));
  }

  LongCounter *counters_[kCounters] = {};
  CountComparison comparisons_[kComparisons] = {};
  std::uint32_t rises_[kInputs] = {};
  std::uint32_t enabled_ = 0;  ///< bit 0 is C235
  std::uint32_t levels_ = 0, known_ = 0;
  std::uint32_t epoch_ = 0;
};

}  // namespace ladder::tp03
