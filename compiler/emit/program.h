// The files of one program.
#pragma once

#include "emit/layout.h"
#include "ir/ir.h"
#include "sema/check.h"

#include <string>
#include <vector>

namespace ladderc::emit {

struct EmitOptions {
  std::string name_space = "plant";
  std::string class_name;        ///< empty: from the list's file name
  std::string stem;              ///< of the output files; empty: from the list's file name
  unsigned level = 2;            ///< -O, for the head comment; 0 writes one `if` for every conditional instruction
  bool line_directives = false;  ///< -g: debuggers step through the list
  LayoutLimits limits;
};

struct OutputFile {
  std::string name;
  std::string text;
};

/// NAME.h, NAME.cpp, NAME_2.cpp ..., NAME.symbols.cpp.
std::vector<OutputFile> emit_program(const CheckedProgram &program, const ir::Module &module, const SourceSet &sources,
                                     const EmitOptions &options);
/// NAME.cmake: a target for the program's sources. Written by `ladderc emit`.
OutputFile emit_cmake(const std::vector<OutputFile> &files, const EmitOptions &options);
/// The rungs only, without the frame, for `--emit=cpp-rungs`.
std::string emit_rungs(const CheckedProgram &program, const ir::Module &module, const SourceSet &sources,
                       const EmitOptions &options);

}  // namespace ladderc::emit
