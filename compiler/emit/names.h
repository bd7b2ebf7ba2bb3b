// Identifiers of the output.
#pragma once

#include "llvm/ADT/StringRef.h"

#include <string>

namespace ladderc::emit {

/// Class name for a list file: `press-line 2.il` becomes PressLine2. Characters that C++ has no use for are dropped; a name that is
/// shorter than three characters (it could be a device's) or begins with a digit gets `Program` in front.
std::string class_name(llvm::StringRef path);
/// File stem for the output: press_line_2.
std::string file_stem(llvm::StringRef path);
/// The text as a C++ string literal with its quotes.
std::string quoted(llvm::StringRef text);

}  // namespace ladderc::emit
