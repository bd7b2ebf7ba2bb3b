// Seven-segment displays: F73 SEGD, F74 SEGL, F75 ARWS.
//
// SEGL and ARWS feed displays that have a decoder and a latch for each digit: four data lines for all, a strobe for each. A digit
// takes three scans: the data, the strobe ON, the strobe OFF; so twelve scans show four digits.
//
// Where the manual is silent: all outputs are OFF when the condition goes OFF, whatever n says; the lowest digit comes first. ARWS
// shows the number in twelve scans and then, for twelve more, holds the strobe of the digit that is being edited, so that a lamp on
// it stands out. An arrow key counts where it goes down while the condition is ON.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/ops/drive.h"
#include "ladder/tp03/ops/keys.h"

#include <cstdint>
#include <type_traits>

namespace ladder::tp03 {

// ---------------------------------------------------------------------------------------------- F73
/// Bit 0 is segment a, at the top, then clockwise, bit 6 the one in the middle. M8273 inverts all eight.
template <class S> word segd(word digit, word old, S &sys) noexcept {
  constexpr std::uint8_t kPatterns[16] = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x27,
                                          0x7F, 0x6F, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71};
  const std::uint32_t pattern = kPatterns[pattern_of(digit) & 0xFU];
  const std::uint32_t shown = sys.M[8273] ? pattern ^ 0xFFU : pattern;
  return to_word((pattern_of(old) & 0xFF00U) | shown);
}

namespace detail {

/// A constant where others have a block.
class ConstantBlock {
public:
  constexpr explicit ConstantBlock(word value) noexcept : value_(value) {}
  constexpr unsigned points() const noexcept { return 1; }
  constexpr word get(unsigned) const noexcept { return value_; }

private:
  word value_;
};
template <class Source> constexpr auto block_of(Source source) noexcept {
  if constexpr (std::is_integral<Source>::value)
    return ConstantBlock(to_word(static_cast<std::uint32_t>(source)));
  else
    return source;
}

constexpr std::uint16_t kPowersOfTen[4] = {1, 10, 100, 1000};
constexpr bool four_digits(word value) noexcept {
  return value >= 0 && value <= 9999;
}
constexpr std::uint32_t digit_of(word value, unsigned place) noexcept {
  return pattern_of(value) / kPowersOfTen[place] % 10U;
}

/// The lines to the displays and their polarity.
template <class Run> class SegmentLines {
public:
  static constexpr unsigned kDigits = 4, kSteps = 3 * kDigits;
  static constexpr unsigned lines(unsigned sets) noexcept { return sets == 2 ? 12 : 8; }

  constexpr SegmentLines(Run run, word n) noexcept : run_(run), inverse_(pattern_of(n)) {}
  void data(unsigned set, std::uint32_t digit) const noexcept {
    write_bits(run_, set == 0 ? 0 : 8, 4, (inverse_ & 2U) != 0 ? ~digit : digit);
  }
  /// Bit i is the strobe of digit i.
  void strobes(std::uint32_t pattern) const noexcept { write_bits(run_, 4, kDigits, (inverse_ & 1U) != 0 ? ~pattern : pattern); }

private:
  Run run_;
  std::uint32_t inverse_;  ///< the two low bits of n: 1 strobes, 2 data
};

}  // namespace detail

// ---------------------------------------------------------------------------------------------- F74
class SegmentLatch {
public:
  /// `source` is a block, or a constant where n is below 4.
  template <class Source, class Run, class S> Fault run(bit condition, Source source, Run outputs, word n, S &sys) noexcept {
    const auto values = detail::block_of(source);
    const unsigned sets = n >= 4 ? 2 : 1, lines = detail::SegmentLines<Run>::lines(sets);
    if (values.points() < sets || outputs.points() < lines)
      return condition ? Fault::Range : Fault::None;
    const Drive drive = drive_.see(condition, sys);
    if (drive == Drive::Stops) {
      detail::write_bits(outputs, 0, lines, 0);
      if (step_ == 0)
        sys.set_complete(off);
      return Fault::None;
    }
    if (drive == Drive::Off)
      return Fault::None;
    if (drive == Drive::Starts)
      step_ = 0;
    for (unsigned set = 0; set < sets; ++set)
      if (!detail::four_digits(values.get(set)))
        return Fault::Range;
    show(values, detail::SegmentLines<Run>(outputs, n), sets);
    step_ = static_cast<std::uint8_t>((step_ + 1U) % detail::SegmentLines<Run>::kSteps);
    sys.set_complete(bit(step_ == 0));
    return Fault::None;
  }

private:
  template <class Block, class Lines> void show(const Block &values, const Lines &lines, unsigned sets) noexcept {
    const unsigned digit = step_ / 3U;
    if (step_ % 3U == 0)
      for (unsigned set = 0; set < sets; ++set)
        lines.data(set, detail::digit_of(values.get(set), digit));
    lines.strobes(step_ % 3U == 1 ? 1U << digit : 0);
  }

  DriveMemory drive_;
  std::uint8_t step_ = 0;
};

// ---------------------------------------------------------------------------------------------- F75
class ArrowSwitch {
public:
  template <class Keys, class Run, class Out, class S>
  Fault run(bit condition, Keys keys, word value, Run outputs, word n, Out &&result, S &sys) noexcept {
    constexpr unsigned kLines = detail::SegmentLines<Run>::lines(1);
    if (keys.points() < kKeys || outputs.points() < kLines)
      return condition ? Fault::Range : Fault::None;
    const std::uint32_t down = detail::read_bits(keys, 0, kKeys), pressed = down & ~before_;
    before_ = static_cast<std::uint8_t>(down);
    const Drive drive = drive_.see(condition, sys);
    if (drive == Drive::Stops)
      detail::write_bits(outputs, 0, kLines, 0);
    if (drive == Drive::Stops || drive == Drive::Off)
      return Fault::None;
    if (drive == Drive::Starts) {
      digit_ = kDigits - 1;
      step_ = 0;
    }
    if (!detail::four_digits(value))
      return Fault::Range;
    const word edited = edit(value, pressed);
    if (edited != value)
      result = edited;
    show(edited, detail::SegmentLines<Run>(outputs, n));
    return Fault::None;
  }

private:
  static constexpr unsigned kKeys = 4, kDigits = 4, kSteps = 24;
  static constexpr std::uint32_t kDown = 1, kUp = 2, kRight = 4, kLeft = 8;

  word edit(word value, std::uint32_t pressed) noexcept {
    if ((pressed & kRight) != 0)
      digit_ = static_cast<std::uint8_t>((digit_ + kDigits - 1) % kDigits);
    if ((pressed & kLeft) != 0)
      digit_ = static_cast<std::uint8_t>((digit_ + 1U) % kDigits);
    const std::uint32_t old = detail::digit_of(value, digit_);
    const std::uint32_t fresh = (old + ((pressed & kUp) != 0 ? 1U : 0U) + ((pressed & kDown) != 0 ? 9U : 0U)) % 10U;
    return to_word(pattern_of(value) - old * detail::kPowersOfTen[digit_] + fresh * detail::kPowersOfTen[digit_]);
  }
  template <class Lines> void show(word value, const Lines &lines) noexcept {
    const bool marking = step_ >= Lines::kSteps;
    const unsigned place = marking ? step_ - Lines::kSteps : step_ % 3U, last = marking ? Lines::kSteps - 1 : 2;
    if (place == 0) {
      shown_ = marking ? digit_ : static_cast<std::uint8_t>(step_ / 3U);
      lines.data(0, detail::digit_of(value, shown_));
    }
    lines.strobes(place == 0 || place == last ? 0 : 1U << shown_);
    step_ = static_cast<std::uint8_t>((step_ + 1U) % kSteps);
  }

  DriveMemory drive_;
  std::uint8_t before_ = 0;             ///< the keys
  std::uint8_t digit_ = 0, shown_ = 0;  ///< edited, and on the data lines
  std::uint8_t step_ = 0;
};

}  // namespace ladder::tp03
