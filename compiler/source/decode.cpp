// The encoding is found from the bytes: a byte order mark, zero bytes in every second place, valid UTF-8; what remains is a text in
// the code page of the machine that wrote it, Chinese unless it reads as kana. Damage becomes U+FFFD and is told, never refused.
#include "source/decode.h"

#include "source/utf8.h"

#include "llvm/ADT/StringExtras.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <iconv.h>

namespace ladderc {
namespace {

/// Length of the valid UTF-8 sequence that `text` begins with, 0 where there is none.
std::size_t sequence_length(llvm::StringRef text) {
  auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  auto follows = [&](std::size_t i) { return i < text.size() && (byte(i) & 0xC0) == 0x80; };
  const unsigned char lead = byte(0);
  if (lead < 0x80)
    return 1;
  if (lead >= 0xC2 && lead < 0xE0)
    return follows(1) ? 2 : 0;
  if (lead >= 0xE0 && lead < 0xF0) {
    if (!follows(1) || !follows(2) || (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) >= 0xA0))
      return 0;  // overlong, or half of a surrogate pair
    return 3;
  }
  if (lead >= 0xF0 && lead < 0xF5) {
    if (!follows(1) || !follows(2) || !follows(3) || (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) >= 0x90))
      return 0;
    return 4;
  }
  return 0;
}

std::size_t skip_ascii(llvm::StringRef text, std::size_t at) {
  while (at + 8 <= text.size()) {
    std::uint64_t word;
    std::memcpy(&word, text.data() + at, 8);
    if (word & 0x8080808080808080ULL)
      break;
    at += 8;
  }
  while (at < text.size() && static_cast<unsigned char>(text[at]) < 0x80)
    ++at;
  return at;
}

/// Bytes up to the first that is not UTF-8.
std::size_t valid_prefix(llvm::StringRef text) {
  std::size_t at = 0;
  while ((at = skip_ascii(text, at)) < text.size()) {
    const std::size_t length = sequence_length(text.substr(at));
    if (length == 0)
      break;
    at += length;
  }
  return at;
}

Decoded from_utf8(llvm::StringRef bytes) {
  Decoded result;
  result.encoding = "UTF-8";
  while (true) {
    const std::size_t good = valid_prefix(bytes);
    result.text.append(bytes.data(), good);
    if (good == bytes.size())
      return result;
    result.text += kReplacement;
    result.damaged = true;
    bytes = bytes.drop_front(good + 1);
  }
}

Decoded from_utf16(llvm::StringRef bytes, bool little) {
  Decoded result;
  result.encoding = little ? "UTF-16LE" : "UTF-16BE";
  result.text.reserve(bytes.size());
  auto unit = [&](std::size_t i) -> std::uint32_t {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    return little ? first | second << 8 : first << 8 | second;
  };
  std::size_t i = 0;
  for (; i + 2 <= bytes.size(); i += 2) {
    std::uint32_t c = unit(i);
    if (c >= 0xD800 && c < 0xE000) {
      const bool pair = c < 0xDC00 && i + 4 <= bytes.size() && unit(i + 2) >= 0xDC00 && unit(i + 2) < 0xE000;
      if (pair) {
        c = 0x10000 + ((c - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
        i += 2;
      } else {
        c = 0xFFFD;
        result.damaged = true;
      }
    }
    append_utf8(c, result.text);
  }
  if (i < bytes.size()) {
    result.text += kReplacement;
    result.damaged = true;
  }
  return result;
}

/// An open iconv conversion to UTF-8.
class Converter {
public:
  explicit Converter(const char *from) : handle_(iconv_open("UTF-8", from)) {}
  Converter(const Converter &) = delete;
  Converter &operator=(const Converter &) = delete;
  ~Converter() {
    if (is_open())
      iconv_close(handle_);
  }
  bool is_open() const { return handle_ != reinterpret_cast<iconv_t>(-1); }

  void convert(llvm::StringRef bytes, Decoded &result) {
    char *in = const_cast<char *>(bytes.data());  // iconv's signature; it does not write there
    std::size_t left = bytes.size();
    std::array<char, 4096> chunk;
    while (left > 0) {
      char *out = chunk.data();
      std::size_t room = chunk.size();
      const std::size_t done = iconv(handle_, &in, &left, &out, &room);
      const int reason = errno;
      result.text.append(chunk.data(), static_cast<std::size_t>(out - chunk.data()));
      if (done != static_cast<std::size_t>(-1) || reason == E2BIG)
        continue;
      // A byte without meaning, or a character cut off by the end: one mark for one byte, then go on behind it.
      result.text += kReplacement;
      result.damaged = true;
      iconv(handle_, nullptr, nullptr, nullptr, nullptr);
      ++in;
      --left;
    }
    char *out = chunk.data();
    std::size_t room = chunk.size();
    iconv(handle_, nullptr, nullptr, &out, &room);  // some code pages hold a character back for a combining mark
    result.text.append(chunk.data(), static_cast<std::size_t>(out - chunk.data()));
  }

private:
  iconv_t handle_;
};

/// Nothing where this machine's iconv does not know the code page.
bool from_code_page(llvm::StringRef bytes, const char *iconv_name, llvm::StringRef shown_name, Decoded &result) {
  Converter converter(iconv_name);
  if (!converter.is_open())
    return false;
  result = Decoded();
  result.encoding = shown_name.str();
  result.text.reserve(bytes.size() + bytes.size() / 2);
  converter.convert(bytes, result);
  if (valid_prefix(result.text) != result.text.size()) {
    result.text = from_utf8(result.text).text;
    result.damaged = true;
  }
  return true;
}

/// Zero bytes in nearly all odd (little endian) or even places, and not in the others: letters, digits and separators of a list in
/// UTF-16 without a mark, even where the comments are Chinese.
enum class Zeros { None, Odd, Even };
Zeros zeros(llvm::StringRef bytes) {
  llvm::StringRef sample = bytes.take_front(4096);
  std::size_t count[2] = {0, 0};
  for (std::size_t i = 0; i < sample.size(); ++i)
    count[i & 1] += sample[i] == 0;
  const std::size_t units = sample.size() / 2;
  if (units == 0)
    return Zeros::None;
  if (count[1] * 4 >= units && count[1] > 4 * count[0])
    return Zeros::Odd;
  if (count[0] * 4 >= units && count[0] > 4 * count[1])
    return Zeros::Even;
  return Zeros::None;
}

/// Japanese text of the code page is known by its kana; Chinese bytes read as Shift-JIS give half-width katakana and rare signs.
bool reads_as_japanese(llvm::StringRef utf8) {
  std::size_t kana = 0, other = 0;
  for (std::size_t at = 0; (at = skip_ascii(utf8, at)) < utf8.size();) {
    const CodePoint c = code_point(utf8.substr(at));
    (c.value >= 0x3041 && c.value <= 0x30FF ? kana : other) += 1;
    if (c.value >= 0xFF61 && c.value <= 0xFF9F)
      ++other;
    at += c.length;
  }
  return kana > 0 && kana * 3 >= other;
}

/// A text that is no UTF-8 and has no mark.
Decoded from_unknown_code_page(llvm::StringRef bytes) {
  Decoded chinese, japanese;
  const bool has_chinese = from_code_page(bytes, "GB18030", "GB18030", chinese);
  const bool has_japanese = from_code_page(bytes, "CP932", "SHIFT_JIS", japanese);
  if (has_japanese && !japanese.damaged && (reads_as_japanese(japanese.text) || (has_chinese && chinese.damaged)))
    return japanese;
  if (has_chinese && !chinese.damaged)
    return chinese;
  // Nothing fits without damage. Where most wide characters are UTF-8, it is UTF-8 with a flaw.
  Decoded utf8 = from_utf8(bytes);
  const std::size_t marks = llvm::StringRef(utf8.text).count(kReplacement);
  std::size_t wide = 0;
  for (std::size_t at = 0; (at = skip_ascii(utf8.text, at)) < utf8.text.size(); ++wide)
    at += code_point(llvm::StringRef(utf8.text).substr(at)).length;
  return has_chinese && marks * 2 > wide ? chinese : utf8;
}

struct NamedEncoding {
  llvm::StringRef name;
  Decoded (*decode)(llvm::StringRef);
};

const NamedEncoding kOwnEncodings[] = {
    {"utf8", [](llvm::StringRef bytes) { return from_utf8(bytes); }},
    {"utf16le", [](llvm::StringRef bytes) { return from_utf16(bytes, true); }},
    {"utf16be", [](llvm::StringRef bytes) { return from_utf16(bytes, false); }},
};

/// "UTF-16LE", "utf_16le" and "utf16le" are one name.
std::string plain_name(llvm::StringRef name) {
  std::string result = name.lower();
  llvm::erase_if(result, [](char c) { return c == '-' || c == '_'; });
  return result;
}

llvm::StringRef without_mark(llvm::StringRef bytes, llvm::StringRef encoding) {
  const std::string name = plain_name(encoding);
  if (name == "utf8")
    bytes.consume_front("\xEF\xBB\xBF");
  if (name == "utf16le")
    bytes.consume_front("\xFF\xFE");
  if (name == "utf16be")
    bytes.consume_front("\xFE\xFF");
  return bytes;
}

Decoded decode_as(llvm::StringRef bytes, llvm::StringRef encoding) {
  const std::string name = plain_name(encoding);
  for (const NamedEncoding &own : kOwnEncodings)
    if (own.name == name)
      return own.decode(without_mark(bytes, encoding));
  Decoded result;
  const bool shift_jis = name == "shiftjis" || name == "sjis";
  if (from_code_page(bytes, shift_jis ? "CP932" : encoding.str().c_str(), encoding.upper(), result))
    return result;
  return from_utf8(bytes);
}

}  // namespace

bool is_known_encoding(llvm::StringRef encoding) {
  if (encoding == "auto")
    return true;
  const std::string name = plain_name(encoding);
  for (const NamedEncoding &own : kOwnEncodings)
    if (own.name == name)
      return true;
  return !encoding.empty() && Converter(encoding.str().c_str()).is_open();
}

static Decoded decode_all(llvm::StringRef bytes, llvm::StringRef encoding) {
  if (encoding != "auto")
    return decode_as(bytes, encoding);
  if (bytes.consume_front("\xEF\xBB\xBF"))
    return from_utf8(bytes);
  if (bytes.consume_front("\xFF\xFE"))
    return from_utf16(bytes, true);
  if (bytes.consume_front("\xFE\xFF"))
    return from_utf16(bytes, false);
  switch (zeros(bytes)) {
  case Zeros::Odd:
    return from_utf16(bytes, true);
  case Zeros::Even:
    return from_utf16(bytes, false);
  case Zeros::None:
    break;
  }
  if (valid_prefix(bytes) == bytes.size())
    return from_utf8(bytes);
  return from_unknown_code_page(bytes);
}

Decoded decode(llvm::StringRef bytes, llvm::StringRef encoding) {
  Decoded decoded = decode_all(bytes, encoding);
  // DOS editors end or fill files with Ctrl-Z.
  while (!decoded.text.empty() && decoded.text.back() == '\x1A')
    decoded.text.pop_back();
  return decoded;
}

}  // namespace ladderc
