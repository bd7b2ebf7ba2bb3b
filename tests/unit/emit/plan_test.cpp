// What is inlined where it changes nothing, and only there.
//
// Random rungs are run as the emitter prints them (what is inlined is worked out at its user, in both orders that C++ may take
// inside of an expression) and directly, from every state of their bits.
#include "compiled.h"
#include "machine.h"
#include "random_ir.h"

#include "emit/expressions.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

TEST(Plan, PrintedRungsDoWhatTheIrDoes) {
  for (unsigned seed = 0; seed < 200 && !testing::Test::HasFailure(); ++seed) {
    const ir::Module module = random_module(5000 + seed, 24);
    for_each_state(random_cells(), [&](const Cells &cells) {
      if (testing::Test::HasFailure())
        return;
      const Outcome wanted = run_scan(module, cells);
      for (const Way way : {Way::LeftFirst, Way::RightFirst}) {
        const Outcome got = run_scan(module, cells, way, seed % 3 != 0);
        EXPECT_TRUE(got == wanted) << "seed " << seed << "\n"
                                   << print(module) << "wanted: " << to_text(wanted) << "\ngot: " << to_text(got);
      }
    });
  }
}

/// Whether the operation with that result is part of its user.
bool inlined(llvm::StringRef rung, ir::ValueId value) {
  const ir::Module module = parse_module("edges 1, 2\nroutine main {\nrung 0\n" + rung.str() + "\n}\n");
  const emit::RungPlan plan(module, module.routines[0].rungs[0], true);
  return plan.inlined(plan.definition(value));
}

TEST(Plan, AContactIsReadBeforeItsDeviceIsWritten) {
  EXPECT_TRUE(inlined("%0 = load M0\nstore M1, %0", 0));
  EXPECT_FALSE(inlined("%0 = load M0\n%1 = load X0\nstore M0, %1\nstore M1, %0", 0));
  EXPECT_TRUE(inlined("%0 = load M0\n%1 = load X0\nstore M2, %1\nstore M1, %0", 0));
  EXPECT_FALSE(inlined("%0 = load M0\n%1 = load X0\ncall MOV if %1 (5) -> (K1M0)\nstore M1, %0", 0));
  EXPECT_FALSE(inlined("%0 = load D0.5\n%1 = load X0\ncall INC if %1 (D0) -> (D0)\nstore M1, %0", 0));
  EXPECT_FALSE(inlined("%0 = load T0\n%1 = load X0\nrun \"OUT T\" with %1 (5) -> (T0)\nstore M1, %0", 0));
}

TEST(Plan, AComparisonIsMadeBeforeItsWordsChange) {
  EXPECT_TRUE(inlined("%0 = test LD= (D0, 5)\nstore M1, %0", 0));
  EXPECT_FALSE(inlined("%0 = test LD= (D0, 5)\n%1 = load X0\ncall INC if %1 (D0) -> (D0)\nstore M1, %0", 0));
  EXPECT_FALSE(inlined("%0 = test LDD= (D0, 5)\n%1 = load X0\ncall INC if %1 (D1) -> (D1)\nstore M1, %0", 0));
  EXPECT_TRUE(inlined("%0 = test LD= (D0, 5)\n%1 = load X0\ncall INC if %1 (D1) -> (D1)\nstore M1, %0", 0));
}

TEST(Plan, AnEdgeRelayIsRenewedBeforeItIsLookedAt) {
  EXPECT_TRUE(inlined("%0 = load X0\n%1 = rising V0, %0\nstore M1, %1", 1));
  EXPECT_FALSE(inlined("%0 = load X0\n%1 = rising V0, %0\n%2 = load V0\n%3 = and %1, %2\nstore M1, %3", 1));
  EXPECT_FALSE(inlined("%0 = load X0\n%1 = rising V0, %0\n%2 = rising V0, %1\n%3 = and %1, %2\nstore M1, %3", 1));
  EXPECT_TRUE(inlined("%0 = load X0\n%1 = rising edge0, %0\n%2 = load V0\n%3 = and %1, %2\nstore M1, %3", 1));
}

TEST(Plan, NothingIsMovedOverACallThatMayEndTheScan) {
  EXPECT_FALSE(inlined("%0 = load X0\n%1 = load X1\ncall BCD if %1 (D0) -> (D1) at 5\nstore M1, %0", 0));
  EXPECT_FALSE(inlined("%0 = load X0\n%1 = rising edge0, %0\n%2 = load X1\ncall BCD if %2 (D0) -> (D1) at 5\nset M1 if %1", 1));
}

TEST(Plan, AResultOfSeveralUsersHasAName) {
  EXPECT_FALSE(inlined("%0 = load X0\n%1 = load X1\n%2 = and %0, %1\nstore M1, %2\nstore M2, %2", 2));
  EXPECT_TRUE(inlined("%0 = load X0\nstore M1, %0\nstore M2, %0", 0));  // a contact is as good as a name
  EXPECT_FALSE(inlined("%0 = load M1\nstore M1, %0\nstore M2, %0", 0));
}

TEST(Plan, ValuesWithoutAUserAreNotPrinted) {
  EXPECT_TRUE(inlined("%0 = load X0\n%1 = load X1\n%2 = and %0, %1", 2));
  EXPECT_FALSE(inlined("%0 = load X0\n%1 = rising edge0, %0", 1));  // but an edge is
}

TEST(Plan, NeighboursWithOneConditionAreAGroup) {
  const ir::Module m = parse_module(
      "%0 = load X0\n%1 = load X1\n%2 = and %0, %1\ncall MOV if %2 (1) -> (D0)\ncall MOV if %2 (2) -> (D1)\nstore Y0, %0\n"
      "call MOV if %2 (3) -> (D2)");
  const ir::Rung &rung = m.routines[0].rungs[0];
  const emit::RungPlan grouped(m, rung, true), single(m, rung, false);
  EXPECT_FALSE(grouped.continues_group(3));
  EXPECT_TRUE(grouped.continues_group(4));
  EXPECT_FALSE(grouped.continues_group(6));
  EXPECT_EQ(grouped.uses(2), 2u);
  EXPECT_FALSE(single.continues_group(4));
  EXPECT_EQ(single.uses(2), 3u);
}

}  // namespace
}  // namespace ladderc::test
