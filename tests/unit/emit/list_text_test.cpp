// The list's own words in comments.
#include "emit/list_text.h"

#include "compiled.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

std::string text_of(const std::string &line) {
  auto c = compile_rungs("LD X0 / " + line);
  return emit::list_text(c->program, c->program.list.instructions[1]);
}

TEST(ListText, IsTheUsualSpelling) {
  EXPECT_EQ(text_of("mov k100 d0"), "MOV K100 D0");
  EXPECT_EQ(text_of("MOV H0f K2Y10"), "MOV HF K2Y10");
  EXPECT_EQ(text_of("SET D0.0a"), "SET D0.A");
  EXPECT_EQ(text_of("OUT Y1f"), "OUT Y1F");
  EXPECT_EQ(text_of("DMOV K-5 W1A"), "DMOV K-5 W1A");
  EXPECT_EQ(text_of("OUT T10 D5"), "OUT T10 D5");
}

std::string comment(const std::string &text) {
  SourceSet sources;
  sources.add("test.il", text);
  return emit::comment_text(sources, SourceRange(0, static_cast<std::uint32_t>(text.size())));
}

TEST(CommentText, IsOneLine) {
  EXPECT_EQ(comment("plain"), "plain");
  EXPECT_EQ(comment("a\tb\x01"
                    "c\x7F"
                    "d"),
            "a b c d");
  EXPECT_EQ(comment("\xE6\x8E\xA7\xE5\x88\xB6 \xF0\x9F\x98\x80"), "\xE6\x8E\xA7\xE5\x88\xB6 \xF0\x9F\x98\x80");
  EXPECT_EQ(comment(""), "");
}

TEST(CommentText, MarksThatTurnTheDirectionAreDropped) {
  EXPECT_EQ(comment("a\xE2\x80\xAE"
                    "b\xE2\x81\xA6"
                    "c\xE2\x81\xA9"),
            "abc");
  EXPECT_EQ(comment("\xE2\x80\x94 \xE2\x80\xA6"), "\xE2\x80\x94 \xE2\x80\xA6");
}

TEST(CommentText, ThreeSemicolonsBelongToTheFile) {
  SourceSet sources;
  sources.add("test.il", ";;; rule\n;; note\n; x");
  EXPECT_TRUE(emit::belongs_to_file(sources, SourceRange(4, 4)));
  EXPECT_FALSE(emit::belongs_to_file(sources, SourceRange(12, 4)));
  EXPECT_FALSE(emit::belongs_to_file(sources, SourceRange(19, 1)));
}

}  // namespace
}  // namespace ladderc::test
