// The system side of a TP03: special relays and registers, errors, clocks, RUN and STOP, interrupts, high-speed counters, pulses.
//
// A program owns one System. Each scan is begin_scan(now), the hooks that look at device images, the program, the hooks behind it,
// end_scan(); between scans the host may read and write M8000 on and D8000 on like any device. Time comes in as an argument and
// only its differences count. What an error does is state here, so that two programs never share any.
//
// Where the manual is silent:
// * STOP to RUN clears M8067 and D8067; other special devices stay as they are.
// * In the first scan no time has passed: time in STOP is neither scan time nor time of a timer.
// * A watchdog error (6105) lasts until power comes on again; the switch alone does not end it. M8000 is OFF meanwhile.
// * The host measures whole scans, so WDT has nothing to do. A program that jumps backwards without end is stopped by a limit.
// * Behind the last active state D8040-D8047 hold 0, and D8049 where no annunciator is ON; with M8047 or M8049 OFF they stay.
#pragma once

#include "ladder/bit.h"
#include "ladder/calendar.h"
#include "ladder/image.h"
#include "ladder/io.h"
#include "ladder/numbered.h"
#include "ladder/scan_types.h"
#include "ladder/tp03/clocks.h"
#include "ladder/tp03/counter.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/high_speed.h"
#include "ladder/tp03/interrupts.h"
#include "ladder/tp03/parameters.h"
#include "ladder/tp03/ports.h"
#include "ladder/tp03/pulses.h"
#include "ladder/tp03/timer.h"

#include <cstdint>

namespace ladder::tp03 {

inline constexpr std::uint16_t kWatchdogError = 6105;

/// What a program talks to while nothing is connected.
class NoIo final : public Io {
public:
  static NoIo &instance() noexcept {
    static NoIo nothing;  // has no state
    return nothing;
  }
};

class System {
public:
  Numbered<Bits<512>, 8000> M;   ///< special relays M8000-M8511
  Numbered<Words<512>, 8000> D;  ///< special registers D8000-D8511
  HighSpeed high_speed;          ///< counters C235-C254 and what compares with them
  Pulses pulses;                 ///< pulse outputs Y0 and Y1
  Ports ports;                   ///< who has the serial ports

  // ---- the host's side
  void power_on(const Parameters &parameters) noexcept;
  void set_mode(Mode mode) noexcept;
  /// Sets the clock; the weekday follows from the date. False, and nothing changed, where D8018 cannot show the year.
  bool set_calendar(Calendar time) noexcept;
  void connect(Io *io) noexcept { io_ = io; }
  /// In RUN and not stopped by an error.
  bool running() const noexcept { return mode_ == Mode::Run && !stopped_; }
  Status status() const noexcept { return {mode_, running(), error_, error_step_, scans_}; }
  void watchdog_error() noexcept;  ///< the host found a scan longer than D8000 ms: 6105, the CPU stops
  /// The image of Y goes to the terminals: M8034 is OFF, and no error has stopped the CPU.
  bool outputs_enabled() const noexcept { return !stopped_ && !is_on(8034); }
  /// An input terminal changed between scans. The image does not see it; counters and interrupts do.
  void input(unsigned number, bit state) noexcept {
    if (running())
      sense(number, state);
  }

  // ---- the scan
  bool begin_scan(Micros now) noexcept;  ///< false: the program must not be executed, nor end_scan() called
  void end_scan() noexcept;
  template <class X> void watch_inputs(const X &x) noexcept;      ///< edges of X0-X5 since the last look: counters and interrupts
  template <class T> void begin_timers(T &t) noexcept;            ///< T246-T249 keep time in the background
  template <class T> void end_timers(T &t) noexcept;              ///< T192-T199 keep time where their coil was not executed
  template <class S> void show_states(const S &s) noexcept;       ///< M8046, M8048, D8040-D8047, D8049
  bool clears_unlatched() const noexcept { return is_on(8031); }  ///< END clears what is not latched
  bool clears_latched() const noexcept { return is_on(8032); }    ///< END clears what is latched
  bool holds_memory() const noexcept { return is_on(8033); }      ///< RUN to STOP clears nothing

  // ---- for instructions
  /// Time between the beginning of the last scan and that of this one, microseconds.
  std::uint32_t elapsed_us() const noexcept { return elapsed_us_; }
  /// Time since power-on as seen at the beginning of this scan, microseconds; wraps around after 71 minutes.
  std::uint32_t now_us() const noexcept { return now_us_; }
  /// Counts the scans that were begun; wraps around.
  std::uint32_t scan_number() const noexcept { return scan_number_; }
  bit first_scan() const noexcept { return M[8002]; }
  Io &io() noexcept { return io_ != nullptr ? *io_ : NoIo::instance(); }
  /// The clock as D8013-D8019 show it.
  const Calendar &calendar() const noexcept { return clock_.now(); }

  /// Rising edge for P forms: none in the first scan.
  template <class Memory> bit pulse(Memory &&memory, bit now) noexcept {
    if (!now || static_cast<bit>(memory)) {  // most scans see no edge
      memory = now;
      return off;
    }
    memory = on;
    return !first_scan();
  }

  /// M8020, M8021, M8022.
  void set_flags(bool zero, bool borrow, bool carry) noexcept {
    M[8020] = bit(zero);
    M[8021] = bit(borrow);
    M[8022] = bit(carry);
  }
  void set_complete(bit state) noexcept { M[8029] = state; }

  /// Fault: M8067 and D8067. None: the place that was in error is not any more.
  void check(Fault fault, std::uint32_t step) noexcept {
    const bool failed = fault != Fault::None;
    if (failed | is_on(8067))  // one branch that is never taken in a plant that works
      report(fault, step);
  }
  /// False, and error 6706, where an index register led out of the devices. A place with its condition OFF reports nothing.
  bool in_range(bool inside, std::uint32_t step, bit executed = on) noexcept {
    if (executed)
      check(inside ? Fault::None : Fault::Range, step);
    return inside;
  }

  // ---- program flow
  /// FOR n: passes through the loop, one at least.
  static constexpr word passes(word n) noexcept { return n > 1 ? n : word{1}; }
  /// A jump backwards. False when so many have been made in this scan that the watchdog of a real controller would have expired:
  /// error 6105, the scan ends.
  bool may_jump_back() noexcept {
    if (jumps_ < kJumps) {
      ++jumps_;
      return true;
    }
    watchdog_error();
    return false;
  }
  void reset_watchdog(std::uint32_t = 0) noexcept {}  ///< WDT: the host measures whole scans only
  /// CJ or CALL whose index leads to a label that is not placed.
  void no_such_label(std::uint32_t step) noexcept { report(Fault::Range, step); }
  /// The condition of a transfer between states, which M8040 inhibits.
  bit transfer(bit condition) const noexcept { return condition & !M[8040]; }

  // ---- interrupts
  void enable_interrupts(std::uint32_t = 0) noexcept { interrupts_.enable(); }
  void disable_interrupts(std::uint32_t = 0) noexcept { interrupts_.disable(); }
  /// An event that the program has a routine for; held while interrupts are disabled or a routine runs, up to 8.
  void raise(unsigned pointer) noexcept {
    if (running())
      interrupts_.raise(pointer, M);
  }
  /// The pointer of the next routine to run, or -1. The routine asked for before has ended with this.
  int next_interrupt() noexcept { return running() ? interrupts_.next(M) : -1; }
  /// Between next_interrupt() and the call that follows: routines are not interrupted themselves.
  bool routine_running() const noexcept { return interrupts_.routine_running(); }

  // ---- 32-bit counters
  /// OUT C200-C234
  void count(LongCounter &counter, unsigned number, bit pulse, dword preset, std::uint32_t = 0) noexcept {
    counter.count(pulse, preset, M[8000 + number]);
  }
  /// OUT C235-C254
  void enable_high_speed(LongCounter &counter, unsigned number, bit condition, dword preset, std::uint32_t = 0) noexcept {
    counter.coil = condition;
    counter.preset = preset;
    high_speed.enable(counter, number, condition);
  }

private:
  static constexpr std::uint32_t kJumps = 100000;

  struct InitialValue {
    unsigned number;
    word value;
  };
  static constexpr InitialValue kInitialValues[] = {
      {8000, 200},                        // watchdog, ms
      {8124, 2},   {8125, 3},             // RS: STX, ETX
      {8177, 7},   {8179, 3}, {8180, 5},  // data link: slaves, retries, timeout
      {8324, 2},   {8325, 3},             // RS on the expansion port
      {8377, 4},   {8379, 3}, {8380, 5},  // remote I/O
  };

  bool is_on(unsigned relay) const noexcept { return static_cast<bool>(M[relay]); }
  void start_run() noexcept;
  void leave_run() noexcept;
  void show_run(bit running, bit first) noexcept;
  void report(Fault fault, std::uint32_t step) noexcept;
  void show_errors() noexcept;
  void sense(unsigned number, bit state) noexcept {
    if (high_speed.look(number, state, *this))
      interrupts_.edge(number, static_cast<bool>(state), M);
  }

  Io *io_ = nullptr;
  Parameters parameters_ = {{0, 0, 0}};
  Interrupts interrupts_;
  ClockRelays relays_;
  ScanTimes scan_times_;
  RealTimeClock clock_;
  Micros last_now_ = 0;
  std::uint32_t elapsed_us_ = 0, now_us_ = 0, scan_number_ = 0;
  std::uint32_t scans_ = 0, error_step_ = 0, jumps_ = 0;
  std::uint16_t error_ = 0;
  Mode mode_ = Mode::Stop;
  bool stopped_ = false;
  bool timed_ = false;      ///< last_now_ is a time
  bool first_scan_ = true;  ///< no completed scan to measure
};

// Start, RUN and STOP.

inline void System::power_on(const Parameters &parameters) noexcept {
  parameters_ = parameters;
  M.clear();
  D.clear();
  for (const InitialValue &each : kInitialValues)
    D[each.number] = each.value;
  relays_.restart();
  clock_.forget_setting();
  clock_.show(D);
  pulses.restart();
  ports.restart();
  now_us_ = 0;
  timed_ = false;
  stopped_ = false;
  error_ = 0;
  error_step_ = 0;
  mode_ = Mode::Run;
  start_run();
}

inline void System::set_mode(Mode mode) noexcept {
  if (mode == mode_)
    return;
  mode_ = mode;
  if (stopped_)
    return;
  if (mode == Mode::Run)
    start_run();
  else
    leave_run();
}

inline void System::start_run() noexcept {
  high_speed.restart();
  interrupts_.restart(parameters_);
  scan_times_.restart();
  M[8067] = off;
  D[8067] = 0;
  show_errors();
  show_run(on, on);
  scans_ = 0;
  first_scan_ = true;
}

inline void System::leave_run() noexcept {
  high_speed.restart();
  interrupts_.restart(parameters_);
  pulses.restart();
  ports.restart();
  show_run(off, off);
}

/// M8000-M8003.
inline void System::show_run(bit running, bit first) noexcept {
  M[8000] = running;
  M[8001] = !running;
  M[8002] = first;
  M[8003] = !first;
}

inline bool System::set_calendar(Calendar time) noexcept {
  if (!clock_.set(time))
    return false;
  clock_.show(D);
  return true;
}

// The scan.

inline bool System::begin_scan(Micros now) noexcept {
  const std::uint32_t elapsed_us = timed_ ? now - last_now_ : 0;  // unsigned: right across the wrap
  last_now_ = now;
  timed_ = true;
  now_us_ += elapsed_us;
  relays_.advance(elapsed_us, M);
  clock_.advance(elapsed_us);
  clock_.exchange(M, D);
  pulses.advance(elapsed_us, M, D, io());
  show_errors();
  if (!running())
    return false;
  ++scan_number_;
  jumps_ = 0;
  elapsed_us_ = first_scan_ ? 0 : elapsed_us;
  if (!first_scan_)
    scan_times_.measure(elapsed_us, D);
  show_run(on, bit(first_scan_));
  first_scan_ = false;
  interrupts_.advance(elapsed_us_, M);
  return true;
}

inline void System::end_scan() noexcept {
  if (!running())  // an error stopped the program
    return;
  show_run(on, off);
  clock_.exchange(M, D);
  ++scans_;
}

template <class X> void System::watch_inputs(const X &x) noexcept {
  for (unsigned number = 0; number < HighSpeed::kInputs && number < X::kPoints; ++number)
    sense(number, x[number]);
}

template <class T> void System::begin_timers(T &t) noexcept {
  for (unsigned number = 246; number <= 249 && number < T::kPoints; ++number)
    if (t[number].coil)
      t[number].template advance<1000>(elapsed_us_, false);
}

template <class T> void System::end_timers(T &t) noexcept {
  for (unsigned number = 192; number <= 199 && number < T::kPoints; ++number) {
    Timer &timer = t[number];
    const std::uint16_t now = static_cast<std::uint16_t>(scan_number_);
    if (!timer.coil || timer.scan == now)
      continue;
    timer.scan = now;
    timer.template advance<100000>(elapsed_us_, true);
  }
}

template <class S> void System::show_states(const S &s) noexcept {
  const auto next_on = [&s](unsigned number, unsigned end) {
    while (number < end && number < S::kPoints && static_cast<bit>(s[number]) == off)
      ++number;
    return number < end && number < S::kPoints ? number : end;
  };
  bit active{};
  if (M[8047]) {
    unsigned state = next_on(0, 900);
    active = bit(state < 900);
    for (unsigned place = 8040; place <= 8047; ++place) {
      D[place] = state < 900 ? static_cast<word>(state) : word{0};
      state = state < 900 ? next_on(state + 1, 900) : state;
    }
  }
  M[8046] = active;
  active = off;
  if (M[8049]) {
    const unsigned annunciator = next_on(900, 1000);
    active = bit(annunciator < 1000);
    D[8049] = active ? static_cast<word>(annunciator) : word{0};
  }
  M[8048] = active;
}

// Errors.

inline void System::watchdog_error() noexcept {
  if (stopped_)
    return;
  M[8061] = on;
  D[8061] = static_cast<word>(kWatchdogError);
  error_ = kWatchdogError;
  error_step_ = 0;
  stopped_ = true;
  leave_run();
  show_errors();
}

[[gnu::noinline]] inline void System::report(Fault fault, std::uint32_t step) noexcept {
  if (fault == Fault::None) {
    if (step != error_step_)
      return;
    M[8067] = off;
  } else {
    error_ = static_cast<std::uint16_t>(fault);
    error_step_ = step;
    M[8067] = on;
    D[8067] = static_cast<word>(fault);
  }
  show_errors();
}

/// M8004.
inline void System::show_errors() noexcept {
  bit any{};
  for (unsigned number = 8060; number <= 8067; ++number)
    any |= M[number];
  M[8004] = any;
}

}  // namespace ladder::tp03
