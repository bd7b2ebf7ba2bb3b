// One pass over bytes: a table says what each byte is, and only bytes beyond ASCII are looked at as characters.
#include "source/words.h"

#include "source/utf8.h"

#include <array>

namespace ladderc {
namespace {

enum class Byte : std::uint8_t { Word, Lower, Blank, LineEnd, Semicolon, Slash, Wide };

constexpr std::array<Byte, 256> kBytes = [] {
  std::array<Byte, 256> table{};
  for (unsigned c = 0x80; c < 0x100; ++c)
    table[c] = Byte::Wide;
  for (unsigned c = 'a'; c <= 'z'; ++c)
    table[c] = Byte::Lower;
  for (unsigned c : {' ', '\t', '\v', '\f'})
    table[c] = Byte::Blank;
  for (unsigned c : {'\r', '\n'})
    table[c] = Byte::LineEnd;
  table[';'] = Byte::Semicolon;
  table['/'] = Byte::Slash;
  return table;
}();

Byte kind(char c) {
  return kBytes[static_cast<unsigned char>(c)];
}

CodePoint character(const char *at, const char *end) {
  return code_point(llvm::StringRef(at, static_cast<std::size_t>(end - at)));
}

bool is_wide_blank(std::uint32_t c) {
  return c == 0x3000 || c == 0xA0 || c == 0xFEFF;
}

constexpr std::uint32_t kWideSemicolon = 0xFF1B;
constexpr std::uint32_t kWideSlash = 0xFF0F;

/// Length of `;`, or of one of the two slashes of `//`, in either width; `mark` says which.
std::size_t mark_character(const char *at, const char *end, char mark) {
  if (at == end)
    return 0;
  if (*at == mark)
    return 1;
  if (kind(*at) != Byte::Wide)
    return 0;
  const CodePoint c = character(at, end);
  return c.value == (mark == ';' ? kWideSemicolon : kWideSlash) ? c.length : 0;
}

/// A string constant: to its closing quote, two quotes standing for one, or to the end of the line.
const char *scan_string(const char *at, const char *end) {
  for (++at; at != end && kind(*at) != Byte::LineEnd; ++at) {
    if (*at != '"')
      continue;
    if (at + 1 == end || at[1] != '"')
      return at + 1;
    ++at;
  }
  return at;
}

/// The ASCII spelling of a character that people and editors write for an ASCII sign; empty where there is none.
llvm::StringRef sign(std::uint32_t c) {
  switch (c) {
  case 0x2264:
  case 0x2266:
    return "<=";
  case 0x2265:
  case 0x2267:
    return ">=";
  case 0x2260:
    return "<>";
  case 0x2013:  // word processors make these of a minus
  case 0x2014:
  case 0x2212:
    return "-";
  default:
    return {};
  }
}

}  // namespace

const char *skip_blanks(const char *at, const char *end) {
  while (at != end) {
    const Byte byte = kind(*at);
    if (byte == Byte::Blank) {
      ++at;
      continue;
    }
    if (byte != Byte::Wide)
      break;
    const CodePoint c = character(at, end);
    if (!is_wide_blank(c.value))
      break;
    at += c.length;
  }
  return at;
}

llvm::StringRef trim_blanks(llvm::StringRef text) {
  const char *begin = skip_blanks(text.begin(), text.end());
  const char *end = text.end();
  while (end != begin) {
    const char *last = end - 1;
    while (last != begin && (*last & 0xC0) == 0x80)
      --last;
    if (skip_blanks(last, end) != end)
      break;
    end = last;
  }
  return llvm::StringRef(begin, static_cast<std::size_t>(end - begin));
}

std::size_t comment_mark(const char *at, const char *end) {
  const char *p = at;
  while (const std::size_t length = mark_character(p, end, ';'))
    p += length;
  if (p != at)
    return static_cast<std::size_t>(p - at);
  std::size_t slashes = 0;
  while (const std::size_t length = mark_character(p, end, '/')) {
    p += length;
    ++slashes;
  }
  return slashes >= 2 ? static_cast<std::size_t>(p - at) : 0;
}

ScannedWord scan_word(const char *at, const char *end, bool comments) {
  if (*at == '"')
    return {scan_string(at, end), true};
  bool as_written = true;
  const char *p = at;
  while (p != end) {
    const Byte byte = kind(*p);
    if (byte == Byte::Word) {
      ++p;
      continue;
    }
    if (byte == Byte::Blank || byte == Byte::LineEnd)
      break;
    if (byte == Byte::Wide && is_wide_blank(character(p, end).value))
      break;
    if (comments && byte != Byte::Lower && comment_mark(p, end) != 0)
      break;
    as_written = as_written && byte != Byte::Lower && byte != Byte::Wide;
    p += byte == Byte::Wide ? character(p, end).length : 1;
  }
  return {p, as_written};
}

llvm::StringRef normalise(llvm::StringRef written, llvm::StringSaver &saver) {
  std::string text;
  text.reserve(written.size());
  while (!written.empty()) {
    const CodePoint c = code_point(written);
    std::uint32_t value = c.value;
    if (value >= 0xFF01 && value <= 0xFF5E)
      value -= 0xFF01 - '!';
    if (value >= 'a' && value <= 'z')
      value -= 'a' - 'A';
    if (llvm::StringRef ascii = sign(value); !ascii.empty())
      text.append(ascii.data(), ascii.size());
    else if (value < 0x80)
      text += static_cast<char>(value);
    else
      text.append(written.data(), c.length);
    written = written.drop_front(c.length);
  }
  return saver.save(text);
}

bool Allowances::read(llvm::StringRef comment) {
  if (!comment.consume_front("ladderc:"))
    return false;
  llvm::StringRef rest = trim_blanks(comment);
  llvm::StringRef verb = rest.take_until([](char c) { return c == ' ' || c == '\t'; });
  llvm::StringRef ids = trim_blanks(rest.drop_front(verb.size()));
  if (verb != "allow" || ids.empty()) {
    diagnostics_.report(DiagId::UnknownDirective, range_of(buffer_, file_, rest)).arg("text", rest);
    return true;
  }
  while (!(ids = ids.ltrim(" \t,")).empty()) {
    llvm::StringRef id = ids.take_until([](char c) { return c == ' ' || c == '\t' || c == ','; });
    ids = ids.drop_front(id.size());
    const DiagInfo *record = find_diagnostic(id);
    if (!record)
      diagnostics_.report(DiagId::UnknownAllow, range_of(buffer_, file_, id)).arg("id", id);
    else if (record->severity != Severity::Warning)
      diagnostics_.report(DiagId::AllowNotWarning, range_of(buffer_, file_, id)).arg("id", id);
    else
      pending_.push_back(id);
  }
  return true;
}

void Allowances::enter(std::uint32_t offset, bool continues) {
  if (!continues)
    current_.clear();
  current_.append(pending_.begin(), pending_.end());
  pending_.clear();
  if (current_.empty())
    return;
  const unsigned line = buffer_.line_of(offset);
  for (llvm::StringRef id : current_)
    diagnostics_.allow(file_, line, id);
}

}  // namespace ladderc
