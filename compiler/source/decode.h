// From bytes to UTF-8.
#pragma once

#include "llvm/ADT/StringRef.h"

#include <string>

namespace ladderc {

struct Decoded {
  std::string text;      ///< valid UTF-8 without byte order mark; CR LF and CR are kept as they are
  std::string encoding;  ///< what was recognised: "UTF-8", "UTF-16LE", "UTF-16BE", "GB18030", "SHIFT_JIS"
  bool damaged = false;  ///< some bytes had no meaning and became U+FFFD
};

/// Decodes by byte order mark, then by structure (zero bytes: UTF-16), then as UTF-8, else as Shift-JIS where that gives kana and
/// as GB18030 otherwise. `encoding` ("auto" or an iconv name) overrides; a name that is not known reads as UTF-8, so ask first. Any
/// bytes give some text.
Decoded decode(llvm::StringRef bytes, llvm::StringRef encoding = "auto");

/// True for "auto" and every name that this machine can decode.
bool is_known_encoding(llvm::StringRef encoding);

}  // namespace ladderc
