// Random programs: what stands around rungs.
#pragma once

#include "generate/rung_maker.h"

#include <string>
#include <vector>

namespace ladderc::generate {

class ProgramMaker {
public:
  explicit ProgramMaker(const GenerateOptions &options) : rungs_(options) {}

  std::string list();

private:
  /// Where a part stands: what may be in it depends on that.
  struct Place {
    unsigned depth = 0;  ///< parts around it
    unsigned loops = 0;  ///< loops around it
    bool apart = false;  ///< in a routine
    bool in_state = false;
    bool in_master = false, in_bus = false, in_skip = false;  ///< an end closes all ranges of its kind
    unsigned routine = 0;                                     ///< routines from here on may be called
    std::string exit;                                         ///< a label behind the loops around it, or empty
  };
  enum class Part : std::uint8_t {
    Rung,
    Master,
    Bus,
    Skip,
    JumpForward,
    JumpBack,
    JumpToEnd,
    Exit,
    Call,
    Loop,
    Ladder,
    Alone,
    MainEnd
  };

  static Place inside(const Place &place);
  std::vector<Part> possible_parts(const Place &place) const;
  void parts(const Place &place, unsigned most);
  void part(const Place &place);
  void alone();
  unsigned master(const Place &place, unsigned first_level);
  std::string exit_label(Place &inner);
  void bus(const Place &place);
  void skip(const Place &place);
  void range(const Place &place, const InstructionInfo &begin, const InstructionInfo &end);
  void jump_forward(const Place &place, bool over_main_end);
  void jump_back(const Place &place);
  void jump(const std::string &label, bool seldom);
  void call(const Place &place);
  void loop(const Place &place);
  void ladder(const Place &place);
  void state(const Place &place, std::size_t index);
  void transfer();
  void routines();
  std::string new_label(Lowering lowering);
  void place_label(const std::string &label);
  DeviceId device_of(const OperandInfo &info) const;

  Random &random() { return rungs_.random(); }
  const InstructionInfo *find(Lowering lowering) const { return rungs_.catalogue().find(lowering); }

  RungMaker rungs_;
  std::vector<std::string> routines_;  ///< labels of the subroutines
  bool interrupts_ = false;            ///< has interrupt routines
  std::vector<std::uint32_t> states_;  ///< of the ladder that is being made
};

}  // namespace ladderc::generate
