// Serial ports of a program on serial devices of this computer.
//
// The program opens a port with the format that it wants; until then the device is open and idle. A device that goes away is as
// silent as a cable that is pulled out.
#pragma once

#include "ladder/io.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>

namespace ladder::hosted {

/// A device cannot be opened or is no serial device. The message is for the user.
class SerialError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

class SerialIo final : public Io {
public:
  /// A format that a device cannot have is reported to `err`; the device keeps the one it has.
  explicit SerialIo(std::FILE *err = stderr) : err_(err) {}
  ~SerialIo();
  SerialIo(const SerialIo &) = delete;
  SerialIo &operator=(const SerialIo &) = delete;

  /// Opens the device ("/dev/ttyUSB0") for a port of the program; what it had received is thrown away. Throws SerialError.
  void attach(unsigned port, const std::string &path);

  void open_serial(unsigned port, const SerialFormat &format) noexcept override;
  int read_serial(unsigned port) noexcept override;
  bool write_serial(unsigned port, std::uint8_t byte) noexcept override;

private:
  struct Line {
    int file;
    std::string path;
    SerialFormat format;                  ///< baud 0: not yet opened by the program
    std::array<std::uint8_t, 256> bytes;  ///< received, from `next` to `end` not yet read
    std::size_t next, end;
  };
  Line *line_of(unsigned port) noexcept;

  std::map<unsigned, Line> lines_;
  std::FILE *err_;
};

}  // namespace ladder::hosted
