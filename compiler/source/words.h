// What plain lists and CSV cells share: where words begin and end, and the form in which the parser compares them.
#pragma once

#include "source/list_reader.h"

#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/StringSaver.h"

namespace ladderc {

/// A part of a buffer as a range of it.
inline SourceRange range_of(const SourceBuffer &buffer, unsigned file, llvm::StringRef part) {
  constexpr std::size_t kMaxLength = 0xFFFFFF;
  return SourceRange(static_cast<std::uint32_t>(part.data() - buffer.text().data()),
                     static_cast<std::uint32_t>(part.size() < kMaxLength ? part.size() : kMaxLength), file);
}

/// Behind blanks: blank, tab, form feed, no-break and ideographic blank, a stray byte order mark. Stops at line ends.
const char *skip_blanks(const char *at, const char *end);

llvm::StringRef trim_blanks(llvm::StringRef text);

/// Length of the comment mark that begins at `at`, with all its repetitions (`;;`, `///`); 0 where none begins.
std::size_t comment_mark(const char *at, const char *end);

struct ScannedWord {
  const char *end;
  bool as_written;  ///< already in the form that the parser compares
};
/// The word that begins at `at`, which is no blank. `comments`: the marks `;` and `//` end it.
ScannedWord scan_word(const char *at, const char *end, bool comments);

/// Half-width, upper case, comparison signs as ASCII.
llvm::StringRef normalise(llvm::StringRef written, llvm::StringSaver &saver);

/// Entries of `; ladderc: allow ID`. They hold for the next line with words where the comment stands alone, else for its own line.
class Allowances {
public:
  Allowances(const SourceBuffer &buffer, unsigned file, Diagnostics &diagnostics)
      : buffer_(buffer), file_(file), diagnostics_(diagnostics) {}

  /// True where the comment is a directive; it is no text for people then.
  bool read(llvm::StringRef comment);
  /// A line with words, and its offset. `continues`: it belongs to the instruction of the line before.
  void line(std::uint32_t offset, bool continues = false) {
    if (!pending_.empty() || !current_.empty())
      enter(offset, continues);
  }

private:
  void enter(std::uint32_t offset, bool continues);

  const SourceBuffer &buffer_;
  unsigned file_;
  Diagnostics &diagnostics_;
  llvm::SmallVector<llvm::StringRef, 4> pending_;
  llvm::SmallVector<llvm::StringRef, 4> current_;
};

}  // namespace ladderc
