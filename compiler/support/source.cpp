// Lines and columns are needed for messages only, so a buffer keeps where its lines begin and counts characters on demand.
#include "support/source.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace ladderc {
namespace {

/// Offsets of all line beginnings. CR LF, LF and a lone CR end a line; files of one kind or the other are found by memchr alone.
std::vector<std::uint32_t> find_lines(llvm::StringRef text) {
  std::vector<std::uint32_t> starts{0};
  const char *const begin = text.begin();
  const char *const end = text.end();
  auto find = [&](const char *from, char c) {
    const void *hit = from == end ? nullptr : std::memchr(from, c, static_cast<std::size_t>(end - from));
    return hit ? static_cast<const char *>(hit) : end;
  };
  const char *cr = find(begin, '\r');
  const char *lf = find(begin, '\n');
  while (cr != end || lf != end) {
    const char *next;
    if (lf < cr) {
      next = lf + 1;
      lf = find(next, '\n');
    } else {
      next = cr + 1;
      cr = find(next, '\r');
      if (lf == next && lf != end) {  // CR LF is one line end
        ++next;
        lf = find(next, '\n');
      }
    }
    starts.push_back(static_cast<std::uint32_t>(next - begin));
  }
  return starts;
}

}  // namespace

SourceBuffer::SourceBuffer(std::string name, std::string utf8)
    : name_(std::move(name)), text_(std::move(utf8)), line_starts_(find_lines(text_)) {}

unsigned SourceBuffer::position_line(std::uint32_t offset) const {
  auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  return static_cast<unsigned>(after - line_starts_.begin());
}

LineColumn SourceBuffer::position(std::uint32_t offset) const {
  LineColumn at;
  at.line = position_line(offset);
  const std::uint32_t start = line_starts_[at.line - 1];
  llvm::StringRef before = text().slice(start, offset);
  // Every byte that does not continue a character begins one.
  at.column = 1 + static_cast<unsigned>(std::count_if(before.begin(), before.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  return at;
}

llvm::StringRef SourceBuffer::line(unsigned number) const {
  if (number == 0 || number > line_starts_.size())
    return {};
  const std::size_t end = number < line_starts_.size() ? line_starts_[number] : text_.size();
  return text().slice(line_starts_[number - 1], end).rtrim("\r\n");
}

unsigned SourceSet::add(std::string name, std::string utf8) {
  buffers_.push_back(std::make_unique<SourceBuffer>(std::move(name), std::move(utf8)));
  return static_cast<unsigned>(buffers_.size() - 1);
}

}  // namespace ladderc
