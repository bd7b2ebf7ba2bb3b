// Pulse outputs Y0 and Y1 of the system: what the instructions PLSY, PWM, PLSR, ZRN, PLSV, DRVI and DRVA start and stop.
//
// Positions are in D8140-D8143 (a pair for each output; PLSY and PLSR count there too), M8147 and M8148 are ON while pulses go out,
// M8145 and M8146 stop them. The host hears of every start, change and stop through Io.
#pragma once

#include "ladder/bit.h"
#include "ladder/blocks.h"
#include "ladder/io.h"
#include "ladder/number.h"
#include "ladder/tp03/pulse_channel.h"

#include <cstdint>

namespace ladder::tp03 {

class Pulses {
public:
  static constexpr unsigned kChannels = 2;
  static constexpr unsigned kPosition = 8140;       ///< D: the pair of channel 0; that of channel 1 follows
  static constexpr unsigned kStop = 8145;           ///< M
  static constexpr unsigned kBusy = 8147;           ///< M
  static constexpr std::uint32_t kClearUs = 20000;  ///< least length of the clear signal of ZRN

  /// Power comes on, or the switch goes to STOP: all outputs stop. The relays, and the host, see it with the next advance().
  void restart() noexcept {
    for (Channel &each : channels_) {
      if (each.pulses.in_use())
        each.pulses.stop();
      if (each.clear_us != 0)
        each.clear = off;
      each.clear_us = 0;
    }
    ++epoch_;
  }
  /// Changes with restart(): what an instruction remembers from before is over.
  std::uint32_t epoch() const noexcept { return epoch_; }

  /// Time passes, before the program is executed.
  template <class M, class D> void advance(std::uint32_t elapsed_us, M &m, D &d, Io &io) noexcept {
    for (unsigned channel = 0; channel < kChannels; ++channel) {
      Channel &each = channels_[channel];
      if (const std::uint32_t moved = each.pulses.advance(elapsed_us); moved != 0) {
        auto position = d.pair(kPosition + 2 * channel);
        position = to_dword(pattern_of(static_cast<dword>(position)) + moved);
      }
      if (m[kStop + channel] && each.pulses.train())
        each.pulses.stop();
      if (each.clear_us != 0 && elapsed_us >= each.clear_us)
        each.clear = off;
      each.clear_us = elapsed_us < each.clear_us ? each.clear_us - elapsed_us : 0;
      show(channel, m, io);
    }
  }

  PulseChannel &operator[](unsigned channel) noexcept { return channels_[channel].pulses; }

  /// The relay, and the host, see what an instruction has done to a channel.
  template <class M> void show(unsigned channel, M &m, Io &io) noexcept {
    Channel &each = channels_[channel];
    const PulseChannel &pulses = each.pulses;
    m[kBusy + channel] = bit(pulses.busy());
    const Told now = {pulses.frequency(), pulses.forward(), pulses.on_ms(), pulses.period_ms()};
    if (now.frequency != each.told.frequency || (now.frequency != 0 && now.forward != each.told.forward))
      io.pulse_output(channel, now.frequency, now.frequency != 0 ? pulses.remaining() : 0, now.forward);
    if (now.period_ms != each.told.period_ms || (now.period_ms != 0 && now.on_ms != each.told.on_ms))
      io.width_output(channel, now.on_ms, now.period_ms);
    each.told = now;
  }

  /// ZRN has found the origin: the signal that clears a servo's deviation counter.
  void clear_servo(unsigned channel, BitTarget target) noexcept {
    Channel &each = channels_[channel];
    each.clear = target;
    each.clear = on;
    each.clear_us = kClearUs;
  }

private:
  struct Told {
    std::uint32_t frequency = 0;
    bool forward = true;
    std::uint16_t on_ms = 0, period_ms = 0;
  };
  struct Channel {
    PulseChannel pulses;
    Told told;
    BitTarget clear;
    std::uint32_t clear_us = 0;
  };

  Channel channels_[kChannels];
  std::uint32_t epoch_ = 0;
};

}  // namespace ladder::tp03
