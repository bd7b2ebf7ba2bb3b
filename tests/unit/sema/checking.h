// Compiles a list as far as sema and shows its messages in one line each.
#pragma once

#include "sema/check.h"

#include "gmock/gmock.h"

#include <memory>
#include <string>
#include <vector>

namespace ladderc::test {

/// A checked list with everything that it refers to.
struct Checked {
  SourceSet sources;
  std::unique_ptr<Diagnostics> diagnostics;
  CheckedProgram program;

  /// "line:column id", in source order.
  std::vector<std::string> messages() const;
  /// The texts, in source order.
  std::vector<std::string> texts() const;
};

/// What a test is about, where it is not the usual controller.
struct Controller {
  llvm::StringRef family = "melsec-qs";
  llvm::StringRef model = {};  ///< empty: the family's first
};

/// `parameters` is JSON.
std::unique_ptr<Checked> check_text(std::string list, llvm::StringRef parameters = "{}", Controller controller = {});

/// The messages of the lines followed by END.
std::vector<std::string> messages_of(std::string lines, llvm::StringRef parameters = "{}", Controller controller = {});

inline auto no_messages() {
  return testing::IsEmpty();
}
/// Exactly these, in order.
template <class... T> auto are(T... expected) {
  return testing::ElementsAre(std::string(expected)...);
}

}  // namespace ladderc::test
