// A pair of pseudo-terminals: a serial device by its path, and the partner at the other end.
#pragma once

#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <string>
#include <termios.h>
#include <thread>
#include <unistd.h>

namespace ladder::hosted::test {

/// Up to two seconds, which are never needed.
template <typename Done> bool wait_for(Done done) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  do {
    if (done())
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  } while (std::chrono::steady_clock::now() < end);
  return false;
}

class PseudoTerminal {
public:
  PseudoTerminal() : partner_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    if (partner_ < 0 || ::grantpt(partner_) != 0 || ::unlockpt(partner_) != 0)
      return;
    path_ = ::ptsname(partner_);
    ::fcntl(partner_, F_SETFL, O_NONBLOCK);
    device_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY);  // held, so that the device does not go when a program closes it
  }
  ~PseudoTerminal() {
    close_partner();
    if (device_ >= 0)
      ::close(device_);
  }
  PseudoTerminal(const PseudoTerminal &) = delete;
  PseudoTerminal &operator=(const PseudoTerminal &) = delete;

  bool ok() const { return device_ >= 0; }
  const std::string &path() const { return path_; }
  void send(const std::string &bytes) const { (void)!::write(partner_, bytes.data(), bytes.size()); }
  /// At least `count` bytes where they come in time.
  std::string receive(std::size_t count) const {
    std::string all;
    wait_for([&] { return (all += receive_now()).size() >= count; });
    return all;
  }
  std::string receive_now() const {
    char bytes[64];
    const ssize_t count = ::read(partner_, bytes, sizeof bytes);
    return {bytes, bytes + (count > 0 ? count : 0)};
  }
  std::unique_ptr<termios> settings() const {
    auto settings = std::make_unique<termios>();
    ::tcgetattr(device_, settings.get());
    return settings;
  }
  void close_partner() {
    if (partner_ >= 0)
      ::close(partner_);
    partner_ = -1;
  }

private:
  int partner_, device_ = -1;
  std::string path_;
};

}  // namespace ladder::hosted::test
