// The verifier finds what passes must not leave.
#include "compiled.h"
#include "random_ir.h"

#include <gmock/gmock.h>

namespace ladderc::test {
namespace {

using testing::HasSubstr;

ir::Module good() {
  return parse_module(
      "edges 3\nlevels 1\nroutine main {\nrung 0\n%0 = load X0\n%1 = rising edge0, %0\n%2 = and %0, %1\nstore master0, %2\n"
      "call MOV if %2 (1) -> (D0)\n}\n");
}
std::vector<ir::Operation> &operations(ir::Module &m) {
  return m.routines[0].rungs[0].operations;
}

TEST(Verify, AcceptsWhatIsRight) {
  EXPECT_EQ(ir::verify(good()), "");
}

TEST(Verify, ValuesAreDefinedOnceAndBeforeTheirUse) {
  ir::Module m = good();
  std::swap(operations(m)[0], operations(m)[2]);
  EXPECT_THAT(ir::verify(m), HasSubstr("operand used before its definition"));
  m = good();
  operations(m)[2].result = 1;
  EXPECT_THAT(ir::verify(m), HasSubstr("value defined twice"));
  m = good();
  operations(m)[2].b = 2;
  EXPECT_THAT(ir::verify(m), HasSubstr("operand used before its definition"));
  m = good();
  operations(m)[3].a = ir::kNoValue;
  EXPECT_THAT(ir::verify(m), HasSubstr("operand used before its definition"));
  m = good();
  m.routines[0].rungs[0].values = 2;
  EXPECT_THAT(ir::verify(m), HasSubstr("value number out of range"));
}

TEST(Verify, PlacesExist) {
  ir::Module m = good();
  m.edges.clear();
  EXPECT_THAT(ir::verify(m), HasSubstr("no such edge memory"));
  m = good();
  m.master_levels = 0;
  EXPECT_THAT(ir::verify(m), HasSubstr("no such master control state"));
  m = good();
  operations(m)[0].place.device = kNoDevice;
  EXPECT_THAT(ir::verify(m), HasSubstr("no such device class"));
}

TEST(Verify, CallsFitTheirTableEntry) {
  ir::Module m = good();
  operations(m)[4].info = nullptr;
  EXPECT_THAT(ir::verify(m), HasSubstr("no table entry"));
  m = good();
  operations(m)[4].inputs.clear();
  EXPECT_THAT(ir::verify(m), HasSubstr("operands do not match the table entry"));
  m = good();
  operations(m)[4].outputs[0] = operations(m)[4].inputs[0];
  EXPECT_THAT(ir::verify(m), HasSubstr("constant as output"));
}

/// Whatever random damage leaves, the verifier answers.
TEST(Verify, ComesBackFromAnything) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    ir::Module m = random_module(seed);
    for (ir::Rung &rung : m.routines[0].rungs) {
      ir::Operation &o = rung.operations[seed % rung.operations.size()];
      o.a = seed % 7 * 1000;
      o.result = seed % 5 == 0 ? ir::kNoValue : o.result;
      o.op = static_cast<ir::Op>(seed % 16);
    }
    EXPECT_LT(ir::verify(m).size(), 1000u);
  }
}

}  // namespace
}  // namespace ladderc::test
