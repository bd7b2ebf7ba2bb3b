// As much of a TP03 as its panel and serial instructions see, with a script for its serial port.
#pragma once

#include "ladder/image.h"
#include "ladder/io.h"
#include "ladder/numbered.h"
#include "ladder/tp03/ports.h"

#include <cstdint>
#include <deque>
#include <vector>

namespace ladder::tp03 {

/// What is connected: bytes to be read, bytes that were written.
struct ScriptedIo : Io {
  std::deque<int> arriving[2];
  std::vector<std::uint8_t> sent[2];
  std::uint16_t positions[8] = {}, channels[8] = {};
  SerialFormat format{};
  bool takes = true;
  int opened = 0;

  void open_serial(unsigned, const SerialFormat &wanted) noexcept override {
    format = wanted;
    ++opened;
  }
  int read_serial(unsigned port) noexcept override {
    if (arriving[port].empty())
      return -1;
    const int byte = arriving[port].front();
    arriving[port].pop_front();
    return byte;
  }
  bool write_serial(unsigned port, std::uint8_t byte) noexcept override {
    if (takes)
      sent[port].push_back(byte);
    return takes;
  }
  std::uint16_t potentiometer(unsigned number) noexcept override { return positions[number]; }
  std::uint16_t option_input(unsigned channel) noexcept override { return channels[channel]; }

  template <class Bytes> void arrive(const Bytes &bytes, unsigned port = 0) {
    for (const auto byte : bytes)
      arriving[port].push_back(static_cast<std::uint8_t>(byte));
  }
};

struct PanelMachine {
  Numbered<Bits<512>, 8000> M;
  Numbered<Words<512>, 8000> D;
  Ports ports;
  ScriptedIo scripted;
  Io *connected = &scripted;
  std::uint32_t elapsed = 10000;
  bit first{};

  Io &io() noexcept { return *connected; }
  std::uint32_t elapsed_us() const noexcept { return elapsed; }
  bit first_scan() const noexcept { return first; }
  void set_complete(bit state) noexcept { M[8029] = state; }
  bit complete() const noexcept { return M[8029]; }
};

}  // namespace ladder::tp03
