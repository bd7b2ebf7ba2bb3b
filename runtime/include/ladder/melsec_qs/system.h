// The system side of a QS controller: special relays and registers, errors, clocks, RUN and STOP.
//
// A program owns one System. Each scan is begin_scan(now), the program, end_scan(F); between scans the host may read and write SM
// and SD like any device. Time comes in as an argument and only its differences count. What an error does to the CPU is state here,
// so that two programs never share any.
//
// Where the manual is silent:
// * Time in STOP drives the clock relays and the calendar, but no timer, no SD412 and no scan time: the first scan after power-on
// and
//   after STOP has 0 ticks and no scan time.
// * SD420, and the minimum and maximum scan time, start again at each change to RUN.
// * A stop error lasts until power_on(); the switch alone does not end it. The devices keep what they held.
// * Of several annunciators an error reset takes the oldest; SM0 and SD0-SD26 go on showing the one reported last, and bit 5 of
//   SD81 stays until none is left.
// * An annunciator that turns ON again while it is still in the list is reported again but not entered twice.
// * The calendar survives power_on(), as if from a battery.
#pragma once

#include "ladder/bit.h"
#include "ladder/calendar.h"
#include "ladder/image.h"
#include "ladder/melsec_qs/annunciators.h"
#include "ladder/melsec_qs/error_report.h"
#include "ladder/melsec_qs/parameters.h"
#include "ladder/melsec_qs/time.h"
#include "ladder/scan_types.h"

#include <cstdint>

namespace ladder::melsec_qs {

inline constexpr std::uint16_t kAbortError = 4700;
inline constexpr std::uint16_t kWatchdogError = 5001;
inline constexpr std::uint16_t kScanTimeError = 5010;
inline constexpr std::uint16_t kAnnunciatorError = 9000;

template <unsigned SmPoints = 1300, unsigned SdPoints = 1300> class System {
  static_assert(SmPoints > 722 && SdPoints > 527, "the system itself uses relays up to SM722 and registers up to SD527");

public:
  Bits<SmPoints> SM;   ///< special relays
  Words<SdPoints> SD;  ///< special registers

  /// Power-on or reset in RUN: everything but the calendar starts anew.
  void power_on(const Parameters &parameters) noexcept;

  /// The RUN/STOP switch.
  void set_mode(Mode mode) noexcept;

  /// Sets the clock; the weekday follows from the date. False, and nothing changed, when the CPU cannot hold that time.
  bool set_calendar(Calendar time) noexcept;

  /// In RUN and not stopped by an error.
  bool running() const noexcept { return mode_ == Mode::Run && !stopped_; }
  Status status() const noexcept { return {mode_, running(), error_, error_step_, scans_}; }

  /// Moves time to `now`. False: the program must not be executed, nor end_scan() called.
  bool begin_scan(Micros now) noexcept;

  /// END processing. `f` holds the annunciators.
  template <class F> void end_scan(F &f) noexcept;
  void end_scan() noexcept {
    NoAnnunciators none;
    end_scan(none);
  }

  /// Ticks of the last completed scan.
  word low_ticks() const noexcept { return low_.ticks(); }
  word high_ticks() const noexcept { return high_.ticks(); }

  /// An instruction cannot process its operands: the CPU stops. Returns false, the scan's end.
  bool operation_error(std::uint16_t code, std::uint32_t step) noexcept;

  /// S.QSABORT: the CPU stops with the program's own code. SM1 is left alone. Returns false, the scan's end.
  bool abort(word code, std::uint32_t step) noexcept;

  /// OUT F: OFF clears the state only, its entry stays. `step` is reported as the place of error 9000.
  template <class F> void annunciator_out(F &f, unsigned number, bit state, std::uint32_t step = 0) noexcept;
  /// SET F
  template <class F> void annunciator_set(F &f, unsigned number, std::uint32_t step = 0) noexcept;
  /// RST F: clears the state and removes the entry.
  /// `step` is given to every call of the system; this one reports nothing.
  template <class F> void annunciator_reset(F &f, unsigned number, std::uint32_t step = 0) noexcept;

  /// The host found a scan longer than the watchdog time: the CPU stops. 0 or less than that time: the measured time is not known
  /// and is reported as the watchdog time.
  void watchdog_error(std::uint32_t measured_us = 0) noexcept;

  /// The host found a scan longer than the constant scan time: reported, the CPU goes on.
  void scan_time_error(std::uint32_t measured_us) noexcept;

private:
  static constexpr word kScanTimeCause = 1 << 4;     ///< of SD81
  static constexpr word kAnnunciatorCause = 1 << 5;  ///< of SD81

  AnnunciatorList<Words<SdPoints>> annunciators() noexcept { return AnnunciatorList<Words<SdPoints>>(SD); }
  ErrorReport<Words<SdPoints>> report(std::uint16_t code, ErrorCategory category, std::uint32_t step) noexcept;
  void start_run() noexcept;
  void advance_clocks(std::uint32_t elapsed_us) noexcept;
  void show_calendar() noexcept;
  void store_scan_time(unsigned number, std::uint32_t us) noexcept;
  void measure_scan(std::uint32_t us) noexcept;
  template <class F> void clear_errors(F &f) noexcept;

  Parameters parameters_{"MAIN    ", 100000, 10000, 0, 0, {}};
  TickCounter low_, high_;
  SecondCounter clock_, calendar_clock_;
  Flicker flicker_;
  Calendar calendar_ = calendar::kUnset;
  Micros last_now_ = 0;
  std::uint32_t shortest_us_ = 0, longest_us_ = 0;
  std::uint32_t scans_ = 0, error_step_ = 0;
  std::uint16_t error_ = 0;
  Mode mode_ = Mode::Stop;
  bool stopped_ = false;
  bool timed_ = false;       ///< last_now_ is a time
  bool first_scan_ = true;   ///< no completed scan to measure
  bool odd_second_ = false;  ///< of SM413
  bit reset_command_{};      ///< SM50 at the last END
};

// Start, RUN and STOP.

template <unsigned SmPoints, unsigned SdPoints> void System<SmPoints, SdPoints>::power_on(const Parameters &parameters) noexcept {
  parameters_ = parameters;
  if (parameters_.low_unit_us == 0)
    parameters_.low_unit_us = 100000;
  if (parameters_.high_unit_us == 0)
    parameters_.high_unit_us = 10000;

  SM.clear();
  SD.clear();
  SM[660] = on;  // SAFETY MODE, as SD560 = 0 says: always started from the ROM
  for (unsigned i = 0; i < 15; ++i)
    SD[290 + i] = parameters.points[i];
  SD[414] = 30;

  clock_.restart();
  flicker_.restart();
  odd_second_ = false;
  timed_ = false;
  stopped_ = false;
  error_ = 0;
  error_step_ = 0;
  reset_command_ = off;
  mode_ = Mode::Run;
  start_run();
}

template <unsigned SmPoints, unsigned SdPoints> void System<SmPoints, SdPoints>::start_run() noexcept {
  SM[203] = off;
  SM[400] = on;
  SM[401] = off;
  SM[402] = on;
  SM[403] = off;
  SD[420] = 0;
  for (unsigned number = 520; number <= 527; ++number)
    SD[number] = 0;
  low_.restart(parameters_.low_unit_us);
  high_.restart(parameters_.high_unit_us);
  shortest_us_ = 0xFFFFFFFFU;
  longest_us_ = 0;
  scans_ = 0;
  first_scan_ = true;
}

template <unsigned SmPoints, unsigned SdPoints> void System<SmPoints, SdPoints>::set_mode(Mode mode) noexcept {
  if (mode == mode_)
    return;
  mode_ = mode;
  if (mode == Mode::Stop)
    SM[203] = on;
  else if (stopped_)
    SM[203] = off;
  else
    start_run();
}

template <unsigned SmPoints, unsigned SdPoints> bool System<SmPoints, SdPoints>::set_calendar(Calendar time) noexcept {
  if (!calendar::is_valid(time))
    return false;
  time.weekday = static_cast<std::uint8_t>(calendar::weekday_of(time.year, time.month, time.day));
  calendar_ = time;
  calendar_clock_.restart();
  return true;
}

// The scan.

template <unsigned SmPoints, unsigned SdPoints> bool System<SmPoints, SdPoints>::begin_scan(Micros now) noexcept {
  const std::uint32_t elapsed_us = timed_ ? now - last_now_ : 0;  // unsigned: right across the wrap
  last_now_ = now;
  timed_ = true;
  advance_clocks(elapsed_us);
  show_calendar();
  if (!running())
    return false;
  if (first_scan_) {
    first_scan_ = false;
    return true;
  }
  low_.advance(elapsed_us);
  high_.advance(elapsed_us);
  measure_scan(elapsed_us);
  return true;
}

template <unsigned SmPoints, unsigned SdPoints> template <class F> void System<SmPoints, SdPoints>::end_scan(F &f) noexcept {
  SM[400] = on;  // again, in case the program wrote them
  SM[401] = off;
  SM[402] = off;
  SM[403] = on;
  SD[420] = to_word(pattern_of(SD[420]) + 1U);
  ++scans_;
  const bit command = SM[50];
  if (command & !reset_command_)
    clear_errors(f);
  reset_command_ = command;
  show_calendar();
}

// Time.

template <unsigned SmPoints, unsigned SdPoints> void System<SmPoints, SdPoints>::advance_clocks(std::uint32_t elapsed_us) noexcept {
  for (std::uint32_t seconds = clock_.advance(elapsed_us); seconds > 0; --seconds) {
    odd_second_ = !odd_second_;
    flicker_.second_passed(SD[414]);
    if (running())
      SD[412] = to_word(pattern_of(SD[412]) + 1U);
  }
  for (std::uint32_t seconds = calendar_clock_.advance(elapsed_us); seconds > 0; --seconds)
    calendar::tick(calendar_);

  const std::uint32_t us = clock_.rest_us();
  SM[410] = bit(us % 100000 >= 50000);
  SM[411] = bit(us % 200000 >= 100000);
  SM[412] = bit(us >= 500000);
  SM[413] = bit(odd_second_);
  SM[414] = flicker_.state();
}

template <unsigned SmPoints, unsigned SdPoints> void System<SmPoints, SdPoints>::show_calendar() noexcept {
  if (!SM[213])
    return;
  SD[210] = bcd_pair(calendar_.year % 100U, calendar_.month);
  SD[211] = bcd_pair(calendar_.day, calendar_.hour);
  SD[212] = bcd_pair(calendar_.minute, calendar_.second);
  SD[213] = bcd_pair(calendar_.year / 100U, calendar_.weekday);
}

/// Milliseconds and the rest in steps of 100 us. The controller's range ends at 6553.9 ms.
template <unsigned SmPoints, unsigned SdPoints>
void System<SmPoints, SdPoints>::store_scan_time(unsigned number, std::uint32_t us) noexcept {
  const std::uint32_t tenths = us < 6553900 ? us / 100 : 65539;
  SD[number] = to_word(tenths / 10);
  SD[number + 1] = to_word(tenths % 10 * 100);
}

template <unsigned SmPoints, unsigned SdPoints> void System<SmPoints, SdPoints>::measure_scan(std::uint32_t us) noexcept {
  store_scan_time(520, us);
  if (us < shortest_us_) {
    shortest_us_ = us;
    store_scan_time(524, us);
  }
  if (us > longest_us_) {
    longest_us_ = us;
    store_scan_time(526, us);
  }
}

// Errors.

/// Everything that all errors have in common; the caller adds the individual information.
template <unsigned SmPoints, unsigned SdPoints>
ErrorReport<Words<SdPoints>> System<SmPoints, SdPoints>::report(std::uint16_t code, ErrorCategory category,
                                                                std::uint32_t step) noexcept {
  const unsigned categories = static_cast<unsigned>(category);
  error_ = code;
  error_step_ = step;
  SM[0] = on;
  SM[5] = bit((categories & 0xFFU) != 0);
  SM[16] = bit((categories >> 8) != 0);
  ErrorReport<Words<SdPoints>> result(SD);
  result.begin(code, category, calendar_);
  if ((categories & 0xFFU) == 4)
    result.location(parameters_.name, step);
  return result;
}

template <unsigned SmPoints, unsigned SdPoints>
bool System<SmPoints, SdPoints>::operation_error(std::uint16_t code, std::uint32_t step) noexcept {
  report(code, ErrorCategory::Location, step);
  SM[1] = on;
  SM[56] = on;
  stopped_ = true;
  return false;
}

template <unsigned SmPoints, unsigned SdPoints> bool System<SmPoints, SdPoints>::abort(word code, std::uint32_t step) noexcept {
  report(kAbortError, ErrorCategory::LocationAbort, step).individual(code);
  stopped_ = true;
  return false;
}

template <unsigned SmPoints, unsigned SdPoints>
void System<SmPoints, SdPoints>::watchdog_error(std::uint32_t measured_us) noexcept {
  const std::uint32_t limit_us = parameters_.watchdog_us;
  auto times = report(kWatchdogError, ErrorCategory::ScanTime, 0);
  times.time_set(limit_us);
  times.time_measured(measured_us > limit_us ? measured_us : limit_us);
  SM[1] = on;
  stopped_ = true;
}

template <unsigned SmPoints, unsigned SdPoints>
void System<SmPoints, SdPoints>::scan_time_error(std::uint32_t measured_us) noexcept {
  if (stopped_)  // the error that stopped the CPU stays the one shown
    return;
  auto times = report(kScanTimeError, ErrorCategory::ScanTime, 0);
  times.time_set(parameters_.constant_scan_us);
  times.time_measured(measured_us);
  SM[1] = on;
  SD[81] = to_word(pattern_of(SD[81]) | pattern_of(kScanTimeCause));
}

/// Error reset: SD50 names the error, its last digit does not count. What is shown goes only with the error that came last.
template <unsigned SmPoints, unsigned SdPoints> template <class F> void System<SmPoints, SdPoints>::clear_errors(F &f) noexcept {
  const unsigned group = pattern_of(SD[50]) / 10;
  std::uint32_t causes = pattern_of(SD[81]);
  bool shown = error_ / 10U == group;
  if (group == kAnnunciatorError / 10) {
    auto list = annunciators();
    const unsigned oldest = list.oldest();
    if (list.count() > 0)
      annunciator_reset(f, oldest);
    if (list.count() > 0)
      shown = shown && pattern_of(SD[16]) == oldest;
    else
      causes &= ~pattern_of(kAnnunciatorCause);
  } else if (group == kScanTimeError / 10) {
    causes &= ~pattern_of(kScanTimeCause);
  } else {
    return;
  }
  SD[81] = to_word(causes);
  if (!shown)
    return;
  ErrorReport<Words<SdPoints>>(SD).clear();
  SM[0] = off;
  SM[1] = off;
  SM[5] = off;
  SM[16] = off;
  error_ = 0;
  error_step_ = 0;
}

// Annunciators.

template <unsigned SmPoints, unsigned SdPoints>
template <class F>
void System<SmPoints, SdPoints>::annunciator_out(F &f, unsigned number, bit state, std::uint32_t step) noexcept {
  if (state)
    annunciator_set(f, number, step);
  else
    f[number] = off;
}

template <unsigned SmPoints, unsigned SdPoints>
template <class F>
void System<SmPoints, SdPoints>::annunciator_set(F &f, unsigned number, std::uint32_t step) noexcept {
  if (static_cast<bit>(f[number]))
    return;
  f[number] = on;
  annunciators().enter(number);
  SM[62] = on;
  report(kAnnunciatorError, ErrorCategory::LocationAnnunciator, step).individual(to_word(number));
  SD[81] = to_word(pattern_of(SD[81]) | pattern_of(kAnnunciatorCause));
}

template <unsigned SmPoints, unsigned SdPoints>
template <class F>
void System<SmPoints, SdPoints>::annunciator_reset(F &f, unsigned number, std::uint32_t) noexcept {
  f[number] = off;
  auto list = annunciators();
  list.remove(number, f);
  if (list.count() == 0)
    SM[62] = off;
}

}  // namespace ladder::melsec_qs
