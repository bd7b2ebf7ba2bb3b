// Runs one program three ways with the same inputs and compares every device after every scan.
#pragma once

#include "batch.h"

#include <optional>
#include <string>

namespace ladderc::differential {

struct RunSettings {
  unsigned scans = 200;
};

/// What differs first: scan, device, who says what. Nothing where all three agree.
std::optional<std::string> run_case(const CompiledCase &c, const RunSettings &settings, unsigned &stops);

}  // namespace ladderc::differential
