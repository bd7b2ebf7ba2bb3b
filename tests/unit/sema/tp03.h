// Lists of the TP03 in tests of sema.
#pragma once

#include "checking.h"

namespace ladderc::test {

constexpr Controller kTp03{"tp03"};
constexpr Controller kTp03Sr{"tp03", "TP03SR"};

/// The messages of the lines followed by END.
inline std::vector<std::string> tp03(std::string lines, Controller controller = kTp03) {
  return messages_of(std::move(lines), "{}", controller);
}

/// The texts of the messages of the lines followed by END.
inline std::vector<std::string> tp03_texts(std::string lines, Controller controller = kTp03) {
  return check_text(std::move(lines) + "\nEND\n", "{}", controller)->texts();
}

/// `lines` with `{}` replaced by the numbers from `first` to `last`.
inline std::string numbered(llvm::StringRef lines, int first, int last) {
  std::string text;
  for (int n = first; n <= last; ++n) {
    llvm::StringRef rest = lines;
    while (!rest.empty()) {
      auto [before, behind] = rest.split("{}");
      text += before.str();
      if (before.size() != rest.size())
        text += std::to_string(n);
      rest = behind;
    }
  }
  return text;
}

}  // namespace ladderc::test
