// parse(print(m)) prints the same and means the same, for every list that there is.
#include "compiled.h"
#include "random_ir.h"

#include "opt/pipeline.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

/// Two table entries can share a form and its numbers of operands ("+ S D" with D read, "+ S1 S2 D"); what they do is the same
/// then.
bool same_entry(const InstructionInfo *a, const InstructionInfo *b) {
  return a == b ||
         (a && b && a->form == b->form && a->function == b->function && a->style == b->style && a->error_code == b->error_code);
}

void expect_same(const ir::Module &a, const ir::Module &b) {
  ASSERT_EQ(a.routines.size(), b.routines.size());
  ASSERT_EQ(a.edges.size(), b.edges.size());
  EXPECT_EQ(a.master_levels, b.master_levels);
  for (std::size_t r = 0; r < a.routines.size(); ++r) {
    ASSERT_EQ(a.routines[r].rungs.size(), b.routines[r].rungs.size());
    for (std::size_t i = 0; i < a.routines[r].rungs.size(); ++i) {
      const ir::Rung &x = a.routines[r].rungs[i], &y = b.routines[r].rungs[i];
      EXPECT_EQ(x.step, y.step);
      ASSERT_EQ(x.operations.size(), y.operations.size());
      EXPECT_EQ(x.values, y.values);
      for (std::size_t n = 0; n < x.operations.size(); ++n) {
        const ir::Operation &p = x.operations[n], &q = y.operations[n];
        const std::string text = ir::to_text(a, p);
        EXPECT_TRUE(p.op == q.op && p.result == q.result && p.a == q.a && p.b == q.b && p.constant == q.constant) << text;
        EXPECT_TRUE(same_entry(p.info, q.info)) << text;
        EXPECT_TRUE(p.place == q.place) << text;
        EXPECT_TRUE(p.inputs == q.inputs) << text;
        EXPECT_TRUE(p.outputs == q.outputs) << text;
        if (ir::tells_step(p))
          EXPECT_EQ(p.step, q.step) << text;
      }
    }
  }
}

void expect_round_trip(const ir::Module &module, const SourceSet &sources, const std::string &name) {
  SCOPED_TRACE(name);
  std::string text;
  llvm::raw_string_ostream out(text);
  ir::print(module, sources, out);
  ir::Module again;
  again.family = module.family;
  std::string error;
  ASSERT_TRUE(ir::parse(text, again, error)) << error << "\n" << text;
  EXPECT_EQ(ir::verify(again), "");
  EXPECT_EQ(print(again), text);
  expect_same(module, again);
}

TEST(RoundTrip, EveryListThatThereIs) {
  const auto lists = known_lists();
  EXPECT_GT(lists.size(), 150u);
  for (const auto &[name, list] : lists) {
    auto c = compile(list, R"({"ST_points": 64})", "folder/a list.il");
    expect_round_trip(c->module, c->sources, name);
    opt::Context context;
    ASSERT_EQ(opt::run(c->module, {}, context), "") << name;
    expect_round_trip(c->module, c->sources, name + " -O2");
  }
}

TEST(RoundTrip, RandomIr) {
  for (unsigned seed = 0; seed < 300; ++seed)
    expect_round_trip(random_module(seed, 40), SourceSet(), "seed " + std::to_string(seed));
}

TEST(RoundTrip, AllocationIsKept) {
  auto c = compile_rungs("LD X0 / OUT Y0", R"({"device_points": {"D": 1000}, "ST_points": 8})");
  const ir::Module again = parse_module(c->ir());
  EXPECT_EQ(again.points, c->module.points);
}

}  // namespace
}  // namespace ladderc::test
