// Parses a list in a test, one of the QS unless another family is named.
#pragma once

#include "syntax/parser.h"

#include <string>

namespace ladderc {

inline const FamilyInfo &qs() {
  return *find_family("melsec-qs");
}
inline const FamilyInfo &tp03() {
  return *find_family("tp03");
}

struct Parsed {
  SourceSet sources;
  Diagnostics diagnostics{sources};
  ListProgram program;

  explicit Parsed(std::string list, ListFormat format = ListFormat::Auto, const FamilyInfo &family = qs()) {
    const unsigned file = sources.add("a.il", std::move(list));
    program = parse_list(family, sources, file, format, diagnostics);
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
    print_text(diagnostics, program.family->id, out);
    return text;
  }
};

}  // namespace ladderc
