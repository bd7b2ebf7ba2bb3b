// docs/ir.md: its examples are what the compiler prints, and no operation is missing.
#include "compiled.h"

#include "llvm/Support/MemoryBuffer.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

std::string read_docs() {
  auto file = llvm::MemoryBuffer::getFile(LADDERC_SOURCE_DIR "/docs/ir.md");
  return file ? (*file)->getBuffer().str() : "";
}

/// The fenced blocks of that language, in order.
std::vector<std::string> blocks(llvm::StringRef text, llvm::StringRef language) {
  std::vector<std::string> found;
  const std::string fence = ("```" + language + "\n").str();
  for (std::size_t at = text.find(fence); at != llvm::StringRef::npos; at = text.find(fence, at + 1)) {
    const llvm::StringRef body = text.drop_front(at + fence.size());
    found.push_back(body.take_front(body.find("```")).str());
  }
  return found;
}

TEST(Docs, EveryListGivesTheIrBelowIt) {
  const std::string text = read_docs();
  const auto lists = blocks(text, "list"), irs = blocks(text, "ir");
  ASSERT_FALSE(lists.empty());
  ASSERT_EQ(lists.size(), irs.size());
  for (std::size_t i = 0; i < lists.size(); ++i)
    EXPECT_EQ(compile(lists[i] + "END\n", "{}", "press.il")->ir(), irs[i]) << lists[i];
}

TEST(Docs, EveryOperationIsExplained) {
  const std::string text = read_docs();
  for (unsigned op = 0; op <= static_cast<unsigned>(ir::Op::EndScan); ++op) {
    const std::string name = ir::name(static_cast<ir::Op>(op)).str();
    EXPECT_TRUE(text.find("`" + name + " ") != std::string::npos || text.find(" = " + name + " ") != std::string::npos) << name;
  }
}

}  // namespace
}  // namespace ladderc::test
