// Where runs go on behind the end of their device.
#include "checking.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

class MemoryOrder : public testing::Test {
protected:
  const FamilyInfo &family_ = *find_family("melsec-qs");
  Parameters parameters_ = default_parameters(family_, "QS001CPU");

  DeviceId id(llvm::StringRef prefix) const { return find_device(family_, prefix); }
  std::pair<std::string, unsigned> behind(llvm::StringRef prefix, unsigned number, unsigned distance) const {
    DevicePoint point = point_behind(family_, parameters_, {id(prefix), number}, distance);
    return {point.device == kNoDevice ? "" : family_.devices[point.device].prefix.str(), point.number};
  }
  using Place = std::pair<std::string, unsigned>;
};

TEST_F(MemoryOrder, StaysInsideTheClass) {
  EXPECT_EQ(behind("D", 10, 5), Place("D", 15));
  EXPECT_FALSE(crosses_end(family_, parameters_, id("D"), 6142, 2));
  EXPECT_TRUE(crosses_end(family_, parameters_, id("D"), 6143, 2));
}

TEST_F(MemoryOrder, WordsGoOnInWords) {
  EXPECT_EQ(behind("D", 6143, 1), Place("W", 0));
  EXPECT_EQ(behind("D", 6143, 3), Place("W", 2));
  EXPECT_EQ(behind("C", 511, 1), Place("D", 0));
  EXPECT_EQ(behind("SW", 1535, 1), Place("SD", 0));
  EXPECT_EQ(behind("SD", 5119, 1), Place("", 0));
}

TEST_F(MemoryOrder, ClassesWithoutPointsTakeNoPlace) {
  EXPECT_EQ(behind("T", 511, 1), Place("C", 0));
  parameters_.points[id("ST")] = 4;
  EXPECT_EQ(behind("T", 511, 1), Place("ST", 0));
  EXPECT_EQ(behind("T", 511, 5), Place("C", 0));
}

TEST_F(MemoryOrder, BitsGoOnInBits) {
  EXPECT_EQ(behind("SM", 5119, 1), Place("X", 0));
  EXPECT_EQ(behind("X", 0x17FF, 2), Place("Y", 1));
  EXPECT_EQ(behind("SB", 1535, 1), Place("V", 0));
  EXPECT_EQ(behind("V", 1023, 1), Place("", 0));
}

TEST_F(MemoryOrder, LevelsLieNowhere) {
  EXPECT_EQ(behind("N", 14, 1), Place("", 0));
}

}  // namespace
}  // namespace ladderc::test
