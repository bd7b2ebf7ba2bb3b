// `ladderc explain`: the page of a message.
#include "support/diagnostics.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

std::string page(const DiagInfo &record) {
  std::string text;
  llvm::raw_string_ostream out(text);
  print_explanation(record, out);
  return text;
}

TEST(Explanation, HasAllPartsOfTheRecord) {
  constexpr DiagReference kReferences[] = {{"melsec-qs", "5.2.2", "4010"}};
  const DiagInfo record{"two-words",      Severity::Warning, "'{word}' twice", "It stands twice.",
                        "LD X0\nLD X0\n", "LD X0\n",         kReferences};
  EXPECT_EQ(page(record), "two-words (warning)\n"
                          "\n"
                          "    '{word}' twice\n"
                          "\n"
                          "It stands twice.\n"
                          "\n"
                          "A list that gets it:\n"
                          "    LD X0\n"
                          "    LD X0\n"
                          "\n"
                          "Put right:\n"
                          "    LD X0\n"
                          "\n"
                          "Manual of melsec-qs, section 5.2.2; the controller reports 4010\n"
                          "\n"
                          "To silence it: -Wno-two-words, or `; ladderc: allow two-words` on the line above.\n");
}

TEST(Explanation, EveryErrorAndWarningHasOne) {
  for (const DiagInfo &record : all_diagnostics()) {
    if (record.severity == Severity::Note)
      continue;
    EXPECT_FALSE(record.explanation.empty()) << record.id.str();
    EXPECT_TRUE(llvm::StringRef(page(record)).contains(record.explanation.trim())) << record.id.str();
  }
}

}  // namespace
}  // namespace ladderc
