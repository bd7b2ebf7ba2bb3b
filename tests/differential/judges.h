// Runs one program in two or three ways with the same inputs and compares every device after every scan.
#pragma once

#include "batch.h"

#include <optional>
#include <string>

namespace ladderc::differential {

struct RunSettings {
  unsigned scans = 200;
};

struct Counts {
  unsigned programs = 0, judged = 0, stops = 0;  ///< judged: by an interpreter too
};

/// What differs first: scan, device, who says what. Nothing where all agree.
std::optional<std::string> run_case(const CompiledCase &c, const RunSettings &settings, Counts &counts);

}  // namespace ladderc::differential
