// A document as a test: its fenced blocks, and doing what they say. README.md describes the comments above them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace docs {

struct Block {
  unsigned line = 0;     ///< of the opening fence, 1-based
  std::string language;  ///< behind the fence
  std::string role;      ///< inside the comment above, "run: exact"; empty: none
  std::string text;      ///< between the fences
};

/// The blocks of a document of this repository, by its path.
std::vector<Block> blocks(std::string_view path);

/// A folder with a copy of samples/, in which commands of a document run one after another.
class Folder {
public:
  explicit Folder(std::string_view document);

  void write(const std::string &name, std::string_view text) const;
  /// Standard output and error of a shell command, and its exit code.
  std::string run(const std::string &command, int &exit_code) const;

private:
  std::string path_;
};

/// Does everything that the document's blocks say, in order. Failures are GoogleTest's.
void follow(std::string_view path);

}  // namespace docs
