// Text that is no IR is refused with line and reason, and bytes of any kind without a crash.
#include "compiled.h"

#include "ir/extent.h"

#include <gtest/gtest.h>

#include <random>

namespace ladderc::test {
namespace {

std::string error_of(llvm::StringRef text) {
  ir::Module module;
  module.family = find_family("melsec-qs");
  std::string error;
  return ir::parse(text, module, error) ? "accepted" : error;
}
std::string error_in_rung(const std::string &line) {
  return error_of("routine main {\nrung 0\n" + line + "\n}\n");
}

TEST(Parse, SaysWhatIsWrong) {
  EXPECT_EQ(error_of("rung 0\n"), "line 1: routine expected");
  EXPECT_EQ(error_of("routine main\n"), "line 1: '{' expected");
  EXPECT_EQ(error_of("routine main {\n"), "line 1: routine is not closed");
  EXPECT_EQ(error_of("routine main {\n%0 = load X0\n}\n"), "line 2: rung expected");
  EXPECT_EQ(error_of("routine main {\nrung x\n}\n"), "line 2: step number expected");
  EXPECT_EQ(error_of("edges 1, x\n"), "line 1: step number expected");
  EXPECT_EQ(error_of("levels many\n"), "line 1: number of levels expected");
  EXPECT_EQ(error_of("points Q 5\n"), "line 1: device class expected");
  EXPECT_EQ(error_of("points D many\n"), "line 1: number of points expected");
  EXPECT_EQ(error_in_rung("%0 = jump X0"), "line 3: unknown operation");
  EXPECT_EQ(error_in_rung("%0 = store X0, %0"), "line 3: unknown operation");
  EXPECT_EQ(error_in_rung("load X0"), "line 3: unknown operation");
  EXPECT_EQ(error_in_rung("%0 load X0"), "line 3: '%N =' expected");
  EXPECT_EQ(error_in_rung("%0 = load Q5"), "line 3: 'Q5' is no place");
  EXPECT_EQ(error_in_rung("%0 = const 2"), "line 3: 0 or 1 expected");
  EXPECT_EQ(error_in_rung("%0 = and %1"), "line 3: two values expected");
  EXPECT_EQ(error_in_rung("%0 = not X0"), "line 3: value expected");
  EXPECT_EQ(error_in_rung("set Y0 %0"), "line 3: condition expected");
  EXPECT_EQ(error_in_rung("store Y0, %0 %1"), "line 3: text behind the operation");
  EXPECT_EQ(error_in_rung("call MOV if (1) -> (D0)"), "line 3: condition expected");
  EXPECT_EQ(error_in_rung("call MOV if %0 (1"), "line 3: operand list expected");
  EXPECT_EQ(error_in_rung("call MOV if %0 (1)"), "line 3: no such instruction form");
  EXPECT_EQ(error_in_rung("call JUMP if %0 (1) -> (D0)"), "line 3: no such instruction form");
  EXPECT_EQ(error_in_rung("call BCD if %0 (D0) -> (D1) at x"), "line 3: step number expected");
}

TEST(Parse, CommentsAndBlanksDoNotCount) {
  EXPECT_EQ(error_of("; one\n\n  routine main {  ;;; two\n\trung 0\n; three\n    %0 = load X0  \n}\n"), "accepted");
}

TEST(Parse, OneFormHasEntriesForWordsTimersAndCounters) {
  const ir::Module m =
      parse_module("%0 = load X0\ncall RST if %0 () -> (T0)\ncall RST if %0 () -> (C0)\ncall RST if %0 () -> (D0)");
  const auto &operations = m.routines[0].rungs[0].operations;
  EXPECT_EQ(operations[1].outputs[0].type, OperandType::Timer);
  EXPECT_EQ(operations[2].outputs[0].type, OperandType::Counter);
  EXPECT_EQ(operations[3].outputs[0].type, OperandType::Word);
}

TEST(Parse, NumbersCountInTheRadixOfTheirDevice) {
  const ir::Module m = parse_module("%0 = load X1F\n%1 = load M20\n%2 = load D5.A");
  const auto &operations = m.routines[0].rungs[0].operations;
  EXPECT_EQ(operations[0].place.number, 0x1Fu);
  EXPECT_EQ(operations[1].place.number, 20u);
  EXPECT_EQ(operations[2].place.bit, 10u);
}

TEST(Parse, ConstantsKeepTheirValueAndForm) {
  const ir::Module m = parse_module("%0 = test LD= (-32768, HFFFF)\n%1 = test LDD= (HFFFF, H80000000)");
  const auto &operations = m.routines[0].rungs[0].operations;
  EXPECT_EQ(operations[0].inputs[0].value, -32768);
  EXPECT_EQ(operations[0].inputs[1].value, -1);
  EXPECT_EQ(operations[1].inputs[0].value, 0xFFFF);
  EXPECT_EQ(operations[1].inputs[1].value, INT32_MIN);
  EXPECT_EQ(ir::to_text(m, operations[1]), "%1 = test LDD= (HFFFF, H80000000)");
}

TEST(Parse, AnyBytesComeBack) {
  std::mt19937 random(1);
  static constexpr const char *kPieces[] = {"routine main {\n",
                                            "rung 0\n",
                                            "%0 = load X0\n",
                                            "%",
                                            "=",
                                            " ",
                                            "\n",
                                            "(",
                                            ")",
                                            "->",
                                            "call",
                                            "MOV",
                                            "if",
                                            "with",
                                            "edge",
                                            "master",
                                            "99999999999",
                                            "-",
                                            "\"",
                                            "}",
                                            ",",
                                            "K4M0",
                                            "D0.5",
                                            "at",
                                            "\x80",
                                            ";;;",
                                            "levels 300\n"};
  for (unsigned n = 0; n < 3000; ++n) {
    std::string text = "routine main {\nrung 0\n";
    for (unsigned i = random() % 12; i > 0; --i)
      text += std::string(kPieces[random() % std::size(kPieces)]) + (random() % 2 ? " " : "");
    ir::Module module;
    module.family = find_family("melsec-qs");
    std::string error;
    if (ir::parse(text, module, error))
      ir::verify(module);
    else
      ASSERT_NE(error, "") << text;
  }
}

}  // namespace
}  // namespace ladderc::test
