// Building the native program of a compilation.
#pragma once

#include "driver/compilation.h"
#include "toolchain/toolchain.h"

namespace ladderc::driver {

/// The text of a main file that runs the program with the hosted runtime's options.
std::string main_text(const std::vector<emit::OutputFile> &files, const std::string &name_space, const std::string &class_name);

/// Builds into `executable` (with the sources in the cache), or into the cache where `executable` is empty. Returns the path of the program, or an
/// empty text after a message.
std::string build_native(Compilation &compilation, llvm::StringRef executable, bool verbose);

}  // namespace ladderc::driver
