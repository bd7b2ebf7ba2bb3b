// Source texts and places in them.
//
// A list is decoded to UTF-8 once and kept whole; a place is a byte range of that text. Lines and columns are worked out only when
// a message or a generated comment needs them, so that a million instructions cost eight bytes each for their position.
#pragma once

#include "llvm/ADT/StringRef.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ladderc {

/// A byte range of a decoded source text. `file` indexes the SourceSet (one per list of a project).
struct SourceRange {
  std::uint32_t begin = 0;
  std::uint32_t length : 24;
  std::uint32_t file : 8;

  SourceRange() : length(0), file(0) {}
  SourceRange(std::uint32_t begin_, std::uint32_t length_, std::uint32_t file_ = 0) : begin(begin_), length(length_), file(file_) {}
  std::uint32_t end() const { return begin + length; }
};

/// 1-based; columns count characters (code points), not bytes.
struct LineColumn {
  unsigned line = 0;
  unsigned column = 0;
};

/// One decoded text.
class SourceBuffer {
public:
  SourceBuffer(std::string name, std::string utf8);

  /// The path as the user gave it.
  llvm::StringRef name() const { return name_; }
  llvm::StringRef text() const { return text_; }
  llvm::StringRef slice(SourceRange range) const { return text().substr(range.begin, range.length); }
  LineColumn position(std::uint32_t offset) const;
  unsigned line_of(std::uint32_t offset) const { return position_line(offset); }
  /// The line without its end, 1-based.
  llvm::StringRef line(unsigned number) const;
  unsigned line_count() const { return static_cast<unsigned>(line_starts_.size()); }

private:
  unsigned position_line(std::uint32_t offset) const;

  std::string name_;
  std::string text_;
  std::vector<std::uint32_t> line_starts_;
};

/// The texts of one compilation. Buffers do not move once added.
class SourceSet {
public:
  /// Returns the file index.
  unsigned add(std::string name, std::string utf8);
  const SourceBuffer &operator[](unsigned file) const { return *buffers_[file]; }
  std::size_t size() const { return buffers_.size(); }
  llvm::StringRef text(SourceRange range) const { return buffers_[range.file]->slice(range); }
  LineColumn position(SourceRange range) const { return buffers_[range.file]->position(range.begin); }

private:
  std::vector<std::unique_ptr<SourceBuffer>> buffers_;
};

}  // namespace ladderc
