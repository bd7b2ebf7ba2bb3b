// `--emit=lines`: the reader's view of a list, for people who wonder why a file reads as it does.
#include "source/list_reader.h"

namespace ladderc {

void print_lines(const SourceBuffer &buffer, unsigned file, ListFormat format, Diagnostics &diagnostics, llvm::raw_ostream &out) {
  llvm::BumpPtrAllocator memory;
  llvm::StringSaver saver(memory);
  auto place = [&](SourceRange range) -> llvm::raw_ostream & { return out << buffer.line_of(range.begin) << ": "; };
  auto text = [&](llvm::StringRef what, SourceRange range) {
    if (range.length != 0)
      place(range) << what << ": " << buffer.slice(range) << '\n';
  };
  read_list(buffer, file, format, saver, diagnostics, [&](const ListLine &line) {
    text("statement", line.statement);
    if (!line.words.empty()) {
      place(line.words.front().range) << (line.continues ? "..." : "");
      const char *gap = line.continues ? " " : "";
      for (const Word &word : line.words) {
        out << gap << word.text;
        gap = " ";
      }
      out << '\n';
    }
    text("comment", line.comment);
    text("note", line.note);
  });
}

}  // namespace ladderc
