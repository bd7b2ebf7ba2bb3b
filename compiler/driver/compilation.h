// The pipeline from a list file to C++, as the subcommands use it.
#pragma once

#include "driver/options.h"
#include "emit/program.h"
#include "ir/ir.h"
#include "opt/pipeline.h"
#include "sema/check.h"

#include <memory>
#include <optional>
#include <vector>

namespace ladderc::driver {

/// One list with everything that has been made of it.
struct Compilation {
  CommonOptions options;
  SourceSet sources;
  std::unique_ptr<Diagnostics> diagnostics;
  CheckedProgram program;
  ir::Module module;
  opt::Context rewrites;
  std::vector<std::pair<std::string, double>> times;  ///< stage, milliseconds

  /// Reads and checks the file. False where it cannot be read or options do not fit (message given).
  bool check_file(llvm::StringRef path);
  /// The same for a text that is here already.
  bool check_text(std::string name, std::string utf8, const Parameters *parameters);
  /// Prints what has been reported; false where there are errors.
  bool report(llvm::raw_ostream &out);
  /// Lowers and optimizes a program without errors. False after an internal fault.
  bool lower_and_optimize();
  /// Reads IR text instead of a list. Returns 0, or the exit code after messages.
  int read_ir(llvm::StringRef path);
  /// Runs the passes over `module`. False after an internal fault.
  bool optimize();
  emit::EmitOptions emit_options() const;
  std::vector<emit::OutputFile> emit();
  /// `--emit=STAGE`: prints the stage. Returns the exit code, or nothing where no stage was asked for.
  std::optional<int> print_stage(llvm::raw_ostream &out);
  void print_stats(llvm::raw_ostream &out) const;
};

/// Compiles `path` up to IR; a file whose name ends in `.ir` is IR already. Returns 0, or the exit code after messages; `done` is
/// set where --emit printed a stage.
int compile_list(Compilation &compilation, llvm::StringRef path, bool &done);

}  // namespace ladderc::driver
