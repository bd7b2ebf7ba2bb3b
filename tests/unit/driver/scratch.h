// A folder of its own for a test's files.
#pragma once

#include "llvm/ADT/SmallString.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/raw_ostream.h"

#include <string>

namespace ladderc::test {

class Scratch {
public:
  Scratch() {
    llvm::SmallString<128> path;
    llvm::sys::fs::createUniqueDirectory("ladderc-test", path);
    folder_ = path.str().str();
  }
  Scratch(const Scratch &) = delete;
  Scratch &operator=(const Scratch &) = delete;
  ~Scratch() { llvm::sys::fs::remove_directories(folder_); }

  std::string path(const std::string &name) const { return folder_ + "/" + name; }
  std::string write(const std::string &name, const std::string &text) const {
    std::error_code ec;
    llvm::raw_fd_ostream out(path(name), ec);
    out << text;
    return path(name);
  }
  std::string read(const std::string &name) const {
    auto file = llvm::MemoryBuffer::getFile(path(name));
    return file ? (*file)->getBuffer().str() : "";
  }

private:
  std::string folder_;
};

}  // namespace ladderc::test
