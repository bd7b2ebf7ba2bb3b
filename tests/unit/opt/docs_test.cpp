// docs/passes.md: for every pass a list, the IR before and after the pass alone, and the C++ before and after. All are made by the
// compiler.
#include "compiled.h"

#include "emit/program.h"
#include "opt/pipeline.h"

#include "llvm/Support/MemoryBuffer.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

std::vector<std::string> blocks(llvm::StringRef text) {
  std::vector<std::string> found;
  for (std::size_t at = text.find("```"); at != llvm::StringRef::npos;) {
    const std::size_t body = text.find('\n', at) + 1, end = text.find("```", body);
    if (end == llvm::StringRef::npos)
      break;
    found.push_back(text.slice(body, end).str());
    at = text.find("```", end + 3);
  }
  return found;
}

class Docs : public testing::Test {
protected:
  void SetUp() override {
    auto file = llvm::MemoryBuffer::getFile(LADDERC_SOURCE_DIR "/docs/passes.md");
    ASSERT_TRUE(bool(file));
    text = (*file)->getBuffer().str();
  }
  /// From the pass's heading to the next one.
  std::string section(llvm::StringRef pass) const {
    const std::size_t at = text.find("\n## " + pass.str() + "\n");
    return at == std::string::npos ? "" : text.substr(at + 1, text.find("\n## ", at + 1) - at);
  }
  std::string text;
};

TEST_F(Docs, EveryPassHasItsSection) {
  for (const opt::Pass &pass : opt::passes())
    EXPECT_NE(section(pass.name), "") << pass.name.str();
}

TEST_F(Docs, EveryExampleIsWhatTheCompilerMakes) {
  for (const opt::Pass &pass : opt::passes()) {
    SCOPED_TRACE(pass.name.str());
    const std::vector<std::string> parts = blocks(section(pass.name));
    ASSERT_GE(parts.size(), 5u);
    ASSERT_EQ(parts.size() % 5, 0u);
    for (std::size_t i = 0; i < parts.size(); i += 5) {
      auto c = compile(parts[i] + "END\n", "{}", "press.il");
      EXPECT_EQ(c->ir(), parts[i + 1]);
      EXPECT_EQ(emit::emit_rungs(c->program, c->module, c->sources, {}), parts[i + 3]);
      opt::Options options;
      options.only = {pass.name.str()};
      opt::Context context;
      ASSERT_EQ(opt::run(c->module, options, context), "");
      EXPECT_FALSE(context.counts().empty()) << "the example gives the pass nothing to do";
      EXPECT_EQ(c->ir(), parts[i + 2]);
      EXPECT_EQ(emit::emit_rungs(c->program, c->module, c->sources, {}), parts[i + 4]);
    }
  }
}

}  // namespace
}  // namespace ladderc::test
