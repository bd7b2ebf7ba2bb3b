// Watched devices: remembers their values and prints those that a scan changed.
#pragma once

#include "ladder/hosted/instance.h"

#include <cstdio>
#include <string>
#include <vector>

namespace ladder::hosted {

struct WatchedDevice {
  std::string text;  ///< as the user wrote it
  DeviceRef ref;
  Value value;  ///< after the last scan that was looked at
};

class Watch {
public:
  /// Throws DeviceError. The values at this moment count as known.
  Watch(const Instance &instance, const std::vector<std::string> &texts);

  /// After a scan that started at `time` microseconds: prints changes. Returns whether there were some.
  bool look(const Instance &instance, std::uint64_t time, bool json, std::FILE *out);

  const std::vector<WatchedDevice> &devices() const { return devices_; }

private:
  std::vector<WatchedDevice> devices_;
};

}  // namespace ladder::hosted
