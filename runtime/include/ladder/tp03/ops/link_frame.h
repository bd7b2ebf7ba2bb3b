// The telegrams of DTLK, DTLK2 and RMIO. The maker's are not in the manual, so these are of our own; their lengths make the
// manual's table of times come out. A link therefore works between programs of this compiler only.
//
//     ':'  station  command  counter  data ...  LRC  CR LF
//
// Everything between ':' and CR is written as pairs of hexadecimal characters 0-9, A-F, words with the high byte first. The LRC is
// the two's complement of the sum of all bytes before it.
//
// command        station        data
// 1 settings     0              number of slaves, layout, time-out in 10 ms, retries: one byte each
// 2 request      whom it asks   RMIO: the outputs for that slave; DTLK, DTLK2: nothing
// 3 data         who sends it   what the station shares
//
// The layout byte is 0, 1 or 2 with DTLK (its refresh modes), 80H + words with DTLK2, 40H with RMIO. The counter is that of the
// request; an answer repeats it. The master begins each round with the settings, then sends its own data (not with RMIO), and asks
// one slave after the other. All stations hear everything, so data go from each to all without being repeated by the master.
#pragma once

#include "ladder/number.h"
#include "ladder/tp03/ops/text.h"

#include <cstdint>

namespace ladder::tp03 {

enum class LinkCommand : std::uint8_t { Settings = 1, Request = 2, Data = 3 };

/// A telegram on its way out.
template <unsigned MostWords> class LinkSender {
public:
  void begin(unsigned station, LinkCommand command, std::uint8_t counter) noexcept {
    length_ = sent_ = 0;
    sum_ = 0;
    text_[length_++] = ':';
    add(station);
    add(static_cast<unsigned>(command));
    add(counter);
  }
  void add(unsigned byte) noexcept {
    sum_ = static_cast<std::uint8_t>(sum_ + byte);
    text_[length_++] = detail::hex_character(byte >> 4 & 0xFU);
    text_[length_++] = detail::hex_character(byte & 0xFU);
  }
  void add_word(word value) noexcept {
    add(pattern_of(value) >> 8);
    add(pattern_of(value) & 0xFFU);
  }
  void end() noexcept {
    add(0x100U - sum_);
    text_[length_++] = '\r';
    text_[length_++] = '\n';
  }

  bool done() const noexcept { return sent_ == length_; }
  std::uint8_t next() const noexcept { return text_[sent_]; }
  void sent() noexcept { ++sent_; }

private:
  static constexpr unsigned kFrame = 11, kSettings = 8;
  std::uint8_t text_[kFrame + (4 * MostWords > kSettings ? 4 * MostWords : kSettings)];
  std::uint8_t length_ = 0, sent_ = 0, sum_ = 0;
};

/// A telegram as it comes in.
template <unsigned MostWords> class LinkReceiver {
public:
  enum class Event : std::uint8_t { Nothing, Telegram, Damaged };

  void restart() noexcept { started_ = false; }
  /// Telegram: it is complete and its check code right, and can be looked at until the next call.
  Event take(std::uint8_t byte) noexcept {
    if (byte == ':') {
      const bool cut = started_;
      started_ = true;
      half_ = ended_ = false;
      length_ = sum_ = 0;
      return cut ? Event::Damaged : Event::Nothing;
    }
    if (!started_)
      return Event::Nothing;
    if (byte == '\r' && !ended_ && !half_) {
      ended_ = true;
      return Event::Nothing;
    }
    if (byte == '\n' && ended_) {
      started_ = false;
      return length_ >= kHeader + 1 && sum_ == 0 ? Event::Telegram : Event::Damaged;
    }
    const std::uint32_t digit = detail::hex_digit(byte);
    if (digit > 0xF || ended_ || length_ == kMost) {
      started_ = false;
      return Event::Damaged;
    }
    half_ = !half_;
    if (half_) {
      bytes_[length_] = static_cast<std::uint8_t>(digit << 4);
    } else {
      bytes_[length_] = static_cast<std::uint8_t>(bytes_[length_] | digit);
      sum_ = static_cast<std::uint8_t>(sum_ + bytes_[length_++]);
    }
    return Event::Nothing;
  }

  unsigned station() const noexcept { return bytes_[0]; }
  unsigned command() const noexcept { return bytes_[1]; }
  std::uint8_t counter() const noexcept { return bytes_[2]; }
  bool is(LinkCommand command) const noexcept { return bytes_[1] == static_cast<std::uint8_t>(command); }
  unsigned data_bytes() const noexcept { return length_ - kHeader - 1U; }
  unsigned byte(unsigned i) const noexcept { return bytes_[kHeader + i]; }
  word data_word(unsigned i) const noexcept { return to_word(byte(2 * i) << 8 | byte(2 * i + 1)); }

private:
  static constexpr unsigned kHeader = 3, kSettings = 4;
  static constexpr unsigned kMost = kHeader + 1 + (2 * MostWords > kSettings ? 2 * MostWords : kSettings);
  std::uint8_t bytes_[kMost] = {};
  std::uint8_t length_ = 0, sum_ = 0;
  bool started_ = false, half_ = false, ended_ = false;
};

}  // namespace ladder::tp03
