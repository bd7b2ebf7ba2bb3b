// A station of a link: the master asks one slave after the other, a slave listens and answers. What is exchanged is the business of
// an Area, which special devices tell of it that of Rules; link.h has both for DTLK, DTLK2 and RMIO.
//
// Where the manual is silent:
// * The settings count as they are behind the first scan of RUN; values out of range are the defaults, but a station number out of
//   range is error 6706 and no link.
// * The master tries a slave D8179 times, at least once; a slave that is in error already gets one try in each round.
// * An error relay goes OFF, and its code becomes 0, when the station is heard again; the counts stay. A count is of turns that
//   failed, not of tries.
// * A slave misses the master when it has heard it before and then nothing for ten times the time-out. Without a master it waits.
// * While an error relay is ON, so is M8063, with 6301 or 6302 in D8063. The program goes on.
// * Telegrams need scans to be seen and answered; the scan is not made longer.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/ops/link_frame.h"
#include "ladder/tp03/ops/serial_line.h"
#include "ladder/tp03/ports.h"

#include <cstdint>

namespace ladder::tp03 {

/// Numbers of special devices. Each run goes over the stations, the master first.
struct LinkDevices {
  unsigned settings;    ///< D: own station, slaves, layout, retries, time-out
  unsigned copies;      ///< D: own station, slaves, layout
  unsigned times;       ///< D: of the last round, of the longest
  unsigned counts;      ///< D: of errors
  unsigned codes;       ///< D: of errors
  unsigned errors;      ///< M
  unsigned running;     ///< M
  unsigned on_port[2];  ///< M
};

/// What the code registers show. First digit 0: found by the master, 1: in the master by a slave, 2: in a slave by another one.
namespace link_error {
inline constexpr std::uint8_t kNone = 0, kNoAnswer = 0x01, kStation = 0x02, kThird = 0x03, kForm = 0x04;
inline constexpr std::uint8_t kMasterSilent = 0x11, kMasterCommand = 0x13, kMasterForm = 0x14;
inline constexpr std::uint8_t kMissing = 0x21, kSeenStation = 0x22, kSeenThird = 0x23, kSeenForm = 0x24;
inline constexpr std::uint8_t kNoSettings = 0x31, kSeenCommand = 0x32;
}  // namespace link_error

template <class Rules> class LinkStation {
protected:
  /// To be called in every scan.
  template <class Area, class S> Fault exchange(bit condition, word port, const Area &area, S &sys) noexcept {
    port_ = port == 1 ? 1 : 0;
    settle(sys);
    if (!condition) {
      stop(sys);
      return Fault::None;
    }
    if (!settled_)
      return Fault::None;
    if (own_ > Rules::kMostSlaves)
      return Fault::Range;
    if (!(active_ && sys.ports.has(port_, this)) && !start(sys))
      return Fault::None;
    line_.pass(sys.elapsed_us());
    silence_us_ = detail::add_time(silence_us_, sys.elapsed_us());
    round_us_ = detail::add_time(round_us_, sys.elapsed_us());
    own_ == 0 ? master(area, sys) : slave(area, sys);
    show_errors(sys);
    return Fault::None;
  }
  /// The highest station whose area this one must have: the last slave for the master, a slave itself.
  unsigned last_station() const noexcept { return own_ != 0 ? own_ : slaves_; }
  /// The settings of this RUN.
  template <class S> void settle(S &sys) noexcept {
    if (sys.first_scan()) {
      settled_ = false;
      return;
    }
    if (settled_)
      return;
    settled_ = true;
    const auto setting = [&](unsigned place, word least, word most, word normal) {
      const word value = sys.D[kDevices.settings + place];
      return static_cast<std::uint8_t>(value >= least && value <= most ? value : normal);
    };
    own_ = setting(0, 0, static_cast<word>(Rules::kMostSlaves), 0xFF);
    slaves_ = setting(1, 1, static_cast<word>(Rules::kMostSlaves), Rules::kSlaves);
    layout_ = setting(2, 0, 2, 0);
    retries_ = setting(3, 0, kMostRetries, kRetries);
    timeout_ = setting(4, kTimeout, kMostTimeout, kTimeout);
    sys.D[kDevices.copies] = sys.D[kDevices.settings];
    show_settings(sys);
  }

private:
  static constexpr LinkDevices kDevices = Rules::kDevices;
  static constexpr word kMostRetries = 10, kRetries = 3, kMostTimeout = 255, kTimeout = 5;
  static constexpr unsigned kFormat = 8120, kError = 8063;
  static constexpr std::uint32_t kPatience = 10;  ///< time-outs without a word of the master
  using Receiver = LinkReceiver<Rules::kMostWords>;
  enum class Turn : std::uint8_t { Settings, OwnData, Request, Answer };

  // ---- start and end
  template <class S> void show_settings(S &sys) noexcept {
    sys.D[kDevices.copies + 1] = slaves_;
    if (Rules::kShowsLayout)
      sys.D[kDevices.copies + 2] = layout_;
  }
  template <class S> bool start(S &sys) noexcept {
    active_ = false;
    if (!sys.ports.claim(port_, this))
      return false;
    if (!sys.ports.claim(Rules::kResource, this)) {
      sys.ports.release(port_, this);
      return false;
    }
    active_ = true;
    line_.open(port_, detail::serial_format(sys.D[kFormat + 200U * port_]), sys.io());
    receiver_.restart();
    turn_ = Turn::Settings;
    sending_ = heard_ = configured_ = timing_ = false;
    expected_ = counter_ = 0;
    for (unsigned station = 0; station <= Rules::kMostSlaves; ++station)
      clear(station, sys);
    sys.M[kDevices.on_port[port_]] = on;
    return true;
  }
  template <class S> void stop(S &sys) noexcept {
    if (!active_)
      return;
    active_ = false;
    if (sys.ports.claim(Rules::kResource, this)) {  // nobody else shows these relays now
      sys.M[kDevices.running] = off;
      sys.M[kDevices.on_port[0]] = off;
      sys.M[kDevices.on_port[1]] = off;
      sys.ports.release(Rules::kResource, this);
    }
    sys.ports.release(port_, this);
  }

  // ---- errors
  template <class S> void clear(unsigned station, S &sys) noexcept {
    sys.M[kDevices.errors + station] = off;
    sys.D[kDevices.codes + station] = 0;
  }
  template <class S> void flag(unsigned station, std::uint8_t code, S &sys) noexcept {
    sys.M[kDevices.errors + station] = on;
    sys.D[kDevices.codes + station] = code;
    word &count = sys.D[kDevices.counts + station];
    if (count < 32767)
      ++count;
  }
  template <class S> void show_errors(S &sys) noexcept {
    bit any{};
    for (unsigned station = 0; station <= Rules::kMostSlaves; ++station)
      any |= sys.M[kDevices.errors + station];
    word &code = sys.D[kError];
    if (any) {
      sys.M[kError] = on;
      code = Rules::kErrorCode;
    } else if (code == Rules::kErrorCode) {
      sys.M[kError] = off;
      code = 0;
    }
  }

  // ---- both
  /// True when the telegram is out.
  template <class S> bool pump(S &sys) noexcept {
    while (line_.free() && !sender_.done()) {
      if (!line_.send(sender_.next(), sys.io()))
        return false;
      sender_.sent();
    }
    if (!line_.free() || !sender_.done())
      return false;
    sending_ = false;
    silence_us_ = 0;
    return true;
  }
  template <class Area> void send_own_data(const Area &area, std::uint8_t counter) noexcept {
    sender_.begin(own_, LinkCommand::Data, counter);
    for (unsigned i = 0; i < area.data_words(layout_); ++i)
      sender_.add_word(area.data_word(layout_, own_, i));
    sender_.end();
    sending_ = true;
  }
  template <class Area> void take_data(const Area &area, unsigned station) noexcept {
    for (unsigned i = 0; i < area.data_words(layout_); ++i)
      area.take_data(layout_, station, i, receiver_.data_word(i));
  }
  template <class S> void measure_round(S &sys) noexcept {
    if (timing_) {
      const std::uint32_t tens = round_us_ / 10000U + (round_us_ % 10000U >= 5000U ? 1U : 0U);
      const word time = static_cast<word>(tens < 32767U ? tens : 32767U);
      sys.D[kDevices.times] = time;
      if (time > sys.D[kDevices.times + 1])
        sys.D[kDevices.times + 1] = time;
    }
    timing_ = true;
    round_us_ = 0;
  }

  // ---- master
  template <class Area, class S> void master(const Area &area, S &sys) noexcept {
    for (;;) {
      if (sending_ && !pump(sys))
        return;
      if (turn_ == Turn::Answer && !listen(area, sys))
        return;
      speak(area, sys);
    }
  }
  template <class Area, class S> void speak(const Area &area, S &sys) noexcept {
    switch (turn_) {
    case Turn::Settings:
      measure_round(sys);
      layout_ = area.layout(layout_);
      sender_.begin(0, LinkCommand::Settings, counter_);
      sender_.add(slaves_);
      sender_.add(layout_);
      sender_.add(timeout_);
      sender_.add(retries_);
      sender_.end();
      turn_ = Rules::kShared ? Turn::OwnData : Turn::Request;
      slave_ = 1;
      tries_ = 0;
      break;
    case Turn::OwnData:
      send_own_data(area, counter_);
      turn_ = Turn::Request;
      break;
    case Turn::Request:
    case Turn::Answer:
      while (line_.receive(sys.io()) >= 0) {
        // an answer that is too late
      }
      receiver_.restart();
      sender_.begin(slave_, LinkCommand::Request, ++counter_);
      for (unsigned i = 0; i < area.request_words(); ++i)
        sender_.add_word(area.request_word(slave_, i));
      sender_.end();
      turn_ = Turn::Answer;
      break;
    }
    sending_ = true;
  }
  /// True when the slave's turn is over.
  template <class Area, class S> bool listen(const Area &area, S &sys) noexcept {
    for (int byte = line_.receive(sys.io()); byte >= 0; byte = line_.receive(sys.io())) {
      silence_us_ = 0;
      const auto event = receiver_.take(static_cast<std::uint8_t>(byte));
      if (event == Receiver::Event::Nothing)
        continue;
      judge(event == Receiver::Event::Telegram ? check_answer(area) : link_error::kForm, area, sys);
      return true;
    }
    if (silence_us_ < timeout_ * 10000U)
      return false;
    judge(link_error::kNoAnswer, area, sys);
    return true;
  }
  template <class Area> std::uint8_t check_answer(const Area &area) const noexcept {
    if (!receiver_.is(LinkCommand::Data))
      return Rules::kWrongCommand;
    if (receiver_.station() != slave_)
      return link_error::kStation;
    if (receiver_.counter() != counter_)
      return Rules::kWrongCounter;
    return receiver_.data_bytes() == 2 * area.data_words(layout_) ? link_error::kNone : link_error::kForm;
  }
  template <class Area, class S> void judge(std::uint8_t error, const Area &area, S &sys) noexcept {
    line_.begin();
    turn_ = Turn::Request;
    if (error != link_error::kNone && ++tries_ < retries_ && !sys.M[kDevices.errors + slave_])
      return;
    tries_ = 0;
    if (error != link_error::kNone) {
      flag(slave_, error, sys);
    } else {
      take_data(area, slave_);
      clear(slave_, sys);
      heard_ = true;
      sys.M[kDevices.running] = on;
    }
    if (slave_++ < slaves_)
      return;
    turn_ = Turn::Settings;
    sys.M[kDevices.running] = bit(heard_);
    heard_ = false;
  }

  // ---- slave
  template <class Area, class S> void slave(const Area &area, S &sys) noexcept {
    for (;;) {
      if (sending_ && !pump(sys))
        return;
      const int byte = line_.receive(sys.io());
      if (byte < 0)
        break;
      switch (receiver_.take(static_cast<std::uint8_t>(byte))) {
      case Receiver::Event::Nothing:
        break;
      case Receiver::Event::Telegram:
        understand(area, sys);
        break;
      case Receiver::Event::Damaged:
        blame(Rules::kSeenForm, link_error::kMasterForm, sys);
        break;
      }
    }
    if (!heard_ || silence_us_ < kPatience * timeout_ * 10000U)
      return;
    flag(0, link_error::kMasterSilent, sys);
    heard_ = configured_ = timing_ = false;
    expected_ = 0;
    sys.M[kDevices.running] = off;
    area.master_lost();
  }
  /// A telegram is wrong that only the slave that was asked can have sent, or else the master.
  template <class S> void blame(std::uint8_t slave_code, std::uint8_t master_code, S &sys) noexcept {
    if (expected_ != 0)
      flag(expected_, slave_code, sys);
    else
      flag(0, master_code, sys);
    expected_ = 0;
  }
  template <class Area, class S> void understand(const Area &area, S &sys) noexcept {
    const unsigned station = receiver_.station();
    if (receiver_.is(LinkCommand::Data) && station != 0) {
      overhear(area, station, sys);
      return;
    }
    if (!receiver_.is(LinkCommand::Settings) && !receiver_.is(LinkCommand::Request) && !receiver_.is(LinkCommand::Data)) {
      blame(Rules::kSeenWrongCommand, Rules::kWrongCommandOfMaster, sys);
      return;
    }
    if (expected_ != 0)
      flag(expected_, link_error::kMissing, sys);
    expected_ = 0;
    heard_ = true;
    silence_us_ = 0;
    if (configured_)
      clear(0, sys);
    if (receiver_.is(LinkCommand::Settings))
      take_settings(area, sys);
    else if (receiver_.is(LinkCommand::Data))
      hear(area, 0, link_error::kMasterForm, sys);
    else if (station == own_)
      answer(area, sys);
    else if (station <= Rules::kMostSlaves)
      expect(station);
  }
  void expect(unsigned station) noexcept {
    expected_ = static_cast<std::uint8_t>(station);
    counter_ = receiver_.counter();
  }
  template <class Area, class S> void take_settings(const Area &area, S &sys) noexcept {
    configured_ = receiver_.data_bytes() == 4 && area.accepts(receiver_.byte(1));
    if (!configured_) {
      flag(0, link_error::kMasterForm, sys);
      return;
    }
    slaves_ = static_cast<std::uint8_t>(receiver_.byte(0));
    layout_ = static_cast<std::uint8_t>(receiver_.byte(1));
    timeout_ = static_cast<std::uint8_t>(receiver_.byte(2));
    show_settings(sys);
    measure_round(sys);
    clear(0, sys);
    clear(own_, sys);
    sys.M[kDevices.running] = on;
  }
  template <class Area, class S> void answer(const Area &area, S &sys) noexcept {
    if (!configured_) {
      flag(own_, link_error::kNoSettings, sys);
      return;
    }
    if (receiver_.data_bytes() != 2 * area.request_words()) {
      flag(0, link_error::kMasterForm, sys);
      return;
    }
    for (unsigned i = 0; i < area.request_words(); ++i)
      area.take_request(i, receiver_.data_word(i));
    line_.begin();
    send_own_data(area, receiver_.counter());
  }
  template <class Area, class S> void hear(const Area &area, unsigned station, std::uint8_t code, S &sys) noexcept {
    if (!configured_)
      return;
    if (receiver_.data_bytes() != 2 * area.data_words(layout_)) {
      flag(station, code, sys);
      return;
    }
    clear(station, sys);
    if (Rules::kShared)
      take_data(area, station);
  }
  /// Another slave answers.
  template <class Area, class S> void overhear(const Area &area, unsigned station, S &sys) noexcept {
    if (expected_ == 0)
      return;  // its request did not come through
    if (station != expected_)
      flag(expected_, link_error::kSeenStation, sys);
    else if (receiver_.counter() != counter_)
      flag(expected_, Rules::kSeenWrongCounter, sys);
    else
      hear(area, station, Rules::kSeenForm, sys);
    expected_ = 0;
  }

  SerialLine line_;
  LinkSender<Rules::kMostWords> sender_;
  Receiver receiver_;
  std::uint32_t silence_us_ = 0, round_us_ = 0;
  Turn turn_ = Turn::Settings;
  std::uint8_t port_ = 0, own_ = 0, slaves_ = 0, layout_ = 0, retries_ = 0, timeout_ = 0;
  std::uint8_t slave_ = 1, tries_ = 0;  ///< of the master: whose turn it is
  std::uint8_t expected_ = 0;           ///< of a slave: whose answer comes next, 0: nobody's
  std::uint8_t counter_ = 0;            ///< of the last request
  bool active_ = false, settled_ = false, sending_ = false;
  bool heard_ = false;       ///< the master: a slave in this round; a slave: the master
  bool configured_ = false;  ///< a slave knows the settings
  bool timing_ = false;      ///< the round before has begun
};

}  // namespace ladder::tp03
