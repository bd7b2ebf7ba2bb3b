// The exact text of messages.
#include "support/diagnostics.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

std::string render(Diagnostics &diagnostics, llvm::StringRef family = "melsec-qs") {
  std::string text;
  llvm::raw_string_ostream out(text);
  print_text(diagnostics, family, out);
  return text;
}

/// Renders a stray-operand error on `word`, which stands in `text` once.
std::string mark(const std::string &text, const std::string &word) {
  SourceSet sources;
  sources.add("a.il", text);
  Diagnostics diagnostics(sources);
  diagnostics
      .report(DiagId::StrayOperand,
              SourceRange(static_cast<std::uint32_t>(text.find(word)), static_cast<std::uint32_t>(word.size())))
      .arg("word", word);
  return render(diagnostics);
}

TEST(DiagnosticText, ErrorWithNoteStepAndManual) {
  SourceSet sources;
  sources.add("press.il", "LD X0\nOUTT Y0\nOUT Y1\nEND\n");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagId::UnknownMnemonic, SourceRange(6, 4))
      .arg("word", "OUTT")
      .arg("family", "MELSEC QS")
      .at(1, 1)
      .note(DiagId::NearestMnemonic, SourceRange(14, 3))
      .arg("name", "OUT");
  EXPECT_EQ(render(diagnostics), "press.il:2:1: error: 'OUTT' is no instruction of MELSEC QS [unknown-mnemonic]\n"
                                 "    2 | OUTT Y0\n"
                                 "      | ^~~~\n"
                                 "press.il:3:1: note: the nearest one is 'OUT'\n"
                                 "    3 | OUT Y1\n"
                                 "      | ^~~\n"
                                 "  = at: step 1, rung 1\n"
                                 "  = manual: QS 9.1.6; the controller reports 4000\n"
                                 "\n"
                                 "1 error\n");
}

TEST(DiagnosticText, TheManualIsThatOfTheFamily) {
  SourceSet sources;
  sources.add("a.il", "X\n");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagId::UnknownMnemonic, SourceRange(0, 1)).arg("word", "X").arg("family", "F");
  EXPECT_EQ(render(diagnostics, "another"), "a.il:1:1: error: 'X' is no instruction of F [unknown-mnemonic]\n"
                                            "    1 | X\n"
                                            "      | ^\n"
                                            "\n"
                                            "1 error\n");
}

TEST(DiagnosticText, ANoteOnTheSamePlaceShowsNoSecondLine) {
  SourceSet sources;
  sources.add("a.il", "OUTT Y0\n");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagId::UnknownMnemonic, SourceRange(0, 4))
      .arg("word", "OUTT")
      .arg("family", "F")
      .note(DiagId::NearestMnemonic, SourceRange(0, 4))
      .arg("name", "OUT");
  EXPECT_EQ(render(diagnostics, ""), "a.il:1:1: error: 'OUTT' is no instruction of F [unknown-mnemonic]\n"
                                     "    1 | OUTT Y0\n"
                                     "      | ^~~~\n"
                                     "a.il:1:1: note: the nearest one is 'OUT'\n"
                                     "\n"
                                     "1 error\n");
}

TEST(DiagnosticText, WarningsTellHowToSilenceThem) {
  SourceSet sources;
  sources.add("a.il", "; ladderc: allow nothing\nLD X0\n");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagId::UnknownAllow, SourceRange(17, 7)).arg("id", "nothing");
  diagnostics.report(DiagId::StrayOperand, SourceRange(28, 2)).arg("word", "X0");
  EXPECT_EQ(render(diagnostics), "a.il:1:18: warning: no message has the id 'nothing' [unknown-allow]\n"
                                 "    1 | ; ladderc: allow nothing\n"
                                 "      |                  ^~~~~~~\n"
                                 "  = silence: -Wno-unknown-allow, or `; ladderc: allow unknown-allow` above line 1\n"
                                 "\n"
                                 "a.il:2:4: error: 'X0' belongs to no instruction [stray-operand]\n"
                                 "    2 | LD X0\n"
                                 "      |    ^~\n"
                                 "\n"
                                 "1 error, 1 warning\n");
}

TEST(DiagnosticText, CaretStandsUnderWideCharacters) {
  EXPECT_EQ(mark("\"手动\"\tＸ５ 电机 K1\n", "电机"), "a.il:1:9: error: '电机' belongs to no instruction [stray-operand]\n"
                                                      "    1 | \"手动\"  Ｘ５ 电机 K1\n"
                                                      "      |              ^~~~\n"
                                                      "\n"
                                                      "1 error\n");
}

TEST(DiagnosticText, TabsAreExpanded) {
  EXPECT_EQ(mark("\tOUT\tY0\tM1\n", "M1"), "a.il:1:9: error: 'M1' belongs to no instruction [stray-operand]\n"
                                           "    1 |         OUT     Y0      M1\n"
                                           "      |                         ^~\n"
                                           "\n"
                                           "1 error\n");
}

TEST(DiagnosticText, ControlCharactersAreShownAsPictures) {
  EXPECT_EQ(mark("LD \x1B[31m X0\n", "X0"), "a.il:1:10: error: 'X0' belongs to no instruction [stray-operand]\n"
                                            "    1 | LD ␛[31m X0\n"
                                            "      |          ^~\n"
                                            "\n"
                                            "1 error\n");
}

TEST(DiagnosticText, ARangeOverTheLineEndStopsThere) {
  SourceSet sources;
  sources.add("a.il", "LD X0\nEND");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagId::StrayOperand, SourceRange(3, 6)).arg("word", "X0");
  diagnostics.report(DiagId::StrayOperand, SourceRange(9, 0)).arg("word", "?");
  EXPECT_EQ(render(diagnostics), "a.il:1:4: error: 'X0' belongs to no instruction [stray-operand]\n"
                                 "    1 | LD X0\n"
                                 "      |    ^~\n"
                                 "\n"
                                 "a.il:2:4: error: '?' belongs to no instruction [stray-operand]\n"
                                 "    2 | END\n"
                                 "      |    ^\n"
                                 "\n"
                                 "2 errors\n");
}

TEST(DiagnosticText, AnEmptyTextHasAPlaceToo) {
  SourceSet sources;
  sources.add("a.il", "");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagId::StrayOperand, SourceRange(0, 0)).arg("word", "?");
  EXPECT_EQ(render(diagnostics), "a.il:1:1: error: '?' belongs to no instruction [stray-operand]\n"
                                 "    1 |\n"
                                 "      | ^\n"
                                 "\n"
                                 "1 error\n");
}

TEST(DiagnosticText, ALongLineIsShownAroundThePlace) {
  std::string line(1000, 'a');
  line += "HERE";
  line += std::string(1000, 'b');
  const std::string expected = "a.il:1:1001: error: 'HERE' belongs to no instruction [stray-operand]\n"
                               "    1 | ..." +
                               std::string(60, 'a') + "HERE" + std::string(160 - 67, 'b') + "...\n      | " + std::string(63, ' ') +
                               "^~~~\n\n1 error\n";
  EXPECT_EQ(mark(line, "HERE"), expected);
}

TEST(DiagnosticText, ErrorsBeyondTheLimitAreCountedButNotShown) {
  SourceSet sources;
  sources.add("a.il", "X0\nX1\nX2\n");
  DiagOptions options;
  options.max_errors = 1;
  Diagnostics diagnostics(sources, std::move(options));
  for (unsigned i = 0; i < 3; ++i)
    diagnostics.report(DiagId::StrayOperand, SourceRange(3 * i, 2)).arg("word", "X");
  EXPECT_EQ(render(diagnostics), "a.il:1:1: error: 'X' belongs to no instruction [stray-operand]\n"
                                 "    1 | X0\n"
                                 "      | ^~\n"
                                 "\n"
                                 "3 errors; 2 errors not shown, --max-errors=0 shows all\n");
}

TEST(DiagnosticText, ACleanListPrintsNothing) {
  SourceSet sources;
  sources.add("a.il", "END\n");
  Diagnostics diagnostics(sources);
  EXPECT_EQ(render(diagnostics), "");
}

}  // namespace
}  // namespace ladderc
