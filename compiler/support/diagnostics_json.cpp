// Messages for tools: one JSON object a line, from the same structure as the text, with the arguments as typed values.
#include "support/diagnostics.h"

#include <nlohmann/json.hpp>

#include <charconv>

namespace ladderc {
namespace {

// Keys in the order in which a person would read them, so that outputs can be compared as text.
using Json = nlohmann::ordered_json;

llvm::StringRef name(Severity severity) {
  switch (severity) {
  case Severity::Note:
    return "note";
  case Severity::Warning:
    return "warning";
  case Severity::Error:
    return "error";
  }
  return "error";
}

Json place(const SourceSet &sources, SourceRange range) {
  const LineColumn begin = sources[range.file].position(range.begin);
  const LineColumn end = sources[range.file].position(range.end());
  return {{"line", begin.line}, {"column", begin.column}, {"endLine", end.line}, {"endColumn", end.column}};
}

Json arguments(llvm::ArrayRef<DiagArg> args) {
  Json result = Json::object();
  for (const DiagArg &arg : args) {
    long long number = 0;
    if (arg.is_number && std::from_chars(arg.value.data(), arg.value.data() + arg.value.size(), number).ec == std::errc())
      result[arg.name] = number;
    else
      result[arg.name] = arg.value;
  }
  return result;
}

Json common(const Diagnostic &diagnostic, const SourceSet &sources) {
  Json json;
  json["id"] = info(diagnostic.id).id.str();
  json["severity"] = name(diagnostic.severity).str();
  json["message"] = diagnostic.message;
  json["file"] = sources[diagnostic.range.file].name().str();
  json["range"] = place(sources, diagnostic.range);
  return json;
}

Json object(const Diagnostic &diagnostic, const SourceSet &sources, llvm::StringRef family) {
  Json json = common(diagnostic, sources);
  if (diagnostic.step >= 0)
    json["step"] = diagnostic.step;
  if (diagnostic.rung >= 0)
    json["rung"] = diagnostic.rung;
  json["args"] = arguments(diagnostic.args);
  json["notes"] = Json::array();
  for (const Diagnostic &note : diagnostic.notes) {
    Json entry = common(note, sources);
    entry["args"] = arguments(note.args);
    json["notes"].push_back(std::move(entry));
  }
  json["manual"] = Json::array();
  for (const DiagReference &reference : info(diagnostic.id).references) {
    if (reference.family != family)
      continue;
    json["manual"].push_back({{"family", reference.family.str()}, {"section", reference.section.str()}});
    if (!reference.code.empty() && !json.contains("plc"))
      json["plc"] = {{"code", reference.code.str()}};
  }
  return json;
}

}  // namespace

void print_json(Diagnostics &diagnostics, llvm::StringRef family, llvm::raw_ostream &out) {
  const unsigned limit = diagnostics.options().max_errors;
  unsigned shown = 0;
  for (const Diagnostic &diagnostic : diagnostics.sorted()) {
    if (diagnostic.severity == Severity::Error && limit != 0 && shown++ >= limit)
      continue;
    // Names and messages may hold bytes of the file system or of a list that are no UTF-8.
    out << object(diagnostic, diagnostics.sources(), family).dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
  }
}

}  // namespace ladderc
