// The diagnostics as enumerators, as a constant array and as pages.
//
// The order of the records is the order of the enumerators and of the array, so that an id indexes the array.
#include "actions.h"
#include "family.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/TableGen/Error.h"

#include <vector>

namespace ladderc::tblgen {
namespace {

using llvm::PrintError;
using llvm::raw_ostream;

bool is_kebab_case(StringRef id) {
  return !id.empty() && llvm::all_of(id, [](char c) { return c == '-' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); });
}

/// `{name}` arguments are plain words; a lone brace would reach the user.
bool has_well_formed_arguments(StringRef message) {
  while (!message.empty()) {
    std::size_t open = message.find_first_of("{}");
    if (open == StringRef::npos)
      return true;
    std::size_t close = message.find('}', open);
    if (message[open] == '}' || close == StringRef::npos || close == open + 1)
      return false;
    StringRef name = message.slice(open + 1, close);
    if (!llvm::all_of(name, [](char c) { return c == '_' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }))
      return false;
    message = message.drop_front(close + 1);
  }
  return true;
}

std::vector<const Record *> read_diagnostics(llvm::RecordKeeper &records) {
  std::vector<const Record *> result;
  for (const Record *record : records.getAllDerivedDefinitions("Diagnostic"))
    result.push_back(record);
  llvm::sort(result, [](const Record *a, const Record *b) { return a->getID() < b->getID(); });
  llvm::StringMap<const Record *> ids;
  for (const Record *r : result) {
    StringRef id = r->getValueAsString("id"), severity = r->getValueAsString("severity"), message = r->getValueAsString("message");
    if (!is_kebab_case(id))
      PrintError(r, "'" + id + "' is not an id in kebab case");
    if (!ids.insert({id, r}).second)
      PrintError(r, "two diagnostics have the id '" + id + "'");
    if (severity != "Error" && severity != "Warning" && severity != "Note")
      PrintError(r, "the severity is Error, Warning or Note");
    if (message.empty() || message.back() == '.')
      PrintError(r, "a message is a text without full stop");
    if (!has_well_formed_arguments(message))
      PrintError(r, "arguments are written {name} in lower case");
    if (severity != "Note" && r->getValueAsString("explanation").empty())
      PrintError(r, "errors and warnings need an explanation");
    if (r->getValueAsString("wrong").empty() && !r->getValueAsString("right").empty())
      PrintError(r, "a right list shows how a wrong one is put right; there is no wrong one");
  }
  return result;
}

/// References as an array of its own, named by the record; `{}` where there are none.
std::string emit_references(const Record &r, raw_ostream &out) {
  std::vector<Record *> references = r.getValueAsListOfDefs("references");
  if (references.empty())
    return "{}";
  std::string name = ("k" + r.getName() + "References").str();
  out << "constexpr DiagReference " << name << "[] = {";
  for (const Record *reference : references)
    out << "{" << quoted(reference->getValueAsString("family")) << ", " << quoted(reference->getValueAsString("section")) << ", "
        << quoted(reference->getValueAsString("plc")) << "}, ";
  out << "};\n";
  return name;
}

void print_list(raw_ostream &out, StringRef title, StringRef list) {
  if (list.empty())
    return;
  out << title << "\n\n```\n" << list.trim("\n") << "\n```\n\n";
}

void print_page(const Record &r, raw_ostream &out) {
  out << "### " << r.getValueAsString("id") << "\n\n"
      << r.getValueAsString("severity").lower() << ": `" << r.getValueAsString("message") << "`\n\n";
  if (StringRef explanation = r.getValueAsString("explanation").trim(); !explanation.empty())
    out << explanation << "\n\n";
  StringRef family = r.getValueAsString("family");
  print_list(out, ("The list that gets it" + (family.empty() ? "" : " (" + family + ")") + ":").str(), r.getValueAsString("wrong"));
  print_list(out, "Put right:", r.getValueAsString("right"));
  for (const Record *reference : r.getValueAsListOfDefs("references")) {
    out << "* manual: " << reference->getValueAsString("family") << ", section " << reference->getValueAsString("section");
    if (StringRef code = reference->getValueAsString("plc"); !code.empty())
      out << "; the controller itself reports " << code;
    out << "\n";
  }
  if (!r.getValueAsListOfDefs("references").empty())
    out << "\n";
}

}  // namespace

void emit_diagnostic_ids(llvm::RecordKeeper &records, raw_ostream &out) {
  out << "// Written by ladder-tblgen from grammar/diagnostics.td.\n";
  for (const Record *r : read_diagnostics(records))
    out << "LADDERC_DIAG(" << r->getName() << ")\n";
}

void emit_diagnostics(llvm::RecordKeeper &records, raw_ostream &out) {
  out << "// Written by ladder-tblgen from grammar/diagnostics.td. Indexed by DiagId.\nnamespace ladderc {\n\n";
  std::vector<const Record *> diagnostics = read_diagnostics(records);
  std::vector<std::string> references;
  for (const Record *r : diagnostics)
    references.push_back(emit_references(*r, out));
  out << "static constexpr DiagInfo kDiagnostics[] = {\n";
  for (auto [r, reference] : llvm::zip(diagnostics, references)) {
    out << "    {" << quoted(r->getValueAsString("id")) << ", Severity::" << r->getValueAsString("severity");
    for (StringRef field : {"message", "explanation", "wrong", "right"})
      out << ", " << quoted(r->getValueAsString(field));
    out << ", " << reference << ", " << quoted(r->getValueAsString("family")) << "},\n";
  }
  out << "};\n\n}  // namespace ladderc\n";
}

void emit_diagnostic_docs(llvm::RecordKeeper &records, raw_ostream &file) {
  std::string text;  // every page ends with an empty line, the file does not
  llvm::raw_string_ostream out(text);
  std::vector<const Record *> diagnostics = read_diagnostics(records);
  llvm::sort(diagnostics, [](const Record *a, const Record *b) { return a->getValueAsString("id") < b->getValueAsString("id"); });
  out << "# Diagnostics\n\nEvery message of `ladderc` by its id. `ladderc explain ID` prints the same page. A warning is silenced "
         "with\n"
         "`-Wno-ID`, made an error with `-Werror=ID`, and allowed in one place with the comment `; ladderc: allow ID` on the line "
         "above.\n"
         "\nMade from `grammar/diagnostics.td`; do not edit.\n\n";
  for (StringRef severity : {"Error", "Warning", "Note"}) {
    bool first = true;
    for (const Record *r : diagnostics) {
      if (r->getValueAsString("severity") != severity)
        continue;
      if (std::exchange(first, false))
        out << "## " << severity << "s\n\n";
      print_page(*r, out);
    }
  }
  file << StringRef(text).rtrim("\n") << "\n";
}

}  // namespace ladderc::tblgen
