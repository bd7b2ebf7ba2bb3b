// What dead-coil must see between two coils of a device, by constructing every kind of reader.
#include "compiled.h"

#include "opt/pipeline.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

/// How many of the two coils of M5 are left with that in between, both inside of one rung and in rungs of their own.
unsigned coils_left(const std::string &between, const std::string &rung = "") {
  ir::Module module = parse_module("edges 1\nroutine main {\n" + ("rung 0\n%0 = load X0\nstore M5, %0\n" + rung) + between +
                                   (rung.empty() ? "" : "\nrung 2\n%0 = load X0") + "\nstore M5, %0\n}\n");
  opt::Options options;
  options.only = {"dead-coil"};
  opt::Context context;
  EXPECT_EQ(opt::run(module, options, context), "");
  unsigned coils = 0;
  for (const ir::Rung &r : module.routines[0].rungs)
    for (const ir::Operation &o : r.operations)
      coils += o.op == ir::Op::Store && ir::to_text(module, o.place) == "M5";
  return coils;
}

const char *const kReaders[] = {
    "%1 = load M5\nstore Y0, %1",
    "%1 = load M5\n%2 = rising edge0, %1",
    "call MOV if %0 (K1M4) -> (D0)",
    "call MOV if %0 (K4M0) -> (D0)",
    "call DMOV if %0 (K8M0) -> (D0)",
    "%1 = test LD= (K2M0, 5)",
    "call MOV if %0 (5) -> (K1M4)",
    "call INC if %0 (K1M4) -> (K1M4)",
    "set M5 if %0",
    "reset M5 if %0",
    "call BMOV if %0 (K1M0, K1Y0, D9) -> (K1Y0) at 3",
    "call FMOV if %0 (0, K1M0, D9) -> (K1M0) at 3",
    "call BCD if %0 (D0) -> (D1) at 3",
    "call S.QSABORT if %0 (1) at 3",
    "call \"SET F\" if %0 () -> (F1) at 3",
    "run \"OUT F\" with %0 () -> (F1) at 3",
};
const char *const kOthers[] = {
    "%1 = load M6\nstore Y0, %1",
    "call MOV if %0 (K1M8) -> (D0)",
    "call MOV if %0 (K1M0) -> (D0)",
    "%1 = test LD= (D5, 5)",
    "set M4 if %0",
    "call + if %0 (D0, D1) -> (D2)",
    "run \"OUT T\" with %0 (50) -> (T5)",
    "run \"OUT C\" with %0 (D5) -> (C5)",
    "%1 = rising V5, %0",
    "store D0.5, %0",
};

TEST(DeadCoil, StaysWhereSomebodyLooks) {
  for (const char *reader : kReaders) {
    EXPECT_EQ(coils_left(reader), 2u) << reader;
    EXPECT_EQ(coils_left(reader, "rung 1\n%0 = load X1\n"), 2u) << reader;
  }
}

TEST(DeadCoil, GoesWhereNobodyLooks) {
  for (const char *other : kOthers) {
    EXPECT_EQ(coils_left(other), 1u) << other;
    EXPECT_EQ(coils_left(other, "rung 1\n%0 = load X1\n"), 1u) << other;
  }
}

TEST(DeadCoil, TheLastCoilOfAScanStays) {
  ir::Module module = parse_module("%0 = load X0\nstore M5, %0");
  opt::Context context;
  EXPECT_EQ(opt::run(module, {}, context), "");
  EXPECT_EQ(context.counts().lookup("dead-coil.removed"), 0u);
}

TEST(DeadCoil, AReaderOfAPairThatCrossesTheEndIsSeen) {
  // K8M6128 has 32 bits, the last 16 lie behind the end of M.
  ir::Module module = parse_module("%0 = load X0\nstore B0, %0\ncall DMOV if %0 (K8M6128) -> (D0)\nstore B0, %0");
  opt::Options options;
  options.only = {"dead-coil"};
  opt::Context context;
  EXPECT_EQ(opt::run(module, options, context), "");
  EXPECT_TRUE(context.counts().empty());
}

TEST(DeadCoil, ThreeCoilsLeaveOne) {
  ir::Module module = parse_module("%0 = load X0\nstore M5, %0\nstore M5, %0\nstore M6, %0\nstore M5, %0");
  opt::Context context;
  EXPECT_EQ(opt::run(module, {}, context), "");
  EXPECT_EQ(context.counts().lookup("dead-coil.removed"), 2u);
}

}  // namespace
}  // namespace ladderc::test
