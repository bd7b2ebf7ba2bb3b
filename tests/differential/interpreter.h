// The third judge: a list executed instruction by instruction, as the manual describes the machine.
//
// It takes the parsed list and nothing else of the compiler: mnemonics are told apart by their spelling here, not by what the
// instruction tables say that they become, and there is no IR. Slow and plain on purpose.
#pragma once

#include "interpreter_system.h"
#include "judge.h"
#include "memory.h"

#include <string>
#include <vector>

namespace ladderc::differential {

/// What a word instruction does, without width and P.
enum class WordOp : std::uint8_t {
  Add,
  Subtract,
  Multiply,
  Divide,
  Increment,
  Decrement,
  ToBcd,
  FromBcd,
  Negate,
  Move,
  Complement,
  BlockMove,
  Fill,
  And,
  Or,
  Xor,
  Xnor,
};

enum class Action : std::uint8_t {
  Contact,
  Compare,
  AndBlock,
  OrBlock,
  Push,
  Read,
  Pop,
  Invert,
  EdgeOfResult,
  EdgeRelay,
  Out,
  OutFast,
  Set,
  Reset,
  Pulse,
  Toggle,
  Master,
  MasterReset,
  Nothing,
  End,
  Abort,
  Word,
};

/// One mnemonic taken apart.
struct Decoded {
  Action action = Action::Nothing;
  char join = 'L';       ///< of contacts: L opens a block, A in series, O in parallel
  bool negated = false;  ///< LDI
  char edge = ' ';       ///< P or F of contacts, MEP, EGP, PLS and so on
  std::string sign;      ///< of comparisons
  WordOp op = WordOp::Move;
  bool wide = false, pulsed = false;
};

/// Throws std::runtime_error where nobody knows the mnemonic.
Decoded decode_mnemonic(const std::string &spelling);

class Interpreter : public Judge {
public:
  explicit Interpreter(const CheckedProgram &program);
  static bool knows(const CheckedProgram &) { return true; }

  void power_on() override;
  void set_run(bool run) override;
  void scan(std::uint32_t now_us) override;
  DeviceArray &array(DeviceId id) override { return memory_.array(id); }
  std::optional<std::string> state() const override { return state_text(system_.running(), system_.error(), system_.error_step()); }

private:
  struct Region {
    std::int64_t level;
    bool on;
  };

  /// False: the CPU has stopped.
  bool execute(std::size_t index);
  void contact(const Decoded &d, std::size_t index);
  bool output(const Decoded &d, std::size_t index);
  void out(const Decoded &d, std::size_t index, bool on);
  void set(std::size_t index, bool on, bool to);
  void drive_timer(const Operand &timer, const Operand &preset, unsigned ticks, bool retentive, bool on);
  void drive_counter(const Operand &counter, const Operand &preset, bool on);
  bool word(const Decoded &d, std::size_t index);
  bool block(const Decoded &d, std::size_t index);
  bool compare(const Decoded &d, std::size_t index);
  bool edge(char kind, std::uint8_t &memory, bool now);
  bool condition() const;
  llvm::ArrayRef<Operand> operands(std::size_t index) const { return program_.list.operands_of(program_.list.instructions[index]); }
  std::string prefix(const Operand &o) const { return program_.family->devices[o.device].prefix.str(); }

  const CheckedProgram &program_;
  Memory memory_;
  SystemModel system_;
  std::vector<Decoded> decoded_;
  std::vector<std::uint8_t> edges_;  ///< one for each instruction
  std::vector<bool> blocks_, branches_;
  std::vector<Region> regions_;
};

}  // namespace ladderc::differential
