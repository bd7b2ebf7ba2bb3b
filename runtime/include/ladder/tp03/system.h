// The system side of a TP03: special relays and registers, errors, clocks, RUN and STOP, interrupts, high-speed counters, pulses.
#pragma once

#include "ladder/bit.h"
#include "ladder/calendar.h"
#include "ladder/image.h"
#include "ladder/io.h"
#include "ladder/numbered.h"
#include "ladder/scan_types.h"
#include "ladder/tp03/counter.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/high_speed.h"
#include "ladder/tp03/parameters.h"
#include "ladder/tp03/pulses.h"
#include "ladder/tp03/timer.h"

#include <cstdint>

namespace ladder::tp03 {

class System {
public:
  Numbered<Bits<512>, 8000> M;   ///< special relays M8000-M8511
  Numbered<Words<512>, 8000> D;  ///< special registers D8000-D8511
  HighSpeed high_speed;          ///< counters C235-C254 and what compares with them
  Pulses pulses;                 ///< pulse outputs Y0 and Y1

  // ---- the host's side
  void power_on(const Parameters &parameters) noexcept;
  void set_mode(Mode mode) noexcept;
  bool set_calendar(Calendar time) noexcept;
  void connect(Io *io) noexcept { io_ = io; }
  bool running() const noexcept;
  Status status() const noexcept;
  void watchdog_error() noexcept;  ///< the host found a scan longer than D8000 ms: 6105, the CPU stops
  /// M8034 is OFF: the image of Y goes to the terminals.
  bool outputs_enabled() const noexcept { return !M[8034]; }

  // ---- the scan
  bool begin_scan(Micros now) noexcept;  ///< false: the program must not be executed, nor end_scan() called
  void end_scan() noexcept;
  template <class X> void watch_inputs(const X &x) noexcept;  ///< edges of X0-X5 since the last look: counters and interrupts
  template <class T> void begin_timers(T &t) noexcept;        ///< T246-T249 keep time in the background
  template <class T> void end_timers(T &t) noexcept;          ///< T192-T199 keep time where their coil was not executed
  template <class S> void show_states(const S &s) noexcept;   ///< M8046, M8048, D8040-D8047, D8049

  // ---- for instructions
  /// Time between the beginning of the last scan and that of this one, microseconds.
  std::uint32_t elapsed_us() const noexcept { return elapsed_us_; }
  /// Time since power-on as seen at the beginning of this scan, microseconds; wraps around after 71 minutes.
  std::uint32_t now_us() const noexcept { return now_us_; }
  bit first_scan() const noexcept { return M[8002]; }
  Io &io() noexcept { return *io_; }
  /// The clock as D8013-D8019 show it.
  const Calendar &calendar() const noexcept { return calendar_; }

  /// Rising edge for P forms: none in the first scan.
  template <class Memory> bit pulse(Memory &&memory, bit now) noexcept {
    const bit before = memory;
    memory = now;
    return now & !before & !first_scan();
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
    if (fault != Fault::None || M[8067])
      report(fault, step);
  }
  /// False, and error 6706, where an index register led out of the devices. A place with its condition OFF reports nothing.
  bool in_range(bool inside, std::uint32_t step, bit executed = on) noexcept {
    if (inside)
      return true;
    if (executed)
      report(Fault::Range, step);
    return false;
  }

  // ---- program flow
  /// FOR n: passes through the loop; below 1 none... see F08.
  static word passes(word n) noexcept;
  /// A jump backwards. False when so many have been made in this scan that the watchdog of a real controller would have expired:
  /// error 6105, the scan ends.
  bool may_jump_back() noexcept;
  void reset_watchdog() noexcept {}  ///< WDT: the host measures whole scans only
  /// The condition of a transfer between states, which M8040 inhibits.
  bit transfer(bit condition) const noexcept { return condition & !M[8040]; }

  // ---- interrupts
  void enable_interrupts(std::uint32_t step) noexcept;
  void disable_interrupts(std::uint32_t step) noexcept;
  /// An event that the program has a routine for; held while interrupts are disabled or a routine runs, up to 8.
  void raise(unsigned pointer) noexcept;
  /// The pointer of the next routine to run, or -1.
  int next_interrupt() noexcept;

  // ---- 32-bit counters
  void count(LongCounter &counter, unsigned number, bit pulse, dword preset, std::uint32_t step) noexcept;  ///< OUT C200-C234
  void enable_high_speed(LongCounter &counter, unsigned number, bit condition, dword preset, std::uint32_t step) noexcept;

private:
  void report(Fault fault, std::uint32_t step) noexcept;

  Io *io_;
  Calendar calendar_ = calendar::kUnset;
  std::uint32_t elapsed_us_ = 0, now_us_ = 0;
};

}  // namespace ladder::tp03
