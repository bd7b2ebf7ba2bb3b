// golden_runner --ladderc PATH FILE...
//
// Runs ladderc as each golden test says, in the folder of the test, and compares exit code, output and messages exactly. With
// LADDERC_UPDATE_GOLDEN in the environment the expectations are rewritten instead and the changed files named. The name of a test
// says what it expects: `bad-` errors, `warn-` warnings, any other neither.
#include "golden_file.h"

#include "llvm/ADT/SmallString.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/Program.h"
#include "llvm/Support/raw_ostream.h"

#include <cstdlib>

namespace {

using llvm::StringRef;

struct Outcome {
  int exit_code = -1;
  std::string out, err;
};

std::string read_and_remove(StringRef path) {
  auto file = llvm::MemoryBuffer::getFile(path);
  std::string text = file ? (*file)->getBuffer().str() : "";
  llvm::sys::fs::remove(path);
  return text;
}

Outcome run(const std::string &ladderc, std::vector<std::string> arguments) {
  llvm::SmallString<128> out, err;
  if (llvm::sys::fs::createTemporaryFile("golden", "out", out) || llvm::sys::fs::createTemporaryFile("golden", "err", err))
    return {};
  arguments.insert(arguments.begin(), ladderc);
  const std::vector<StringRef> words(arguments.begin(), arguments.end());
  const std::optional<StringRef> redirects[] = {StringRef("/dev/null"), StringRef(out), StringRef(err)};
  Outcome outcome;
  outcome.exit_code = llvm::sys::ExecuteAndWait(ladderc, words, std::nullopt, redirects);
  outcome.out = read_and_remove(out);
  outcome.err = read_and_remove(err);
  return outcome;
}

/// The counts that `--stats` prints: lines of a number and a name. Times have a unit between.
std::map<std::string, unsigned> counts_of(StringRef text) {
  std::map<std::string, unsigned> counts;
  while (!text.empty()) {
    const auto [line, rest] = text.split('\n');
    text = rest;
    const auto [number, name] = line.trim().split(' ');
    unsigned value = 0;
    if (!number.getAsInteger(10, value) && !name.contains(' '))
      counts[name.str()] = value;
  }
  return counts;
}

std::string listed(const std::map<std::string, unsigned> &counts) {
  std::string text;
  for (const auto &[name, count] : counts)
    text += "  " + name + " = " + std::to_string(count) + "\n";
  return text;
}

/// The first line in which the texts differ, from both.
std::string difference(StringRef expected, StringRef got) {
  for (unsigned line = 1; !expected.empty() || !got.empty(); ++line) {
    const auto [a, more_a] = expected.split('\n');
    const auto [b, more_b] = got.split('\n');
    if (a != b || expected.empty() != got.empty())
      return "  line " + std::to_string(line) + " expected: " + (expected.empty() ? "(nothing)" : a.str()) + "\n  line " +
             std::to_string(line) + " got:      " + (got.empty() ? "(nothing)" : b.str()) + "\n";
    expected = more_a;
    got = more_b;
  }
  return "";
}

/// What the name of the test promises and the outcome does not keep.
std::string check_name(StringRef name, const Outcome &outcome) {
  const bool errors = outcome.exit_code != 0;
  const bool warnings =
      !errors && (StringRef(outcome.err).contains(": warning: ") || StringRef(outcome.out).contains("\"severity\":\"warning\""));
  if (name.starts_with("bad-") != errors)
    return errors ? "there are errors, so the name has to begin with `bad-`\n" : "the name promises errors\n";
  if (name.starts_with("warn-") != warnings)
    return warnings ? "there are warnings, so the name has to begin with `warn-`\n" : "the name promises warnings\n";
  if (!errors && !warnings && !outcome.err.empty())
    return "stderr is not empty:\n" + outcome.err;
  for (const std::string *text : {&outcome.out, &outcome.err})
    if (!text->empty() && text->back() != '\n')
      return "the last line of the output does not end\n";
  return "";
}

class Runner {
public:
  explicit Runner(std::string ladderc) : ladderc_(std::move(ladderc)), update_(std::getenv("LADDERC_UPDATE_GOLDEN") != nullptr) {}

  /// Returns what is wrong, or an empty text.
  std::string test(const std::string &path) {
    auto file = llvm::MemoryBuffer::getFile(path);
    if (!file)
      return "cannot be read\n";
    std::string problem;
    const auto test = golden::parse((*file)->getBuffer().str(), problem);
    if (!test)
      return problem + "\n";
    if (llvm::sys::fs::set_current_path(llvm::sys::path::parent_path(path)))
      return "its folder cannot be entered\n";
    std::vector<std::string> arguments = test->arguments;
    if (test->input != "none")
      arguments.push_back(test->input ? *test->input : llvm::sys::path::filename(path).str());
    const Outcome outcome = run(ladderc_, arguments);
    if (outcome.exit_code != test->exit_code)
      return "exit code " + std::to_string(outcome.exit_code) + ", expected " + std::to_string(test->exit_code) + "\n" +
             outcome.err;
    problem = check_name(llvm::sys::path::filename(path), outcome);
    if (problem.empty() && !test->stats.empty())
      problem = check_stats(*test, arguments);
    if (!problem.empty())
      return problem;
    return update_ ? update(path, *test, outcome) : compare(*test, outcome);
  }

private:
  std::string check_stats(const golden::Test &test, std::vector<std::string> arguments) {
    arguments.push_back("--stats");
    const auto counts = counts_of(run(ladderc_, arguments).err);
    return counts == test.stats ? "" : "counts expected:\n" + listed(test.stats) + "counts got:\n" + listed(counts);
  }

  static std::string compare(const golden::Test &test, const Outcome &outcome) {
    std::string problem;
    if (test.out != outcome.out)
      problem += "stdout differs\n" + difference(test.out, outcome.out);
    if (test.err != outcome.err)
      problem += "stderr differs\n" + difference(test.err, outcome.err);
    return problem;
  }

  static std::string update(const std::string &path, const golden::Test &test, const Outcome &outcome) {
    if (compare(test, outcome).empty())
      return "";
    std::error_code ec;
    llvm::raw_fd_ostream file(path, ec);
    if (ec)
      return "cannot be written\n";
    file << golden::with_sections(test, outcome.out, outcome.err);
    llvm::outs() << "updated: " << path << "\n";
    return "";
  }

  std::string ladderc_;
  bool update_;
};

}  // namespace

int main(int argc, char **argv) {
  if (argc < 4 || StringRef(argv[1]) != "--ladderc") {
    llvm::errs() << "usage: golden_runner --ladderc PATH FILE...\n";
    return 2;
  }
  // Each test runs in its own folder, so all paths have to hold from anywhere.
  std::vector<std::string> paths;
  for (int i = 2; i < argc; ++i) {
    llvm::SmallString<256> path(argv[i]);
    if (llvm::sys::fs::make_absolute(path))
      return 2;
    paths.push_back(path.str().str());
  }
  Runner runner(paths.front());
  unsigned failed = 0;
  for (std::size_t i = 1; i < paths.size(); ++i) {
    if (const std::string problem = runner.test(paths[i]); !problem.empty()) {
      llvm::outs() << "FAILED: " << paths[i] << "\n" << problem;
      ++failed;
    }
  }
  llvm::outs() << paths.size() - 1 - failed << " passed, " << failed << " failed\n";
  return failed ? 1 : 0;
}
