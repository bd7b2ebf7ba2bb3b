// Many random programs, compiled twice in two compiler calls, and loaded.
#pragma once

#include "driver/compilation.h"
#include "generate/generate.h"
#include "ladder/symbols.h"

#include <memory>
#include <string>
#include <vector>

namespace ladderc::differential {

/// What one seed stands for.
struct Case {
  std::uint64_t seed = 0;
  GenerateOptions generate;  ///< profile, allocation and length are drawn from the seed
  std::string list;
};
Case make_case(const FamilyInfo &family, std::uint64_t seed);

struct CompiledCase {
  Case c;
  std::unique_ptr<driver::Compilation> plain, optimized;  ///< -O0 and -O2
  const ladder::ProgramSymbols *plain_symbols = nullptr, *optimized_symbols = nullptr;
};

struct BatchSettings {
  std::string folder;   ///< for sources and libraries
  bool packed = false;  ///< the -O0 side keeps 32 bits to a word
  bool trap_undefined = false;
};

/// Compiles and loads all cases. Returns what went wrong, or an empty text. The libraries stay loaded.
std::string build_batch(std::vector<Case> cases, const BatchSettings &settings, std::vector<CompiledCase> &compiled);

/// Only up to IR; returns what went wrong.
std::string compile_case(const Case &c, unsigned level, std::unique_ptr<driver::Compilation> &compilation);

}  // namespace ladderc::differential
