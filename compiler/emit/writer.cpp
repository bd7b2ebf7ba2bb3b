// Indentation and line breaking of generated text.
#include "emit/writer.h"

#include "llvm/Support/Unicode.h"

#include <algorithm>

namespace ladderc::emit {

namespace {

constexpr unsigned kColumns = 120;

unsigned width(llvm::StringRef text) {
  const int columns = llvm::sys::unicode::columnWidthUTF8(text);
  return columns < 0 ? static_cast<unsigned>(text.size()) : static_cast<unsigned>(columns);
}

/// The last place before `limit` bytes at which a statement may be broken: behind a comma or before an operator.
std::size_t break_place(llvm::StringRef text, std::size_t limit) {
  for (llvm::StringRef mark : {" | ", " & ", ", "}) {
    const std::size_t at = text.take_front(limit).rfind(mark);
    if (at != llvm::StringRef::npos && at > limit / 3)
      return mark == ", " ? at + 1 : at;
  }
  return llvm::StringRef::npos;
}

/// Where a comment is broken so that at most `room` columns stand on the line: behind the last ` · ` that lies behind `from`, else
/// at the last blank there, else at the first blank behind.
std::size_t comment_break(llvm::StringRef text, unsigned room, std::size_t from) {
  static constexpr llvm::StringLiteral kJoint = " \xC2\xB7 ";
  for (const llvm::StringRef mark : {llvm::StringRef(kJoint), llvm::StringRef(" ")}) {
    std::size_t last = 0;
    for (std::size_t at = text.find(mark, from); at != llvm::StringRef::npos; at = text.find(mark, at + 1)) {
      const std::size_t end = at + mark.rtrim().size();
      if (width(text.take_front(end)) > room)
        break;
      last = end;
    }
    if (last > 0)
      return last;
  }
  return std::min(text.find(' ', from + 1), text.size());
}

}  // namespace

void Writer::raw(unsigned indent, llvm::StringRef line) {
  if (!line.empty()) {
    out_.append(indent, ' ');
    out_.append(line.data(), line.size());
  }
  out_ += '\n';
  ++lines_;
}

void Writer::text(llvm::StringRef line) {
  raw(indent_, line);
}

void Writer::left(llvm::StringRef line, unsigned indent) {
  raw(indent, line);
}

void Writer::blank() {
  raw(0, "");
}

void Writer::statement(llvm::StringRef statement) {
  unsigned indent = indent_;
  while (indent + statement.size() > kColumns) {
    const std::size_t at = break_place(statement, kColumns - indent);
    if (at == llvm::StringRef::npos)
      break;
    raw(indent, statement.take_front(at));
    statement = statement.drop_front(at).ltrim();
    indent = indent_ + 4;
  }
  raw(indent, statement);
}

void Writer::comment(llvm::StringRef text, unsigned hang) {
  bool first = true;
  do {
    const unsigned room = kColumns - indent_ - 3 - (first ? 0 : hang);
    const std::size_t taken = width(text) <= room ? text.size() : comment_break(text, room, first ? hang : 0);
    std::string line = "// " + std::string(first ? 0 : hang, ' ') + text.take_front(taken).rtrim().str();
    // A backslash at the end would join the next line to the comment.
    if (line.back() == '\\')
      line += '.';
    raw(indent_, llvm::StringRef(line).rtrim());
    text = text.drop_front(taken).ltrim();
    first = false;
  } while (!text.empty());
}

Block Writer::block(llvm::StringRef head, llvm::StringRef end) {
  return Block(*this, head.empty() ? "{" : head.str() + " {", end);
}

Block::Block(Writer &writer, llvm::StringRef head, llvm::StringRef end) : writer_(&writer), end_(end.str()) {
  writer.statement(head);
  writer.indent_ += 2;
}

Block::~Block() {
  writer_->indent_ -= 2;
  writer_->text(end_);
}

}  // namespace ladderc::emit
