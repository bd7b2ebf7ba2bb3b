// Serial telegrams: F80 RS and F87 MBUS.
//
// Both are driven over many scans: they open the port, wait for telegrams, and send one where the program sets M8122. What is said
// here of M8121-M8129 and D8120-D8129, those of the built-in port, holds for M8321-M8329 and D8320-D8329 of the expansion port.
//
// Where the manual is silent: bytes that come while the port is sending are taken behind it, bytes that come between M8123 ON and
// its reset are lost. Sending reads the registers when the turn of each byte has come. A condition that goes OFF stops what is
// under way and resets M8121 and M8122; what was received stays, with M8123. A request for 0 bytes sends nothing and is reset at
// once. M8124 is reset together with M8123.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/ops/serial_frame.h"
#include "ladder/tp03/ops/serial_line.h"
#include "ladder/tp03/ops/text.h"
#include "ladder/tp03/ports.h"

#include <cstdint>

namespace ladder::tp03 {

template <class Frame> class SerialTransferOf {
public:
  template <class Source, class Target, class S>
  Fault run(bit condition, Source source, word m, Target target, word n, word port, S &sys) noexcept {
    port_ = port == 1 ? 1 : 0;
    if (!condition) {
      stop(sys);
      return Fault::None;
    }
    bytes_ = static_cast<bool>(static_cast<bit>(sys.M[detail::kByteMode]));
    if (!fits(source, m) || !fits(target, n))
      return Fault::Range;
    if (!(driven_ && sys.ports.has(port_, this)) && !start(n, sys))
      return Fault::None;
    most_ = static_cast<std::uint8_t>(n);
    follow_program(sys);
    if (sending_)
      send(source, sys);
    if (!sending_)
      receive(target, sys);
    if (sys.M[relay(kRequest)] && !sending_)
      request(source, static_cast<unsigned>(m), sys);
    return Fault::None;
  }

private:
  enum class Receiver : std::uint8_t { Closed, Waiting, Receiving, Complete };

  // M and D of the built-in port, 200 less than those of the expansion port.
  static constexpr unsigned kFormat = 8120, kWaits = 8121, kRequest = 8122, kLeft = 8122, kComplete = 8123, kCount = 8123;
  static constexpr unsigned kStart = 8124, kError = 8124, kEnd = 8125, kTimeout = 8129;
  static constexpr word kMost = 255;
  constexpr unsigned relay(unsigned number) const noexcept { return number + 200U * port_; }

  template <class Block> bool fits(const Block &block, word count) const noexcept {
    return count >= 0 && count <= kMost && detail::words_of(static_cast<unsigned>(count), bytes_) <= block.points();
  }

  template <class S> bool start(word n, S &sys) noexcept {
    driven_ = sys.ports.claim(port_, this);
    if (!driven_)
      return false;
    const word format = sys.D[relay(kFormat)];
    frame_.open(format, sys.D[relay(kStart)], sys.D[relay(kEnd)]);
    line_.open(port_, detail::serial_format(format), sys.io());
    sending_ = false;
    sys.M[relay(kWaits)] = off;
    sys.D[relay(kLeft)] = 0;
    receiver_ = sys.M[relay(kComplete)] ? Receiver::Complete : Receiver::Closed;
    if (receiver_ == Receiver::Closed && n > 0)
      wait(sys);
    return true;
  }
  template <class S> void stop(S &sys) noexcept {
    if (driven_ && sys.ports.has(port_, this)) {
      sys.M[relay(kWaits)] = off;
      sys.M[relay(kRequest)] = off;
      sys.ports.release(port_, this);
    }
    driven_ = sending_ = false;
  }

  // ---- receiving
  template <class S> void wait(S &sys) noexcept {
    receiver_ = Receiver::Waiting;
    frame_.begin_receiving();
    sys.D[relay(kCount)] = 0;
  }
  template <class S> void complete(bool in_time, S &sys) noexcept {
    receiver_ = Receiver::Complete;
    sys.M[relay(kComplete)] = on;
    if (!in_time)
      sys.M[relay(kTimeout)] = on;
    if (Frame::kChecks && !frame_.correct())
      sys.M[kError] = on;  // one relay for both ports
  }
  /// M8123 ON ends a reception, OFF begins to wait; without room for a byte nothing waits until M8123 has been ON and OFF again.
  template <class S> void follow_program(S &sys) noexcept {
    if (sys.M[relay(kComplete)]) {
      receiver_ = Receiver::Complete;
    } else if (receiver_ == Receiver::Complete) {
      sys.M[relay(kTimeout)] = off;
      if (Frame::kChecks)
        sys.M[kError] = off;
      receiver_ = Receiver::Closed;
      if (most_ > 0)
        wait(sys);
    } else if (most_ == 0) {
      receiver_ = Receiver::Closed;
    }
  }
  template <class Target, class S> void receive(Target target, S &sys) noexcept {
    const auto store = [&](std::uint8_t byte) {
      word &count = sys.D[relay(kCount)];
      if (count >= 0 && count < most_)
        detail::set_character(target, static_cast<unsigned>(count++), byte, bytes_);
      return static_cast<unsigned>(count);
    };
    bool heard = false;
    for (int byte = line_.receive(sys.io()); byte >= 0; byte = line_.receive(sys.io())) {
      if (receiver_ != Receiver::Waiting && receiver_ != Receiver::Receiving)
        continue;
      heard = true;
      switch (frame_.receive(static_cast<std::uint8_t>(byte), most_, store)) {
      case Received::Nothing:
        break;
      case Received::Start:
        sys.D[relay(kCount)] = 0;
        receiver_ = Receiver::Receiving;
        break;
      case Received::Part:
        receiver_ = Receiver::Receiving;
        break;
      case Received::End:
        complete(true, sys);
        break;
      }
    }
    pause_us_ = heard ? 0 : detail::add_time(pause_us_, sys.elapsed_us());
    if (receiver_ == Receiver::Receiving && pause_us_ >= detail::timeout_us(sys.D[relay(kTimeout)]))
      complete(false, sys);
  }

  // ---- sending
  template <class Source, class S> void request(Source source, unsigned count, S &sys) noexcept {
    const bool waits = receiver_ == Receiver::Receiving;
    sys.M[relay(kWaits)] = bit(waits);
    if (waits)
      return;
    count_ = static_cast<std::uint8_t>(count);
    sent_ = 0;
    sending_ = true;
    frame_.begin_sending();
    line_.begin();
    send(source, sys);
  }
  template <class Source, class S> void send(Source source, S &sys) noexcept {
    const auto data = [&](unsigned i) {  // M8161 may have changed since the length was checked
      return detail::words_of(i + 1, bytes_) <= source.points() ? detail::character(source, i, bytes_) : std::uint8_t{0};
    };
    const unsigned length = count_ == 0 ? 0 : frame_.length(count_);
    if (sent_ > 0)
      line_.pass(sys.elapsed_us());
    while (line_.free() && sent_ < length) {
      const std::uint8_t byte = frame_.byte(sent_, count_, data);
      if (!line_.send(byte, sys.io()))
        break;
      frame_.sent(sent_, count_, byte);
      ++sent_;
    }
    sys.D[relay(kLeft)] = to_word(count_ - frame_.data_sent(sent_, count_));
    if (sent_ < length || !line_.free())
      return;
    sending_ = false;
    sys.M[relay(kRequest)] = off;
    if (receiver_ == Receiver::Waiting)
      frame_.begin_receiving();
  }

  Frame frame_;
  SerialLine line_;
  std::uint32_t pause_us_ = 0;
  std::uint16_t sent_ = 0;             ///< bytes of the frame
  std::uint8_t count_ = 0, most_ = 0;  ///< bytes of data to send, and to receive
  Receiver receiver_ = Receiver::Closed;
  std::uint8_t port_ = 0;
  bool driven_ = false, sending_ = false, bytes_ = false;
};

using SerialTransfer = SerialTransferOf<PlainFrame>;
using Modbus = SerialTransferOf<ModbusFrame>;

}  // namespace ladder::tp03
