// The pipeline object: stages, messages and what it leaves behind.
#include "driver/compilation.h"
#include "driver/native.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"

#include <gmock/gmock.h>

namespace ladderc::test {
namespace {

using testing::HasSubstr;

driver::Compilation compilation() {
  driver::Compilation c;
  c.options.family = "melsec-qs";
  c.options.diagnostics = "text";
  return c;
}

TEST(Compilation, GoesFromTextToFiles) {
  driver::Compilation c = compilation();
  ASSERT_TRUE(c.check_text("press.il", "LD X0\nOUT Y0\nEND\n", nullptr));
  ASSERT_TRUE(c.lower_and_optimize());
  const auto files = c.emit();
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0].name, "press.h");
  std::vector<std::string> stages;
  for (const auto &[stage, ms] : c.times) {
    stages.push_back(stage);
    EXPECT_GE(ms, 0);
  }
  EXPECT_EQ(stages, (std::vector<std::string>{"read and parse", "check", "lower", "optimize", "emit"}));
}

TEST(Compilation, ErrorsAreReportedAndStopIt) {
  driver::Compilation c = compilation();
  ASSERT_TRUE(c.check_text("press.il", "LD X0\nOUT Q0\nEND\n", nullptr));
  std::string text;
  llvm::raw_string_ostream out(text);
  EXPECT_FALSE(c.report(out));
  EXPECT_THAT(text, HasSubstr("press.il:2:5: error:"));
}

TEST(Compilation, StatsCountRewritesByName) {
  driver::Compilation c = compilation();
  ASSERT_TRUE(c.check_text("press.il", "LD SM400\nMOV K1 D0\nEND\n", nullptr));
  ASSERT_TRUE(c.lower_and_optimize());
  std::string text;
  llvm::raw_string_ostream out(text);
  c.print_stats(out);
  EXPECT_THAT(text, HasSubstr("         1 const-contact.folded\n"));
  EXPECT_THAT(text, HasSubstr(" ms in all\n"));
}

TEST(Native, TheMainFileStartsTheProgramOfTheList) {
  driver::Compilation c = compilation();
  ASSERT_TRUE(c.check_text("x.il", "LD X0\nOUT Y0\nEND\n", nullptr));
  ASSERT_TRUE(c.lower_and_optimize());
  const std::string text = driver::main_text(c.emit(), "a::b", "ProgramX");
  EXPECT_THAT(text, HasSubstr("#include \"x.h\""));
  EXPECT_THAT(text, HasSubstr("a::b::kProgramXSymbols"));
}

/// Every text of every golden test.
std::string golden_texts() {
  std::string text;
  std::error_code ec;
  for (llvm::sys::fs::recursive_directory_iterator it(LADDERC_SOURCE_DIR "/tests/golden", ec), end; it != end && !ec; it.increment(ec))
    if (auto file = llvm::MemoryBuffer::getFile(it->path()))
      text += (*file)->getBuffer();
  return text;
}

TEST(Messages, EachIsShownByAGoldenTest) {
  const std::string text = golden_texts();
  for (const DiagInfo &d : all_diagnostics())
    if (d.severity != Severity::Note)
      EXPECT_NE(text.find("[" + d.id.str() + "]"), std::string::npos) << d.id.str();
}

TEST(Passes, EachIsShownByAGoldenTest) {
  const std::string text = golden_texts();
  for (const opt::Pass &pass : opt::passes())
    EXPECT_NE(text.find("--pass=" + pass.name.str() + " "), std::string::npos) << pass.name.str();
}

}  // namespace
}  // namespace ladderc::test
