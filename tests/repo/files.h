// The files of the repository as the tests about it see them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace repo {

struct File {
  std::string path;  ///< from the root, with '/'
  std::string text;

  std::string_view name() const { return std::string_view(path).substr(path.rfind('/') + 1); }
  bool ends_with(std::string_view end) const { return std::string_view(path).ends_with(end); }
  std::string_view first_line() const { return std::string_view(text).substr(0, text.find('\n')); }
};

std::filesystem::path root();

/// Every file but those of version control and of builds, sorted by path.
const std::vector<File> &files();

/// The text of one file; fails the test where it is missing.
std::string read(std::string_view path);

}  // namespace repo
