// The pass manager.
#include "compiled.h"
#include "random_ir.h"

#include "opt/pipeline.h"

#include "llvm/ADT/StringSet.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

std::vector<std::string> passes_run(opt::Options options) {
  std::vector<std::string> names;
  options.after = [&](const opt::Pass &pass, const ir::Module &) { names.push_back(pass.name.str()); };
  ir::Module module = random_module(1);
  opt::Context context;
  EXPECT_EQ(opt::run(module, options, context), "");
  return names;
}

TEST(Pipeline, EveryPassHasItsOwnNameAndASentence) {
  llvm::StringSet<> names;
  for (const opt::Pass &pass : opt::passes()) {
    EXPECT_TRUE(names.insert(pass.name).second) << pass.name.str();
    EXPECT_FALSE(pass.what.empty());
    EXPECT_EQ(opt::find_pass(pass.name), &pass);
  }
  EXPECT_EQ(opt::find_pass("no-such-pass"), nullptr);
}

TEST(Pipeline, LevelsChoosePasses) {
  opt::Options options;
  options.level = 0;
  EXPECT_TRUE(passes_run(options).empty());
  options.level = 1;
  const auto first = passes_run(options);
  EXPECT_EQ(llvm::count(first, "dead-coil"), 0);
  EXPECT_FALSE(first.empty());
  options.level = 2;
  EXPECT_EQ(passes_run(options).size(), opt::passes().size());
}

TEST(Pipeline, PassesCanBeLeftOut) {
  opt::Options options;
  options.disabled.insert("simplify");
  EXPECT_EQ(llvm::count(passes_run(options), "simplify"), 0);
}

TEST(Pipeline, NamedPassesRunInTheirOrderAtAnyLevel) {
  opt::Options options;
  options.level = 0;
  options.only = {"dead-value", "simplify", "dead-value"};
  EXPECT_EQ(passes_run(options), options.only);
}

TEST(Pipeline, ALimitStopsAllPassesTogether) {
  for (long long limit : {0, 1, 3}) {
    ir::Module module =
        parse_module("%0 = load SM400\n%1 = load X0\n%2 = and %0, %1\n%3 = load X0\n%4 = or %2, %3\nstore Y0, %4\nset Y1 if %0\n");
    opt::Options options;
    options.bisect = limit;
    opt::Context context;
    EXPECT_EQ(opt::run(module, options, context), "");
    long long made = 0;
    for (const auto &entry : context.counts())
      made += entry.second;
    EXPECT_EQ(made, limit);
  }
}

TEST(Pipeline, RunningTwiceFindsNothingMoreToDropOfDeadValues) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    ir::Module module = random_module(seed);
    opt::Options options;
    options.only = {"dead-value"};
    opt::Context first, second;
    EXPECT_EQ(opt::run(module, options, first), "");
    const std::string once = print(module);
    EXPECT_EQ(opt::run(module, options, second), "");
    EXPECT_EQ(print(module), once);
    EXPECT_TRUE(second.counts().empty());
  }
}

TEST(Pipeline, EveryKnownListStaysGood) {
  for (const auto &[name, list] : known_lists()) {
    auto c = compile(list, R"({"ST_points": 64})");
    opt::Context context;
    EXPECT_EQ(opt::run(c->module, {}, context), "") << name;
  }
}

}  // namespace
}  // namespace ladderc::test
