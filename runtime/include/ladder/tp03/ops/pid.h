// F88 PID: a control loop in velocity form, with the derivative of the measured value.
//
//   PVf = PV + a (PVf' - PV)                                  a: filter; ' is the sample before, '' the one before that
//   EV  = PVf - SV (forward)  or  SV - PVf (reverse)
//   D   = TD / (Ts + aD TD) x (PVf - 2 PVf' + PVf'') x (1 forward, -1 reverse) + aD TD / (Ts + aD TD) x D'
//   MV  = MV' + Kp ((EV - EV') + Ts / TI x EV + D)
//
// MV is accumulated with its fraction and rounded to the nearest where it is stored; when something else has written the register,
// the loop goes on from there. The registers that the manual sets aside as work area are not used: the history is in this object.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/ops/pid_tuning.h"

#include <cstdint>

namespace ladder::tp03 {
namespace pid {

/// The parameter registers, counted from S3.
enum Register : unsigned {
  kSamplingTime,    ///< Ts, ms
  kAction,          ///< the bits below
  kFilter,          ///< a, percent
  kGain,            ///< Kp, percent
  kIntegralTime,    ///< TI, 100 ms; 0: none
  kDerivativeGain,  ///< aD, percent
  kDerivativeTime,  ///< TD, 10 ms; 0: none
  kInputRise = 20,  ///< alarm limits of the change from sample to sample
  kInputFall,
  kOutputRise,
  kOutputFall,
  kAlarms,
  kUpperLimit = kOutputRise,  ///< where the output is limited
  kLowerLimit = kOutputFall,
};

inline constexpr word kReverse = 1, kInputAlarm = 2, kOutputAlarm = 4, kTune = 16, kLimited = 32;  ///< bits of kAction

// Errors of a running loop: it goes on with the value limited to 16 bits.
inline constexpr Fault kChangeOverflow{6742};
inline constexpr Fault kDeviationOverflow{6743};
inline constexpr Fault kIntegralOverflow{6744};
inline constexpr Fault kDerivativeGainOverflow{6745};  ///< already TD / (Ts + aD TD) is too large
inline constexpr Fault kDerivativeOverflow{6746};
inline constexpr Fault kOutputOverflow{6747};
inline constexpr Fault kTuningResult{6750};     ///< tuning ends: the parameters found are out of range
inline constexpr Fault kTuningDirection{6751};  ///< tuning goes on: the process acts the other way round
inline constexpr Fault kTuningRestless{6752};   ///< tuning ends: the measured value goes up and down

constexpr bool outside(word value, word low, word high) noexcept {
  return value < low || value > high;
}

/// The first parameter out of range. Gains and times are not looked at while they are being found.
template <class Block> constexpr Fault check(const Block &table, bool tuning) noexcept {
  if (table.get(kSamplingTime) < 1)
    return Fault::SamplingTime;
  if (outside(table.get(kFilter), 0, 99))
    return Fault::InputFilter;
  if (!tuning && table.get(kGain) < 1)
    return Fault::ProportionalGain;
  if (!tuning && table.get(kIntegralTime) < 0)
    return Fault::IntegralTime;
  if (!tuning && outside(table.get(kDerivativeGain), 0, 100))
    return Fault::DerivativeGain;
  if (!tuning && table.get(kDerivativeTime) < 0)
    return Fault::DerivativeTime;
  const word action = table.get(kAction);
  if ((action & kInputAlarm) != 0 && (table.get(kInputRise) < 0 || table.get(kInputFall) < 0))
    return Fault::Range;
  if ((action & kLimited) != 0)
    return table.get(kUpperLimit) < table.get(kLowerLimit) ? Fault::Range : Fault::None;
  if ((action & kOutputAlarm) != 0 && (table.get(kOutputRise) < 0 || table.get(kOutputFall) < 0))
    return Fault::Range;
  return Fault::None;
}

/// 1 to 32767 when it is rounded.
constexpr bool is_positive_word(double value) noexcept {
  return value >= 0.5 && value < 32767.5;
}
constexpr word rounded(double value) noexcept {
  return static_cast<word>(value < 0 ? value - 0.5 : value + 0.5);
}

}  // namespace pid

class Pid {
public:
  /// `present` is what the output register holds.
  template <class Block, class Out, class S>
  Fault run(bit condition, word set_value, word measured, Block table, word present, Out &&output, S &sys) noexcept {
    if (!condition) {
      running_ = false;
      return Fault::None;
    }
    const word action = table.get(pid::kAction);
    const Fault bad = pid::check(table, (action & pid::kTune) != 0);
    if (bad != Fault::None) {
      running_ = false;
      return bad;
    }
    if (!running_ || sys.first_scan()) {
      tuning_ = false;
      tuning_fault_ = Fault::None;
      begin(set_value, measured, present, action, sys.now_us());
    }
    if (!tuning_ && (action & pid::kTune) != 0)
      begin_tuning(set_value, table, present, sys.now_us());
    else if (tuning_ && (action & pid::kTune) == 0) {
      tuning_ = false;
      begin(set_value, measured, present, action, sys.now_us());
    }
    if (!is_due(static_cast<std::uint32_t>(table.get(pid::kSamplingTime)) * 1000, sys.now_us(),
                sys.routine_running() ? 0 : sys.elapsed_us()))
      return fault_;
    fault_ = period_is_scan_ ? Fault::SamplingBelowScan : Fault::None;
    sample(set_value, measured, table, present, output, sys.now_us());
    note(tuning_fault_);
    return fault_;
  }

private:
  /// Starts without a jump: the loop finds its history as if it had stood still.
  void begin(word set_value, word measured, word present, word action, std::uint32_t now_us) noexcept {
    running_ = true;
    fault_ = tuning_fault_;
    last_us_ = now_us;
    measured_ = measured;
    filtered_ = before_ = measured;
    deviation_ = limited(deviation(set_value, action), Fault::None);
    derivative_ = 0;
    exact_ = stored_ = present;
  }

  template <class Block> void begin_tuning(word set_value, const Block &table, word present, std::uint32_t now_us) noexcept {
    tuning_fault_ = Fault::None;
    last_us_ = now_us;
    tuning_ = true;
    if (!tuning_steps_.start(filtered_, set_value, present))
      end_tuning(table, pid::kTuningResult);
  }

  template <class Block> void end_tuning(const Block &table, Fault fault) noexcept {
    tuning_ = false;
    tuning_fault_ = fault_ = fault;
    table.set(pid::kAction, static_cast<word>(table.get(pid::kAction) & ~pid::kTune));
  }

  /// Whether this scan calculates, and `period_us_`. Samples keep to a grid of Ts from the start, so that one that comes late makes
  /// the next come early; a grid that was missed altogether starts anew. Ts within one scan: every scan calculates. A `scan_us` of
  /// 0 says that a timer interrupt is being served, where the scan time means nothing: it may have to make up for several samples.
  bool is_due(std::uint32_t sampling_us, std::uint32_t now_us, std::uint32_t scan_us) noexcept {
    const std::uint32_t waited = now_us - last_us_;
    period_is_scan_ = sampling_us <= scan_us;
    period_us_ = period_is_scan_ ? scan_us : sampling_us;
    if (waited == 0 || (!period_is_scan_ && waited < sampling_us))
      return false;
    const std::uint32_t most = scan_us == 0 ? 16 : 2;
    last_us_ = period_is_scan_ || waited / most >= sampling_us ? now_us : last_us_ + sampling_us;
    return true;
  }

  template <class Block, class Out>
  void sample(word set_value, word measured, const Block &table, word present, Out &&output, std::uint32_t now_us) noexcept {
    const word action = table.get(pid::kAction);
    const dword change = dword{measured} - measured_;
    if (change < -32768 || change > 32767)
      note(pid::kChangeOverflow);
    measured_ = measured;
    const double older = before_;
    before_ = filtered_;
    filtered_ = measured + table.get(pid::kFilter) / 100.0 * (before_ - measured);

    dword output_change = 0;
    if (tuning_) {
      tune(set_value, measured, table, present, now_us);
    } else {
      calculate(set_value, table, present, older);
      output = stored_;
      output_change = dword{stored_} - present;
    }
    show_alarms(table, action, change, output_change);
  }

  template <class Block> void calculate(word set_value, const Block &table, word present, double older) noexcept {
    const word action = table.get(pid::kAction);
    const double ts = period_us_ / 1e6;
    const double ti = table.get(pid::kIntegralTime) / 10.0;
    const double td = table.get(pid::kDerivativeTime) / 100.0;
    const double filtered_td = table.get(pid::kDerivativeGain) / 100.0 * td;
    if (present != stored_)
      exact_ = present;

    const double deviation_before = deviation_;
    deviation_ = limited(deviation(set_value, action), pid::kDeviationOverflow);
    const double integral = ti > 0 ? limited(ts / ti * deviation_, pid::kIntegralOverflow) : 0;
    const double gain = td / (ts + filtered_td);
    const double bend = filtered_ - 2 * before_ + older;
    derivative_ = limited(gain * ((action & pid::kReverse) != 0 ? -bend : bend) + filtered_td / (ts + filtered_td) * derivative_,
                          gain > 32767 ? pid::kDerivativeGainOverflow : pid::kDerivativeOverflow);
    exact_ += table.get(pid::kGain) / 100.0 * (deviation_ - deviation_before + integral + derivative_);
    if ((action & pid::kLimited) != 0)
      exact_ = between(exact_, table.get(pid::kLowerLimit), table.get(pid::kUpperLimit));
    else
      exact_ = limited(exact_, pid::kOutputOverflow);
    stored_ = pid::rounded(exact_);
  }

  template <class Block> void tune(word set_value, word measured, const Block &table, word present, std::uint32_t now_us) noexcept {
    switch (tuning_steps_.sample(filtered_, period_us_ / 1e6)) {
    case PidTuning::Step::Goes:
      return;
    case PidTuning::Step::Opposite:
      tuning_fault_ = pid::kTuningDirection;
      return;
    case PidTuning::Step::Restless:
      end_tuning(table, pid::kTuningRestless);
      break;
    case PidTuning::Step::Ends:
      end_tuning(table, accept(tuning_steps_.result(), table) ? Fault::None : pid::kTuningResult);
      break;
    }
    begin(set_value, measured, present, table.get(pid::kAction), now_us);
  }

  /// Writes what tuning found, if the registers can hold it.
  template <class Block> static bool accept(const PidTuning::Result &found, const Block &table) noexcept {
    if (!pid::is_positive_word(found.gain) || !pid::is_positive_word(found.integral_time) ||
        !pid::is_positive_word(found.derivative_time))
      return false;
    const word others = static_cast<word>(table.get(pid::kAction) & ~pid::kReverse);
    table.set(pid::kAction, static_cast<word>(found.reverse ? others | pid::kReverse : others));
    table.set(pid::kGain, pid::rounded(found.gain));
    table.set(pid::kIntegralTime, pid::rounded(found.integral_time));
    table.set(pid::kDerivativeTime, pid::rounded(found.derivative_time));
    return true;
  }

  /// A rise beyond the first limit of a pair, a fall beyond the second. The word is left alone where its registers are not in use.
  template <class Block>
  static void show_alarms(const Block &table, word action, dword input_change, dword output_change) noexcept {
    if ((action & (pid::kInputAlarm | pid::kOutputAlarm | pid::kLimited)) == 0)
      return;
    unsigned alarms = 0;
    if ((action & pid::kInputAlarm) != 0)
      alarms |= (input_change > table.get(pid::kInputRise) ? 1U : 0U) | (input_change < -table.get(pid::kInputFall) ? 2U : 0U);
    if ((action & (pid::kOutputAlarm | pid::kLimited)) == pid::kOutputAlarm)
      alarms |= (output_change > table.get(pid::kOutputRise) ? 4U : 0U) | (output_change < -table.get(pid::kOutputFall) ? 8U : 0U);
    table.set(pid::kAlarms, static_cast<word>(alarms));
  }

  double deviation(word set_value, word action) const noexcept {
    return (action & pid::kReverse) != 0 ? set_value - filtered_ : filtered_ - set_value;
  }

  static constexpr double between(double value, word low, word high) noexcept {
    return value < low ? low : value > high ? high : value;
  }
  /// Limited to 16 bits; `fault` is noted where that changes the value.
  double limited(double value, Fault fault) noexcept {
    const double result = between(value, -32768, 32767);
    if (value < result || value > result)
      note(fault);
    return result;
  }
  /// Of several errors in one calculation the first stays: it is the cause.
  void note(Fault fault) noexcept {
    if (fault_ == Fault::None)
      fault_ = fault;
  }

  double exact_ = 0;  ///< MV with its fraction
  double deviation_ = 0, derivative_ = 0;
  double filtered_ = 0, before_ = 0;  ///< PVf of the last sample and of the one before
  std::uint32_t last_us_ = 0;         ///< when that was due
  std::uint32_t period_us_ = 0;       ///< Ts of the equations
  word measured_ = 0;                 ///< PV of the last sample
  word stored_ = 0;                   ///< what the loop wrote last
  Fault fault_ = Fault::None;         ///< of the last calculation, shown until the next one
  Fault tuning_fault_ = Fault::None;  ///< shown until the condition goes OFF or tuning starts anew
  bool running_ = false, tuning_ = false, period_is_scan_ = false;
  PidTuning tuning_steps_;
};

}  // namespace ladder::tp03
