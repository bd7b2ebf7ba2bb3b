// ladderc-differential: random programs, run by -O0 code, by -O2 code and by an interpreter, must do the same.
#include "judges.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace ladderc;
using namespace ladderc::differential;

struct Arguments {
  const FamilyInfo *family = find_family("melsec-qs");
  std::uint64_t first = 1, last = 40;
  unsigned batch = 12;
  bool trap = false, keep_going = false;
  std::string folder, list;
  RunSettings run;
};

int usage(const char *self) {
  fmt::print(
      stderr,
      "usage: {} [--family=ID] [--seeds=FROM-TO] [--scans=N] [--batch=N] [--folder=DIR] [--keep-going] [--trap] [--list=FILE]\n"
      "  --family   of the programs (default melsec-qs)\n"
      "  --seeds    the programs (default 1-40)\n"
      "  --list     this list in the allocation and with the inputs of the first seed, in place of its own list\n"
      "  --trap     undefined behaviour in the compiled programs kills the run\n",
      self);
  return 2;
}

bool read_arguments(int argc, char **argv, Arguments &a) {
  for (int i = 1; i < argc; ++i) {
    auto [name, value] = llvm::StringRef(argv[i]).split('=');
    bool bad = false;
    if (name == "--family") {
      a.family = find_family(value);
      bad = a.family == nullptr;
    } else if (name == "--seeds") {
      const auto [from, to] = value.split('-');
      bad = from.getAsInteger(10, a.first) || (to.empty() ? from : to).getAsInteger(10, a.last) || a.last < a.first;
    } else if (name == "--scans")
      bad = value.getAsInteger(10, a.run.scans);
    else if (name == "--batch")
      bad = value.getAsInteger(10, a.batch) || a.batch == 0;
    else if (name == "--folder")
      a.folder = value.str();
    else if (name == "--list")
      a.list = value.str();
    else if (name == "--trap")
      a.trap = true;
    else if (name == "--keep-going")
      a.keep_going = true;
    else
      bad = true;
    if (bad)
      return false;
  }
  return true;
}

}  // namespace

int main(int argc, char **argv) {
  Arguments a;
  if (!read_arguments(argc, argv, a))
    return usage(argv[0]);
  if (a.folder.empty()) {
    llvm::SmallString<128> folder;
    if (llvm::sys::fs::createUniqueDirectory("ladderc-differential", folder))
      return 2;
    a.folder = folder.str().str();
  }
  std::string replacement;
  if (!a.list.empty()) {
    auto text = llvm::MemoryBuffer::getFile(a.list);
    if (!text) {
      fmt::print(stderr, "{}: {}\n", a.list, text.getError().message());
      return 2;
    }
    replacement = (*text)->getBuffer().str();
    a.last = a.first;
  }
  unsigned failures = 0;
  Counts counts;
  for (std::uint64_t seed = a.first; seed <= a.last;) {
    std::vector<Case> cases;
    for (; seed <= a.last && cases.size() < a.batch; ++seed) {
      cases.push_back(make_case(*a.family, seed));
      if (!replacement.empty())
        cases.back().list = replacement;
    }
    const std::uint64_t from = cases.front().seed;
    const BatchSettings settings{fmt::format("{}/{}", a.folder, from), from / a.batch % 2 == 1, a.trap};
    std::vector<CompiledCase> compiled;
    if (const std::string problem = build_batch(std::move(cases), settings, compiled); !problem.empty()) {
      fmt::print("seeds from {}: {}\n", from, problem);
      ++failures;
      if (!a.keep_going)
        return 1;
      continue;
    }
    for (const CompiledCase &c : compiled) {
      const auto difference = run_case(c, a.run, counts);
      if (!difference)
        continue;
      ++failures;
      fmt::print("seed {} ({} rungs, profile {}{}): {}\n", c.c.seed, c.plain->program.rungs, name(c.c.generate.profile).str(),
                 settings.packed ? ", packed" : "", *difference);
      if (!a.keep_going) {
        fmt::print("{}", c.c.list);
        return 1;
      }
    }
    std::fflush(stdout);
    if (failures == 0)
      llvm::sys::fs::remove_directories(settings.folder);
  }
  fmt::print("{} programs ({} judged by an interpreter), {} scans each, {} stops, {} failures\n", counts.programs, counts.judged,
             a.run.scans, counts.stops, failures);
  return failures ? 1 : 0;
}
