// Turning generated C++ into native programs.
#pragma once

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringRef.h"

#include <optional>
#include <string>
#include <vector>

namespace ladderc::toolchain {

/// Where the runtime is: beside an installed ladderc (`../include`, `../lib`), else where this build has it. LADDERC_RUNTIME names the
/// folder of another one (with `include/` and `lib/` inside).
struct Locations {
  std::string runtime_include;
  std::string hosted_include;
  std::string hosted_library;
};
Locations find_runtime(llvm::StringRef argv0);

struct CompileOptions {
  unsigned level = 2;            ///< -O of the C++ compiler
  bool debug = false;            ///< -g
  std::vector<std::string> extra;///< further flags of the C++ compiler
  unsigned jobs = 2;             ///< compilers that run side by side
  bool verbose = false;          ///< print the commands
};

/// `$CXX`, or the first of g++, clang++, c++ on the PATH. Empty: none.
std::string find_compiler();

/// Compiles `sources` (paths in `folder`) and links them with the hosted runtime to `executable`. Returns what went wrong (the
/// compiler's own messages are shown as they come), or nothing.
[[nodiscard]] std::optional<std::string> build(llvm::StringRef folder, llvm::ArrayRef<std::string> sources, llvm::StringRef executable,
                                               const Locations &locations, const CompileOptions &options);

/// `$XDG_CACHE_HOME/ladderc` or `~/.cache/ladderc`; a folder of its own for each key. Created where it is missing.
std::string cache_folder(llvm::StringRef key);
/// A key for texts and flags: equal inputs, equal key. The runtime library's time and size are part of it.
std::string cache_key(llvm::ArrayRef<llvm::StringRef> parts, const Locations &locations);

/// Writes the file unless it has that content already. Returns what went wrong, or nothing.
[[nodiscard]] std::optional<std::string> write_file(llvm::StringRef path, llvm::StringRef text);

/// Runs a program with the terminal's streams and returns its exit code; -1 with `error` where it could not be started or was killed by
/// a signal. SIGINT reaches the child, not ladderc, so that it can end cleanly.
int run(llvm::StringRef executable, llvm::ArrayRef<std::string> arguments, std::string &error);
/// Becomes that program: signals and exit code are its own from here on. Returns only where it could not be started, with the reason.
std::string become(const std::string &executable, llvm::ArrayRef<std::string> arguments);

}  // namespace ladderc::toolchain
