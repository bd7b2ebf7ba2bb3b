// A serial line: the format that a register asks for, and when the next byte can go out.
//
// Bytes are handed to the host when their turn on the line has come, so many in a scan as its time allows; the line is busy with
// each for as long as its bits take.
#pragma once

#include "ladder/bit.h"
#include "ladder/io.h"
#include "ladder/number.h"

#include <cstdint>

namespace ladder::tp03 {
namespace detail {

/// D8120 and D8320: b0 eight data bits, b2 b1 parity, b3 two stop bits, b7-b4 the rate. Rates that the manual does not have are
/// 9600, and both parity bits together are even parity.
constexpr SerialFormat serial_format(word setting) noexcept {
  constexpr std::uint32_t kRates[16] = {9600,  9600,  9600,  9600,  9600,   9600,   9600,   9600,
                                        19200, 38400, 57600, 76800, 128000, 153600, 307200, 9600};
  const std::uint32_t bits = pattern_of(setting);
  const std::uint32_t parity = bits >> 1 & 3U;
  return {kRates[bits >> 4 & 0xFU], static_cast<std::uint8_t>((bits & 1U) != 0 ? 8 : 7),
          static_cast<std::uint8_t>((bits & 8U) != 0 ? 2 : 1),
          parity == 0   ? 'N'
          : parity == 1 ? 'O'
                        : 'E'};
}

constexpr unsigned bits_of(const SerialFormat &format) noexcept {
  return 1U + format.data_bits + (format.parity == 'N' ? 0U : 1U) + format.stop_bits;
}

/// Time-outs are given in 10 ms; what is not 5 to 255 means 50 ms.
constexpr std::uint32_t timeout_us(word setting) noexcept {
  return (setting >= 5 && setting <= 255 ? static_cast<std::uint32_t>(setting) : 5U) * 10000U;
}
/// Times that are only compared with limits stop at the largest number.
constexpr std::uint32_t add_time(std::uint32_t a, std::uint32_t b) noexcept {
  return a + b < a ? 0xFFFFFFFFU : a + b;
}

}  // namespace detail

class SerialLine {
public:
  void open(unsigned port, const SerialFormat &format, Io &io) noexcept {
    port_ = static_cast<std::uint8_t>(port);
    byte_ns_ = detail::bits_of(format) * (1000000000U / format.baud);
    begin();
    io.open_serial(port, format);
    while (io.read_serial(port) >= 0) {
      // what came before nobody waits for
    }
  }
  /// A text begins now: time that has gone by already is not for it.
  void begin() noexcept {
    time_ns_ = 0;
    busy_ns_ = 0;
  }
  /// A scan has gone by.
  void pass(std::uint32_t elapsed_us) noexcept {
    time_ns_ = std::uint64_t{elapsed_us} * 1000U;
    spend();
  }
  /// The last byte is out and there is time for another one.
  bool free() const noexcept { return busy_ns_ == 0; }
  /// False where the host does not take the byte; it is asked again in the next scan.
  bool send(std::uint8_t byte, Io &io) noexcept {
    if (!io.write_serial(port_, byte))
      return false;
    busy_ns_ = byte_ns_;
    spend();
    return true;
  }
  int receive(Io &io) const noexcept { return io.read_serial(port_); }

private:
  void spend() noexcept {
    const std::uint64_t spent = time_ns_ < busy_ns_ ? time_ns_ : busy_ns_;
    time_ns_ -= spent;
    busy_ns_ -= static_cast<std::uint32_t>(spent);
  }

  std::uint64_t time_ns_ = 0;                ///< left of this scan
  std::uint32_t byte_ns_ = 0, busy_ns_ = 0;  ///< of a byte; of the one on the line
  std::uint8_t port_ = 0;
};

}  // namespace ladder::tp03
