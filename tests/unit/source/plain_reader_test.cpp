// Plain lists: words, comments, step numbers, and everything that people write a little differently.
#include "reading.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

TEST(PlainReader, OneInstructionALine) {
  EXPECT_EQ(read_text("LD X0\nOUT T0 K10\nEND\n").text, "1 LD X0\n2 OUT T0 K10\n3 END\n");
}

TEST(PlainReader, LineEndsOfEveryKindAndBlankLines) {
  EXPECT_EQ(read_text("LD X0\r\n\r\nOR X1\rOUT Y0\n\n\nEND").text, "1 LD X0\n3 OR X1\n4 OUT Y0\n7 END\n");
}

TEST(PlainReader, CommentsBehindAndAbove) {
  EXPECT_EQ(read_text(";; motor ;;\n// second\nLD X0;first\nOUT Y0 // lamp ; on\n;\n  ///\n").text,
            "1 ; motor ;;\n2 ; second\n3 LD X0 ; first\n4 OUT Y0 ; lamp ; on\n");
}

TEST(PlainReader, ASlashIsAMnemonicAndTwoAreAComment) {
  EXPECT_EQ(read_text("/ D0 D1 D2\n/P D0 D1 D2\nD/ D0 D2 D4 // divide\nD/P D0 D2 D4//x\n* D0 D1 D2 + D0 D1\n").text,
            "1 / D0 D1 D2\n2 /P D0 D1 D2\n3 D/ D0 D2 D4 ; divide\n4 D/P D0 D2 D4 ; x\n5 * D0 D1 D2 + D0 D1\n");
}

TEST(PlainReader, StepNumbersAreSkipped) {
  EXPECT_EQ(read_text("0 LD X0\n00001: OUT T0\n  \t12\tK10\n13:END\n14 : NOP\n15\n16:\n").text,
            "1 LD X0\n2 OUT T0\n3 K10\n4 END\n5 NOP\n");
}

TEST(PlainReader, ANumberBehindTheFirstWordStays) {
  EXPECT_EQ(read_text("OUT T0 100\n").text, "1 OUT T0 100\n");
}

TEST(PlainReader, FullWidthCharacters) {
  EXPECT_EQ(read_text("　ＬＤ　Ｘ０　；　手动\n０：ＯＵＴ　ｙ０\n１　ＬＤ＜＝　Ｋ１　Ｄ０／／　注\n").text,
            "1 LD X0 ; 手动\n2 OUT Y0\n3 LD<= K1 D0 ; 注\n");
}

TEST(PlainReader, LowerCaseAndMathematicalSigns) {
  EXPECT_EQ(read_text("ld≤ k−5 d0\nand≥ d0 d1\nor≠ d0 k–1\nld≦ d0 d1\nout y0\n").text,
            "1 LD<= K-5 D0\n2 AND>= D0 D1\n3 OR<> D0 K-1\n4 LD<= D0 D1\n5 OUT Y0\n");
}

TEST(PlainReader, RangesAreThoseOfTheFile) {
  SourceSet sources;
  const unsigned file = sources.add("a.il", "12: ｌｄ  x1f ; a\n");
  Diagnostics diagnostics(sources);
  llvm::BumpPtrAllocator memory;
  llvm::StringSaver saver(memory);
  unsigned lines = 0;
  read_list(sources[file], file, ListFormat::Plain, saver, diagnostics, [&](const ListLine &line) {
    ++lines;
    ASSERT_EQ(line.words.size(), 2u);
    EXPECT_EQ(sources.text(line.words[0].range), "ｌｄ");
    EXPECT_EQ(line.words[0].text, "LD");
    EXPECT_EQ(sources.text(line.words[1].range), "x1f");
    EXPECT_EQ(sources.position(line.words[1].range).column, 9u);
    EXPECT_EQ(sources.text(line.comment), "a");
  });
  EXPECT_EQ(lines, 1u);
}

TEST(PlainReader, StringsKeepBlanksCaseAndCommentMarks) {
  EXPECT_EQ(read_text("$MOV \"ab ;c // d\" D0 ; x\n$MOV \"a\"\"b\" D0\nX \"open ; end\nEND\n").text,
            "1 $MOV \"ab ;c // d\" D0 ; x\n2 $MOV \"a\"\"b\" D0\n3 X \"open ; end\n4 END\n");
}

TEST(PlainReader, UpperCaseWordsAreNotCopied) {
  SourceSet sources;
  const unsigned file = sources.add("a.il", "LD X0\n");
  Diagnostics diagnostics(sources);
  llvm::BumpPtrAllocator memory;
  llvm::StringSaver saver(memory);
  read_list(sources[file], file, ListFormat::Plain, saver, diagnostics,
            [&](const ListLine &line) { EXPECT_EQ(line.words[0].text.data(), sources[file].text().data()); });
  EXPECT_EQ(memory.getBytesAllocated(), 0u);
}

TEST(PlainReader, DamageIsReportedOnce) {
  const Reading reading = read_text("LD X0 ; \xEF\xBF\xBD\nOUT Y0 ; \xEF\xBF\xBD\n");
  EXPECT_EQ(reading.messages, "1 damaged-text\n");
}

TEST(PrintLines, ShowsWhatTheReaderSaw) {
  SourceSet sources;
  const unsigned file = sources.add("a.il", "; start\n0 ld x0 ; a\n\nOUT Y0\n");
  Diagnostics diagnostics(sources);
  std::string text;
  llvm::raw_string_ostream out(text);
  print_lines(sources[file], file, ListFormat::Auto, diagnostics, out);
  EXPECT_EQ(text, "1: comment: start\n2: LD X0\n2: comment: a\n4: OUT Y0\n");
}

}  // namespace
}  // namespace ladderc
