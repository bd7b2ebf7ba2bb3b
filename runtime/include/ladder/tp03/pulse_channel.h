// One pulse output: a train of pulses, or a width-modulated signal, that runs between scans.
//
// Real outputs work by interrupt. Here a channel is a function of time: at the beginning of every scan it is told how much time has
// passed, and works out how many pulses went out. Numbers are whole: a pulse is a million parts, of which a frequency of f Hz puts
// out f in every microsecond, so that nothing is lost from scan to scan however they fall.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/tp03/speed_ramp.h"

#include <cstdint>

namespace ladder::tp03 {

/// What a channel is to put out.
struct PulseOrder {
  std::uint32_t frequency = 0;  ///< pulses a second
  std::uint32_t count = 0;      ///< 0: without end
  bool forward = true;          ///< counts the position up
  SpeedRamp ramp{};             ///< only where there is a count
};

class PulseChannel {
public:
  /// ON and OFF take half of a pulse each, ON first.
  static constexpr std::uint32_t kPulse = 1000000;

  bool in_use() const noexcept { return use_ != Use::None; }
  bool train() const noexcept { return use_ == Use::Train; }
  bool width_modulated() const noexcept { return use_ == Use::Width; }
  /// Not in use, and was not in use at the beginning of this scan: a drive that comes earlier is an error.
  bool rested() const noexcept { return rested_; }
  /// Pulses go out.
  bool busy() const noexcept { return train() && order_.frequency != 0; }
  /// The run that start() gave this ticket goes on; all its pulses are out.
  bool running(std::uint32_t ticket) const noexcept { return in_use() && ticket == ticket_; }
  bool finished(std::uint32_t ticket) const noexcept { return finished_ && ticket == ticket_; }

  std::uint32_t start(const PulseOrder &order, BitTarget output) noexcept {
    begin(Use::Train, output);
    order_ = order;
    remaining_ = order.count;
    show();
    return ticket_;
  }
  std::uint32_t start_width(std::uint16_t on_ms, std::uint16_t period_ms, BitTarget output) noexcept {
    begin(Use::Width, output);
    change_width(on_ms, period_ms);
    return ticket_;
  }
  /// The frequency follows at once; the pulse that is under way keeps the part that is done. 0 stops the pulses, not the run.
  void change(std::uint32_t frequency, bool forward) noexcept {
    order_.frequency = frequency;
    order_.forward = forward;
    show();
  }
  void change_width(std::uint16_t on_ms, std::uint16_t period_ms) noexcept {
    on_ms_ = on_ms;
    period_ms_ = period_ms;
    part_ %= period_ms * 1000U;
    show();
  }
  void stop() noexcept {
    use_ = Use::None;
    rested_ = false;
    output_ = off;
  }
  /// Falls to a stop along the ramp.
  void slow_down() noexcept {
    order_.count = order_.ramp.exists() ? order_.ramp.pulses(order_.ramp.level_at(distance()) - 1) : 0;
    if (order_.count == 0)
      stop();
    else if (order_.count < remaining_)
      remaining_ = order_.count;
    aborted_ = true;
  }

  /// Time passes. Returns how far the position moves, as a number that wraps around.
  std::uint32_t advance(std::uint32_t elapsed_us) noexcept {
    rested_ = !in_use();
    std::uint32_t moved = 0;
    if (width_modulated())
      part_ = static_cast<std::uint32_t>((std::uint64_t{part_} + elapsed_us) % (period_ms_ * 1000U));
    else if (train())
      moved = put_out(elapsed_us);
    if (in_use())
      show();
    return moved;
  }

  // ---- what a host is told
  std::uint32_t frequency() const noexcept {
    if (!busy())
      return 0;
    return order_.ramp.exists() ? order_.ramp.frequency(order_.ramp.level_at(distance())) : order_.frequency;
  }
  std::uint32_t remaining() const noexcept { return remaining_; }
  bool forward() const noexcept { return order_.forward; }
  std::uint16_t on_ms() const noexcept { return on_ms_; }
  std::uint16_t period_ms() const noexcept { return width_modulated() ? period_ms_ : std::uint16_t{0}; }

private:
  enum class Use : std::uint8_t { None, Train, Width };

  void begin(Use use, BitTarget output) noexcept {
    use_ = use;
    output_ = output;
    part_ = 0;
    done_ = 0;
    finished_ = aborted_ = false;
    ++ticket_;
  }
  void show() const noexcept { output_ = bit(width_modulated() ? part_ < on_ms_ * 1000U : busy() && part_ < kPulse / 2); }
  /// Pulses between the present one and the nearer end of the run.
  std::uint32_t distance() const noexcept { return done_ < remaining_ ? done_ : remaining_ - 1; }

  /// How many pulses the present speed holds for.
  std::uint64_t stretch() const noexcept {
    if (order_.count == 0)
      return ~std::uint64_t{0} / kPulse;
    const SpeedRamp &ramp = order_.ramp;
    if (!ramp.exists())
      return remaining_;
    const std::uint32_t level = ramp.level_at(distance());
    if (level == ramp.levels() || done_ >= remaining_)
      return remaining_ - ramp.pulses(level - 1);
    const std::uint32_t rise = ramp.pulses(level) - done_, middle = (remaining_ - 1 - done_) / 2 + 1;
    return rise < middle ? rise : middle;
  }

  std::uint32_t put_out(std::uint64_t time_us) noexcept {
    std::uint32_t out = 0;
    while (busy()) {
      const std::uint64_t speed = frequency(), parts = part_ + speed * time_us, most = stretch();
      if (parts / kPulse < most) {
        out += count(static_cast<std::uint32_t>(parts / kPulse));
        part_ = static_cast<std::uint32_t>(parts % kPulse);
        break;
      }
      time_us -= (most * kPulse - part_ + speed - 1) / speed;
      part_ = 0;
      out += count(static_cast<std::uint32_t>(most));
      if (remaining_ == 0) {
        finished_ = !aborted_;
        stop();
      }
    }
    return order_.forward ? out : 0U - out;
  }
  std::uint32_t count(std::uint32_t pulses) noexcept {
    done_ += pulses;
    if (order_.count != 0)
      remaining_ -= pulses;
    return pulses;
  }

  PulseOrder order_;
  std::uint32_t done_ = 0, remaining_ = 0;
  std::uint32_t part_ = 0;  ///< of the present pulse, millionths; of the present period, microseconds
  std::uint32_t ticket_ = 0;
  std::uint16_t on_ms_ = 0, period_ms_ = 1;
  Use use_ = Use::None;
  bool rested_ = true, finished_ = false, aborted_ = false;
  BitTarget output_;
};

}  // namespace ladder::tp03
