// Indentation, line breaking and comments of generated text.
#include "emit/writer.h"

#include "llvm/Support/Unicode.h"

#include <gtest/gtest.h>

namespace ladderc::emit {
namespace {

std::vector<std::string> lines(llvm::StringRef text) {
  std::vector<std::string> result;
  while (!text.empty()) {
    const auto [line, rest] = text.split('\n');
    result.push_back(line.str());
    text = rest;
  }
  return result;
}

TEST(Writer, BlocksIndentAndClose) {
  Writer out;
  {
    const Block a = out.block("if (x)");
    const Block b = out.block("const int y[] =", "};");
    out.line("{},", 1);
    out.blank();
  }
  out.left(" public:");
  EXPECT_EQ(out.take(), "if (x) {\n  const int y[] = {\n    1,\n\n  };\n}\n public:\n");
}

TEST(Writer, CountsLines) {
  Writer out;
  out.comment("a");
  out.blank();
  out.statement("x = 1;");
  EXPECT_EQ(out.lines(), 3u);
}

TEST(Statement, LongOnesAreBrokenBeforeOperators) {
  Writer out;
  std::string statement = "Y[0] = X[0]";
  for (unsigned i = 1; i < 40; ++i)
    statement += " | X[" + std::to_string(i) + "]";
  out.statement(statement + ";");
  const std::vector<std::string> text = lines(out.take());
  ASSERT_GT(text.size(), 1u);
  std::string joined = text[0];
  for (std::size_t i = 1; i < text.size(); ++i) {
    EXPECT_TRUE(llvm::StringRef(text[i]).starts_with("    | "));
    joined += " " + llvm::StringRef(text[i]).ltrim().str();
  }
  EXPECT_EQ(joined, statement + ";");
  for (const std::string &line : text)
    EXPECT_LE(line.size(), 120u);
}

TEST(Statement, WhatCannotBeBrokenStaysWhole) {
  Writer out;
  const std::string name(150, 'x');
  out.statement(name + ";");
  EXPECT_EQ(out.take(), name + ";\n");
}

TEST(Comment, WrapsBetweenWords) {
  Writer out;
  std::string text;
  for (unsigned i = 0; i < 60; ++i)
    text += (i ? " word" : "word") + std::to_string(i);
  out.comment(text, 4);
  std::string joined;
  for (const std::string &line : lines(out.take())) {
    EXPECT_LE(line.size(), 120u);
    EXPECT_TRUE(llvm::StringRef(line).starts_with("// "));
    joined += (joined.empty() ? "" : " ") + llvm::StringRef(line).drop_front(3).ltrim().str();
  }
  EXPECT_EQ(joined, text);
}

TEST(Comment, WrapsBetweenInstructionsWhereItCan) {
  Writer out;
  std::string text = "rung 1";
  for (unsigned i = 0; i < 40; ++i)
    text += " \xC2\xB7 AND X" + std::to_string(i);
  out.comment(text, 10);
  for (const std::string &line : lines(out.take()))
    EXPECT_FALSE(llvm::StringRef(line).ends_with("AND")) << line;
}

TEST(Comment, ABackslashAtTheEndJoinsNoLine) {
  Writer out;
  out.comment("path C:\\");
  out.comment("path C:\\   ");
  EXPECT_EQ(out.take(), "// path C:\\.\n// path C:\\.\n");
  // Nor where the text is wrapped behind one.
  std::string text(110, 'x');
  out.comment(text + " a\\ bbbbbbbbbbbbbbb ccccccccccccc");
  for (const std::string &line : lines(out.take()))
    EXPECT_FALSE(llvm::StringRef(line).ends_with("\\")) << line;
}

TEST(Comment, WideCharactersCountTwice) {
  Writer out;
  std::string text;
  for (unsigned i = 0; i < 40; ++i)
    text += "\xE7\x94\xB5\xE5\x8A\xA8\xE6\x9C\xBA ";  // three characters of two columns
  out.comment(text);
  for (const std::string &line : lines(out.take()))
    EXPECT_LE(llvm::sys::unicode::columnWidthUTF8(line), 120);
}

TEST(Comment, OneLongWordStaysWhole) {
  Writer out;
  const std::string word(300, 'x');
  out.comment(word + " end", 8);
  EXPECT_EQ(out.take(), "// " + word + "\n//         end\n");
}

TEST(Comment, EmptyTextIsAnEmptyComment) {
  Writer out;
  out.comment("");
  EXPECT_EQ(out.take(), "//\n");
}

}  // namespace
}  // namespace ladderc::emit
