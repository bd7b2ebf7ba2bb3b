// A program table has one instruction a row and its further operands on rows of their own:
//
//   step | line statement | instruction or label | operand | blank | P/I statement | note | whatever an export appends
//
// Steps are those of the software that wrote the file or mere row numbers, so they are not looked at.
#include "source/csv_reader.h"

#include "source/csv_table.h"
#include "source/words.h"

namespace ladderc {
namespace {

enum Column : std::size_t { kStatement = 1, kInstruction = 2, kOperand = 3, kBlank = 4, kPointerStatement = 5, kNote = 6 };
constexpr Column kRead[] = {kStatement, kInstruction, kOperand, kBlank, kPointerStatement, kNote};

class CsvReader {
public:
  CsvReader(const SourceBuffer &buffer, unsigned file, llvm::StringSaver &saver, Diagnostics &diagnostics,
            llvm::function_ref<void(const ListLine &)> on_line)
      : buffer_(buffer), file_(file), saver_(saver), diagnostics_(diagnostics), on_line_(on_line),
        allowances_(buffer, file, diagnostics) {}

  void read() {
    llvm::StringRef text = buffer_.text();
    CsvShape shape{text.take_until([](char c) { return c == '\n'; }).contains('\t') ? '\t' : ',', 0};
    if (std::optional<CsvShape> known = csv_shape(text))
      shape = *known;
    text = text.drop_front(shape.data);
    Row row;
    while (!text.empty()) {
      text = text.drop_front(split_row(text, shape.delimiter, row));
      read_row(row);
    }
  }

private:
  static llvm::StringRef cell(const Row &row, Column column) { return column < row.size() ? row[column].text : llvm::StringRef(); }

  void read_row(const Row &row) {
    report_quotes(row);
    words_.clear();
    add_words(row, kInstruction);
    const bool has_instruction = !words_.empty();
    add_words(row, kOperand);
    add_words(row, kBlank);  // some generators put a second operand here

    ListLine line;
    line.words = words_;
    line.starts_instruction = has_instruction;
    line.continues = !has_instruction && !words_.empty();
    if (!words_.empty())
      allowances_.line(words_.front().range.begin, line.continues);
    line.statement = statement(cell(row, kStatement));
    line.note = text_range(cell(row, kNote));
    SourceRange pointer_statement = text_range(cell(row, kPointerStatement));
    if (line.note.length == 0)
      std::swap(line.note, pointer_statement);
    if (!line.words.empty() || line.statement.length != 0 || line.note.length != 0)
      on_line_(line);
    if (pointer_statement.length != 0) {
      ListLine second;
      second.note = pointer_statement;
      on_line_(second);
    }
  }

  void report_quotes(const Row &row) {
    for (Column column : kRead)
      if (column < row.size() && row[column].unclosed)
        diagnostics_.report(DiagId::UnclosedQuote, range_of(buffer_, file_, row[column].text)).arg("text", row[column].text);
  }

  void add_words(const Row &row, Column column) {
    llvm::StringRef written = cell(row, column);
    if (written.empty())
      return;
    if (row[column].doubled) {
      add_string(written);
      return;
    }
    const char *at = written.begin();
    const char *const end = written.end();
    while ((at = skip_blanks(at, end)) != end) {
      const ScannedWord scanned = scan_word(at, end, false);
      llvm::StringRef word(at, static_cast<std::size_t>(scanned.end - at));
      words_.push_back({scanned.as_written ? word : normalise(word, saver_), range_of(buffer_, file_, word)});
      at = scanned.end;
    }
  }

  /// A cell with doubled quotes holds string constants; its words have no place of their own in the file, so all take the cell's.
  void add_string(llvm::StringRef written) {
    std::string single;
    for (std::size_t i = 0; i < written.size(); ++i) {
      single += written[i];
      if (written[i] == '"' && i + 1 < written.size() && written[i + 1] == '"')
        ++i;
    }
    llvm::StringRef text = saver_.save(single);
    const char *at = text.begin();
    while ((at = skip_blanks(at, text.end())) != text.end()) {
      const ScannedWord scanned = scan_word(at, text.end(), false);
      llvm::StringRef word(at, static_cast<std::size_t>(scanned.end - at));
      words_.push_back({scanned.as_written ? word : normalise(word, saver_), range_of(buffer_, file_, written)});
      at = scanned.end;
    }
  }

  SourceRange text_range(llvm::StringRef text) const {
    return text.empty() ? SourceRange(0, 0, file_) : range_of(buffer_, file_, text);
  }

  /// A leading `*` says that the statement stays in the computer and is not written to the controller; people need not see it.
  SourceRange statement(llvm::StringRef text) {
    text = trim_blanks(text.ltrim('*'));
    if (allowances_.read(trim_blanks(text.ltrim(';'))))
      return text_range({});
    return text_range(text);
  }

  const SourceBuffer &buffer_;
  unsigned file_;
  llvm::StringSaver &saver_;
  Diagnostics &diagnostics_;
  llvm::function_ref<void(const ListLine &)> on_line_;
  Allowances allowances_;
  llvm::SmallVector<Word, 8> words_;
};

}  // namespace

void read_csv(const SourceBuffer &buffer, unsigned file, llvm::StringSaver &saver, Diagnostics &diagnostics,
              llvm::function_ref<void(const ListLine &)> on_line) {
  CsvReader(buffer, file, saver, diagnostics, on_line).read();
}

}  // namespace ladderc
