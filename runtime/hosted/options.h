// The command line of a compiled program. One table row per option gives the parser and the help text.
#pragma once

#include "hosted/stimulus.h"

#include "ladder/scan_types.h"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ladder::hosted {

/// A command line that says nothing sensible. The message is one line for the user.
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

enum class Pace : std::uint8_t {
  Timed,        ///< a scan every scan time, real clock
  FreeRunning,  ///< as fast as possible, real clock
  Virtual,      ///< as fast as possible, the clock moves by the scan time
};

/// `--set X0=1@5`, not yet resolved.
struct Setting {
  std::string device, value;
  std::uint64_t scan;  ///< written before this one; the first is 1
  bool timed;          ///< "@" was written
};

/// `--serial 0=/dev/ttyUSB0`
struct SerialDevice {
  unsigned port;
  std::string path;
};

struct Options {
  std::optional<std::uint64_t> scans;
  std::optional<Pace> pace;
  std::optional<Micros> scan_time;
  std::vector<Setting> settings;
  std::vector<std::string> watched;
  StimulusKind stimulus;
  std::vector<SerialDevice> serial;
  std::string clock;  ///< "system", or a date and time, not yet read; empty: as the parameters say
  bool bench = false, json = false, quiet = false, help = false;
};

constexpr Micros kDefaultScanTime = 10'000;

/// Throws UsageError. With --help given, the other options are not checked against each other.
Options parse_options(int argc, const char *const *argv);

/// What --help prints.
std::string help_text(std::string_view program);

/// "10ms", "500us", "0.5s"; throws UsageError. From 1us to one hour.
Micros parse_duration(std::string_view text);

}  // namespace ladder::hosted
