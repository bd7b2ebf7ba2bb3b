// Generated lists: legal in every profile and allocation, the same for the same seed, and rich enough to be worth running.
#include "generate/generate.h"

#include "generate/random.h"
#include "sema/check.h"
#include "syntax/parser.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringSet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ladderc {
namespace {

const FamilyInfo &qs() {
  return *find_family("melsec-qs");
}
const FamilyInfo &tp03() {
  return *find_family("tp03");
}

GenerateOptions options_for(std::uint64_t seed, GenerateProfile profile, const FamilyInfo &family = qs()) {
  GenerateOptions options;
  options.family = &family;
  options.model = family.models.front();
  options.parameters = default_parameters(family, options.model);
  options.profile = profile;
  options.seed = seed;
  return options;
}

struct Checked {
  SourceSet sources;
  std::unique_ptr<Diagnostics> diagnostics;
  CheckedProgram program;
  std::string text;

  explicit Checked(const GenerateOptions &options) : text(generate_list(options)) {
    const unsigned file = sources.add("random.il", text);
    diagnostics = std::make_unique<Diagnostics>(sources, DiagOptions{});
    program = check(parse_list(*options.family, sources, file, ListFormat::Auto, *diagnostics), options.model, options.parameters,
                    *diagnostics);
  }
  std::string errors() const {
    std::string all;
    for (const Diagnostic &d : diagnostics->sorted())
      if (d.severity == Severity::Error)
        all += std::to_string(sources.position(d.range).line) + ": " + d.message + "\n";
    return all;
  }
};

class Profiles : public testing::TestWithParam<GenerateProfile> {};
INSTANTIATE_TEST_SUITE_P(All, Profiles, testing::Values(GenerateProfile::Contacts, GenerateProfile::Mixed, GenerateProfile::All),
                         [](const auto &p) { return name(p.param).str(); });

TEST_P(Profiles, ListsHaveNoErrors) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Checked checked(options_for(seed, GetParam()));
    ASSERT_EQ(checked.errors(), "") << "seed " << seed << "\n" << checked.text;
    ASSERT_TRUE(checked.program.ok);
    EXPECT_GE(checked.program.rungs, 20u);
  }
}

TEST_P(Profiles, ListsHaveNoErrorsInASmallAllocation) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    GenerateOptions options = options_for(seed, GetParam());
    ASSERT_EQ(read_parameters(R"({"device_points": {"X": 32, "Y": 16, "M": 20, "B": 8, "F": 40, "SB": 4, "V": 8, "T": 5, "ST": 3,
                                                    "C": 4, "D": 12, "W": 4, "SW": 8}})",
                              qs(), options.parameters),
              std::nullopt);
    const Checked checked(options);
    ASSERT_EQ(checked.errors(), "") << "seed " << seed << "\n" << checked.text;
  }
}

TEST_P(Profiles, EachModelOfAFamilyWithControlFlow) {
  for (const llvm::StringRef model : tp03().models)
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      GenerateOptions options = options_for(seed, GetParam(), tp03());
      options.model = model;
      options.parameters = default_parameters(tp03(), model);
      const Checked checked(options);
      ASSERT_EQ(checked.errors(), "") << model.str() << ", seed " << seed << "\n" << checked.text;
      ASSERT_TRUE(checked.program.ok);
      EXPECT_GE(checked.program.rungs, 20u);
    }
}

TEST_P(Profiles, SameSeedSameList) {
  EXPECT_EQ(generate_list(options_for(7, GetParam())), generate_list(options_for(7, GetParam())));
  EXPECT_NE(generate_list(options_for(7, GetParam())), generate_list(options_for(8, GetParam())));
}

TEST_P(Profiles, NamesAreFoundAgain) {
  EXPECT_EQ(find_generate_profile(name(GetParam())), GetParam());
}

TEST(Profile, UnknownNameIsNone) {
  EXPECT_EQ(find_generate_profile("every"), std::nullopt);
}

/// Forms that occur in the lists of some seeds.
llvm::StringSet<> forms(GenerateProfile profile, const FamilyInfo &family = qs()) {
  llvm::StringSet<> found;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    GenerateOptions options = options_for(seed, profile, family);
    if (&family == &qs()) {
      EXPECT_EQ(read_parameters(R"({"ST_points": 4})", qs(), options.parameters), std::nullopt);
    }
    const Checked checked(options);
    for (const Instruction &i : checked.program.list.instructions)
      if (i.info)
        found.insert(i.info->form);
  }
  return found;
}

TEST(Profile, AllHasEveryInstruction) {
  const llvm::StringSet<> found = forms(GenerateProfile::All);
  for (const InstructionInfo &info : qs().instructions)
    EXPECT_TRUE(found.contains(info.form)) << info.form.str();
}

TEST(Profile, AllHasEveryInstructionOfAFamilyWithControlFlow) {
  const llvm::StringSet<> found = forms(GenerateProfile::All, tp03());
  for (const InstructionInfo &info : tp03().instructions)
    EXPECT_TRUE(found.contains(info.form)) << info.form.str();
}

TEST(Profile, MixedCannotStopTheCpu) {
  const llvm::StringSet<> found = forms(GenerateProfile::Mixed);
  for (const InstructionInfo &info : qs().instructions)
    EXPECT_EQ(found.contains(info.form), !info.error_code && !info.stops_scan && info.style != CallStyle::System)
        << info.form.str();
}

TEST(Profile, ContactsHasContactsBlocksAndCoilsOnly) {
  const llvm::StringSet<> found = forms(GenerateProfile::Contacts);
  std::vector<std::string> names;
  for (const auto &entry : found)
    names.push_back(entry.first().str());
  EXPECT_THAT(names, testing::UnorderedElementsAre("LD", "LDI", "AND", "ANI", "OR", "ORI", "ANB", "ORB", "OUT", "END"));
}

TEST(GeneratorRandom, IsTheSameOnEveryMachine) {
  Random random(1);
  EXPECT_EQ(random.next(), 0x910A2DEC89025CC1u);
  EXPECT_EQ(Random(7).below(1000), 389u);
  EXPECT_EQ(Random(7).below(0), 0u);
  EXPECT_EQ(Random(7).between(-5, -5), -5);
}

TEST(GeneratorRandom, ReachesBothEnds) {
  Random random(3);
  bool low = false, high = false;
  for (int i = 0; i < 1000; ++i) {
    const std::int64_t n = random.between(-3, 4);
    ASSERT_GE(n, -3);
    ASSERT_LE(n, 4);
    low |= n == -3;
    high |= n == 4;
  }
  EXPECT_TRUE(low && high);
}

}  // namespace
}  // namespace ladderc
