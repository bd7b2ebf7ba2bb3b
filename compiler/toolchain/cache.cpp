// The cache of built programs.
#include "toolchain/toolchain.h"

#include "llvm/ADT/SmallString.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/SHA1.h"
#include "llvm/Support/raw_ostream.h"

#include <fmt/format.h>

namespace ladderc::toolchain {

std::string cache_folder(llvm::StringRef key) {
  llvm::SmallString<256> path;
  if (!llvm::sys::path::cache_directory(path))
    llvm::sys::path::system_temp_directory(true, path);
  llvm::sys::path::append(path, "ladderc", key);
  llvm::sys::fs::create_directories(path);
  return path.str().str();
}

std::string cache_key(llvm::ArrayRef<llvm::StringRef> parts, const Locations &locations) {
  llvm::SHA1 hash;
  auto add = [&](llvm::StringRef text) {
    hash.update(text);
    hash.update(llvm::StringRef("\0", 1));
  };
  for (llvm::StringRef part : parts)
    add(part);
  add(find_compiler());
  add(LADDERC_EXTRA_FLAGS);
  // Headers of the runtime are part of the program too; the library is rebuilt whenever one of them changes in a build tree.
  llvm::sys::fs::file_status status;
  if (!llvm::sys::fs::status(locations.hosted_library, status))
    add(fmt::format("{} {}", status.getSize(), status.getLastModificationTime().time_since_epoch().count()));
  std::error_code ec;
  for (llvm::sys::fs::recursive_directory_iterator it(locations.runtime_include + "/ladder", ec), end; it != end && !ec; it.increment(ec))
    if (!llvm::sys::fs::status(it->path(), status))
      add(fmt::format("{} {} {}", it->path(), status.getSize(), status.getLastModificationTime().time_since_epoch().count()));
  return llvm::toHex(hash.final(), true).substr(0, 24);
}

std::optional<std::string> write_file(llvm::StringRef path, llvm::StringRef text) {
  if (auto old = llvm::MemoryBuffer::getFile(path); old && (*old)->getBuffer() == text)
    return std::nullopt;
  std::error_code ec;
  llvm::raw_fd_ostream out(path, ec);
  if (!ec) {
    out << text;
    out.close();
    ec = out.error();
    out.clear_error();
  }
  if (ec)
    return fmt::format("cannot write {}: {}", path.str(), ec.message());
  return std::nullopt;
}

}  // namespace ladderc::toolchain
