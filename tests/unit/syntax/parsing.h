// Parses a list of the QS in a test.
#pragma once

#include "syntax/parser.h"

#include <string>

namespace ladderc {

inline const FamilyInfo &qs() {
  return *find_family("melsec-qs");
}

struct Parsed {
  SourceSet sources;
  Diagnostics diagnostics{sources};
  ListProgram program;

  explicit Parsed(std::string list, ListFormat format = ListFormat::Auto) {
    const unsigned file = sources.add("a.il", std::move(list));
    program = parse_list(qs(), sources, file, format, diagnostics);
  }

  std::string ast() const {
    std::string text;
    llvm::raw_string_ostream out(text);
    print_ast(program, sources, out);
    return text;
  }

  /// "LINE:COLUMN id", one a line.
  std::string messages() {
    std::string text;
    for (const Diagnostic &diagnostic : diagnostics.sorted()) {
      const LineColumn at = sources.position(diagnostic.range);
      text += std::to_string(at.line) + ":" + std::to_string(at.column) + " " + info(diagnostic.id).id.str() + "\n";
    }
    return text;
  }

  std::string rendered() {
    std::string text;
    llvm::raw_string_ostream out(text);
    print_text(diagnostics, "melsec-qs", out);
    return text;
  }
};

}  // namespace ladderc
