// What goes over the line around the data of RS and MBUS: start and end characters, check codes, hexadecimal characters.
//
// A frame tells how many bytes m bytes of data become and which the i-th is, and takes received bytes one by one. Bytes are asked
// for in order; sent() follows where the line has taken one. Received data go to `store`, a check code never does: the last bytes
// are held back until it is known that others follow.
//
// Where the manual is silent: start and end characters are neither stored nor counted, and so are check codes; what comes before a
// start character, or before the ':' of Modbus ASCII, is not looked at; a telegram without its end characters that a pause ended is
// judged by its check code alone.
#pragma once

#include "ladder/number.h"
#include "ladder/tp03/ops/text.h"

#include <cstdint>

namespace ladder::tp03 {

enum class Received : std::uint8_t {
  Nothing,  ///< does not belong to a telegram
  Start,    ///< a telegram begins; what came of one before does not count
  Part,
  End,  ///< the telegram is complete
};

/// CRC-16 of Modbus: start with FFFF, low byte first on the line. Behind the low byte the high one is left; behind both, 0.
constexpr std::uint16_t modbus_crc(std::uint16_t crc, std::uint8_t byte) noexcept {
  std::uint32_t value = std::uint32_t{crc} ^ byte;
  for (unsigned i = 0; i < 8; ++i)
    value = (value & 1U) != 0 ? value >> 1 ^ 0xA001U : value >> 1;
  return static_cast<std::uint16_t>(value);
}

/// RS: the data, between a start and an end character where bits 8 and 9 of the format ask for them.
class PlainFrame {
public:
  static constexpr bool kChecks = false;

  /// The characters are those that D8124 and D8125 hold at this moment.
  void open(word format, word start, word end) noexcept {
    has_start_ = (pattern_of(format) >> 8 & 1U) != 0;
    has_end_ = (pattern_of(format) >> 9 & 1U) != 0;
    start_ = static_cast<std::uint8_t>(pattern_of(start));
    end_ = static_cast<std::uint8_t>(pattern_of(end));
  }

  void begin_sending() noexcept {}
  unsigned length(unsigned data) const noexcept { return data + (has_start_ ? 1U : 0U) + (has_end_ ? 1U : 0U); }
  template <class Data> std::uint8_t byte(unsigned i, unsigned count, Data data) const noexcept {
    const unsigned first = has_start_ ? 1 : 0;
    if (i < first)
      return start_;
    return i - first < count ? data(i - first) : end_;
  }
  void sent(unsigned, unsigned, std::uint8_t) noexcept {}
  /// Of the data, when i bytes of the frame are out.
  unsigned data_sent(unsigned i, unsigned count) const noexcept {
    const unsigned sent = has_start_ && i > 0 ? i - 1 : i;
    return sent < count ? sent : count;
  }

  void begin_receiving() noexcept { started_ = !has_start_; }
  template <class Store> Received receive(std::uint8_t byte, unsigned most, Store store) noexcept {
    if (!started_) {
      started_ = byte == start_;
      return started_ ? Received::Start : Received::Nothing;
    }
    if (has_end_ && byte == end_)
      return Received::End;
    return store(byte) == most ? Received::End : Received::Part;
  }
  bool correct() const noexcept { return true; }

private:
  std::uint8_t start_ = 0, end_ = 0;
  bool has_start_ = false, has_end_ = false, started_ = false;
};

/// MBUS: RTU, or ASCII where bit 13 of the format is set.
class ModbusFrame {
public:
  static constexpr bool kChecks = true;

  void open(word format, word, word) noexcept { ascii_ = (pattern_of(format) >> 13 & 1U) != 0; }

  void begin_sending() noexcept {
    crc_ = 0xFFFF;
    sum_ = 0;
  }
  unsigned length(unsigned data) const noexcept { return ascii_ ? 1 + 2 * data + 2 + 2 : data + 2; }
  template <class Data> std::uint8_t byte(unsigned i, unsigned count, Data data) noexcept {
    if (!ascii_)
      return i < count ? data(i) : static_cast<std::uint8_t>(crc_);
    if (i == 0)
      return ':';
    const unsigned place = (i - 1) / 2;
    if (place > count)
      return i % 2 != 0 ? '\r' : '\n';
    if (i % 2 != 0)  // both characters are of the byte as it is now
      current_ = place < count ? data(place) : static_cast<std::uint8_t>(0U - sum_);
    return detail::hex_character(i % 2 != 0 ? current_ >> 4 : current_ & 0xFU);
  }
  void sent(unsigned i, unsigned count, std::uint8_t byte) noexcept {
    crc_ = modbus_crc(crc_, byte);
    if (i > 0 && i % 2 == 0 && (i - 1) / 2 < count)
      sum_ = static_cast<std::uint8_t>(sum_ + current_);
  }
  unsigned data_sent(unsigned i, unsigned count) const noexcept {
    const unsigned sent = ascii_ ? (i > 0 ? (i - 1) / 2 : 0) : i;
    return sent < count ? sent : count;
  }

  void begin_receiving() noexcept {
    crc_ = 0xFFFF;
    sum_ = 0;
    bytes_ = 0;
    started_ = !ascii_;
    half_ = wrong_ = ended_ = false;
  }
  template <class Store> Received receive(std::uint8_t byte, unsigned most, Store store) noexcept {
    if (ascii_)
      return receive_character(byte, most, store);
    crc_ = modbus_crc(crc_, byte);
    hold(byte, 2, store);
    return bytes_ == most + 2 ? Received::End : Received::Part;
  }
  /// Of what has been received.
  bool correct() const noexcept {
    if (ascii_)
      return !wrong_ && !half_ && bytes_ >= 2 && sum_ == 0;
    return bytes_ > 2 && crc_ == 0;
  }

private:
  /// The last `check` bytes may be the check code.
  template <class Store> void hold(std::uint8_t byte, unsigned check, Store store) noexcept {
    if (bytes_ >= check)
      store(held_[check - 1]);
    held_[1] = held_[0];
    held_[0] = byte;
    ++bytes_;
  }
  template <class Store> Received receive_character(std::uint8_t byte, unsigned most, Store store) noexcept {
    const std::uint32_t digit = detail::hex_digit(byte);
    if (byte == ':') {
      begin_receiving();
      started_ = true;
      return Received::Start;
    }
    if (!started_)
      return Received::Nothing;
    if (ended_ || (digit > 0xF && byte != '\r')) {
      wrong_ |= !ended_ || byte != '\n';
      return Received::End;
    }
    if (byte == '\r') {
      ended_ = true;
      return Received::Part;
    }
    half_ = !half_;
    if (half_) {
      current_ = static_cast<std::uint8_t>(digit << 4);
      return Received::Part;
    }
    if (bytes_ > most) {
      wrong_ = true;
      return Received::End;
    }
    const auto whole = static_cast<std::uint8_t>(current_ | digit);
    sum_ = static_cast<std::uint8_t>(sum_ + whole);
    hold(whole, 1, store);
    return Received::Part;
  }

  std::uint16_t crc_ = 0xFFFF, bytes_ = 0;
  std::uint8_t held_[2] = {};
  std::uint8_t sum_ = 0, current_ = 0;
  bool ascii_ = false, started_ = false, half_ = false, wrong_ = false, ended_ = false;
};

}  // namespace ladder::tp03
