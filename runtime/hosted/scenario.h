// Running one scenario: steps of inputs, scans and expected devices, on an instance of its own with a virtual clock.
#pragma once

#include "ladder/symbols.h"

#include <nlohmann/json.hpp>

#include <span>
#include <string_view>

namespace ladder::hosted {

/// Keeps the order in which the file lists the devices to set: where they overlap, the last one wins.
using Json = nlohmann::ordered_json;

/// The result entry of one scenario, as README.md describes it. What is wrong with the scenario itself is its "error".
Json run_scenario(const Json &scenario, std::span<const ProgramSymbols *const> programs);

/// "1998-11-30T11:50:20"; throws DeviceError. The weekday follows from the date.
Calendar parse_calendar(std::string_view text);

}  // namespace ladder::hosted
