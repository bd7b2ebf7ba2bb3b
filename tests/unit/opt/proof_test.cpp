// Every pass, and all together, on random IR: the same bits and the same calls from every state. A proof for those programs, not a
// sample.
#include "compiled.h"
#include "machine.h"
#include "random_ir.h"

#include "opt/pipeline.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

/// Compares the modules from every state; false at the first difference.
void expect_equal(const ir::Module &before, const ir::Module &after, unsigned seed, Way way = Way::Direct) {
  for_each_state(random_cells(), [&](const Cells &cells) {
    if (testing::Test::HasFailure())
      return;
    const Outcome wanted = run_scan(before, cells), got = run_scan(after, cells, way);
    EXPECT_TRUE(wanted == got) << "seed " << seed << "\nbefore:\n"
                               << print(before) << "after:\n"
                               << print(after) << "wanted: " << to_text(wanted) << "\ngot: " << to_text(got);
  });
}

class Proof : public testing::TestWithParam<const char *> {};

TEST_P(Proof, ChangesNothingThatCanBeSeen) {
  for (unsigned seed = 0; seed < 150 && !HasFailure(); ++seed) {
    const ir::Module before = random_module(seed);
    ir::Module after = before;
    opt::Options options;
    if (llvm::StringRef(GetParam()) != "all")
      options.only = {GetParam()};
    opt::Context context;
    ASSERT_EQ(opt::run(after, options, context), "") << "seed " << seed;
    expect_equal(before, after, seed);
  }
}

std::vector<const char *> names() {
  std::vector<const char *> names = {"all"};
  for (const opt::Pass &pass : opt::passes())
    names.push_back(pass.name.data());
  return names;
}
INSTANTIATE_TEST_SUITE_P(Passes, Proof, testing::ValuesIn(names()), [](const auto &info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Proof, PassesInAnyOrderChangeNothing) {
  const auto passes = opt::passes();
  for (unsigned seed = 0; seed < 60 && !testing::Test::HasFailure(); ++seed) {
    const ir::Module before = random_module(1000 + seed);
    ir::Module after = before;
    opt::Options options;
    for (unsigned i = 0; i < 12; ++i)
      options.only.push_back(passes[(seed * 7 + i * i * 3) % passes.size()].name.str());
    opt::Context context;
    ASSERT_EQ(opt::run(after, options, context), "");
    expect_equal(before, after, seed);
  }
}

/// What the emitter prints of the optimized IR is the same too, whatever order C++ takes inside of an expression.
TEST(Proof, ThePrintedProgramIsTheSame) {
  for (unsigned seed = 0; seed < 100 && !testing::Test::HasFailure(); ++seed) {
    const ir::Module before = random_module(2000 + seed);
    ir::Module after = before;
    opt::Context context;
    ASSERT_EQ(opt::run(after, {}, context), "");
    expect_equal(before, after, seed, seed % 2 ? Way::LeftFirst : Way::RightFirst);
  }
}

/// Any number of rewrites is a correct program, not only all of them: that is what --bisect relies on.
TEST(Proof, EveryPrefixOfTheRewritesIsCorrect) {
  for (unsigned seed = 0; seed < 12 && !testing::Test::HasFailure(); ++seed) {
    const ir::Module before = random_module(3000 + seed);
    for (long long limit = 0; limit < 25; ++limit) {
      ir::Module after = before;
      opt::Options options;
      options.bisect = limit;
      opt::Context context;
      ASSERT_EQ(opt::run(after, options, context), "");
      expect_equal(before, after, seed);
    }
  }
}

TEST(Proof, TheRandomProgramsGiveEveryPassWork) {
  opt::Context context;
  for (unsigned seed = 0; seed < 150; ++seed) {
    ir::Module module = random_module(seed);
    ASSERT_EQ(opt::run(module, {}, context), "");
  }
  for (const char *rewrite :
       {"const-contact.folded", "redundant-load.removed", "simplify.constant", "simplify.inversion", "simplify.absorption",
        "simplify.never-executed", "simplify.always-executed", "dead-coil.removed", "dead-value.removed"})
    EXPECT_GT(context.counts().lookup(rewrite), 0u) << rewrite;
}

}  // namespace
}  // namespace ladderc::test
