// One line for each change: scan, time since power-on, device and value.
#include "hosted/watch.h"

#include "hosted/report.h"

#include <fmt/format.h>

namespace ladder::hosted {

Watch::Watch(const Instance &instance, const std::vector<std::string> &texts) {
  for (const std::string &text : texts) {
    DeviceRef ref = find_device(instance.symbols(), text);
    devices_.push_back({text, ref, instance.get(ref)});
  }
}

bool Watch::look(const Instance &instance, std::uint64_t time, bool json, std::FILE *out) {
  bool changed = false;
  for (WatchedDevice &device : devices_) {
    Value value = instance.get(device.ref);
    if (value == device.value)
      continue;
    device.value = value;
    changed = true;
    if (json) {
      nlohmann::ordered_json line = {
          {"scan", instance.scans()}, {"time_us", time}, {"device", device.text}, {"value", json_of(value)}};
      fmt::print(out, "{}\n", line.dump());
    } else {
      fmt::print(out, "scan {}, {}: {}={}\n", instance.scans(), seconds_text(time), device.text, value_text(value));
    }
  }
  return changed;
}

}  // namespace ladder::hosted
