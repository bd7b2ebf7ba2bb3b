// Automatic tuning of F88 PID from the answer of the process to a step of the output.
//
// The output stands still at the height of the step. Sample by sample the measured value is followed on its way from the start to
// the set value; at a third of the way it is known how steeply it rises at most (R, per second) and, from the tangent there, how
// long the process did nothing (L, seconds). The manual's table makes the parameters of it: Kp = 1.2/(R L) x step, TI = 20 L, TD =
// 50 L.
//
// What the manual leaves open is decided here: a third of the way ends the tuning; a tenth of it is what noise may do. Moved back
// by more than that, the value goes up and down; moved as far in the other direction, the process acts the other way round.
#pragma once

#include "ladder/number.h"

namespace ladder::tp03 {

class PidTuning {
public:
  enum class Step : unsigned char { Goes, Opposite, Restless, Ends };

  /// What the table of the manual gives, in the units of the parameter registers; not rounded, not limited.
  struct Result {
    bool reverse;            ///< the output must rise for the measured value to rise
    double gain;             ///< percent
    double integral_time;    ///< 100 ms
    double derivative_time;  ///< 10 ms
  };

  /// False where there is nothing to learn: no way to go, or no step.
  bool start(double measured, word set_value, word height) noexcept {
    const double way = set_value - measured;
    start_ = last_ = measured;
    up_ = way > 0;
    way_ = up_ ? way : -way;
    height_ = height;
    time_ = peak_ = slope_ = dead_time_ = 0;
    return way_ > 0 && height != 0;
  }

  /// The next sample, `period` seconds after the one before.
  Step sample(double measured, double period) noexcept {
    const double before = progress(last_);
    const double now = progress(measured);
    last_ = measured;
    time_ += period;
    const double slope = (now - before) / period;
    if (slope > slope_) {
      slope_ = slope;
      // The tangent through the middle of the two samples meets the start here. Less than a period cannot be told from it.
      const double zero = time_ - period / 2 - (now + before) / 2 / slope;
      dead_time_ = zero > period ? zero : period;
    }
    if (now > peak_)
      peak_ = now;
    if (now >= way_ / 3)
      return Step::Ends;
    const double noise = way_ / 10;
    if (peak_ > noise && peak_ - now > noise)
      return Step::Restless;
    return now < -noise ? Step::Opposite : Step::Goes;
  }

  /// After Ends.
  Result result() const noexcept {
    const bool positive = height_ > 0;
    const double step = positive ? height_ : -height_;
    return {up_ == positive, 120 * step / (slope_ * dead_time_), 20 * dead_time_, 50 * dead_time_};
  }

private:
  /// Distance from the start, positive towards the set value.
  double progress(double measured) const noexcept { return up_ ? measured - start_ : start_ - measured; }

  double start_ = 0, last_ = 0, way_ = 0, time_ = 0, peak_ = 0, slope_ = 0, dead_time_ = 0;
  word height_ = 0;
  bool up_ = false;
};

}  // namespace ladder::tp03
