// The documents, followed to the letter.
#include "document.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace fs = std::filesystem;

class Followed : public ::testing::TestWithParam<const char *> {};

TEST_P(Followed, IsTrue) {
  docs::follow(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Documents, Followed,
                         ::testing::Values("README.md", "docs/getting-started.md", "docs/generated-code.md", "docs/embedding.md",
                                           "docs/parameters.md", "samples/safety-door/README.md", "samples/conveyor/README.md",
                                           "samples/press/README.md"),
                         [](const auto &test) {
                           std::string name = test.param;
                           for (char &c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c)))
                               c = '_';
                           return name;
                         });

TEST(Scenarios, OfTheirPageRun) {
  const docs::Folder folder("docs/scenarios.md");
  unsigned count = 0;
  for (const docs::Block &block : docs::blocks("docs/scenarios.md")) {
    if (block.role.starts_with("file: "))
      folder.write(block.role.substr(6), block.text);
    if (block.language != "json")
      continue;
    int code = 0;
    folder.write("scenario.json", block.text);
    const std::string output = folder.run("ladderc test scenario.json", code);
    EXPECT_EQ(code, 0) << "docs/scenarios.md:" << block.line << "\n" << output;
    ++count;
  }
  EXPECT_GE(count, 5u);
}

TEST(Links, LeadToFiles) {
  const fs::path root = LADDERC_SOURCE_DIR;
  const std::regex link(R"(\]\(([^)#\s]+))");
  unsigned count = 0;
  for (fs::recursive_directory_iterator it(root), end; it != end; ++it) {
    const std::string name = it->path().filename().string();
    if (it->is_directory() && (name.starts_with(".") || name.starts_with("build")))
      it.disable_recursion_pending();
    if (!it->is_regular_file() || it->path().extension() != ".md")
      continue;
    std::ifstream in(it->path());
    std::ostringstream text;
    text << in.rdbuf();
    const std::string page = text.str();
    for (std::sregex_iterator at(page.begin(), page.end(), link), none; at != none; ++at) {
      const std::string target = (*at)[1];
      if (target.starts_with("http"))
        continue;
      EXPECT_TRUE(fs::exists(it->path().parent_path() / target)) << it->path().lexically_relative(root) << ": " << target;
      ++count;
    }
  }
  EXPECT_GT(count, 20u);
}
