// Finding and running the C++ compiler, the cache, files.
#include "toolchain/toolchain.h"

#include "scratch.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace ladderc::test {
namespace {

using testing::HasSubstr;
using toolchain::Locations;

/// Sets a variable for the time of a test.
class Variable {
public:
  Variable(const char *name, const std::string &value) : name_(name) {
    if (const char *old = std::getenv(name))
      old_ = old;
    ::setenv(name, value.c_str(), 1);
  }
  Variable(const Variable &) = delete;
  Variable &operator=(const Variable &) = delete;
  ~Variable() {
    if (old_)
      ::setenv(name_, old_->c_str(), 1);
    else
      ::unsetenv(name_);
  }

private:
  const char *name_;
  std::optional<std::string> old_;
};

TEST(WriteFile, WritesOnlyWhatChanged) {
  const Scratch scratch;
  const std::string path = scratch.write("a", "text");
  llvm::sys::fs::file_status before, after;
  ASSERT_FALSE(llvm::sys::fs::status(path, before));
  EXPECT_EQ(toolchain::write_file(path, "text"), std::nullopt);
  ASSERT_FALSE(llvm::sys::fs::status(path, after));
  EXPECT_EQ(before.getLastModificationTime(), after.getLastModificationTime());
  EXPECT_EQ(toolchain::write_file(path, "other"), std::nullopt);
  EXPECT_EQ(scratch.read("a"), "other");
}

TEST(WriteFile, SaysWhatWentWrong) {
  const auto problem = toolchain::write_file("/nowhere/a", "text");
  ASSERT_TRUE(problem);
  EXPECT_THAT(*problem, HasSubstr("cannot write /nowhere/a"));
}

TEST(Cache, EqualTextsHaveEqualKeys) {
  const Locations none{"/none", "/none", "/none"};
  const std::string key = toolchain::cache_key({"a", "b"}, none);
  EXPECT_EQ(toolchain::cache_key({"a", "b"}, none), key);
  EXPECT_NE(toolchain::cache_key({"a", "c"}, none), key);
  EXPECT_NE(toolchain::cache_key({"ab", ""}, none), key) << "texts do not run together";
  const Variable cxx("CXX", "other-compiler");
  EXPECT_NE(toolchain::cache_key({"a", "b"}, none), key) << "the compiler counts";
}

TEST(Cache, TheRuntimeCounts) {
  const Scratch scratch;
  const Locations before{scratch.path(""), scratch.path(""), scratch.write("libladder_hosted.a", "one")};
  const std::string key = toolchain::cache_key({"a"}, before);
  scratch.write("libladder_hosted.a", "three");
  EXPECT_NE(toolchain::cache_key({"a"}, before), key);
}

TEST(Cache, FoldersLieInTheUsersCache) {
  const Scratch scratch;
  const Variable cache("XDG_CACHE_HOME", scratch.path("cache"));
  const std::string folder = toolchain::cache_folder("0123");
  EXPECT_EQ(folder, scratch.path("cache/ladderc/0123"));
  EXPECT_TRUE(llvm::sys::fs::is_directory(folder));
}

TEST(Compiler, CxxNamesIt) {
  const Variable cxx("CXX", "ccache my-compiler");
  EXPECT_EQ(toolchain::find_compiler(), "ccache my-compiler");
}

TEST(Compiler, AMissingOneIsNamed) {
  const Variable cxx("CXX", "no-such-compiler");
  const auto problem = toolchain::build("/tmp", {}, "/tmp/none", {}, {});
  ASSERT_TRUE(problem);
  EXPECT_THAT(*problem, HasSubstr("'no-such-compiler' was not found"));
}

TEST(Compiler, NoneAtAllSaysHowToGetOne) {
  const Scratch scratch;
  const Variable cxx("CXX", ""), path("PATH", scratch.path(""));
  EXPECT_EQ(toolchain::find_compiler(), "");
  const auto problem = toolchain::build("/tmp", {}, "/tmp/none", {}, {});
  ASSERT_TRUE(problem);
  EXPECT_THAT(*problem, HasSubstr("install one"));
}

TEST(Runtime, LadderRuntimeNamesAnother) {
  const Scratch scratch;
  llvm::sys::fs::create_directories(scratch.path("include/ladder"));
  llvm::sys::fs::create_directories(scratch.path("lib"));
  scratch.write("include/ladder/symbols.h", "");
  scratch.write("lib/libladder_hosted.a", "");
  const Variable named("LADDERC_RUNTIME", scratch.path("."));
  EXPECT_THAT(toolchain::find_runtime("").hosted_library, HasSubstr("lib/libladder_hosted.a"));
  EXPECT_THAT(toolchain::find_runtime("").hosted_library, testing::StartsWith(scratch.path(".")));
}

TEST(Runtime, TheBuildTreesIsThere) {
  const Locations found = toolchain::find_runtime("");
  EXPECT_TRUE(llvm::sys::fs::exists(found.runtime_include + "/ladder/symbols.h"));
}

TEST(Run, GivesTheExitCode) {
  std::string error;
  EXPECT_EQ(toolchain::run("/bin/sh", {"-c", "exit 7"}, error), 7);
  EXPECT_EQ(toolchain::run("/bin/sh", {"-c", "exit 0"}, error), 0);
  EXPECT_EQ(error, "");
}

TEST(Run, TellsWhatCouldNotBeStartedOrWasKilled) {
  std::string error;
  EXPECT_EQ(toolchain::run("/nowhere/program", {}, error), -1);
  EXPECT_NE(error, "");
  error.clear();
  EXPECT_EQ(toolchain::run("/bin/sh", {"-c", "kill -9 $$"}, error), -1);
  EXPECT_NE(error, "");
}

}  // namespace
}  // namespace ladderc::test
