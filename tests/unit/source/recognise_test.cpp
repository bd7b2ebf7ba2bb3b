// Which format a text has.
#include "source/list_reader.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

TEST(RecogniseFormat, PlainListsOfAllShapesArePlain) {
  for (const char *list :
       {"", "\n\n", "LD X0\nOUT Y0\nEND\n", "0 LD X0\n1 OUT Y0\n", "0\tLD\tX0\n1\tOUT\tT0\tK10\n",
        "LD\tX0\tAND\tX1\tOUT\tY0\nLD\tX2\tOUT\tY1\nMOV\tK1\tD0\tMOV\tK2\tD1\nEND\n", "LD X0 ; a, b, c, d, e, f, g\nEND\n",
        ";;;;;;;;;;\n; title\n;;;;;;;;;;\nLD X0\n", "; 1,,LD,X0\nLD X0\n", "12\t\tLD\tX0\n", "LD X0 OUT Y0 END"})
    EXPECT_EQ(recognise_format(list), ListFormat::Plain) << list;
}

TEST(RecogniseFormat, TablesAreKnownByTheirBuild) {
  for (const char *list : {"0,,LD,X0,,,,,\n1,,END,,,,,,\n", "0,,LD,X0\n1,,END\n", "\"0\"\t\"\"\t\"LD\"\t\"X0\"\t\"\"\t\"\"\t\"\"\n",
                           "T\nP\tQ\na\tb\tc\td\te\tf\tg\n0\t\tLD\tX0\n", "T\nP\tQ\na\tb\tc\td\n0\t\tLD\tX0\n",
                           "\n\nT\nP,Q\na,b,c,d,,,\n0,,LD,X0\n", "0,statement,,,,,\n0,,LD,X0,,,\n"})
    EXPECT_EQ(recognise_format(list), ListFormat::GxCsv) << list;
}

}  // namespace
}  // namespace ladderc
