// Keys and switches: F70 TKY, F71 HKY, F72 DSW. (F75 ARWS is in segments.h, because it shows what it edits.)
//
// Where the manual is silent: of keys that go down in one scan the lowest number counts; a key that is still down when the first
// one is let go does not count until it has been up; keys that are down when the instruction is switched on count as pressed then.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/ops/drive.h"

#include <cstdint>

namespace ladder::tp03 {
namespace detail {

/// Consecutive bits as a number, the first being bit 0.
template <class Run> std::uint32_t read_bits(const Run &run, unsigned first, unsigned count) noexcept {
  std::uint32_t pattern = 0;
  for (unsigned i = 0; i < count; ++i)
    pattern |= std::uint32_t{run.get(first + i).value()} << i;
  return pattern;
}
template <class Run> void write_bits(const Run &run, unsigned first, unsigned count, std::uint32_t pattern) noexcept {
  for (unsigned i = 0; i < count; ++i)
    run.set(first + i, bit::lowest_of(pattern >> i));
}

}  // namespace detail

/// Of several keys only the first that went down counts, until it is let go.
class FirstKey {
public:
  static constexpr std::uint8_t kNone = 0xFF;

  /// The key that is accepted now, or kNone.
  std::uint8_t accept(std::uint32_t down) noexcept {
    const std::uint32_t fresh = down & ~before_;
    before_ = down;
    if (held_ != kNone && (down >> held_ & 1U) != 0)
      return kNone;
    held_ = kNone;
    for (std::uint8_t key = 0; key < 32 && held_ == kNone; ++key)
      if ((fresh >> key & 1U) != 0)
        held_ = key;
    return held_;
  }
  /// The accepted key that is still down, or kNone.
  std::uint8_t held() const noexcept { return held_; }

private:
  std::uint32_t before_ = 0;
  std::uint8_t held_ = kNone;
};

// ---------------------------------------------------------------------------------------------- F70
/// Numbers below Limit from ten keys.
template <class Number, std::uint32_t Limit> class TenKeyOf {
public:
  template <class Keys, class Signals, class Out, class S>
  Fault run(bit condition, Keys keys, Number now, Signals signals, Out &&number, S &sys) noexcept {
    if (keys.points() < kKeys || signals.points() < kKeys + 1)
      return condition ? Fault::Range : Fault::None;
    switch (drive_.see(condition, sys)) {
    case Drive::Off:
      return Fault::None;
    case Drive::Stops:
      detail::write_bits(signals, 0, kKeys + 1, 0);
      return Fault::None;
    case Drive::Starts:
      first_ = {};
      break;
    case Drive::Runs:
      break;
    }
    if (const std::uint8_t key = first_.accept(detail::read_bits(keys, 0, kKeys)); key != FirstKey::kNone) {
      number = static_cast<Number>((pattern_of(now) % Limit * 10U + key) % Limit);
      detail::write_bits(signals, 0, kKeys, 1U << key);
    }
    signals.set(kKeys, bit(first_.held() != FirstKey::kNone));
    return Fault::None;
  }

private:
  static constexpr unsigned kKeys = 10;

  DriveMemory drive_;
  FirstKey first_;
};
using TenKey = TenKeyOf<word, 10000>;
using DTenKey = TenKeyOf<dword, 100000000>;

// ---------------------------------------------------------------------------------------------- F71
/// Numbers from a matrix of 4 x 4 keys; a row is switched on in one scan and read in the next.
template <class Number, std::uint32_t Limit> class HexKeyOf {
public:
  template <class Columns, class Rows, class Signals, class Out, class S>
  Fault run(bit condition, Columns columns, Rows rows, Number now, Signals signals, Out &&number, S &sys) noexcept {
    if (columns.points() < kRows || rows.points() < kRows || signals.points() < kSignals)
      return condition ? Fault::Range : Fault::None;
    switch (drive_.see(condition, sys)) {
    case Drive::Off:
      return Fault::None;
    case Drive::Stops:
      stop(rows, signals, sys);
      return Fault::None;
    case Drive::Starts:
      first_ = {};
      phase_ = 0;
      break;
    case Drive::Runs:
      break;
    }
    const unsigned row = phase_ / 2U;
    if (phase_ % 2U == 0)
      detail::write_bits(rows, 0, kRows, 1U << row);
    else
      down_ = (down_ & ~(0xFU << 4 * row)) | detail::read_bits(columns, 0, kRows) << 4 * row;
    complete_ = phase_ == kPhases - 1;
    if (complete_)
      evaluate(now, signals, number, sys);
    phase_ = static_cast<std::uint8_t>((phase_ + 1U) % kPhases);
    sys.set_complete(bit(complete_));
    return Fault::None;
  }

private:
  static constexpr unsigned kRows = 4, kPhases = 2 * kRows, kSignals = 8;
  static constexpr unsigned kFirstLetter = 10, kLetters = 6, kLetterDown = 6, kDigitDown = 7;
  static constexpr unsigned kHexadecimal = 8167;

  template <class Signals, class Out, class S> void evaluate(Number now, Signals signals, Out &&number, S &sys) noexcept {
    const std::uint8_t key = first_.accept(down_);
    if (key != FirstKey::kNone) {
      if (sys.M[kHexadecimal])
        number = from_pattern(pattern_of(now) << 4 | key);
      else if (key < kFirstLetter)
        number = static_cast<Number>((pattern_of(now) % Limit * 10U + key) % Limit);
      else
        detail::write_bits(signals, 0, kLetters, 1U << (key - kFirstLetter));
    }
    const std::uint8_t held = first_.held();
    signals.set(kLetterDown, bit(held != FirstKey::kNone && held >= kFirstLetter));
    signals.set(kDigitDown, bit(held < kFirstLetter));
  }
  template <class Rows, class Signals, class S> void stop(Rows rows, Signals signals, S &sys) noexcept {
    detail::write_bits(rows, 0, kRows, 0);
    detail::write_bits(signals, 0, kSignals, 0);
    if (complete_)
      sys.set_complete(off);
    complete_ = false;
  }
  static constexpr Number from_pattern(std::uint32_t pattern) noexcept {
    if constexpr (sizeof(Number) == sizeof(word))
      return to_word(pattern);
    else
      return to_dword(pattern);
  }

  DriveMemory drive_;
  FirstKey first_;
  std::uint32_t down_ = 0;
  std::uint8_t phase_ = 0;
  bool complete_ = false;
};
using HexKey = HexKeyOf<word, 10000>;
using DHexKey = HexKeyOf<dword, 100000000>;

// ---------------------------------------------------------------------------------------------- F72
/// One or two thumb-wheel switches of four decimal digits, one digit each 100 ms. Both give their digits to the same strobes.
class DigitalSwitch {
public:
  template <class Switches, class Strobes, class Block, class S>
  Fault run(bit condition, Switches switches, Strobes strobes, Block values, word sets, S &sys) noexcept {
    const unsigned count = sets == 2 ? 2 : 1;
    if (switches.points() < 4 * count || strobes.points() < kDigits || values.points() < count)
      return condition ? Fault::Range : Fault::None;
    switch (drive_.see(condition, sys)) {
    case Drive::Off:
      return Fault::None;
    case Drive::Stops:
      detail::write_bits(strobes, 0, kDigits, 0);
      if (complete_)
        sys.set_complete(off);
      complete_ = false;
      return Fault::None;
    case Drive::Starts:
      begin_cycle();
      fault_ = Fault::None;
      break;
    case Drive::Runs:
      time_us_ += sys.elapsed_us();
      break;
    }
    complete_ = false;
    if (time_us_ >= kStrobeUs) {
      sample(switches, count);
      time_us_ = 0;
      if (++digit_ == kDigits)
        finish(values, count);
    }
    detail::write_bits(strobes, 0, kDigits, 1U << digit_);
    if (fault_ == Fault::None)
      sys.set_complete(bit(complete_));
    return fault_;
  }

private:
  static constexpr unsigned kDigits = 4;
  static constexpr std::uint32_t kStrobeUs = 100000;
  static constexpr std::uint16_t kWeights[kDigits] = {1, 10, 100, 1000};

  void begin_cycle() noexcept {
    digit_ = 0;
    time_us_ = 0;
    sums_[0] = sums_[1] = 0;
    wrong_ = false;
  }
  template <class Switches> void sample(Switches switches, unsigned count) noexcept {
    for (unsigned set = 0; set < count; ++set) {
      const std::uint32_t digit = detail::read_bits(switches, 4 * set, 4);
      wrong_ |= digit > 9;
      sums_[set] = static_cast<std::uint16_t>(sums_[set] + digit * kWeights[digit_]);
    }
  }
  /// The values appear together, so that nobody sees the thousands of one setting with the ones of another.
  template <class Block> void finish(Block values, unsigned count) noexcept {
    fault_ = wrong_ ? Fault::Range : Fault::None;
    complete_ = !wrong_;
    for (unsigned set = 0; set < count && complete_; ++set)
      values.set(set, to_word(sums_[set]));
    begin_cycle();
  }

  DriveMemory drive_;
  std::uint32_t time_us_ = 0;
  std::uint16_t sums_[2] = {};
  Fault fault_ = Fault::None;
  std::uint8_t digit_ = 0;
  bool wrong_ = false, complete_ = false;
};

}  // namespace ladder::tp03
