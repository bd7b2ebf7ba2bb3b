// Modes of a machine with a step ladder: F60 IST.
//
// Eight inputs select a mode (manual, return to the origin, step, one cycle, continuous) and have three buttons (start of the
// return, start, stop). The instruction switches the initial states, S0 manual, S1 return, S2 automatic, and the relays that the
// step ladder looks at: M8040 inhibits transfers, M8041 is the condition from S2 to the first state, M8042 the pulse of a start
// button. The program itself drives M8043 (returned), M8044 (at the origin) and M8045 (no reset of outputs).
//
// What the manual leaves open, its section having lost its head, and what is done:
// * Of several mode inputs the lowest counts; with none the mode stays as it was. Before there was one, M8040 is ON.
// * The first execution after RUN and each change between manual, return and automatic (the three automatic modes are one) switch
// S0,
//   S1 and S2. S2 does not come ON while a state from D1 to D2 is active already: the sequence goes on.
// * "Not at the origin" is M8043 and M8044 both OFF. The reset then clears S0-S899 and, unless M8045 is ON, all Y.
// * M8042 answers the start button in all modes and the start of the return in its mode. A button that is down already when the
//   instruction is first executed has not been pressed.
// * In step mode M8040 is OFF in the scan of M8042 only, so that one press makes one step. In the automatic modes a stop in one
// cycle
//   is remembered until start, also when the mode is turned to continuous meanwhile.
// * Condition OFF: relays and states stay, but for M8042.
#pragma once

#include "ladder/bit.h"
#include "ladder/tp03/fault.h"

#include <cstdint>

namespace ladder::tp03 {

struct ist {
  /// `s` and `y` are the whole images. `inputs` are the mode inputs, `low` and `high` begin at D1 and D2.
  template <class States, class Outputs, class Inputs, class State, class S>
  Fault run(bit condition, States &s, Outputs &y, Inputs inputs, State low, State high, S &sys) noexcept {
    if (sys.first_scan())
      *this = ist{};
    if (!condition) {
      if (driven_)
        sys.M[8042] = off;
      driven_ = off;
      return Fault::None;
    }
    if (low.first() >= high.first() || inputs.points() < 8)
      return Fault::Range;
    const Mode before = mode_;
    mode_ = selected(inputs, before);
    if (group_of(mode_) != group_of(before))
      change(s, y, before, low.first(), high.first(), sys);
    drive(press(inputs), inputs.get(6), inputs.get(7), sys);
    driven_ = on;
    return Fault::None;
  }

private:
  enum class Mode : std::uint8_t { None, Manual, Return, Step, Cycle, Continuous };
  enum class Group : std::uint8_t { None, Manual, Return, Automatic };

  static constexpr unsigned kStates = 900;  ///< behind them are annunciators

  static constexpr Group group_of(Mode mode) noexcept { return mode < Mode::Step ? static_cast<Group>(mode) : Group::Automatic; }

  template <class Inputs> static Mode selected(const Inputs &inputs, Mode otherwise) noexcept {
    for (unsigned i = 0; i < 5; ++i)
      if (inputs.get(i))
        return static_cast<Mode>(i + 1);
    return otherwise;
  }

  template <class States> static bool any(const States &s, unsigned first, unsigned last) noexcept {
    for (unsigned i = first; i <= last && i < States::kPoints; ++i)
      if (static_cast<bit>(s[i]))
        return true;
    return false;
  }

  template <class States, class Outputs, class S>
  void change(States &s, Outputs &y, Mode before, unsigned low, unsigned high, S &sys) const noexcept {
    if (before != Mode::None && !(sys.M[8043] | sys.M[8044])) {
      s.clear(0, (States::kPoints < kStates ? States::kPoints : kStates) - 1);
      if (!sys.M[8045])
        y.clear(0, Outputs::kPoints - 1);
    }
    const unsigned initial = static_cast<unsigned>(group_of(mode_)) - 1;
    const bit resumed = bit(group_of(mode_) == Group::Automatic && any(s, low, high));
    for (unsigned i = 0; i < 3 && i < States::kPoints; ++i)
      s[i] = bit(i == initial) & !resumed;
  }

  /// A start button has been pressed.
  template <class Inputs> bit press(const Inputs &inputs) noexcept {
    const bit start = inputs.get(6), return_start = inputs.get(5);
    const bit pressed = (start & !start_) | (return_start & !return_start_ & bit(mode_ == Mode::Return));
    start_ = start;
    return_start_ = return_start;
    return pressed & driven_;
  }

  template <class S> void drive(bit pressed, bit start, bit stop, S &sys) noexcept {
    if (pressed)
      stopped_ = fresh_ = off;
    stopped_ |= stop & bit(mode_ == Mode::Return || mode_ == Mode::Cycle);
    continuous_ = (continuous_ | pressed) & !stop & bit(mode_ == Mode::Continuous);
    sys.M[8042] = pressed;
    switch (mode_) {
    case Mode::None:
    case Mode::Manual:
      sys.M[8040] = on;
      sys.M[8041] = off;
      break;
    case Mode::Return:
      sys.M[8040] = stopped_;
      sys.M[8041] = off;
      break;
    case Mode::Step:
      sys.M[8040] = !pressed;
      sys.M[8041] = start;
      break;
    case Mode::Cycle:
      sys.M[8040] = stopped_;
      sys.M[8041] = start;
      break;
    case Mode::Continuous:
      sys.M[8040] = stopped_ | fresh_;
      sys.M[8041] = continuous_;
      break;
    }
  }

  bit driven_{};
  bit start_{}, return_start_{};
  bit stopped_{};     ///< M8040 of return and one cycle
  bit fresh_ = on;    ///< no start since RUN
  bit continuous_{};  ///< M8041 of continuous
  Mode mode_ = Mode::None;
};

}  // namespace ladder::tp03
