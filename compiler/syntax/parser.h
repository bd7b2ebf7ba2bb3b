// From the words of list lines to instructions.
#pragma once

#include "source/list_reader.h"
#include "support/diagnostics.h"
#include "syntax/ast.h"

namespace ladderc {

/// Parses one list. Words that belong to no instruction, unknown mnemonics and unreadable operands are reported; the program that
/// comes back always can be walked (unknown instructions have no candidates, unreadable operands are Invalid).
ListProgram parse_list(const FamilyInfo &family, const SourceSet &sources, unsigned file, ListFormat format,
                       Diagnostics &diagnostics);

/// Reads one operand word; nothing is reported. Invalid where it is none.
Operand parse_operand(const FamilyInfo &family, llvm::StringRef word, SourceRange range);

/// `--emit=ast`: one instruction a line with its operands taken apart.
void print_ast(const ListProgram &program, const SourceSet &sources, llvm::raw_ostream &out);

}  // namespace ladderc
