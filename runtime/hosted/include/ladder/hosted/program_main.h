// The main function of a compiled program on a PC.
#pragma once

#include "ladder/symbols.h"

#include <cstdio>

namespace ladder::hosted {

/// Runs the program as the options say (`--help` lists them). Returns the exit code: 0 done, or ended by SIGINT or SIGTERM; 2 wrong
/// options; 3 the CPU stopped on an error. Handles SIGINT and SIGTERM while it runs, so call it once at a time in a process.
int program_main(int argc, char **argv, const ProgramSymbols &symbols, std::FILE *out = stdout, std::FILE *err = stderr);

}  // namespace ladder::hosted
