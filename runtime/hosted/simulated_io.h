// What a scenario connects to a controller: serial lines with a script, potentiometers, an option card.
#pragma once

#include "ladder/io.h"

#include <cstdint>
#include <map>
#include <vector>

namespace ladder::hosted {

class SimulatedIo final : public Io {
public:
  using Bytes = std::vector<std::uint8_t>;

  /// The bytes arrive together when the time has come, and wait there until the program reads them.
  void send_to_program(unsigned port, std::uint64_t at_us, const Bytes &bytes);
  void set_potentiometer(unsigned number, std::uint16_t position) { potentiometers_[number] = position; }
  void set_option_input(unsigned channel, std::uint16_t value) { option_inputs_[channel] = value; }

  /// Of the scan that follows.
  void set_time(std::uint64_t now_us) { now_us_ = now_us; }
  /// What the program has sent since this was asked for the last time.
  Bytes take_sent(unsigned port);

  int read_serial(unsigned port) noexcept override;
  bool write_serial(unsigned port, std::uint8_t byte) noexcept override;
  std::uint16_t potentiometer(unsigned number) noexcept override { return at(potentiometers_, number); }
  std::uint16_t option_input(unsigned channel) noexcept override { return at(option_inputs_, channel); }

private:
  using Values = std::map<unsigned, std::uint16_t>;
  static std::uint16_t at(const Values &values, unsigned number) noexcept {
    auto found = values.find(number);
    return found == values.end() ? std::uint16_t{0} : found->second;
  }

  std::map<unsigned, std::multimap<std::uint64_t, std::uint8_t>> arriving_;  ///< by port, then by time
  std::map<unsigned, Bytes> sent_;
  Values potentiometers_, option_inputs_;
  std::uint64_t now_us_ = 0;
};

}  // namespace ladder::hosted
