// From a text to the words of list lines.
//
// One reader per list format; all hand out the same thing: lines of words with their places in the text, so that the parser does
// not know whether an instruction came from a plain list, a numbered list or a spreadsheet. Formats are recognised by structure.
#pragma once

#include "source/decode.h"
#include "support/diagnostics.h"
#include "support/source.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/STLFunctionalExtras.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/StringSaver.h"

namespace ladderc {

enum class ListFormat : std::uint8_t {
  Auto,
  Plain,  ///< one or more instructions a line, step numbers optional
  GxCsv,  ///< GX Works2 / GX Developer program export, tab or comma
};

/// One word of a list line. `text` is in the form that the parser compares: half-width, upper case outside of string constants,
/// `<=` for the sign U+2264 and so on; `range` is the place of the word as written.
struct Word {
  llvm::StringRef text;
  SourceRange range;
};

/// What one line (plain list) or one row (CSV) says.
struct ListLine {
  llvm::ArrayRef<Word> words;  ///< without the step number
  SourceRange comment;         ///< text without mark and outer blanks; length 0: none
  SourceRange statement;       ///< CSV line statement; length 0: none
  SourceRange note;            ///< CSV note or P/I statement; length 0: none. Quotes in CSV texts stay doubled, as in the file
  /// CSV: the instruction cell is filled, so the first word must be a mnemonic. Plain: unknown, false.
  bool starts_instruction = false;
  /// CSV: the instruction cell is empty, so all words are operands of the instruction before.
  bool continues = false;
};

/// Recognises the format of a text; never Auto.
ListFormat recognise_format(llvm::StringRef text);

/// Reads the whole text. Words live in `saver` or in the buffer, which must outlive their use. `; ladderc: allow ID` comments are
/// entered into `diagnostics` here.
void read_list(const SourceBuffer &buffer, unsigned file, ListFormat format, llvm::StringSaver &saver, Diagnostics &diagnostics,
               llvm::function_ref<void(const ListLine &)> on_line);

/// `--emit=lines`: what the reader made of every line, with its line number in the file.
void print_lines(const SourceBuffer &buffer, unsigned file, ListFormat format, Diagnostics &diagnostics, llvm::raw_ostream &out);

}  // namespace ladderc
