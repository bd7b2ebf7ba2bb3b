// Who uses a serial port. RS, MBUS and the links may stand in a program as often as it likes, but one of them at a time has a port;
// the first that is driven gets it, and keeps it until its condition is OFF.
#pragma once

namespace ladder::tp03 {

class Ports {
public:
  static constexpr unsigned kPorts = 2;        ///< the built-in one and that of the expansion card
  static constexpr unsigned kDataLink = 2;     ///< the data link, which can run on one port only
  static constexpr unsigned kRemoteInOut = 3;  ///< remote I/O likewise

  /// Power comes on, or the switch goes to STOP: nobody has a port any more.
  void restart() noexcept {
    for (const void *&user : users_)
      user = nullptr;
  }
  /// True where `user` has it now.
  bool claim(unsigned resource, const void *user) noexcept {
    if (users_[resource] == nullptr)
      users_[resource] = user;
    return users_[resource] == user;
  }
  bool has(unsigned resource, const void *user) const noexcept { return users_[resource] == user; }
  void release(unsigned resource, const void *user) noexcept {
    if (users_[resource] == user)
      users_[resource] = nullptr;
  }

private:
  const void *users_[4] = {};
};

}  // namespace ladder::tp03
