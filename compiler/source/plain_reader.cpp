// A plain list is read in one pass: words are pieces of the buffer, and only a word that is not written in upper-case ASCII is
// copied.
//
//   line    = [ step [":"] ] { word } [ comment ] line-end
//   step    = decimal digits, first on the line
//   comment = (";" | "//") rest of the line
//
// `/`, `D/` and `/P` are words: a comment needs two slashes, and no word has two.
#include "source/plain_reader.h"

#include "source/words.h"

#include "llvm/ADT/StringExtras.h"

#include <cstring>

namespace ladderc {
namespace {

class PlainReader {
public:
  PlainReader(const SourceBuffer &buffer, unsigned file, llvm::StringSaver &saver, Diagnostics &diagnostics,
              llvm::function_ref<void(const ListLine &)> on_line)
      : buffer_(buffer), file_(file), saver_(saver), on_line_(on_line), allowances_(buffer, file, diagnostics),
        at_(buffer.text().begin()), end_(buffer.text().end()) {}

  void read() {
    while (at_ != end_)
      read_line();
  }

private:
  void read_line() {
    words_.clear();
    const char *const line_begin = at_;
    llvm::StringRef comment;
    while (true) {
      at_ = skip_blanks(at_, end_);
      if (at_ == end_ || *at_ == '\n' || *at_ == '\r')
        break;
      if (const std::size_t mark = comment_mark(at_, end_)) {
        comment = take_comment(mark);
        break;
      }
      take_word();
    }
    finish(static_cast<std::uint32_t>(line_begin - buffer_.text().begin()), comment);
    step_seen_ = false;
    // CR LF gives one empty line more, which nobody sees.
    if (at_ != end_)
      ++at_;
  }

  llvm::StringRef take_comment(std::size_t mark) {
    const char *begin = at_ + mark;
    const auto left = static_cast<std::size_t>(end_ - begin);
    const void *lf = left ? std::memchr(begin, '\n', left) : nullptr;
    const char *line_end = lf ? static_cast<const char *>(lf) : end_;
    const auto length = static_cast<std::size_t>(line_end - begin);
    if (const void *cr = length ? std::memchr(begin, '\r', length) : nullptr)
      line_end = static_cast<const char *>(cr);
    at_ = line_end;
    return trim_blanks(llvm::StringRef(begin, static_cast<std::size_t>(line_end - begin)));
  }

  void take_word() {
    const ScannedWord scanned = scan_word(at_, end_, true);
    llvm::StringRef written(at_, static_cast<std::size_t>(scanned.end - at_));
    at_ = scanned.end;
    llvm::StringRef text = scanned.as_written ? written : normalise(written, saver_);
    if (words_.empty() && is_step(text, written))
      return;
    words_.push_back({text, range_of(buffer_, file_, written)});
  }

  /// True where the word is the step number or the colon behind it. `12:LD` is cut, and the scan goes on behind the colon.
  bool is_step(llvm::StringRef text, llvm::StringRef written) {
    if (step_seen_)
      return text == ":";
    llvm::StringRef behind = text.drop_while(llvm::isDigit);
    if (behind.size() == text.size())
      return false;
    if (!behind.empty() && behind.front() != ':')
      return false;
    step_seen_ = true;
    if (behind.size() > 1) {
      constexpr llvm::StringLiteral kWideColon("\xEF\xBC\x9A");
      const std::size_t colon = written.find(':');
      const std::size_t wide = written.find(kWideColon);
      at_ = written.begin() + (colon < wide ? colon + 1 : wide + kWideColon.size());
    }
    return true;
  }

  void finish(std::uint32_t offset, llvm::StringRef comment) {
    if (!comment.empty() && allowances_.read(comment))
      comment = {};
    if (!words_.empty())
      allowances_.line(offset);
    if (words_.empty() && comment.empty())
      return;
    ListLine line;
    line.words = words_;
    if (!comment.empty())
      line.comment = range_of(buffer_, file_, comment);
    on_line_(line);
  }

  const SourceBuffer &buffer_;
  unsigned file_;
  llvm::StringSaver &saver_;
  llvm::function_ref<void(const ListLine &)> on_line_;
  Allowances allowances_;
  const char *at_;
  const char *end_;
  llvm::SmallVector<Word, 16> words_;
  bool step_seen_ = false;  ///< on this line
};

}  // namespace

void read_plain(const SourceBuffer &buffer, unsigned file, llvm::StringSaver &saver, Diagnostics &diagnostics,
                llvm::function_ref<void(const ListLine &)> on_line) {
  PlainReader(buffer, file, saver, diagnostics, on_line).read();
}

}  // namespace ladderc
