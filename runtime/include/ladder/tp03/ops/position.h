// F57 PLSY, F58 PWM, F59 PLSR, F156 ZRN, F157 PLSV, F158 DRVI, F159 DRVA: they start and stop the pulse outputs of the system.
//
// Every place in the list has an object that knows what became of its drive. A drive is refused where the output is in use, and
// stays refused until the condition was OFF; where the output stopped less than a scan ago, the drive is in error and acts in the
// next scan. M8145 and M8146 end a run without completing it, and no run starts while they are ON.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/pulses.h"

#include <cstdint>

namespace ladder::tp03 {

/// What all of them remember.
class PulseDrive {
protected:
  enum class State : std::uint8_t { Idle, Running, Refused, Stopped, Done };

  /// Looks at what happened since the last scan. False where the condition is OFF: the drive is over then.
  template <class S> bool driven(bit condition, S &sys, bool slowly = false) noexcept {
    if (epoch_ != sys.pulses.epoch()) {
      state_ = State::Idle;
      epoch_ = sys.pulses.epoch();
    }
    look(sys);
    if (condition)
      return true;
    if (state_ == State::Running) {
      PulseChannel &pulses = sys.pulses[channel_];
      slowly ? pulses.slow_down() : pulses.stop();
      sys.pulses.show(channel_, sys.M, sys.io());
    }
    if (state_ == State::Done)
      sys.set_complete(off);
    state_ = State::Idle;
    return false;
  }

  /// Whether the output can be driven now. `stoppable`: M8145 and M8146 hinder it.
  template <class Run, class S> Fault claim(Run output, S &sys, bool stoppable = true) noexcept {
    if (output.first() >= Pulses::kChannels)
      return Fault::Range;
    channel_ = static_cast<std::uint8_t>(output.first());
    const PulseChannel &pulses = sys.pulses[channel_];
    if (stoppable && sys.M[Pulses::kStop + channel_])
      state_ = State::Stopped;
    else if (pulses.in_use())
      state_ = State::Refused;
    else if (pulses.rested())
      state_ = State::Running;
    return state_ == State::Idle ? Fault::Range : Fault::None;
  }
  template <class Run, class S> void start(const PulseOrder &order, Run output, S &sys) noexcept {
    ticket_ = sys.pulses[channel_].start(order, output);
  }

  /// What the instruction reports, and M8029.
  template <class S> Fault report(S &sys) noexcept {
    if (state_ == State::Refused)
      return Fault::Range;
    sys.set_complete(bit(state_ == State::Done));
    if (state_ == State::Running)
      sys.pulses.show(channel_, sys.M, sys.io());
    return Fault::None;
  }

  std::uint32_t epoch_ = 0, ticket_ = 0;
  State state_ = State::Idle;
  std::uint8_t channel_ = 0;

private:
  template <class S> void look(S &sys) noexcept {
    if (state_ != State::Running)
      return;
    PulseChannel &pulses = sys.pulses[channel_];
    if (pulses.finished(ticket_)) {
      state_ = State::Done;
    } else if (!pulses.running(ticket_)) {
      state_ = State::Stopped;
    } else if (pulses.train() && sys.M[Pulses::kStop + channel_]) {
      pulses.stop();
      sys.pulses.show(channel_, sys.M, sys.io());
      state_ = State::Stopped;
    }
  }
};

/// The highest frequency that an operand of a width can name.
template <class Word> inline constexpr dword kTopFrequency = sizeof(Word) == 2 ? 32767 : 100000;

constexpr dword between(dword value, dword low, dword high) noexcept {
  return value < low ? low : value > high ? high : value;
}

// ---------------------------------------------------------------------------------------------- F57, F58, F59
template <class Word> class PulseTrainOf : PulseDrive {
public:
  template <class Run, class S> Fault run(bit condition, Word frequency, Word count, Run output, S &sys) noexcept {
    if (!driven(condition, sys))
      return Fault::None;
    if (state_ == State::Idle) {
      if (frequency < 1 || frequency > kTopFrequency<Word> || count < 0)
        return Fault::Range;
      if (const Fault fault = claim(output, sys); fault != Fault::None)
        return fault;
      if (state_ == State::Running)
        start({static_cast<std::uint32_t>(frequency), static_cast<std::uint32_t>(count)}, output, sys);
    } else if (state_ == State::Running) {
      if (frequency < 1 || frequency > kTopFrequency<Word>)
        return Fault::Range;
      sys.pulses[channel_].change(static_cast<std::uint32_t>(frequency), true);
    }
    return report(sys);
  }
};
using PulseTrain = PulseTrainOf<word>;
using DPulseTrain = PulseTrainOf<dword>;

class PulseWidth : PulseDrive {
public:
  template <class Run, class S> Fault run(bit condition, word on_ms, word period_ms, Run output, S &sys) noexcept {
    if (!driven(condition, sys))
      return Fault::None;
    if (on_ms < 0 || period_ms < 1 || period_ms > 3000 || on_ms > period_ms)
      return Fault::Range;
    const auto width = static_cast<std::uint16_t>(on_ms), period = static_cast<std::uint16_t>(period_ms);
    if (state_ == State::Idle) {
      if (const Fault fault = claim(output, sys, false); fault != Fault::None)
        return fault;
      if (state_ == State::Running)
        ticket_ = sys.pulses[channel_].start_width(width, period, output);
    } else if (state_ == State::Running) {
      sys.pulses[channel_].change_width(width, period);
    }
    if (state_ == State::Running)
      sys.pulses.show(channel_, sys.M, sys.io());
    return state_ == State::Refused ? Fault::Range : Fault::None;
  }
};

template <class Word> class PulseRampOf : PulseDrive {
public:
  template <class Run, class S> Fault run(bit condition, Word frequency, Word count, Word time_ms, Run output, S &sys) noexcept {
    if (!driven(condition, sys))
      return Fault::None;
    if (state_ == State::Idle) {
      if (count < 110 || time_ms < 0 || time_ms > 5000)
        return Fault::Range;
      if (const Fault fault = claim(output, sys); fault != Fault::None)
        return fault;
      const auto top = static_cast<std::uint32_t>(between(frequency, 10, 100000));
      const std::uint32_t step = top / 10 < 10 ? 10 : top / 10;
      const SpeedRamp ramp(step, top, static_cast<std::uint32_t>(time_ms) * 1000U, 10);
      if (state_ == State::Running)
        start({top, static_cast<std::uint32_t>(count), true, ramp}, output, sys);
    }
    return report(sys);
  }
};
using PulseRamp = PulseRampOf<word>;
using DPulseRamp = PulseRampOf<dword>;

// ---------------------------------------------------------------------------------------------- F156, F157
template <class Word> class HomeReturnOf : PulseDrive {
public:
  template <class Image, class Run, class S>
  Fault run(bit condition, Image &y, Word speed, Word creep, bit near, Run output, S &sys) noexcept {
    if (!driven(condition, sys))
      return Fault::None;
    if (state_ == State::Idle) {
      if (speed < 10 || speed > kTopFrequency<Word> || creep < 10 || creep > 32767)
        return Fault::Range;
      if (const Fault fault = claim(output, sys); fault != Fault::None)
        return fault;
      creep_ = static_cast<std::uint32_t>(creep);
      near_ = near;
      if (state_ == State::Running)
        start({near ? creep_ : static_cast<std::uint32_t>(speed), 0, false}, output, sys);
    } else if (state_ == State::Running) {
      if (near & !near_)
        sys.pulses[channel_].change(creep_, false);
      else if (near_ & !near)
        arrive(y, sys);
      near_ = near;
    }
    return report(sys);
  }

private:
  template <class Image, class S> void arrive(Image &y, S &sys) noexcept {
    sys.pulses[channel_].stop();
    sys.pulses.show(channel_, sys.M, sys.io());
    sys.D.pair(Pulses::kPosition + 2U * channel_) = 0;
    if (sys.M[8140])
      sys.pulses.clear_servo(channel_, y.run(2U + channel_));
    state_ = State::Done;
  }

  std::uint32_t creep_ = 0;
  bit near_{};
};
using HomeReturn = HomeReturnOf<word>;
using DHomeReturn = HomeReturnOf<dword>;

template <class Word> class VariablePulsesOf : PulseDrive {
public:
  template <class Run, class Out, class S> Fault run(bit condition, Word frequency, Run output, Out &&direction, S &sys) noexcept {
    if (!driven(condition, sys))
      return Fault::None;
    const dword signed_frequency = frequency;
    const bool forward = signed_frequency > 0;
    const std::uint32_t speed = forward ? pattern_of(signed_frequency) : 0U - pattern_of(signed_frequency);
    if (speed > 100000U)
      return Fault::Range;
    if (state_ == State::Idle) {
      if (const Fault fault = claim(output, sys); fault != Fault::None)
        return fault;
      if (state_ == State::Running)
        start({speed, 0, forward}, output, sys);
    } else if (state_ == State::Running) {
      sys.pulses[channel_].change(speed, forward);
    }
    if (state_ == State::Running && speed != 0)
      direction = bit(forward);
    return report(sys);
  }
};
using VariablePulses = VariablePulsesOf<word>;
using DVariablePulses = VariablePulsesOf<dword>;

// ---------------------------------------------------------------------------------------------- F158, F159
/// The largest whole number whose square is not above `value`.
constexpr std::uint32_t whole_root(std::uint32_t value) noexcept {
  std::uint32_t root = 0;
  for (std::uint32_t place = 1U << 15; place != 0; place >>= 1)
    if ((root | place) * (root | place) <= value)
      root |= place;
  return root;
}

/// How the axes move: base speed D8145, highest speed (D8147, D8146), and the time D8148 in which that is reached.
struct MoveSettings {
  std::uint32_t base, top, time_ms;

  /// Values out of range are the nearest in range; 0 in the highest speed or the time, as after power-on, is 100 kHz and 100 ms.
  template <class D> static MoveSettings of(D &d) noexcept {
    const dword top = d.pair(8146);
    const word time = d[8148];
    MoveSettings settings{};
    settings.top = static_cast<std::uint32_t>(between(top != 0 ? top : 100000, 10, 100000));
    settings.time_ms = static_cast<std::uint32_t>(between(time != 0 ? time : 100, 50, 5000));
    settings.base = static_cast<std::uint32_t>(between(d[8145], 0, static_cast<dword>(settings.top / 10)));
    return settings;
  }
  /// The lowest frequency that can be put out.
  std::uint32_t lowest() const noexcept { return whole_root(top * 500U / time_ms); }
  /// From the base speed to a frequency, and back at the end.
  SpeedRamp ramp(std::uint32_t frequency) const noexcept {
    const std::uint32_t first = base > lowest() ? base : lowest();
    if (first >= frequency)
      return {};
    return {first, frequency, static_cast<std::uint32_t>(std::uint64_t{time_ms} * 1000U * (frequency - first) / top), 100};
  }
};

class Move : protected PulseDrive {
protected:
  /// The first execution of a drive; the pulses follow by themselves.
  template <class Run, class Out, class S>
  Fault begin(qword distance, dword frequency, dword highest, Run output, Out &&direction, S &sys) noexcept {
    const MoveSettings settings = MoveSettings::of(sys.D);
    if (frequency < 10 || frequency > highest || static_cast<std::uint32_t>(frequency) > settings.top)
      return Fault::Range;
    if (const Fault fault = claim(output, sys); fault != Fault::None)
      return fault;
    if (state_ != State::Running)
      return Fault::None;
    if (distance == 0) {
      state_ = State::Done;
      return Fault::None;
    }
    const bool forward = distance > 0;
    direction = bit(forward);
    const std::uint32_t lowest = settings.lowest(), wanted = static_cast<std::uint32_t>(frequency);
    const std::uint32_t top = wanted > lowest ? wanted : lowest;
    start({top, static_cast<std::uint32_t>(forward ? distance : -distance), forward, settings.ramp(top)}, output, sys);
    return Fault::None;
  }
};

template <class Word> class RelativeMoveOf : Move {
public:
  template <class Run, class Out, class S>
  Fault run(bit condition, Word distance, Word frequency, Run output, Out &&direction, S &sys) noexcept {
    if (!driven(condition, sys, true))
      return Fault::None;
    if (state_ == State::Idle)
      if (const Fault fault = begin(distance, frequency, kTopFrequency<Word>, output, direction, sys); fault != Fault::None)
        return fault;
    return report(sys);
  }
};
using RelativeMove = RelativeMoveOf<word>;
using DRelativeMove = RelativeMoveOf<dword>;

template <class Word> class AbsoluteMoveOf : Move {
public:
  template <class Run, class Out, class S>
  Fault run(bit condition, Word target, Word frequency, Run output, Out &&direction, S &sys) noexcept {
    if (!driven(condition, sys, true))
      return Fault::None;
    if (state_ == State::Idle) {
      if (output.first() >= Pulses::kChannels)
        return Fault::Range;
      const dword position = sys.D.pair(Pulses::kPosition + 2U * output.first());
      if (const Fault fault = begin(qword{target} - position, frequency, kTopFrequency<Word>, output, direction, sys);
          fault != Fault::None)
        return fault;
    }
    return report(sys);
  }
};
using AbsoluteMove = AbsoluteMoveOf<word>;
using DAbsoluteMove = AbsoluteMoveOf<dword>;

}  // namespace ladder::tp03
