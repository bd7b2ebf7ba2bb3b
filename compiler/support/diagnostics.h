// Messages to the person who wrote the list.
//
// Every message is a record in grammar/diagnostics.td: its id, severity, text with named arguments, the page that `ladderc explain`
// prints, and per family the manual's section and the controller's own code. The engine collects, sorts by position, drops what the
// user silenced and hands the result to a printer (text or JSON). Nothing here exits or throws.
#pragma once

#include "support/source.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/Support/raw_ostream.h"

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ladderc {

enum class Severity : std::uint8_t { Note, Warning, Error };

struct DiagReference {
  llvm::StringRef family;   ///< family id
  llvm::StringRef section;  ///< manual section
  llvm::StringRef code;     ///< what the controller itself would report, or empty
};

struct DiagInfo {
  llvm::StringRef id;  ///< kebab-case, public
  Severity severity;
  llvm::StringRef message;  ///< with {name} arguments
  llvm::StringRef explanation;
  llvm::StringRef wrong;  ///< a list that gets this message
  llvm::StringRef right;  ///< the list put right
  llvm::ArrayRef<DiagReference> references;
  llvm::StringRef family = {};  ///< of the two lists, where it is not the usual one
};

enum class DiagId : std::uint16_t {
#define LADDERC_DIAG(Name) Name,
#include "diagnostics_ids.inc"
#undef LADDERC_DIAG
};

const DiagInfo &info(DiagId id);
llvm::ArrayRef<DiagInfo> all_diagnostics();
/// Null for an unknown id.
const DiagInfo *find_diagnostic(llvm::StringRef id);

/// A named argument of a message.
struct DiagArg {
  std::string name;
  std::string value;
  bool is_number;  ///< JSON writes it as a number
};

/// One message or note with its arguments filled in.
struct Diagnostic {
  DiagId id;
  Severity severity;
  SourceRange range;
  std::string message;
  std::vector<DiagArg> args;
  std::vector<Diagnostic> notes;
  std::int32_t step = -1;  ///< -1: not tied to a step
  std::int32_t rung = -1;
};

class Diagnostics;

/// Fills in a message that has just been reported; the message is complete when the builder goes away.
class DiagBuilder {
public:
  DiagBuilder(Diagnostics &owner, Diagnostic diagnostic) : owner_(&owner), diagnostic_(std::move(diagnostic)) {}
  DiagBuilder(DiagBuilder &&other) noexcept
      : owner_(std::exchange(other.owner_, nullptr)), diagnostic_(std::move(other.diagnostic_)) {}
  ~DiagBuilder();

  DiagBuilder &arg(llvm::StringRef name, llvm::StringRef value);
  DiagBuilder &arg(llvm::StringRef name, long long value);
  DiagBuilder &at(std::int32_t step, std::int32_t rung);
  /// Adds a note; following arg() calls fill the note.
  DiagBuilder &note(DiagId id, SourceRange range);

private:
  Diagnostics *owner_;
  Diagnostic diagnostic_;
};

struct DiagOptions {
  llvm::StringSet<> silenced;   ///< -Wno-ID
  llvm::StringSet<> as_errors;  ///< -Werror=ID
  bool all_warnings_are_errors = false;
  unsigned max_errors = 20;  ///< printed; all are counted. 0: no limit
};

class Diagnostics {
public:
  explicit Diagnostics(const SourceSet &sources, DiagOptions options = {}) : sources_(sources), options_(std::move(options)) {}

  DiagBuilder report(DiagId id, SourceRange range);
  /// `; ladderc: allow ID` in `file`: warnings of that id on `line` are dropped.
  void allow(unsigned file, unsigned line, llvm::StringRef id);

  unsigned errors() const { return errors_; }
  unsigned warnings() const { return warnings_; }
  bool ok() const { return errors_ == 0; }
  /// In source order. Call after all stages have run.
  llvm::ArrayRef<Diagnostic> sorted();
  const SourceSet &sources() const { return sources_; }
  const DiagOptions &options() const { return options_; }

private:
  friend class DiagBuilder;
  void finish(Diagnostic diagnostic);

  const SourceSet &sources_;
  DiagOptions options_;
  std::vector<Diagnostic> diagnostics_;
  std::set<std::pair<std::uint64_t, std::string>> allowed_;  ///< (file << 32 | line, id)
  unsigned errors_ = 0;
  unsigned warnings_ = 0;
};

/// GCC's form with the source line and a caret by display width, notes, `= at:` and `= manual:` lines, and the closing count.
/// `family` chooses the manual reference.
void print_text(Diagnostics &diagnostics, llvm::StringRef family, llvm::raw_ostream &out);
/// One JSON object per line.
void print_json(Diagnostics &diagnostics, llvm::StringRef family, llvm::raw_ostream &out);
/// The page of one id, as `ladderc explain` prints it.
void print_explanation(const DiagInfo &diagnostic, llvm::raw_ostream &out);

}  // namespace ladderc
