// Documents and lists that name what the code has: they must name all of it.
#include "files.h"

#include "support/diagnostics.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

namespace {

/// What the command prints.
std::string output_of(const std::string &command) {
  const auto close = [](std::FILE *stream) { EXPECT_EQ(pclose(stream), 0); };
  const std::unique_ptr<std::FILE, decltype(close)> stream(popen(command.c_str(), "r"), close);
  std::string text;
  char buffer[4096];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, stream.get()))
    text.append(buffer, count);
  return text;
}

/// First captures of all matches.
std::set<std::string> captures(const std::string &text, const char *pattern) {
  const std::regex expression(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
    found.insert((*it)[1]);
  return found;
}

std::string help(const std::string &subcommand) {
  return output_of(std::string(LADDERC_EXECUTABLE) + " " + subcommand + " --help");
}

std::set<std::string> subcommands() {
  std::string text = help("");
  const std::size_t begin = text.find("SUBCOMMANDS:");
  EXPECT_NE(begin, std::string::npos);
  return captures(text.substr(begin, text.find("Type \"") - begin), "\n  ([a-z]+) +- ");
}

}  // namespace

TEST(Documents, EveryMessageHasItsPage) {
  const std::string pages = repo::read("docs/diagnostics.md");
  EXPECT_FALSE(ladderc::all_diagnostics().empty());
  for (const ladderc::DiagInfo &diagnostic : ladderc::all_diagnostics())
    EXPECT_NE(pages.find("\n### " + diagnostic.id.str() + "\n"), std::string::npos) << diagnostic.id.str();
}

TEST(Documents, EverySubcommandAndOptionIsDescribed) {
  const std::string page = repo::read("docs/cli.md");
  EXPECT_GE(subcommands().size(), 8u);
  for (const std::string &subcommand : subcommands()) {
    EXPECT_NE(page.find("ladderc " + subcommand), std::string::npos) << subcommand;
    const std::set<std::string> options = captures(help(subcommand), "\n  (--?[A-Za-z][a-z-]*)");
    EXPECT_FALSE(options.empty()) << subcommand;
    for (const std::string &option : options)
      EXPECT_NE(page.find("`" + option), std::string::npos) << subcommand << " " << option;
  }
}

TEST(Documents, EveryFormIsCompiled) {
  std::set<std::string> used;
  std::istringstream list(repo::read("tests/generated/every_form.il"));
  for (std::string line; std::getline(list, line);) {
    std::istringstream words(line.substr(0, line.find(';')));
    for (std::string previous, word; words >> word; previous = word) {
      used.insert(word);
      used.insert(previous + " " + word.substr(0, word.find_first_of("0123456789")));
    }
  }
  std::istringstream forms(repo::read("tests/conformance/melsec-qs/forms.txt"));
  unsigned count = 0;
  for (std::string form; std::getline(forms, form);) {
    if (form.empty() || form.front() == '#')
      continue;
    ++count;
    EXPECT_TRUE(used.contains(form)) << form << " is not in tests/generated/every_form.il";
  }
  EXPECT_EQ(count, 143u);
}
