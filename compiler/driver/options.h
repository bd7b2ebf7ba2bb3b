// Options that several subcommands share.
#pragma once

#include "source/list_reader.h"
#include "support/diagnostics.h"

#include "llvm/Support/CommandLine.h"

#include <string>
#include <vector>

namespace ladderc::driver {

/// A subcommand: its LLVM object and what it does. The table is in main.cpp.
extern llvm::cl::SubCommand kBuild, kEmit, kCheck, kRun, kTest, kBench, kInstructions, kExplain, kGenerate;

struct CommonOptions {
  std::string family, model, parameters_file, encoding, format, emit, diagnostics, name_space;
  unsigned level = 2;
  bool debug = false, stats = false;
  std::vector<std::string> disabled_passes, only_passes, print_after;
  long long bisect = -1;
  DiagOptions diag;
};

/// What the command line says. Returns false after a message where a value makes no sense.
bool read_common_options(CommonOptions &options);

int run_build();
int run_emit();
int run_check();
int run_run(llvm::StringRef argv0);
int run_test(llvm::StringRef argv0);
int run_bench(llvm::StringRef argv0);
int run_instructions();
int run_explain();
int run_generate();

constexpr int kExitErrors = 1, kExitUsage = 2, kExitInternal = 70;

/// argv[0], for finding the runtime beside the executable.
extern std::string g_argv0;

/// `ladderc: error: TEXT` on stderr; returns kExitUsage.
int usage_error(llvm::StringRef text);

}  // namespace ladderc::driver
