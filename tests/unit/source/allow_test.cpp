// `; ladderc: allow ID`.
#include "reading.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

/// Line numbers of the list on which a warning `unknown-allow` is not counted after the list was read.
std::string allowed_lines(std::string list) {
  SourceSet sources;
  const unsigned file = sources.add("a.il", std::move(list));
  Diagnostics diagnostics(sources);
  llvm::BumpPtrAllocator memory;
  llvm::StringSaver saver(memory);
  read_list(sources[file], file, ListFormat::Auto, saver, diagnostics, [](const ListLine &) {});
  std::string lines;
  std::uint32_t offset = 0;
  for (unsigned line = 1; line <= sources[file].line_count(); ++line) {
    const unsigned before = diagnostics.warnings();
    diagnostics.report(DiagId::UnknownAllow, SourceRange(offset, 1, file)).arg("id", "x");
    if (diagnostics.warnings() == before)
      lines += std::to_string(line) + " ";
    offset = static_cast<std::uint32_t>(sources[file].text().find('\n', offset) + 1);
  }
  return lines;
}

TEST(Allow, HoldsForTheNextLineWithWords) {
  EXPECT_EQ(allowed_lines("LD X0\n; ladderc: allow unknown-allow\n\n; why\nOUT Y0\nEND"), "5 ");
}

TEST(Allow, BehindAnInstructionItHoldsForThatLine) {
  EXPECT_EQ(allowed_lines("LD X0\nOUT Y0 // ladderc: allow unknown-allow\nEND"), "2 ");
}

TEST(Allow, SeveralIdsAndSeveralLines) {
  EXPECT_EQ(allowed_lines("; ladderc: allow damaged-text, unknown-allow\n; ladderc: allow unclosed-quote\nLD X0\nEND"), "3 ");
}

TEST(Allow, InATableItStandsInAStatementAndHoldsForAllRowsOfTheInstruction) {
  EXPECT_EQ(allowed_lines("0,ladderc: allow unknown-allow,,,,,\n0,,OUT,T0,,,\n,,,K10,,,\n4,,END,,,,\n"), "2 3 ");
}

TEST(Allow, IsNoCommentForPeople) {
  EXPECT_EQ(read_text("; ladderc: allow unknown-allow\nLD X0 ; ladderc: allow unknown-allow\n").text, "2 LD X0\n");
}

TEST(Allow, WhatItCannotDoIsReported) {
  EXPECT_EQ(read_text("; ladderc: allow no-such-id\nLD X0\n").messages, "1 unknown-allow\n");
  EXPECT_EQ(read_text("; ladderc: allow unknown-mnemonic\nLD X0\n").messages, "1 allow-not-warning\n");
  EXPECT_EQ(read_text("; ladderc: disallow x\nLD X0\n").messages, "1 unknown-directive\n");
  EXPECT_EQ(read_text("; ladderc: allow\nLD X0\n").messages, "1 unknown-directive\n");
}

}  // namespace
}  // namespace ladderc
