// Messages for people: GCC's form, with the source line and a caret that stands right under wide characters, too.
#include "support/diagnostics.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Unicode.h"

#include <algorithm>

namespace ladderc {
namespace {

constexpr unsigned kTabWidth = 8;
/// Longer source lines are shown as a window around the place: some lists are one line.
constexpr unsigned kMaxColumns = 160;
constexpr unsigned kColumnsBefore = 60;

/// Bytes of the character that `text` begins with; 1 where it is not UTF-8.
std::size_t character_length(llvm::StringRef text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t length = lead < 0xC0 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  return std::min(length, text.size());
}

/// A character as it is shown: what is printed and how many columns that takes.
struct Glyph {
  std::string text;
  unsigned width;
};

Glyph glyph(llvm::StringRef character, unsigned column) {
  const auto byte = static_cast<unsigned char>(character.front());
  if (byte == '\t') {
    const unsigned width = kTabWidth - column % kTabWidth;
    return {std::string(width, ' '), width};
  }
  if (character.size() == 1 && byte >= 0x20 && byte < 0x7F)
    return {character.str(), 1};
  // A control character would move the caret or speak to the terminal: its picture stands for it.
  if (byte < 0x20)
    return {std::string("\xE2\x90") + static_cast<char>(0x80 + byte), 1};
  if (byte == 0x7F)
    return {"\xE2\x90\xA1", 1};
  const int width = llvm::sys::unicode::columnWidthUTF8(character);
  if (width < 0)
    return {"\xEF\xBF\xBD", 1};
  return {character.str(), static_cast<unsigned>(width)};
}

std::string printable(llvm::StringRef text) {
  std::string result;
  while (!text.empty()) {
    llvm::StringRef character = text.take_front(character_length(text));
    result += glyph(character, 0).text;
    text = text.drop_front(character.size());
  }
  return result;
}

/// A line with the columns of a range of it.
struct ShownLine {
  std::string text;
  unsigned caret = 0;
  unsigned width = 0;  ///< of the range
};

ShownLine show_line(llvm::StringRef line, std::size_t first, std::size_t last) {
  // The window begins at most kColumnsBefore characters before the range, so that a line of any length costs little.
  std::size_t offset = 0;
  if (line.size() > kMaxColumns && first > kColumnsBefore) {
    offset = first - kColumnsBefore;
    while (offset < first && (line[offset] & 0xC0) == 0x80)
      ++offset;
  }
  ShownLine shown;
  unsigned column = 0;
  if (offset > 0) {
    shown.text = "...";
    column = 3;
  }
  while (offset < line.size() && column < kMaxColumns) {
    llvm::StringRef character = line.substr(offset, character_length(line.substr(offset)));
    if (offset == first)
      shown.caret = column;
    Glyph shape = glyph(character, column);
    shown.text += shape.text;
    column += shape.width;
    if (offset >= first && offset < last)
      shown.width += shape.width;
    offset += character.size();
  }
  if (offset < line.size())
    shown.text += "...";
  else if (first >= line.size())
    shown.caret = column;
  return shown;
}

void print_place(const SourceSet &sources, SourceRange range, llvm::raw_ostream &out) {
  const SourceBuffer &buffer = sources[range.file];
  const LineColumn at = buffer.position(range.begin);
  out << buffer.name() << ':' << at.line << ':' << at.column << ": ";
}

void print_source_line(const SourceSet &sources, SourceRange range, llvm::raw_ostream &out) {
  const SourceBuffer &buffer = sources[range.file];
  const unsigned number = buffer.line_of(range.begin);
  llvm::StringRef line = buffer.line(number);
  const std::size_t start = static_cast<std::size_t>(line.data() - buffer.text().data());
  const std::size_t first = std::min<std::size_t>(range.begin - start, line.size());
  const ShownLine shown = show_line(line, first, first + range.length);
  const std::string margin = llvm::utostr(number);
  const std::size_t margin_width = std::max<std::size_t>(5, margin.size());
  out.indent(static_cast<unsigned>(margin_width - margin.size())) << margin << " |";
  if (llvm::StringRef text = llvm::StringRef(shown.text).rtrim(); !text.empty())
    out << ' ' << text;
  out << '\n';
  out.indent(static_cast<unsigned>(margin_width)) << " | ";
  out.indent(shown.caret) << '^' << std::string(shown.width > 1 ? shown.width - 1 : 0, '~') << '\n';
}

/// "melsec-qs" is cited as "QS": manuals are known by the controller's name, not by its maker's.
std::string manual_name(llvm::StringRef family) {
  return family.rsplit('-').second.empty() ? family.upper() : family.rsplit('-').second.upper();
}

void print_manual(const DiagInfo &record, llvm::StringRef family, llvm::raw_ostream &out) {
  for (const DiagReference &reference : record.references) {
    if (reference.family != family)
      continue;
    out << "  = manual: " << manual_name(family);
    if (!reference.section.empty())
      out << ' ' << reference.section;
    if (!reference.code.empty())
      out << "; the controller reports " << reference.code;
    out << '\n';
  }
}

void print_one(const Diagnostic &diagnostic, const SourceSet &sources, llvm::StringRef family, llvm::raw_ostream &out) {
  const DiagInfo &record = info(diagnostic.id);
  print_place(sources, diagnostic.range, out);
  out << (diagnostic.severity == Severity::Error ? "error: " : "warning: ") << printable(diagnostic.message) << " [" << record.id
      << "]\n";
  print_source_line(sources, diagnostic.range, out);
  for (const Diagnostic &note : diagnostic.notes) {
    print_place(sources, note.range, out);
    out << "note: " << printable(note.message) << '\n';
    // A note on the very same place needs no second picture of it.
    if (note.range.file != diagnostic.range.file || note.range.begin != diagnostic.range.begin)
      print_source_line(sources, note.range, out);
  }
  if (diagnostic.step >= 0) {
    out << "  = at: step " << diagnostic.step;
    if (diagnostic.rung >= 0)
      out << ", rung " << diagnostic.rung;
    out << '\n';
  }
  print_manual(record, family, out);
  if (record.severity == Severity::Warning)
    out << "  = silence: -Wno-" << record.id << ", or `; ladderc: allow " << record.id << "` above line "
        << sources.position(diagnostic.range).line << '\n';
}

void print_count(unsigned count, llvm::StringRef what, llvm::raw_ostream &out) {
  out << count << ' ' << what << (count == 1 ? "" : "s");
}

}  // namespace

void print_text(Diagnostics &diagnostics, llvm::StringRef family, llvm::raw_ostream &out) {
  const unsigned limit = diagnostics.options().max_errors;
  unsigned shown = 0;
  unsigned hidden = 0;
  for (const Diagnostic &diagnostic : diagnostics.sorted()) {
    if (diagnostic.severity == Severity::Error && limit != 0 && shown == limit) {
      ++hidden;
      continue;
    }
    shown += diagnostic.severity == Severity::Error;
    print_one(diagnostic, diagnostics.sources(), family, out);
    out << '\n';
  }
  const unsigned errors = diagnostics.errors();
  const unsigned warnings = diagnostics.warnings();
  if (errors > 0)
    print_count(errors, "error", out);
  if (errors > 0 && warnings > 0)
    out << ", ";
  if (warnings > 0)
    print_count(warnings, "warning", out);
  if (hidden > 0)
    (print_count(hidden, "error", out << "; "), out << " not shown, --max-errors=0 shows all");
  if (errors > 0 || warnings > 0)
    out << '\n';
}

}  // namespace ladderc
