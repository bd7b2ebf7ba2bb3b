// The main function of a scenario runner: `EXE steps.json results.json`. README.md describes both files.
#pragma once

#include "ladder/symbols.h"

#include <cstdio>
#include <span>

namespace ladder::hosted {

/// Runs every scenario of the first file on the program that it names by its index in `programs`, and writes the second file.
/// Returns 0 all passed, 1 some failed, 2 wrong arguments or files.
int scenario_main(int argc, char **argv, std::span<const ProgramSymbols *const> programs, std::FILE *err = stderr);

}  // namespace ladder::hosted
