// Reading the blocks of a document and following them.
#include "document.h"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace docs {

namespace fs = std::filesystem;

namespace {

std::string read(const fs::path &path) {
  std::ifstream in(path);
  EXPECT_TRUE(in) << path;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// "<!-- run: exact -->" to "run: exact".
std::string role_of(std::string_view line) {
  constexpr std::string_view open = "<!-- ", close = " -->";
  if (!line.starts_with(open) || !line.ends_with(close))
    return {};
  return std::string(line.substr(open.size(), line.size() - open.size() - close.size()));
}

/// Runs the `$ ` lines of a session. Gives the session as it really went.
std::string replay(const Folder &folder, const Block &block, bool exact) {
  const std::size_t at = block.role.find("exit ");
  const int expected = at == std::string::npos ? 0 : std::atoi(block.role.c_str() + at + 5);
  std::istringstream lines(block.text);
  std::string session;
  int code = 0;
  bool any = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("$ "))
      continue;
    EXPECT_EQ(code, 0) << "line " << block.line << ", before: " << line;
    any = true;
    const std::string output = folder.run(line.substr(2), code);
    if (!exact) {
      EXPECT_EQ(code, expected) << "line " << block.line << ": " << line << "\n" << output;
    }
    session += line + "\n" + output;
  }
  EXPECT_TRUE(any) << "line " << block.line << " shows no command";
  EXPECT_EQ(code, expected) << "line " << block.line << "\n" << session;
  return session;
}

/// The document with the texts of blocks replaced, for LADDERC_UPDATE_DOCS.
void update(const fs::path &path, const std::vector<Block> &changed) {
  std::istringstream in(read(path));
  std::string out;
  unsigned number = 0;
  auto next = changed.begin();
  for (std::string line; std::getline(in, line);) {
    ++number;
    out += line + "\n";
    if (next == changed.end() || number != next->line)
      continue;
    out += next->text;
    for (++next; std::getline(in, line);) {
      ++number;
      if (line.starts_with("```")) {
        out += line + "\n";
        break;
      }
    }
  }
  std::ofstream(path) << out;
}

}  // namespace

std::vector<Block> blocks(std::string_view path) {
  std::istringstream in(read(fs::path(LADDERC_SOURCE_DIR) / path));
  std::vector<Block> found;
  std::string role;
  bool inside = false;
  unsigned number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.starts_with("```")) {
      if (!inside)
        found.push_back({number, line.substr(3), role, {}});
      inside = !inside;
    } else if (inside) {
      found.back().text += line + "\n";
    }
    if (!inside)
      role = role_of(line);
  }
  EXPECT_FALSE(inside) << path << " ends inside a block";
  return found;
}

Folder::Folder(std::string_view document) {
  std::string name(document);
  for (char &c : name)
    if (c == '/')
      c = '_';
  const fs::path folder = fs::path(LADDERC_BINARY_DIR) / "documents" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  fs::copy(fs::path(LADDERC_SOURCE_DIR) / "samples", folder / "samples", fs::copy_options::recursive);
  path_ = folder.string();
}

void Folder::write(const std::string &name, std::string_view text) const {
  fs::create_directories((fs::path(path_) / name).parent_path());
  std::ofstream(fs::path(path_) / name) << text;
}

std::string Folder::run(const std::string &command, int &exit_code) const {
  write("command.sh", command + "\n");
  const std::string shell = "cd '" + path_ + "' && PATH=\"" + fs::path(LADDERC_EXECUTABLE).parent_path().string() +
                            ":$PATH\" XDG_CACHE_HOME='" LADDERC_BINARY_DIR "/cache' LADDER_INCLUDE='" LADDERC_SOURCE_DIR
                            "/runtime/include' sh command.sh 2>&1";
  std::FILE *stream = popen(shell.c_str(), "r");
  EXPECT_NE(stream, nullptr);
  std::string text;
  char buffer[4096];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, stream))
    text.append(buffer, count);
  const int status = pclose(stream);
  exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return text;
}

void follow(std::string_view path) {
  const Folder folder(path);
  std::vector<Block> changed;
  unsigned followed = 0;
  for (Block block : blocks(path)) {
    std::string real;
    if (block.role.starts_with("file: ")) {
      folder.write(block.role.substr(6), block.text);
      continue;
    }
    if (block.role.starts_with("is: ")) {
      int code = 0;
      real = folder.run(block.role.substr(4), code);
      EXPECT_EQ(code, 0) << path << ":" << block.line << "\n" << real;
    } else if (block.role.starts_with("run")) {
      real = replay(folder, block, block.role.starts_with("run: exact"));
      if (!block.role.starts_with("run: exact"))
        real = block.text;
    } else {
      EXPECT_TRUE(block.role.empty()) << path << ":" << block.line << ": " << block.role;
      continue;
    }
    ++followed;
    if (real == block.text)
      continue;
    if (std::getenv("LADDERC_UPDATE_DOCS")) {
      block.text = real;
      changed.push_back(std::move(block));
    } else {
      ADD_FAILURE() << path << ":" << block.line << " shows\n" << block.text << "but it is\n" << real;
    }
  }
  EXPECT_GT(followed, 0u) << path << " shows nothing that can be checked";
  if (!changed.empty())
    update(fs::path(LADDERC_SOURCE_DIR) / path, changed);
}

}  // namespace docs
