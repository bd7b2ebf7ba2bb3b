// Which devices a place covers.
#include "ir/extent.h"

#include "compiled.h"

#include "syntax/parser.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

class Extents : public testing::Test {
protected:
  ir::Place place(llvm::StringRef word, OperandType type) const {
    return ir::to_place(parse_operand(*module.family, word, {}), type);
  }
  bool overlap(llvm::StringRef a, OperandType type_a, llvm::StringRef b, OperandType type_b) const {
    const ir::Extent x = ir::extent(module, place(a, type_a)), y = ir::extent(module, place(b, type_b));
    EXPECT_EQ(ir::overlap(x, y), ir::overlap(y, x));
    return ir::overlap(x, y);
  }
  ir::Module module = parse_module("%0 = load X0");
};

constexpr auto kBit = OperandType::Bit;
constexpr auto kWord = OperandType::Word;

TEST_F(Extents, WordsOfTheOperandTypes) {
  EXPECT_TRUE(overlap("D1", kWord, "D0", OperandType::DWord));
  EXPECT_FALSE(overlap("D2", kWord, "D0", OperandType::DWord));
  EXPECT_TRUE(overlap("D3", kWord, "D0", OperandType::QWord));
  EXPECT_TRUE(overlap("D1", kWord, "D0", OperandType::WordTwice));
  EXPECT_TRUE(overlap("D3", kWord, "D0", OperandType::DWordTwice));
  EXPECT_FALSE(overlap("D1", kWord, "D0", kWord));
}

TEST_F(Extents, BitsOfWordsLieInTheirWord) {
  EXPECT_TRUE(overlap("D0.5", kBit, "D0", kWord));
  EXPECT_TRUE(overlap("D0.5", kBit, "D0.6", kBit));
  EXPECT_FALSE(overlap("D0.5", kBit, "D1", kWord));
}

TEST_F(Extents, DigitsAreFourBits) {
  EXPECT_TRUE(overlap("M15", kBit, "K4M0", kWord));
  EXPECT_FALSE(overlap("M16", kBit, "K4M0", kWord));
  EXPECT_TRUE(overlap("X1F", kBit, "K1X1C", kWord));
  EXPECT_FALSE(overlap("M0", kBit, "K4X0", kWord));
}

TEST_F(Extents, ATimerIsItsContactAndItsValue) {
  EXPECT_TRUE(overlap("T0", kBit, "T0", OperandType::Timer));
  EXPECT_TRUE(overlap("T0", kWord, "T0", OperandType::Timer));
  EXPECT_FALSE(overlap("T1", kBit, "T0", OperandType::Timer));
}

TEST_F(Extents, WhatCrossesTheEndMayBeAnything) {
  EXPECT_TRUE(overlap("W0", kWord, "D6143", OperandType::DWord));
  EXPECT_FALSE(overlap("W0", kWord, "D6142", OperandType::DWord));
}

TEST_F(Extents, TheEndIsThatOfTheAllocation) {
  module.points.clear();
  for (const DeviceInfo &device : module.family->devices)
    module.points.push_back(device.points);
  module.points[find_device(*module.family, "D")] = 1000;
  EXPECT_TRUE(overlap("W0", kWord, "D999", OperandType::DWord));
  EXPECT_FALSE(overlap("W0", kWord, "D998", OperandType::DWord));
}

TEST_F(Extents, ConstantsAndMemoriesAreApart) {
  EXPECT_FALSE(overlap("K5", kWord, "K5", kWord));
  EXPECT_FALSE(overlap("K5", kWord, "D5", kWord));
  ir::Place edge, master;
  edge.kind = ir::PlaceKind::Edge;
  master.kind = ir::PlaceKind::Master;
  EXPECT_FALSE(ir::overlap(ir::extent(module, edge), ir::extent(module, master)));
  EXPECT_TRUE(ir::overlap(ir::extent(module, edge), ir::extent(module, edge)));
  EXPECT_FALSE(ir::overlap(ir::extent(module, edge), ir::extent(module, place("X0", kBit))));
}

TEST(Barriers, AreCallsThatMayEndTheScanOrLookAround) {
  const ir::Module m = parse_module(
      "%0 = load X0\ncall MOV if %0 (1) -> (D0)\ncall BCD if %0 (D0) -> (D1) at 3\ncall \"SET F\" if %0 () -> (F1) at 6\n"
      "run \"OUT T\" with %0 (5) -> (T0)\ncall S.QSABORT if %0 (1) at 9");
  std::vector<bool> barriers;
  for (const ir::Operation &o : m.routines[0].rungs[0].operations)
    barriers.push_back(ir::is_barrier(o));
  EXPECT_EQ(barriers, (std::vector<bool>{false, false, true, true, false, true}));
}

}  // namespace
}  // namespace ladderc::test
