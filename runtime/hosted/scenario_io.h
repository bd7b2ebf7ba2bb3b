// What scenario files say of the world beside the terminals: serial lines, potentiometers, option cards, interrupt pointers.
#pragma once

#include "hosted/scenario_json.h"
#include "hosted/simulated_io.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace ladder::hosted {

/// Gives `io` the scenario's `serial`, `potentiometers` and `expansion_card`. Throws ScenarioError.
void read_io(const Json &scenario, SimulatedIo &io);

struct SerialText {
  unsigned port;
  SimulatedIo::Bytes bytes;
  double at_ms;  ///< 0 where it is not said
};
/// Entries such as {"port": 0, "hex": "41 0D"} with the bytes under `bytes_key` and no other keys than `keys`.
std::vector<SerialText> serial_texts(const Json &entries, const char *bytes_key, std::initializer_list<std::string_view> keys);

/// "41 0D".
std::string hex_text(const SimulatedIo::Bytes &bytes);

/// ["I001", "I610"] is 1 and 610. Throws ScenarioError.
std::vector<unsigned> pointers_of(const Json &names);

}  // namespace ladder::hosted
