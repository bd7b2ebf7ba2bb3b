// Tables of cells as the makers' software and spreadsheets write them: the rows of a text, and how a program table is known.
#pragma once

#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringRef.h"

#include <cstddef>
#include <optional>

namespace ladderc {

/// One cell. `text` is the piece of the buffer inside the quotes, without outer blanks; doubled quotes are still doubled.
struct Cell {
  llvm::StringRef text;
  bool doubled = false;   ///< holds doubled quotes
  bool unclosed = false;  ///< begins with a quote that does not end on its row
};

using Row = llvm::SmallVector<Cell, 12>;

/// Splits the row that begins at `text` and returns its length with the line end. Cells beyond the columns of a program table are
/// left out.
std::size_t split_row(llvm::StringRef text, char delimiter, Row &row);

struct CsvShape {
  char delimiter;
  std::size_t data;  ///< offset of the first row behind the head
};

/// What kind of program table the text is, or nothing.
std::optional<CsvShape> csv_shape(llvm::StringRef text);

}  // namespace ladderc
