// The records show lists of their own: examples of instructions, and a wrong and a right list for each message.
#include "checking.h"

#include "llvm/ADT/STLExtras.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

/// Examples of retentive timers need some.
constexpr const char *kWithRetentiveTimers = R"({"ST_points": 16})";

/// The lists of a message belong to one family.
std::unique_ptr<Checked> check_list(const DiagInfo &diagnostic, llvm::StringRef list) {
  return check_text(list.str(), "{}", diagnostic.family.empty() ? Controller() : Controller{diagnostic.family});
}

TEST(Records, WrongListsGetTheirMessageAndNoOther) {
  for (const DiagInfo &diagnostic : all_diagnostics()) {
    if (diagnostic.wrong.empty())
      continue;
    auto checked = check_list(diagnostic, diagnostic.wrong);
    ASSERT_FALSE(checked->messages().empty()) << diagnostic.id.str();
    for (const Diagnostic &d : checked->diagnostics->sorted())
      EXPECT_EQ(info(d.id).id.str(), diagnostic.id.str()) << diagnostic.wrong.str();
  }
}

TEST(Records, RightListsGetNoMessage) {
  for (const DiagInfo &diagnostic : all_diagnostics())
    if (!diagnostic.right.empty()) {
      auto checked = check_list(diagnostic, diagnostic.right);
      EXPECT_THAT(checked->messages(), no_messages()) << diagnostic.id.str() << "\n" << diagnostic.right.str();
    }
}

TEST(Records, MessagesHaveAllTheirArguments) {
  for (const DiagInfo &diagnostic : all_diagnostics()) {
    auto checked = check_list(diagnostic, diagnostic.wrong);
    for (const Diagnostic &d : checked->diagnostics->sorted()) {
      EXPECT_EQ(d.message.find('{'), std::string::npos) << d.message;
      for (const Diagnostic &note : d.notes)
        EXPECT_EQ(note.message.find('{'), std::string::npos) << note.message;
    }
  }
}

TEST(Records, ExamplesOfInstructionsCompileWithoutMessage) {
  for (const FamilyInfo &family : families())
    for (const InstructionInfo &instruction : family.instructions) {
      const llvm::StringRef parameters = find_device(family, "ST") == kNoDevice ? "{}" : kWithRetentiveTimers;
      auto checked = check_text(instruction.example.str(), parameters, {family.id});
      EXPECT_THAT(checked->messages(), no_messages()) << instruction.form.str() << "\n" << instruction.example.str();
      EXPECT_TRUE(checked->program.ok) << instruction.form.str();
      bool shown = llvm::any_of(checked->program.list.instructions, [&](const Instruction &i) { return i.info == &instruction; });
      EXPECT_TRUE(shown) << "the example of " << instruction.form.str() << " does not use it\n" << instruction.example.str();
    }
}

}  // namespace
}  // namespace ladderc::test
