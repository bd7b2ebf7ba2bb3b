// A judge for the TP03: sequence logic, timers, counters, jumps, states, and the instructions that move and calculate.
//
// Written from the manual, with its own memory and its own meaning of each mnemonic, read by its spelling. Of the compiler it takes
// the parsed list and the numbers of its rungs. It knows neither special devices nor what several scans are needed for.
#pragma once

#include "judge.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace ladderc::differential {

/// A class of which the system keeps some numbers.
bool is_system_class(const FamilyInfo &family, DeviceId id);

class Tp03Interpreter : public Judge {
public:
  explicit Tp03Interpreter(const CheckedProgram &program);
  static bool knows(const CheckedProgram &program);
  static bool knows_instruction(const InstructionInfo &info);

  void power_on() override;
  void set_run(bool run) override;
  void scan(std::uint32_t now_us) override;
  DeviceArray &array(DeviceId id) override { return arrays_[id]; }
  bool keeps(DeviceId id) const override { return !is_system_class(family_, id); }

private:
  static constexpr std::size_t kNowhere = ~std::size_t(0);

  struct Timer {
    std::uint32_t rest_us = 0;
    std::int64_t preset = 0;
    std::uint64_t last_scan = 0;
  };
  /// STL up to the next one or RET.
  struct Region {
    std::size_t body, end;
    std::vector<std::uint32_t> states;
    bool was_on = false;
    bool on = false;  ///< now: the bus of what lies inside
  };
  struct LoopState {
    std::size_t begin, end;  ///< FOR, NEXT
    std::int64_t left;
  };
  struct Result {
    std::vector<bool> blocks, branches;
    std::uint32_t rung = 0;
  };

  void find_structure();
  void forget_unlatched();
  /// Executes from `pc` to `end`; false when the scan has ended.
  bool run(std::size_t pc, std::size_t end, bool routine);
  bool sequence(std::size_t i, const std::string &name);
  void output(std::size_t i, const std::string &name);
  void drive(std::size_t i);
  void set_or_reset(std::size_t i, bool set);
  void transfer(std::size_t i);
  void drive_timer(const Operand &timer, std::int64_t preset, bool on);
  void advance(const Operand &timer, std::uint32_t elapsed, bool switches);
  void drive_counter(std::size_t i, const Operand &counter, std::int64_t preset, bool on);
  void reset_counter(const Operand &counter, bool on);
  std::size_t enter_region(std::size_t i);
  void leave_regions();
  std::size_t take_jump(std::size_t i, std::vector<LoopState> &loops);

  void word(std::size_t i, std::string name);
  std::optional<std::int64_t> result_of(const std::string &name, llvm::ArrayRef<Operand> o, unsigned width) const;
  void calculate(const std::string &name, std::size_t i, unsigned width);
  std::optional<std::vector<Operand>> resolved(const std::string &name, std::size_t i, unsigned width) const;
  bool reachable(const Operand &o, unsigned words, unsigned bits) const;
  std::int64_t index_of(const Operand &o, unsigned width) const;
  std::int64_t read(const Operand &o, unsigned width) const;
  void write(const Operand &o, std::uint64_t value, unsigned words);
  std::uint16_t word_at(DeviceId id, std::uint64_t place, unsigned k, bool pair) const;
  std::uint8_t &bit(const Operand &o, unsigned distance = 0);

  bool bus(std::size_t i) const;
  bool condition(std::size_t i) const { return (result_.blocks.empty() || result_.blocks.back()) && bus(i); }
  bool edge(std::size_t i, char kind, bool now);
  llvm::ArrayRef<Operand> operands(std::size_t i) const { return program_.list.operands_of(program_.list.instructions[i]); }
  const std::string &name(std::size_t i) const { return names_[i]; }
  std::uint64_t place(const Operand &o) const { return static_cast<std::uint64_t>(o.value) - family_.devices[o.device].first; }

  const CheckedProgram &program_;
  const FamilyInfo &family_;
  std::vector<DeviceArray> arrays_;
  std::vector<std::string> names_;
  std::vector<std::uint8_t> edges_;
  std::vector<std::vector<std::size_t>> ranges_;  ///< by instruction: the MC and SMCS around it
  std::vector<bool> range_on_;                    ///< by instruction that opens one
  std::vector<std::size_t> partner_;              ///< JCS to JCR, FOR to NEXT and back
  std::vector<int> region_of_;                    ///< by instruction, -1: none
  std::vector<Region> regions_;
  std::map<std::int64_t, std::size_t> labels_;
  std::map<std::int64_t, Timer> timers_;
  std::map<std::pair<DeviceId, std::int64_t>, bool> reset_coils_;
  std::set<std::uint32_t> left_;  ///< states that a transfer of this scan has left
  bool leave_due_ = false;
  std::size_t first_stl_ = kNowhere;
  Result result_;
  DeviceId states_ = kNoDevice;
  std::uint32_t last_us_ = 0, elapsed_us_ = 0;
  std::uint64_t scan_ = 0;
  unsigned jumps_back_ = 0;  ///< of this scan
  bool running_ = false, first_scan_ = false, stopped_ = false;
};

}  // namespace ladderc::differential
