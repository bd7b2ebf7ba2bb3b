// The system side of the interpreter: special relays and registers, clocks, errors, annunciators.
#pragma once

#include "memory.h"

namespace ladderc::differential {

class SystemModel {
public:
  SystemModel(const FamilyInfo &family, const Parameters &parameters, Memory &memory);

  void power_on();
  void set_run(bool run);
  bool running() const { return run_ && !stopped_; }
  std::uint16_t error() const { return error_; }
  std::uint32_t error_step() const { return error_step_; }

  /// False: the program is not executed.
  bool begin_scan(std::uint32_t now_us);
  void end_scan();
  /// Ticks that a timer gets at each execution.
  unsigned low_ticks() const { return low_ticks_; }
  unsigned high_ticks() const { return high_ticks_; }

  void operation_error(unsigned code, std::uint32_t step);
  void abort(std::uint16_t code, std::uint32_t step);
  void annunciator_on(unsigned number, std::uint32_t step);
  void annunciator_off(unsigned number) { f_.on[number] = 0; }
  void annunciator_reset(unsigned number);

private:
  std::uint8_t &sm(unsigned n) { return sm_.on[n]; }
  std::uint16_t &sd(unsigned n) { return sd_.value[n]; }
  void start_run();
  void pass_time(std::uint32_t us);
  void show_clock();
  void report(unsigned code, unsigned category, std::uint32_t step);
  void reset_errors();
  std::vector<unsigned> entries();
  void store_entries(const std::vector<unsigned> &numbers);

  const FamilyInfo &family_;
  const Parameters &parameters_;
  DeviceArray &sm_, &sd_, &f_;
  bool run_ = false, stopped_ = false, first_scan_ = true, timed_ = false;
  std::uint32_t last_us_ = 0, low_rest_us_ = 0, high_rest_us_ = 0, shortest_us_ = 0, longest_us_ = 0;
  unsigned low_ticks_ = 0, high_ticks_ = 0;
  std::uint64_t since_power_on_us_ = 0, calendar_us_ = 0;  ///< calendar: since 2000-01-01 00:00
  int flicker_seconds_ = 0;
  bool flicker_ = false, reset_command_ = false;
  std::uint16_t error_ = 0;
  std::uint32_t error_step_ = 0;
};

}  // namespace ladderc::differential
