// Identifiers and literals of the output.
#include "emit/names.h"

#include <gtest/gtest.h>

namespace ladderc::emit {
namespace {

TEST(Names, ClassesAreTheFilesWords) {
  EXPECT_EQ(class_name("press.il"), "Press");
  EXPECT_EQ(class_name("folder/press-line 2.il"), "PressLine2");
  EXPECT_EQ(class_name("press.v2.il"), "PressV2");
  EXPECT_EQ(class_name("PRESS_line.csv"), "PRESSLine");
}

TEST(Names, WhatIsNoClassNameGetsOne) {
  EXPECT_EQ(class_name("2nd.il"), "Program2nd");
  EXPECT_EQ(class_name("\xE6\x8E\xA7\xE5\x88\xB6.il"), "Program");
  EXPECT_EQ(class_name("---"), "Program");
  EXPECT_EQ(class_name(""), "Program");
  EXPECT_EQ(class_name("<stdin>"), "Stdin");
}

TEST(Names, AClassIsNotNamedAsItsMembers) {
  EXPECT_EQ(class_name("x.il"), "ProgramX");
  EXPECT_EQ(class_name("SB.il"), "ProgramSB");
  EXPECT_EQ(class_name("sys.il"), "Sys");
}

TEST(Names, StemsAreLowerCase) {
  EXPECT_EQ(file_stem("folder/Press-Line 2.il"), "press_line_2");
  EXPECT_EQ(file_stem("2nd.il"), "program2nd");
  EXPECT_EQ(file_stem("\xE6\x8E\xA7.il"), "program");
}

TEST(Quoted, IsALiteralForAnyText) {
  EXPECT_EQ(quoted("plain"), "\"plain\"");
  EXPECT_EQ(quoted("a\"b\\c"), "\"a\\\"b\\\\c\"");
  EXPECT_EQ(quoted("a\tb\n1"), "\"a\\011b\\0121\"");
  EXPECT_EQ(quoted("what?\?/"), "\"what\\?\\?/\"");
  EXPECT_EQ(quoted(llvm::StringRef("\0"
                                   "7",
                                   2)),
            "\"\\0007\"");
  EXPECT_EQ(quoted("\xE6\x8E\xA7"), "\"\xE6\x8E\xA7\"");
}

}  // namespace
}  // namespace ladderc::emit
