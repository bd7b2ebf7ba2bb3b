// Runs a fuzz entry without libFuzzer: every file of the corpus, then a fixed number of damaged copies, the same ones each time.
//
//     fuzz-list [--runs=N] [--seed=N] FILE|FOLDER...
#include "generate/random.h"

#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringRef.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);

namespace {

namespace fs = std::filesystem;
using ladderc::Random;

constexpr std::size_t kLongest = 6000;  ///< damaged copies are cut to this, to have many of them

std::string read_file(const fs::path &path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void add(const fs::path &path, std::vector<std::string> &files) {
  if (!fs::is_directory(path)) {
    files.push_back(path.string());
    return;
  }
  for (const auto &entry : fs::recursive_directory_iterator(path))
    if (entry.is_regular_file())
      files.push_back(entry.path().string());
}

/// Words of the corpus: what a damaged copy gets is then often something that means something.
std::vector<std::string> words_of(const std::vector<std::string> &corpus) {
  std::vector<std::string> words;
  for (const std::string &text : corpus) {
    llvm::SmallVector<llvm::StringRef> parts;
    llvm::SplitString(text, parts, " \n\t");
    for (llvm::StringRef word : parts)
      if (word.size() < 30)
        words.push_back(word.str());
  }
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

std::string damaged(const std::vector<std::string> &corpus, const std::vector<std::string> &words, Random &random) {
  std::string text = random.pick(llvm::ArrayRef(corpus));
  if (text.size() > kLongest)
    text = text.substr(random.below(static_cast<std::uint32_t>(text.size() - kLongest)), kLongest);
  for (unsigned n = 1 + random.below(6); n > 0; --n) {
    const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()) + 1);
    const std::size_t length = std::min<std::size_t>(random.below(12), text.size() - at);
    switch (random.below(6)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(at, text.substr(at, length));
      break;
    case 2:
      if (at < text.size())
        text[at] = static_cast<char>(random.below(256));
      break;
    case 3: {
      const std::string &other = random.pick(llvm::ArrayRef(corpus));
      text.insert(at, other.substr(random.below(static_cast<std::uint32_t>(other.size()) + 1), random.below(80)));
      break;
    }
    default:
      if (!words.empty())
        text.insert(at, (random.one_in(2) ? " " : "\n") + random.pick(llvm::ArrayRef(words)) + " ");
    }
  }
  return text;
}

void run(const std::string &text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t *>(text.data()), text.size());
}

}  // namespace

int main(int argc, char **argv) {
  unsigned runs = 1000;
  std::uint64_t seed = 1;
  std::vector<std::string> files, corpus;
  for (int i = 1; i < argc; ++i) {
    const auto [name, value] = llvm::StringRef(argv[i]).split('=');
    if (name == "--runs" ? value.getAsInteger(10, runs) : name == "--seed" ? value.getAsInteger(10, seed) : !fs::exists(argv[i])) {
      fmt::print(stderr, "usage: {} [--runs=N] [--seed=N] FILE|FOLDER...\n", argv[0]);
      return 2;
    }
    if (!name.starts_with("--"))
      add(argv[i], files);
  }
  std::sort(files.begin(), files.end());
  for (const std::string &file : files)
    corpus.push_back(read_file(file));
  if (corpus.empty()) {
    fmt::print(stderr, "no corpus\n");
    return 2;
  }
  const std::vector<std::string> words = words_of(corpus);
  Random random(seed);
  const std::string left_behind = fs::path(argv[0]).filename().string() + ".last-input";
  for (const std::string &text : corpus)
    run(text);
  for (unsigned i = 0; i < runs; ++i) {
    const std::string last = damaged(corpus, words, random);
    if (std::FILE *file = std::fopen(left_behind.c_str(), "wb")) {  // a crash leaves it behind
      std::fwrite(last.data(), 1, last.size(), file);
      std::fclose(file);
    }
    run(last);
  }
  std::remove(left_behind.c_str());
  fmt::print("{} files and {} damaged copies\n", corpus.size(), runs);
  return 0;
}
