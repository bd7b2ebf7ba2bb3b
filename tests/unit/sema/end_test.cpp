// The end of the program.
#include "checking.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

TEST(End, IsNeeded) {
  auto checked = check_text("LD X0\nOUT Y10");
  EXPECT_THAT(checked->messages(), are("2:1 missing-end"));
  EXPECT_FALSE(checked->program.ok);
  EXPECT_THAT(check_text("")->messages(), are("1:1 missing-end"));
  EXPECT_THAT(check_text("; nothing\n")->messages(), testing::Contains(testing::EndsWith(" missing-end")));
}

TEST(End, AloneIsAProgram) {
  auto checked = check_text("END");
  EXPECT_THAT(checked->messages(), no_messages());
  EXPECT_TRUE(checked->program.ok);
  EXPECT_EQ(checked->program.steps, 1u);
}

TEST(End, OtherErrorsShowTooWithoutIt) {
  EXPECT_THAT(check_text("LD X0\nMPS\nOUT Y10\n")->messages(), are("2:1 mps-without-mpp", "3:1 missing-end"));
}

TEST(End, InstructionsBehindIt) {
  auto checked = check_text("LD X0\nOUT Y0\nEND\nNOP\nAND X1\nOUT D0\nEND\n");
  EXPECT_THAT(checked->messages(), are("5:1 after-end"));
  EXPECT_TRUE(checked->program.ok);
  EXPECT_THAT(check_text("END\nNOP\nNOP\n")->messages(), no_messages());
  EXPECT_THAT(check_text("END\nEND\n")->messages(), are("2:1 after-end"));
}

}  // namespace
}  // namespace ladderc::test
