// Places in texts: line ends of all kinds, columns in characters.
#include "support/source.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

TEST(SourceBuffer, FindsLinesOfEveryKindOfLineEnd) {
  SourceBuffer buffer("a.il", "one\r\ntwo\rthree\n\nfive");
  ASSERT_EQ(buffer.line_count(), 5u);
  EXPECT_EQ(buffer.line(1), "one");
  EXPECT_EQ(buffer.line(2), "two");
  EXPECT_EQ(buffer.line(3), "three");
  EXPECT_EQ(buffer.line(4), "");
  EXPECT_EQ(buffer.line(5), "five");
  EXPECT_EQ(buffer.line(0), "");
  EXPECT_EQ(buffer.line(6), "");
}

TEST(SourceBuffer, ALineEndMayEndTheText) {
  for (const char *text : {"LD X0\r", "LD X0\n", "LD X0\r\n"}) {
    SourceBuffer buffer("a.il", text);
    EXPECT_EQ(buffer.line_count(), 2u);
    EXPECT_EQ(buffer.line(1), "LD X0");
    EXPECT_EQ(buffer.line(2), "");
  }
}

TEST(SourceBuffer, CountsColumnsInCharacters) {
  SourceBuffer buffer("a.il", "LD X0\n; 手动 a\n");
  EXPECT_EQ(buffer.position(0).column, 1u);
  const auto a = static_cast<std::uint32_t>(buffer.text().find('a'));
  EXPECT_EQ(buffer.position(a).line, 2u);
  EXPECT_EQ(buffer.position(a).column, 6u);
}

TEST(SourceBuffer, TheEndOfTheTextHasAPlace) {
  SourceBuffer buffer("a.il", "LD X0\nEND");
  EXPECT_EQ(buffer.position(9).line, 2u);
  EXPECT_EQ(buffer.position(9).column, 4u);
  SourceBuffer empty("b.il", "");
  EXPECT_EQ(empty.line_count(), 1u);
  EXPECT_EQ(empty.position(0).line, 1u);
  EXPECT_EQ(empty.position(0).column, 1u);
}

TEST(SourceSet, RangesNameTheirFile) {
  SourceSet sources;
  sources.add("a.il", "LD X0");
  const unsigned second = sources.add("b.il", "OUT Y0");
  EXPECT_EQ(sources.text(SourceRange(4, 2, second)), "Y0");
  EXPECT_EQ(sources[second].name(), "b.il");
  EXPECT_EQ(sources.position(SourceRange(4, 2, second)).column, 5u);
}

}  // namespace
}  // namespace ladderc
