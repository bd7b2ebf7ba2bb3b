// What a controller is connected to beside its terminals: serial ports, potentiometers, option cards, pulse outputs.
//
// A program talks to one Io object, which the host connects with `sys.connect(io)`; without one, nothing is connected: ports are
// silent, potentiometers read 0, pulses are counted by the system's own clock and go nowhere. All calls come from scan() and return
// at once.
#pragma once

#include <cstdint>

namespace ladder {

/// How a serial port sends and receives.
struct SerialFormat {
  std::uint32_t baud;       ///< bits a second
  std::uint8_t data_bits;   ///< 7 or 8
  std::uint8_t stop_bits;   ///< 1 or 2
  char parity;              ///< 'N', 'O', 'E'

  friend constexpr bool operator==(const SerialFormat &a, const SerialFormat &b) noexcept {
    return a.baud == b.baud && a.data_bits == b.data_bits && a.stop_bits == b.stop_bits && a.parity == b.parity;
  }
};

class Io {
public:
  /// The program opens a port, or changes its format. Ports are numbered from 0, the built-in one.
  virtual void open_serial(unsigned port, const SerialFormat &format) noexcept { (void)port, (void)format; }
  /// The next received byte, 0-255, or -1 where there is none.
  virtual int read_serial(unsigned port) noexcept { return (void)port, -1; }
  /// False where the port cannot take the byte yet.
  virtual bool write_serial(unsigned port, std::uint8_t byte) noexcept { return (void)port, (void)byte, true; }

  /// Position of a potentiometer, 0-1023.
  virtual std::uint16_t potentiometer(unsigned number) noexcept { return (void)number, 0; }
  /// What a channel of the option card measures, 0-1023.
  virtual std::uint16_t option_input(unsigned channel) noexcept { return (void)channel, 0; }

  /// A pulse output starts, changes or stops (frequency 0): pulses a second, how many are left (0: without end), direction.
  virtual void pulse_output(unsigned channel, std::uint32_t frequency, std::uint32_t left, bool forward) noexcept {
    (void)channel, (void)frequency, (void)left, (void)forward;
  }
  /// A width-modulated output: ON time and period in milliseconds; period 0 stops it.
  virtual void width_output(unsigned channel, std::uint16_t on_ms, std::uint16_t period_ms) noexcept {
    (void)channel, (void)on_ms, (void)period_ms;
  }

  /// State of an input terminal at this moment, 0 or 1, or -1 where only the image of the scan is known (REF and interrupts read it).
  virtual int input(unsigned number) noexcept { return (void)number, -1; }
  /// An output terminal changes before END.
  virtual void output(unsigned number, bool state) noexcept { (void)number, (void)state; }

protected:
  ~Io() = default;  // nobody deletes it through this class
};

}  // namespace ladder
