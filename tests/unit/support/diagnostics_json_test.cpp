// Messages for tools: one object a line.
#include "support/diagnostics.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ladderc {
namespace {

std::string render(Diagnostics &diagnostics) {
  std::string text;
  llvm::raw_string_ostream out(text);
  print_json(diagnostics, "melsec-qs", out);
  return text;
}

TEST(DiagnosticJson, HasTheFieldsInTheirOrder) {
  SourceSet sources;
  sources.add("press.il", "LD X0\nOUTT Y0\n");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagId::UnknownMnemonic, SourceRange(6, 4))
      .arg("word", "OUTT")
      .arg("family", "QS")
      .at(1, 2)
      .note(DiagId::NearestMnemonic, SourceRange(6, 4))
      .arg("name", "OUT");
  EXPECT_EQ(render(diagnostics),
            R"({"id":"unknown-mnemonic","severity":"error","message":"'OUTT' is no instruction of QS","file":"press.il",)"
            R"("range":{"line":2,"column":1,"endLine":2,"endColumn":5},"step":1,"rung":2,"args":{"word":"OUTT","family":"QS"},)"
            R"("notes":[{"id":"nearest-mnemonic","severity":"note","message":"the nearest one is 'OUT'","file":"press.il",)"
            R"("range":{"line":2,"column":1,"endLine":2,"endColumn":5},"args":{"name":"OUT"}}],)"
            R"("manual":[{"family":"melsec-qs","section":"9.1.6"}],"plc":{"code":"4000"}})"
            "\n");
}

TEST(DiagnosticJson, NumbersStayNumbersAndColumnsAreCharacters) {
  SourceSet sources;
  sources.add("a.il", "; 手\xEF\xBF\xBD\n");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagId::DamagedText, SourceRange(5, 3)).arg("count", 1LL);
  const auto json = nlohmann::json::parse(render(diagnostics));
  EXPECT_EQ(json["args"]["count"], 1);
  EXPECT_TRUE(json["args"]["count"].is_number());
  EXPECT_EQ(json["severity"], "warning");
  EXPECT_EQ(json["range"]["column"], 4);
  EXPECT_EQ(json["range"]["endColumn"], 5);
  EXPECT_FALSE(json.contains("step"));
  EXPECT_FALSE(json.contains("plc"));
}

TEST(DiagnosticJson, BytesThatAreNoTextDoNotStopIt) {
  SourceSet sources;
  sources.add("a\xFF.il", "X0\n");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagId::StrayOperand, SourceRange(0, 2)).arg("word", "\xC3");
  const auto json = nlohmann::json::parse(render(diagnostics));
  EXPECT_EQ(json["args"]["word"], "\xEF\xBF\xBD");
}

}  // namespace
}  // namespace ladderc
