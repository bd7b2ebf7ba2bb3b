// The list's own words for comments of the output.
#pragma once

#include "sema/check.h"

#include <string>

namespace ladderc::emit {

/// `MOV K100 D0`, in the usual spelling whatever the file's was.
std::string list_text(const CheckedProgram &program, const Instruction &instruction);
/// True where three semicolons stand before the comment: it says something of the file and not of a rung.
bool belongs_to_file(const SourceSet &sources, SourceRange range);
/// A comment's text on one line: control characters become blanks, marks that turn the direction of writing are dropped.
std::string comment_text(const SourceSet &sources, SourceRange range);

}  // namespace ladderc::emit
