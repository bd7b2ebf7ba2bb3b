// Every call returns at once: the devices are open without blocking, and what they have received is fetched in one piece.
#include "ladder/hosted/serial_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <iterator>
#include <optional>
#include <termios.h>
#include <unistd.h>

namespace ladder::hosted {
namespace {

struct Speed {
  std::uint32_t baud;
  speed_t code;
};
constexpr Speed kSpeeds[] = {{110, B110},   {300, B300},     {600, B600},     {1200, B1200},   {2400, B2400},    {4800, B4800},
                             {9600, B9600}, {19200, B19200}, {38400, B38400}, {57600, B57600}, {115200, B115200}};

/// Bytes as they are, in the format.
std::optional<termios> settings_of(const SerialFormat &format) {
  auto speed = std::find_if(std::begin(kSpeeds), std::end(kSpeeds), [&](const Speed &s) { return s.baud == format.baud; });
  if (speed == std::end(kSpeeds))
    return std::nullopt;
  termios settings{};
  settings.c_cflag = CREAD | CLOCAL | (format.data_bits == 7 ? tcflag_t{CS7} : tcflag_t{CS8});
  if (format.stop_bits == 2)
    settings.c_cflag |= CSTOPB;
  if (format.parity != 'N') {
    settings.c_cflag |= PARENB | (format.parity == 'O' ? tcflag_t{PARODD} : tcflag_t{0});
    settings.c_iflag = INPCK | IGNPAR;  // a byte in error does not come
  }
  cfsetispeed(&settings, speed->code);
  cfsetospeed(&settings, speed->code);
  return settings;
}

}  // namespace

SerialIo::~SerialIo() {
  for (const auto &[port, line] : lines_)
    ::close(line.file);
}

void SerialIo::attach(unsigned port, const std::string &path) {
  const int file = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0)
    throw SerialError(fmt::format("cannot open '{}': {}", path, std::strerror(errno)));
  // In raw form from the start: an echo would answer the partner before the program does.
  const termios raw = *settings_of({9600, 8, 1, 'N'});
  if (::tcsetattr(file, TCSANOW, &raw) != 0) {
    ::close(file);
    throw SerialError(fmt::format("'{}' is no serial device", path));
  }
  ::tcflush(file, TCIFLUSH);
  if (Line *before = line_of(port)) {
    ::close(before->file);
    lines_.erase(port);
  }
  lines_.emplace(port, Line{file, path, {}, {}, 0, 0});
}

SerialIo::Line *SerialIo::line_of(unsigned port) noexcept {
  auto line = lines_.find(port);
  return line == lines_.end() ? nullptr : &line->second;
}

void SerialIo::open_serial(unsigned port, const SerialFormat &format) noexcept {
  Line *line = line_of(port);
  if (line == nullptr || line->format == format)
    return;
  line->format = format;
  const auto settings = settings_of(format);
  if (!settings || ::tcsetattr(line->file, TCSANOW, &*settings) != 0)
    std::fprintf(err_, "%s: cannot be set to %u bauds, %u data bits, parity %c, %u stop bits\n", line->path.c_str(),
                 unsigned{format.baud}, unsigned{format.data_bits}, format.parity, unsigned{format.stop_bits});
}

int SerialIo::read_serial(unsigned port) noexcept {
  Line *line = line_of(port);
  if (line == nullptr)
    return -1;
  if (line->next == line->end) {
    const ssize_t count = ::read(line->file, line->bytes.data(), line->bytes.size());
    if (count <= 0)
      return -1;
    line->next = 0;
    line->end = static_cast<std::size_t>(count);
  }
  return line->bytes[line->next++];
}

bool SerialIo::write_serial(unsigned port, std::uint8_t byte) noexcept {
  Line *line = line_of(port);
  if (line == nullptr)
    return true;
  // Where the device is gone the byte is lost, as on a cable without a partner; waiting for it would never end.
  return ::write(line->file, &byte, 1) == 1 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
}

}  // namespace ladder::hosted
