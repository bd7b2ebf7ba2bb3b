// Identifiers of the output.
#include "emit/names.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Path.h"

#include <fmt/format.h>

namespace ladderc::emit {

namespace {

/// Words of letters and digits. Other bytes part words.
template <class F> void for_each_word(llvm::StringRef text, F f) {
  while (!text.empty()) {
    text = text.drop_until(llvm::isAlnum);
    const llvm::StringRef word = text.take_while(llvm::isAlnum);
    if (!word.empty())
      f(word);
    text = text.drop_front(word.size());
  }
}

}  // namespace

std::string class_name(llvm::StringRef path) {
  std::string name;
  for_each_word(llvm::sys::path::stem(path), [&](llvm::StringRef word) {
    name += llvm::toUpper(word.front());
    name += word.drop_front();
  });
  // Members are named as their devices, with one or two letters.
  return name.size() <= 2 || llvm::isDigit(name.front()) ? "Program" + name : name;
}

std::string file_stem(llvm::StringRef path) {
  std::string stem;
  for_each_word(llvm::sys::path::stem(path), [&](llvm::StringRef word) { stem += (stem.empty() ? "" : "_") + word.lower(); });
  return stem.empty() || llvm::isDigit(stem.front()) ? "program" + stem : stem;
}

std::string quoted(llvm::StringRef text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += fmt::format("\\{}", c);
    else if (c == '?')
      out += "\\?";  // two of them would begin a trigraph in C++14 compilers
    else if (byte < 0x20)
      out += fmt::format("\\{:03o}", byte);
    else
      out += c;
  }
  return out + "\"";
}

}  // namespace ladderc::emit
