// Bytes are written as pairs of hexadecimal digits with blanks between them or not.
#include "hosted/scenario_io.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <optional>

namespace ladder::hosted {
namespace {

constexpr double kLongestRunMs = 1e12;
constexpr unsigned kMostPorts = 16;

std::optional<unsigned> number_of(std::string_view text, int base = 10) {
  unsigned number = 0;
  const char *end = text.data() + text.size();
  auto parsed = std::from_chars(text.data(), end, number, base);
  return parsed.ec == std::errc{} && parsed.ptr == end ? std::optional(number) : std::nullopt;
}

SimulatedIo::Bytes bytes_of(const Json &json) {
  const std::string text = json.is_string() ? json.get<std::string>() : "?";
  SimulatedIo::Bytes bytes;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ' ') {
      ++at;
      continue;
    }
    const auto byte = number_of(std::string_view(text).substr(at, 2), 16);
    if (!byte || at + 2 > text.size())
      throw ScenarioError(fmt::format("{} are no bytes such as \"41 0D\"", json.dump()));
    bytes.push_back(static_cast<std::uint8_t>(*byte));
    at += 2;
  }
  return bytes;
}

/// {"0": 512}: positions by number.
std::map<unsigned, std::uint16_t> positions_at(const Json &scenario, const char *key) {
  std::map<unsigned, std::uint16_t> positions;
  auto found = scenario.find(key);
  if (found == scenario.end())
    return positions;
  if (!found->is_object())
    throw ScenarioError(fmt::format("'{}' is an object such as {{\"0\": 512}}, not {}", key, found->dump()));
  for (const auto &[name, position] : found->items()) {
    const auto number = number_of(name);
    if (!number || !position.is_number_unsigned() || position.get<std::uint64_t>() > 1023)
      throw ScenarioError(
          fmt::format("'{}' has numbers with positions from 0 to 1023, not \"{}\": {}", key, name, position.dump()));
    positions[*number] = position.get<std::uint16_t>();
  }
  return positions;
}

}  // namespace

std::vector<SerialText> serial_texts(const Json &entries, const char *bytes_key, std::initializer_list<std::string_view> keys) {
  if (!entries.is_array())
    throw ScenarioError(fmt::format("{} is no array of serial texts", entries.dump()));
  std::vector<SerialText> texts;
  for (const Json &entry : entries) {
    check_keys(entry, keys);
    const std::uint64_t port = count_at(entry, "port", 0);
    if (port >= kMostPorts)
      throw ScenarioError(fmt::format("{} is no port", port));
    if (!entry.contains(bytes_key))
      throw ScenarioError(fmt::format("'{}' is missing in {}", bytes_key, entry.dump()));
    texts.push_back({static_cast<unsigned>(port), bytes_of(entry[bytes_key]), number_at(entry, "at_ms", 0, kLongestRunMs)});
  }
  return texts;
}

void read_io(const Json &scenario, SimulatedIo &io) {
  if (auto serial = scenario.find("serial"); serial != scenario.end())
    for (const SerialText &text : serial_texts(*serial, "rx_hex", {"port", "rx_hex", "at_ms"}))
      io.send_to_program(text.port, static_cast<std::uint64_t>(std::llround(text.at_ms * 1000)), text.bytes);
  for (const auto &[number, position] : positions_at(scenario, "potentiometers"))
    io.set_potentiometer(number, position);
  for (const auto &[channel, value] : positions_at(scenario, "expansion_card"))
    io.set_option_input(channel, value);
}

std::string hex_text(const SimulatedIo::Bytes &bytes) {
  std::string text;
  for (std::uint8_t byte : bytes)
    text += fmt::format("{}{:02X}", text.empty() ? "" : " ", byte);
  return text;
}

std::vector<unsigned> pointers_of(const Json &names) {
  if (!names.is_array())
    throw ScenarioError(fmt::format("'interrupts' is an array of pointers, not {}", names.dump()));
  std::vector<unsigned> pointers;
  for (const Json &name : names) {
    const std::string text = name.is_string() ? name.get<std::string>() : "";
    const auto number =
        text.size() > 1 && (text[0] == 'I' || text[0] == 'i') ? number_of(std::string_view(text).substr(1)) : std::nullopt;
    if (!number)
      throw ScenarioError(fmt::format("{} is no interrupt pointer such as \"I001\"", name.dump()));
    pointers.push_back(*number);
  }
  return pointers;
}

}  // namespace ladder::hosted
