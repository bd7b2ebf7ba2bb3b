// What a run tells its user: statistics at the end, the reason of a stop, and the two forms, text and JSON, of both.
#pragma once

#include "hosted/scan_times.h"
#include "hosted/watch.h"

#include "ladder/hosted/instance.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstdio>
#include <string>

namespace ladder::hosted {

/// The value as a JSON number.
nlohmann::ordered_json json_of(const Value &value);

/// "0.000120 s" with as many digits as the time needs, three or six.
std::string seconds_text(std::uint64_t micros);

/// "1.25 us" for 1250.
std::string nanoseconds_text(double nanoseconds);

/// Statistics of a run, and with `json` also the CPU's error.
void print_statistics(const Instance &instance, const ScanTimes &times, const Watch &watch, bool json, std::FILE *out);

/// Why the CPU stopped, or the error that it reported and survived, in the form of a compiler's message.
void print_error(const Instance &instance, std::FILE *err);

}  // namespace ladder::hosted
