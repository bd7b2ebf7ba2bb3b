// The engine: arguments, silencing, counting, order.
#include "support/diagnostics.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

class DiagnosticsTest : public testing::Test {
protected:
  DiagnosticsTest() { sources_.add("a.il", "LD X0\nOUT Y0\nEND\n"); }
  static void warn(Diagnostics &diagnostics, std::uint32_t offset) {
    diagnostics.report(DiagId::UnknownAllow, SourceRange(offset, 3)).arg("id", "x");
  }
  SourceSet sources_;
};

TEST_F(DiagnosticsTest, FillsArgumentsIntoMessagesAndNotes) {
  Diagnostics diagnostics(sources_);
  diagnostics.report(DiagId::UnknownMnemonic, SourceRange(0, 2))
      .arg("word", "LD")
      .arg("family", "F")
      .at(3, 1)
      .note(DiagId::NearestMnemonic, SourceRange(6, 3))
      .arg("name", "OUT");
  ASSERT_EQ(diagnostics.sorted().size(), 1u);
  const Diagnostic &diagnostic = diagnostics.sorted().front();
  EXPECT_EQ(diagnostic.message, "'LD' is no instruction of F");
  EXPECT_EQ(diagnostic.step, 3);
  EXPECT_EQ(diagnostic.rung, 1);
  ASSERT_EQ(diagnostic.notes.size(), 1u);
  EXPECT_EQ(diagnostic.notes[0].message, "the nearest one is 'OUT'");
  EXPECT_EQ(diagnostics.errors(), 1u);
  EXPECT_FALSE(diagnostics.ok());
}

TEST_F(DiagnosticsTest, AnArgumentMayLookLikeAName) {
  Diagnostics diagnostics(sources_);
  diagnostics.report(DiagId::UnknownMnemonic, SourceRange(0, 2)).arg("word", "{family}").arg("family", "F");
  EXPECT_EQ(diagnostics.sorted().front().message, "'{family}' is no instruction of F");
}

TEST_F(DiagnosticsTest, SortsByFileAndPlaceAndKeepsTheOrderOfEquals) {
  Diagnostics diagnostics(sources_);
  warn(diagnostics, 6);
  diagnostics.report(DiagId::UnknownMnemonic, SourceRange(0, 2));
  diagnostics.report(DiagId::StrayOperand, SourceRange(0, 2));
  llvm::ArrayRef<Diagnostic> sorted = diagnostics.sorted();
  ASSERT_EQ(sorted.size(), 3u);
  EXPECT_EQ(sorted[0].id, DiagId::UnknownMnemonic);
  EXPECT_EQ(sorted[1].id, DiagId::StrayOperand);
  EXPECT_EQ(sorted[2].id, DiagId::UnknownAllow);
}

TEST_F(DiagnosticsTest, SilencedWarningsAreNotCounted) {
  DiagOptions options;
  options.silenced.insert("unknown-allow");
  options.silenced.insert("unknown-mnemonic");
  Diagnostics diagnostics(sources_, std::move(options));
  warn(diagnostics, 0);
  diagnostics.report(DiagId::UnknownMnemonic, SourceRange(0, 2));
  EXPECT_EQ(diagnostics.warnings(), 0u);
  EXPECT_EQ(diagnostics.errors(), 1u) << "an error cannot be silenced";
}

TEST_F(DiagnosticsTest, AllowDropsWarningsOfThatLineOnly) {
  Diagnostics diagnostics(sources_);
  diagnostics.allow(0, 2, "unknown-allow");
  diagnostics.allow(0, 1, "damaged-text");
  warn(diagnostics, 0);
  warn(diagnostics, 6);
  ASSERT_EQ(diagnostics.warnings(), 1u);
  EXPECT_EQ(diagnostics.sorted().front().range.begin, 0u);
}

TEST_F(DiagnosticsTest, WarningsBecomeErrorsOnDemand) {
  DiagOptions one;
  one.as_errors.insert("unknown-allow");
  Diagnostics diagnostics(sources_, std::move(one));
  warn(diagnostics, 0);
  diagnostics.report(DiagId::AllowNotWarning, SourceRange(0, 2));
  EXPECT_EQ(diagnostics.errors(), 1u);
  EXPECT_EQ(diagnostics.warnings(), 1u);

  DiagOptions all;
  all.all_warnings_are_errors = true;
  Diagnostics strict(sources_, std::move(all));
  strict.allow(0, 2, "unknown-allow");
  warn(strict, 0);
  warn(strict, 6);
  EXPECT_EQ(strict.errors(), 1u) << "what is allowed is no error either";
}

TEST(DiagnosticRecords, AreFoundByTheirIds) {
  ASSERT_FALSE(all_diagnostics().empty());
  for (const DiagInfo &record : all_diagnostics())
    EXPECT_EQ(find_diagnostic(record.id), &record);
  EXPECT_EQ(find_diagnostic("no-such-id"), nullptr);
  EXPECT_EQ(info(DiagId::UnknownMnemonic).id, "unknown-mnemonic");
}

}  // namespace
}  // namespace ladderc
