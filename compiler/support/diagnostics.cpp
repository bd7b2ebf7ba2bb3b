// The engine: fills in messages, drops what was silenced, counts, sorts. Printing lives in diagnostics_text.cpp and
// diagnostics_json.cpp.
#include "support/diagnostics.h"

#include "diagnostics.inc"

#include <algorithm>

namespace ladderc {

const DiagInfo &info(DiagId id) {
  return kDiagnostics[static_cast<std::size_t>(id)];
}

llvm::ArrayRef<DiagInfo> all_diagnostics() {
  return kDiagnostics;
}

const DiagInfo *find_diagnostic(llvm::StringRef id) {
  for (const DiagInfo &candidate : kDiagnostics)
    if (candidate.id == id)
      return &candidate;
  return nullptr;
}

namespace {

/// Puts the arguments into the {names} of the text. A name without an argument stays as it is, which the tests of the records find.
std::string fill(llvm::StringRef text, llvm::ArrayRef<DiagArg> args) {
  std::string result;
  while (!text.empty()) {
    auto [plain, rest] = text.split('{');
    result += plain;
    if (plain.size() == text.size())
      break;
    auto [name, behind] = rest.split('}');
    auto *arg = llvm::find_if(args, [&, wanted = name](const DiagArg &a) { return a.name == wanted; });
    if (arg != args.end())
      result += arg->value;
    else
      (result += '{').append(name.data(), name.size()) += '}';
    text = behind;
  }
  return result;
}

Diagnostic start(DiagId id, SourceRange range) {
  Diagnostic diagnostic;
  diagnostic.id = id;
  diagnostic.severity = info(id).severity;
  diagnostic.range = range;
  return diagnostic;
}

std::uint64_t line_key(unsigned file, unsigned line) {
  return static_cast<std::uint64_t>(file) << 32 | line;
}

}  // namespace

DiagBuilder::~DiagBuilder() {
  if (owner_)
    owner_->finish(std::move(diagnostic_));
}

DiagBuilder &DiagBuilder::arg(llvm::StringRef name, llvm::StringRef value) {
  Diagnostic &target = diagnostic_.notes.empty() ? diagnostic_ : diagnostic_.notes.back();
  target.args.push_back({name.str(), value.str(), false});
  return *this;
}

DiagBuilder &DiagBuilder::arg(llvm::StringRef name, long long value) {
  Diagnostic &target = diagnostic_.notes.empty() ? diagnostic_ : diagnostic_.notes.back();
  target.args.push_back({name.str(), std::to_string(value), true});
  return *this;
}

DiagBuilder &DiagBuilder::at(std::int32_t step, std::int32_t rung) {
  diagnostic_.step = step;
  diagnostic_.rung = rung;
  return *this;
}

DiagBuilder &DiagBuilder::note(DiagId id, SourceRange range) {
  diagnostic_.notes.push_back(start(id, range));
  return *this;
}

DiagBuilder Diagnostics::report(DiagId id, SourceRange range) {
  return DiagBuilder(*this, start(id, range));
}

void Diagnostics::allow(unsigned file, unsigned line, llvm::StringRef id) {
  allowed_.emplace(line_key(file, line), id.str());
}

void Diagnostics::finish(Diagnostic diagnostic) {
  const DiagInfo &record = info(diagnostic.id);
  if (diagnostic.severity == Severity::Warning) {
    if (options_.silenced.contains(record.id))
      return;
    if (!allowed_.empty() && diagnostic.range.file < sources_.size()) {
      const unsigned line = sources_[diagnostic.range.file].line_of(diagnostic.range.begin);
      if (allowed_.contains({line_key(diagnostic.range.file, line), record.id.str()}))
        return;
    }
    if (options_.all_warnings_are_errors || options_.as_errors.contains(record.id))
      diagnostic.severity = Severity::Error;
  }
  diagnostic.message = fill(record.message, diagnostic.args);
  for (Diagnostic &note : diagnostic.notes)
    note.message = fill(info(note.id).message, note.args);
  (diagnostic.severity == Severity::Error ? errors_ : warnings_) += 1;
  diagnostics_.push_back(std::move(diagnostic));
}

llvm::ArrayRef<Diagnostic> Diagnostics::sorted() {
  auto before = [](const Diagnostic &a, const Diagnostic &b) {
    return std::pair(a.range.file + 0u, a.range.begin) < std::pair(b.range.file + 0u, b.range.begin);
  };
  std::stable_sort(diagnostics_.begin(), diagnostics_.end(), before);
  return diagnostics_;
}

}  // namespace ladderc
