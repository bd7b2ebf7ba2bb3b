// The committed reference pages are what the records say.
#include "gtest/gtest.h"

#include <fstream>
#include <sstream>
#include <string>

namespace {

std::string read(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path << " cannot be read";
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void expect_committed(const std::string &generated_name, const std::string &committed_name) {
  std::string generated = LADDERC_BINARY_DIR "/generated/" + generated_name, committed = LADDERC_SOURCE_DIR "/" + committed_name;
  std::string made = read(generated);
  EXPECT_FALSE(made.empty());
  // Not EXPECT_EQ: gtest would print both pages.
  EXPECT_TRUE(made == read(committed)) << "the records have changed; look at the difference and refresh the page:\n  cp "
                                       << generated << " " << committed;
}

TEST(GeneratedPage, MelsecQsInstructionsAreCommitted) {
  expect_committed("melsec-fx.md", "docs/instructions/melsec-fx.md");
  expect_committed("melsec-qs.md", "docs/instructions/melsec-qs.md");
  expect_committed("tp03.md", "docs/instructions/tp03.md");
}

TEST(GeneratedPage, DiagnosticsAreCommitted) {
  expect_committed("diagnostics.md", "docs/diagnostics.md");
}

}  // namespace
