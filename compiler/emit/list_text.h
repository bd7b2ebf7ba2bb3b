// The list's own words for comments of the output.
#pragma once

#include "sema/check.h"

#include <string>

namespace ladderc::emit {

/// `MOV K100 D0`, in the usual spelling whatever the file's was.
std::string list_text(const CheckedProgram &program, const Instruction &instruction);
/// A comment's text on one line: control characters become blanks.
std::string comment_text(const SourceSet &sources, SourceRange range);

}  // namespace ladderc::emit
