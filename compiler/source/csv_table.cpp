// A program table is known by its build, not by the words of its head, which are in the language of the software: a row of seven
// names behind one or two title rows, and rows that begin with a number or nothing.
#include "source/csv_table.h"

#include "source/words.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

namespace ladderc {
namespace {

constexpr std::size_t kColumns = 16;
constexpr std::size_t kProgramColumns = 7;

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

/// The quote that closes a cell stands before a delimiter or the line end; one elsewhere is a quote that a spreadsheet lost or
/// kept.
bool closes(llvm::StringRef behind, char delimiter) {
  behind = behind.ltrim(" ");
  return behind.empty() || behind.front() == delimiter || is_line_end(behind.front());
}

/// Reads the quoted cell whose first quote is at `at`; returns the offset behind its closing quote.
std::size_t quoted_cell(llvm::StringRef text, std::size_t at, char delimiter, Cell &cell) {
  const std::size_t begin = ++at;
  while (at < text.size() && !is_line_end(text[at])) {
    if (text[at] != '"') {
      ++at;
    } else if (at + 1 < text.size() && text[at + 1] == '"') {
      cell.doubled = true;
      at += 2;
    } else if (closes(text.substr(at + 1), delimiter)) {
      cell.text = trim_blanks(text.slice(begin, at));
      return at + 1;
    } else {
      ++at;
    }
  }
  cell.unclosed = true;
  cell.text = trim_blanks(text.slice(begin, at));
  return at;
}

bool is_number(llvm::StringRef text) {
  return !text.empty() && llvm::all_of(text, llvm::isDigit);
}

bool filled(const Row &row, std::size_t column) {
  return column < row.size() && !row[column].text.empty();
}

/// A row of column names: the first four are filled, which no data row has, and the first is no step number.
bool is_head(const Row &row) {
  return filled(row, 0) && filled(row, 1) && filled(row, 2) && filled(row, 3) && !is_number(row[0].text);
}

/// Statement and instruction never share a row in the files that have a statement column; what follows has its own.
bool is_data(const Row &row) {
  return !filled(row, 0) || is_number(row[0].text);
}

bool is_blank(const Row &row) {
  return llvm::all_of(row, [](const Cell &cell) { return cell.text.empty(); });
}

/// The first rows of a text that are not blank, and the offsets behind them.
struct Sample {
  llvm::SmallVector<Row, 12> rows;
  llvm::SmallVector<std::size_t, 12> ends;
};

Sample take_sample(llvm::StringRef text, char delimiter) {
  constexpr unsigned kRows = 12;
  Sample sample;
  std::size_t at = 0;
  for (unsigned n = 0; n < kRows * 4 && at < text.size() && sample.rows.size() < kRows; ++n) {
    Row row;
    at += split_row(text.substr(at), delimiter, row);
    if (is_blank(row))
      continue;
    sample.rows.push_back(std::move(row));
    sample.ends.push_back(at);
  }
  return sample;
}

/// Offset behind the row of column names. It is the third row; a spreadsheet may have lost the title rows before it.
std::optional<std::size_t> behind_head(const Sample &sample) {
  for (std::size_t i = 0; i < std::min<std::size_t>(3, sample.rows.size()); ++i) {
    const Row &row = sample.rows[i];
    if (!is_head(row))
      continue;
    const bool full = row.size() >= kProgramColumns;
    const bool has_titles = i == 2 && !filled(sample.rows[0], 2) && !filled(sample.rows[1], 2);
    if ((full || has_titles) && llvm::all_of(llvm::drop_begin(sample.rows, i + 1), is_data))
      return sample.ends[i];
  }
  return std::nullopt;
}

/// A table without a head: step, an empty column or a statement, instruction, device. Tabs also part the words of plain lists, so
/// that a tab table must show its seven columns.
bool is_bare_table(const Sample &sample, char delimiter) {
  bool wide = false;
  for (const Row &row : sample.rows) {
    const bool damaged = llvm::any_of(row, [](const Cell &cell) { return cell.unclosed; });
    if (!is_data(row) || row.size() < (damaged ? 2 : 3) || (filled(row, 1) && filled(row, 2)))
      return false;
    wide = wide || row.size() >= (delimiter == '\t' ? kProgramColumns : 4);
  }
  return wide;
}

}  // namespace

std::size_t split_row(llvm::StringRef text, char delimiter, Row &row) {
  row.clear();
  std::size_t at = 0;
  while (true) {
    Cell cell;
    std::size_t begin = at;
    while (at < text.size() && text[at] == ' ')
      ++at;
    const bool quoted = at < text.size() && text[at] == '"';
    if (quoted)
      begin = at = quoted_cell(text, at, delimiter, cell);
    while (at < text.size() && text[at] != delimiter && !is_line_end(text[at]))
      ++at;
    if (!quoted)
      cell.text = trim_blanks(text.slice(begin, at));
    if (row.size() < kColumns)
      row.push_back(cell);
    if (at == text.size())
      return at;
    if (is_line_end(text[at])) {
      const bool crlf = text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n';
      return at + (crlf ? 2 : 1);
    }
    ++at;
  }
}

std::optional<CsvShape> csv_shape(llvm::StringRef text) {
  for (char delimiter : {'\t', ',', ';'}) {
    const Sample sample = take_sample(text, delimiter);
    if (std::optional<std::size_t> data = behind_head(sample))
      return CsvShape{delimiter, *data};
    // `;` begins a comment in plain lists; only a head tells the two apart.
    if (delimiter != ';' && is_bare_table(sample, delimiter))
      return CsvShape{delimiter, 0};
  }
  return std::nullopt;
}

}  // namespace ladderc
