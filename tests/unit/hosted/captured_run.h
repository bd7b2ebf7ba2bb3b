// program_main with its output caught.
#pragma once

#include "fake_program.h"

#include "ladder/hosted/program_main.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace ladder::hosted::test {

struct CapturedRun {
  int exit = -1;
  std::string out, err;
};

inline CapturedRun run(std::vector<std::string> words, const ProgramSymbols &symbols = kFake) {
  words.insert(words.begin(), "/opt/plant/fake");
  std::vector<char *> argv;
  for (std::string &word : words)
    argv.push_back(word.data());
  CapturedRun result;
  char *out = nullptr, *err = nullptr;
  std::size_t out_size = 0, err_size = 0;
  std::FILE *out_file = open_memstream(&out, &out_size), *err_file = open_memstream(&err, &err_size);
  result.exit = program_main(static_cast<int>(argv.size()), argv.data(), symbols, out_file, err_file);
  std::fclose(out_file);
  std::fclose(err_file);
  result.out.assign(out, out_size);
  result.err.assign(err, err_size);
  std::free(out);
  std::free(err);
  return result;
}

}  // namespace ladder::hosted::test
