// Writes C++ text with the right indentation: blocks are opened and closed by objects, not by braces inside of strings.
#pragma once

#include "llvm/ADT/StringRef.h"

#include <fmt/format.h>

#include <string>

namespace ladderc::emit {

class Writer;

/// Closes its block when it goes away.
class Block {
public:
  /// Opens it: `head` has the brace.
  Block(Writer &writer, llvm::StringRef head, llvm::StringRef end = "}");
  Block(const Block &) = delete;
  Block &operator=(const Block &) = delete;
  ~Block();

private:
  Writer *writer_;
  std::string end_;
};

class Writer {
public:
  template <class... Args> void line(fmt::format_string<Args...> format, Args &&...args) {
    text(fmt::format(format, std::forward<Args>(args)...));
  }
  /// One line as it is.
  void text(llvm::StringRef line);
  /// A statement that is broken behind operators and commas where it is longer than a line.
  void statement(llvm::StringRef statement);
  void blank();
  /// `// text`, wrapped between words, and between the parts that ` · ` joins where they fit on a line; continuation lines are
  /// indented by `hang` columns behind the `// `.
  void comment(llvm::StringRef text, unsigned hang = 0);
  /// Writes `head {`, indents, and closes with `end`.
  [[nodiscard]] Block block(llvm::StringRef head, llvm::StringRef end = "}");
  /// A line at the left edge: preprocessor, access specifier.
  void left(llvm::StringRef line, unsigned indent = 0);

  llvm::StringRef text_so_far() const { return out_; }
  unsigned lines() const { return lines_; }
  std::string take() { return std::move(out_); }

private:
  friend class Block;
  void raw(unsigned indent, llvm::StringRef line);

  std::string out_;
  unsigned indent_ = 0;
  unsigned lines_ = 0;
};

}  // namespace ladderc::emit
