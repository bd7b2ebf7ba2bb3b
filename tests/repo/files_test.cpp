// Rules for every file: nothing depends on what is not here, folders and sources say what they are, and none grows too long to
// read.
#include "files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

bool is_source(const repo::File &file) {
  return file.ends_with(".h") || file.ends_with(".cpp") || file.ends_with(".td");
}

bool is_script(const repo::File &file) {
  return file.ends_with(".cmake") || file.ends_with(".sh") || file.name() == "Makefile" || file.name() == "CMakeLists.txt" ||
         file.path == ".ci/run";
}

std::size_t lines_of(const repo::File &file) {
  return static_cast<std::size_t>(std::count(file.text.begin(), file.text.end(), '\n'));
}

}  // namespace

TEST(Files, AreFound) {
  EXPECT_GT(repo::files().size(), 200u);
  EXPECT_FALSE(repo::read("README.md").empty());
}

TEST(Files, NameNothingBesideTheRepository) {
  const std::string beside = std::string("..") + "/shared";
  for (const repo::File &file : repo::files())
    EXPECT_EQ(file.text.find(beside), std::string::npos) << file.path;
}

TEST(Files, SourcesOpenWithAComment) {
  for (const repo::File &file : repo::files()) {
    if (is_source(file)) {
      EXPECT_TRUE(file.first_line().starts_with("// ")) << file.path;
    } else if (is_script(file) && !(file.name() == "CMakeLists.txt" && lines_of(file) < 15)) {  // a few lines say it by themselves
      EXPECT_TRUE(file.first_line().starts_with("#")) << file.path;
    }
  }
}

TEST(Files, SourcesHaveAtMost600Lines) {
  for (const repo::File &file : repo::files())
    if (is_source(file) || is_script(file)) {
      EXPECT_LE(lines_of(file), 600u) << file.path;
    }
}

TEST(Files, SourcesAndDocumentsEndWithANewline) {
  for (const repo::File &file : repo::files())
    if (is_source(file) || is_script(file) || file.ends_with(".md")) {
      EXPECT_TRUE(file.text.ends_with("\n") && !file.text.ends_with("\n\n")) << file.path;
    }
}

TEST(Files, EveryFolderHasAReadme) {
  std::set<std::string> folders, with_readme;
  for (const repo::File &file : repo::files())
    for (const char *top : {"compiler/", "runtime/", "tests/", "samples/"})
      if (file.path.starts_with(top)) {
        const std::size_t end = file.path.find('/', std::string_view(top).size());
        if (end != std::string::npos)
          folders.insert(file.path.substr(0, end));
        if (file.name() == "README.md")
          with_readme.insert(file.path.substr(0, file.path.rfind('/')));
      }
  EXPECT_GT(folders.size(), 15u);
  for (const std::string &folder : folders) {
    if (with_readme.contains(folder))
      continue;
    // A small folder may have its lines on the page above it.
    const std::size_t slash = folder.rfind('/');
    const std::string above = repo::read(folder.substr(0, slash) + "/README.md");
    EXPECT_NE(above.find("`" + folder.substr(slash + 1) + "/"), std::string::npos) << folder << " has no README.md";
  }
}
