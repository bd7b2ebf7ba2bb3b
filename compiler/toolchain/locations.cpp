// Where the runtime is.
#include "toolchain/toolchain.h"

#include "llvm/ADT/SmallString.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"

#include <cstdlib>

namespace ladderc::toolchain {

namespace {

std::string join(llvm::StringRef a, llvm::StringRef b) {
  llvm::SmallString<256> path(a);
  llvm::sys::path::append(path, b);
  return path.str().str();
}

std::optional<Locations> below(llvm::StringRef prefix) {
  Locations found{join(prefix, "include"), join(prefix, "include"), join(prefix, "lib/libladder_hosted.a")};
  if (llvm::sys::fs::exists(join(found.runtime_include, "ladder/symbols.h")) && llvm::sys::fs::exists(found.hosted_library))
    return found;
  return std::nullopt;
}

}  // namespace

Locations find_runtime(llvm::StringRef argv0) {
  if (const char *named = std::getenv("LADDERC_RUNTIME"))
    if (const auto found = below(named))
      return *found;
  static int anchor;
  const std::string self = llvm::sys::fs::getMainExecutable(argv0.str().c_str(), &anchor);
  if (!self.empty())
    if (const auto found = below(llvm::sys::path::parent_path(llvm::sys::path::parent_path(self))))
      return *found;
  return {LADDERC_RUNTIME_INCLUDE, LADDERC_HOSTED_INCLUDE, LADDERC_HOSTED_LIBRARY};
}

}  // namespace ladderc::toolchain
