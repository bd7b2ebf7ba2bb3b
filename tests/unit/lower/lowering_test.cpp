// What IR keeps of the list: steps, rungs, edge memories, and what is left out.
#include "compiled.h"

#include "ir/extent.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

TEST(Lowering, OperationsHaveTheStepOfTheirInstruction) {
  auto c = compile_rungs("LD X0 / MOV K1 D0 / OUT T0 K5 / OUT Y0");
  std::vector<std::uint32_t> steps;
  for (const ir::Operation &o : c->module.routines[0].rungs[0].operations)
    steps.push_back(o.step);
  EXPECT_EQ(steps, (std::vector<std::uint32_t>{0, 1, 3, 7}));
}

TEST(Lowering, RungsHaveTheirInstructions) {
  auto c = compile_rungs("LD X0 / OUT Y0 / NOP / LD X1 / AND X2 / OUT Y1 / OUT Y2");
  const std::vector<ir::Rung> &rungs = c->module.routines[0].rungs;
  ASSERT_EQ(rungs.size(), 2u);
  EXPECT_EQ(rungs[0].number, 1u);
  EXPECT_EQ(rungs[1].number, 2u);
  EXPECT_EQ(rungs[1].step, 3u);
  EXPECT_EQ(rungs[1].first_instruction, 3u);
  EXPECT_EQ(rungs[1].instruction_count, 4u);
}

TEST(Lowering, EveryEdgeHasAMemoryThatKnowsItsStep) {
  auto c = compile_rungs("LDP X0 / ORF X1 / MEP / PLS M0 / FF M1 / MOVP K1 D0 / SET F1 / EGP V0 / SET M2");
  std::vector<std::uint32_t> steps;
  for (const ir::EdgeMemory &e : c->module.edges)
    steps.push_back(e.step);
  EXPECT_EQ(steps, (std::vector<std::uint32_t>{0, 1, 2, 3, 5, 7}));  // SET F1 shares that of MOVP; EGP has V0
}

TEST(Lowering, NothingBehindEndIsPartOfTheProgram) {
  auto c = compile("LD X0\nOUT Y0\nEND\nLD X1\nOUT Y1\nEND\n");
  EXPECT_EQ(c->module.routines[0].rungs.size(), 1u);
}

TEST(Lowering, TheMasterStateIsLoadedOncePerRung) {
  auto c = compile_rungs("LD X0 / MC N0 M100 / LD X1 / OUT Y0 / OUT Y1 / AND X2 / OUT Y2 / MCR N0");
  unsigned loads = 0;
  for (const ir::Operation &o : c->module.routines[0].rungs[1].operations)
    loads += o.op == ir::Op::Load && o.place.kind == ir::PlaceKind::Master;
  EXPECT_EQ(loads, 1u);
  EXPECT_EQ(c->module.master_levels, 1);
}

TEST(Lowering, TheHighestLevelDecidesHowManyStatesThereAre) {
  EXPECT_EQ(compile_rungs("LD X0 / MC N14 M100 / LD X1 / OUT Y0 / MCR N14")->module.master_levels, 15);
  EXPECT_EQ(compile_rungs("LD X0 / OUT Y0")->module.master_levels, 0);
}

TEST(Lowering, AnEmptyProgramHasNoRung) {
  EXPECT_TRUE(compile("END\n")->module.routines[0].rungs.empty());
}

TEST(Lowering, EveryExampleGivesGoodIr) {
  for (const auto &[name, list] : known_lists()) {
    auto c = compile(list, R"({"ST_points": 64})");
    EXPECT_EQ(ir::verify(c->module), "") << name;
    EXPECT_EQ(c->module.routines.size(), 1u) << name;
  }
}

}  // namespace
}  // namespace ladderc::test
