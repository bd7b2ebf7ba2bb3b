// Reading and writing golden tests.
#include "golden_file.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/CommandLine.h"
#include "llvm/Support/StringSaver.h"

namespace golden {

namespace {

using llvm::StringRef;

bool read_stat(Test &test, StringRef value) {
  auto [name, count] = value.split('=');
  unsigned number = 0;
  if (name.trim().empty() || count.trim().getAsInteger(10, number))
    return false;
  test.stats[name.trim().str()] = number;
  return true;
}

/// One `;;; key: value` line.
bool read_key(Test &test, StringRef key, StringRef value) {
  if (key == "golden")
    test.about = value.str();
  else if (key == "input")
    test.input = value.str();
  else if (key == "exit")
    return !value.getAsInteger(10, test.exit_code);
  else if (key == "stat")
    return read_stat(test, value);
  else if (key == "run") {
    llvm::BumpPtrAllocator memory;
    llvm::StringSaver saver(memory);
    llvm::SmallVector<const char *> words;
    llvm::cl::TokenizeGNUCommandLine(value, saver, words);
    test.arguments.assign(words.begin(), words.end());
  } else
    return false;
  return true;
}

void append_section(std::string &text, StringRef name, StringRef mark, StringRef content) {
  if (content.empty())
    return;
  text += (";;; " + name + "\n").str();
  while (!content.empty()) {
    const auto [line, rest] = content.split('\n');
    text += (mark + (line.empty() ? "" : " ") + line + "\n").str();
    content = rest;
  }
}

}  // namespace

std::optional<Test> parse(const std::string &text, std::string &problem) {
  Test test;
  std::string *section = nullptr;
  unsigned number = 0;
  bool in_header = true;
  for (StringRef rest = text; !rest.empty();) {
    const auto [line, next] = rest.split('\n');
    rest = next;
    ++number;
    if (line == ";;; stdout" || line == ";;; stderr") {
      section = line == ";;; stdout" ? &test.out : &test.err;
      continue;
    }
    if (section) {
      StringRef content = line;
      if (!content.consume_front(section == &test.out ? ";>" : ";!")) {
        problem = "line " + std::to_string(number) + ": neither `;>` nor `;!` below the sections";
        return std::nullopt;
      }
      content.consume_front(" ");
      *section += content.str() + "\n";
      continue;
    }
    test.head += line.str() + "\n";
    StringRef header = line;
    in_header = in_header && header.consume_front(";;;");
    if (!in_header)
      continue;
    const auto [key, value] = header.split(':');
    if (!read_key(test, key.trim(), value.trim())) {
      problem = "line " + std::to_string(number) + ": unknown key or value";
      return std::nullopt;
    }
  }
  if (test.about.empty() || test.arguments.empty())
    problem = "`;;; golden:` or `;;; run:` is missing";
  return problem.empty() ? std::optional(test) : std::nullopt;
}

std::string with_sections(const Test &test, const std::string &out, const std::string &err) {
  std::string text = test.head;
  append_section(text, "stdout", ";>", out);
  append_section(text, "stderr", ";!", err);
  return text;
}

}  // namespace golden
