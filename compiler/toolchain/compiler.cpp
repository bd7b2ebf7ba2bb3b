// Running the C++ compiler.
#include "toolchain/toolchain.h"

#include "llvm/ADT/SmallString.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Errno.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/Program.h"
#include "llvm/Support/raw_ostream.h"

#include <fmt/format.h>

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <deque>

namespace ladderc::toolchain {

namespace {

/// Words of a command line variable such as CXX="ccache g++".
std::vector<std::string> split_words(llvm::StringRef text) {
  llvm::SmallVector<llvm::StringRef> words;
  llvm::SplitString(text, words);
  return {words.begin(), words.end()};
}

int execute(const std::vector<std::string> &command, std::string &error, bool verbose) {
  if (verbose)
    llvm::errs() << llvm::join(command, " ") << "\n";
  const std::vector<llvm::StringRef> arguments(command.begin(), command.end());
  return llvm::sys::ExecuteAndWait(command.front(), arguments, std::nullopt, {}, 0, 0, &error);
}

/// Starts commands and keeps at most `jobs` of them running. True where all of them returned 0.
bool execute_all(const std::vector<std::vector<std::string>> &commands, unsigned jobs, bool verbose, std::string &error) {
  std::deque<llvm::sys::ProcessInfo> running;
  bool ok = true;
  auto wait_for_one = [&] {
    const llvm::sys::ProcessInfo done = llvm::sys::Wait(running.front(), std::nullopt, &error);
    running.pop_front();
    ok &= done.ReturnCode == 0;
  };
  for (const std::vector<std::string> &command : commands) {
    if (running.size() >= std::max(1u, jobs))
      wait_for_one();
    if (verbose)
      llvm::errs() << llvm::join(command, " ") << "\n";
    const std::vector<llvm::StringRef> arguments(command.begin(), command.end());
    bool failed = false;
    running.push_back(llvm::sys::ExecuteNoWait(command.front(), arguments, std::nullopt, {}, 0, &error, &failed));
    if (failed) {
      running.pop_back();
      ok = false;
      break;
    }
  }
  while (!running.empty())
    wait_for_one();
  return ok;
}

}  // namespace

std::string find_compiler() {
  if (const char *cxx = std::getenv("CXX"); cxx && *cxx)
    return cxx;
  for (const char *name : {"g++", "clang++", "c++"})
    if (const auto path = llvm::sys::findProgramByName(name))
      return *path;
  return {};
}

std::optional<std::string> build(llvm::StringRef folder, llvm::ArrayRef<std::string> sources, llvm::StringRef executable,
                                 const Locations &locations, const CompileOptions &options) {
  std::vector<std::string> compiler = split_words(find_compiler());
  if (compiler.empty())
    return "no C++ compiler found: install one (apt install g++) or set CXX";
  const auto program = llvm::sys::findProgramByName(compiler.front());
  if (!program)
    return fmt::format("the C++ compiler '{}' was not found: install it or set CXX", compiler.front());
  compiler.front() = *program;
  std::vector<std::string> flags = {"-std=c++20", fmt::format("-O{}", options.level), "-fno-exceptions", "-fno-rtti",
                                    "-I" + locations.runtime_include, "-I" + locations.hosted_include};
  if (options.debug)
    flags.push_back("-g");
  for (const std::string &flag : split_words(LADDERC_EXTRA_FLAGS))
    flags.push_back(flag);
  if (const char *more = std::getenv("CXXFLAGS"))
    for (const std::string &flag : split_words(more))
      flags.push_back(flag);
  flags.insert(flags.end(), options.extra.begin(), options.extra.end());

  std::vector<std::vector<std::string>> commands;
  std::vector<std::string> link = compiler;
  for (const std::string &source : sources) {
    const std::string object = fmt::format("{}/{}.o", folder.str(), source);
    std::vector<std::string> &command = commands.emplace_back(compiler);
    command.insert(command.end(), flags.begin(), flags.end());
    command.insert(command.end(), {"-c", fmt::format("{}/{}", folder.str(), source), "-o", object});
    link.push_back(object);
  }
  std::string error;
  if (!execute_all(commands, options.jobs, options.verbose, error))
    return error.empty() ? "the C++ compiler reported errors" : error;
  link.insert(link.end(), {locations.hosted_library, "-o", executable.str()});
  for (const std::string &flag : split_words(LADDERC_EXTRA_FLAGS))
    link.push_back(flag);
  if (const char *more = std::getenv("LDFLAGS"))
    for (const std::string &flag : split_words(more))
      link.push_back(flag);
  if (execute(link, error, options.verbose) != 0)
    return error.empty() ? "the linker reported errors" : error;
  return std::nullopt;
}

int run(llvm::StringRef executable, llvm::ArrayRef<std::string> arguments, std::string &error) {
  std::vector<std::string> command = {executable.str()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  // The terminal sends SIGINT to both; the child ends by it and prints its statistics, ladderc waits for that.
  void (*before)(int) = std::signal(SIGINT, SIG_IGN);
  const std::vector<llvm::StringRef> refs(command.begin(), command.end());
  bool failed = false;
  // The child must not inherit the ignored SIGINT: it installs a handler of its own when it starts.
  const int code = llvm::sys::ExecuteAndWait(executable, refs, std::nullopt, {}, 0, 0, &error, &failed);
  std::signal(SIGINT, before);
  return failed || code < 0 ? -1 : code;
}

std::string become(const std::string &executable, llvm::ArrayRef<std::string> arguments) {
  std::vector<std::string> words = {executable};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char *> pointers;
  for (std::string &word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  llvm::outs().flush();
  execv(executable.c_str(), pointers.data());
  return llvm::sys::StrError();
}

}  // namespace ladderc::toolchain
