// The error information SD0-SD27 in the layout of the controller.
//
// SD0 code; SD1-SD3 time in BCD; SD4 categories (low byte: of the common information SD5-SD15, high byte: of the individual
// information SD16-SD26); SD27 the CPU that found it.
#pragma once

#include "ladder/calendar.h"
#include "ladder/number.h"

#include <cstdint>

namespace ladder::melsec_qs {

/// SD4 of the errors that a running program can meet.
enum class ErrorCategory : std::uint16_t {
  None = 0,
  Location = 0x0004,             ///< operation error: where
  ScanTime = 0x0303,             ///< time set, time measured
  LocationAnnunciator = 0x0604,  ///< where, annunciator number
  LocationAbort = 0x0B04,        ///< where, abort code
};

constexpr word bcd_pair(unsigned high, unsigned low) noexcept {
  return to_word(calendar::bcd2(high) << 8 | calendar::bcd2(low));
}

/// A view of the special registers as the error information.
template <class SpecialRegisters> class ErrorReport {
public:
  constexpr explicit ErrorReport(SpecialRegisters &registers) noexcept : sd_(registers) {}

  constexpr void clear() noexcept {
    for (unsigned i = 0; i <= 27; ++i)
      sd_[i] = 0;
  }

  constexpr void begin(std::uint16_t code, ErrorCategory category, const Calendar &time) noexcept {
    clear();
    sd_[0] = to_word(code);
    sd_[1] = bcd_pair(time.year % 100U, time.month);
    sd_[2] = bcd_pair(time.day, time.hour);
    sd_[3] = bcd_pair(time.minute, time.second);
    sd_[4] = to_word(static_cast<std::uint16_t>(category));
    sd_[27] = 1;  // CPU A: there is no second CPU to compare results with
  }

  /// Common information: file name, two characters a word with the first in the low byte, ".QPG", and step number.
  constexpr void location(const char (&name)[9], std::uint32_t step) noexcept {
    for (unsigned i = 0; i < 4; ++i)
      sd_[5 + i] = characters(name[2 * i], name[2 * i + 1]);
    sd_[9] = characters('.', 'Q');
    sd_[10] = characters('P', 'G');
    sd_[14] = to_word(step & 0xFFFFU);
    sd_[15] = to_word(step >> 16);
  }

  /// Common information: a time as microseconds below a millisecond, and milliseconds.
  constexpr void time_set(std::uint32_t us) noexcept { store_time(5, us); }
  /// Individual information: likewise.
  constexpr void time_measured(std::uint32_t us) noexcept { store_time(16, us); }
  /// Individual information: annunciator number or abort code.
  constexpr void individual(word value) noexcept { sd_[16] = value; }

private:
  static constexpr word characters(char first, char second) noexcept {
    return to_word(static_cast<unsigned char>(first) | static_cast<std::uint32_t>(static_cast<unsigned char>(second)) << 8);
  }
  constexpr void store_time(unsigned number, std::uint32_t us) noexcept {
    const std::uint32_t ms = us / 1000;
    sd_[number] = to_word(us % 1000);
    sd_[number + 1] = to_word(ms > 32767 ? 32767 : ms);
  }

  SpecialRegisters &sd_;
};

}  // namespace ladder::melsec_qs
