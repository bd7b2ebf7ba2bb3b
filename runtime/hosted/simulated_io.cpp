// A multimap keeps bytes of one time in the order of their coming.
#include "hosted/simulated_io.h"

#include <utility>

namespace ladder::hosted {

void SimulatedIo::send_to_program(unsigned port, std::uint64_t at_us, const Bytes &bytes) {
  for (std::uint8_t byte : bytes)
    arriving_[port].emplace(at_us, byte);
}

SimulatedIo::Bytes SimulatedIo::take_sent(unsigned port) {
  return std::exchange(sent_[port], {});
}

int SimulatedIo::read_serial(unsigned port) noexcept {
  auto line = arriving_.find(port);
  if (line == arriving_.end() || line->second.empty() || line->second.begin()->first > now_us_)
    return -1;
  const std::uint8_t byte = line->second.begin()->second;
  line->second.erase(line->second.begin());
  return byte;
}

bool SimulatedIo::write_serial(unsigned port, std::uint8_t byte) noexcept {
  sent_[port].push_back(byte);
  return true;
}

}  // namespace ladder::hosted
