// `ladderc explain ID`: the page of one message.
#include "support/diagnostics.h"

namespace ladderc {
namespace {

void print_list(llvm::StringRef title, llvm::StringRef list, llvm::raw_ostream &out) {
  if (list.empty())
    return;
  out << '\n' << title << '\n';
  list = list.trim('\n');
  while (!list.empty()) {
    auto [line, rest] = list.split('\n');
    out << (line.empty() ? "" : "    ") << line << '\n';
    list = rest;
  }
}

llvm::StringRef kind(Severity severity) {
  return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "note";
}

}  // namespace

void print_explanation(const DiagInfo &diagnostic, llvm::raw_ostream &out) {
  out << diagnostic.id << " (" << kind(diagnostic.severity) << ")\n\n    " << diagnostic.message << '\n';
  if (llvm::StringRef text = diagnostic.explanation.trim(); !text.empty())
    out << '\n' << text << '\n';
  const std::string family = diagnostic.family.empty() ? std::string() : " (" + diagnostic.family.str() + ")";
  print_list("A list that gets it" + family + ":", diagnostic.wrong, out);
  print_list("Put right:", diagnostic.right, out);
  for (const DiagReference &reference : diagnostic.references) {
    out << "\nManual of " << reference.family;
    if (!reference.section.empty())
      out << ", section " << reference.section;
    if (!reference.code.empty())
      out << "; the controller reports " << reference.code;
    out << '\n';
  }
  if (diagnostic.severity == Severity::Warning)
    out << "\nTo silence it: -Wno-" << diagnostic.id << ", or `; ladderc: allow " << diagnostic.id << "` on the line above.\n";
}

}  // namespace ladderc
