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

/// Decodes by byte order mark, then by structure (zero bytes: UTF-16), then as UTF-8, else as GB18030. `encoding` ("auto" or an iconv
/// name) overrides. Any bytes give some text.
Decoded decode(llvm::StringRef bytes, llvm::StringRef encoding = "auto");

}  // namespace ladderc
