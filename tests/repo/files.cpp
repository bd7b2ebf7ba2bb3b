// Walking the repository once for all tests.
#include "files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace repo {

namespace fs = std::filesystem;

namespace {

bool is_foreign(const fs::path &folder) {
  const std::string name = folder.filename().string();
  return name.starts_with(".git") || name == "build" || name.starts_with("build-");
}

std::string content(const fs::path &path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

std::vector<File> walk() {
  std::vector<File> found;
  for (fs::recursive_directory_iterator it(root()), end; it != end; ++it) {
    if (it->is_directory() && is_foreign(it->path()))
      it.disable_recursion_pending();
    else if (it->is_regular_file())
      found.push_back({it->path().lexically_relative(root()).generic_string(), content(it->path())});
  }
  std::sort(found.begin(), found.end(), [](const File &a, const File &b) { return a.path < b.path; });
  return found;
}

}  // namespace

fs::path root() {
  return LADDERC_SOURCE_DIR;
}

const std::vector<File> &files() {
  static const std::vector<File> all = walk();
  return all;
}

std::string read(std::string_view path) {
  EXPECT_TRUE(fs::exists(root() / path)) << path << " is missing";
  return content(root() / path);
}

}  // namespace repo
