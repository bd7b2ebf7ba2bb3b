// The text form of a golden test: one file that is the program, its command and its answer.
//
//     ;;; golden: self-hold reads the image that the same rung writes
//     ;;; run: build -O0 --emit=ir
//     LD X0
//     ...
//     ;;; stdout
//     ;> routine main {
//
// Header and expectation are comments of the list (and of IR text), so that ladderc reads the very file and its line numbers are
// real.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace golden {

struct Test {
  std::string about;                      ///< golden: the behaviour in one sentence
  std::vector<std::string> arguments;     ///< run: of ladderc
  std::optional<std::string> input;       ///< input: the file that ladderc reads instead of the test, or "none"
  int exit_code = 0;                      ///< exit:
  std::map<std::string, unsigned> stats;  ///< stat: counts of `--stats`, complete where there is one
  std::string out, err;                   ///< sections stdout and stderr
  std::string head;                       ///< the text above the sections
};

/// Reads a test. On failure returns nothing and `problem` says why.
std::optional<Test> parse(const std::string &text, std::string &problem);

/// `head` with these sections.
std::string with_sections(const Test &test, const std::string &out, const std::string &err);

}  // namespace golden
