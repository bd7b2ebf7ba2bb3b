// Time: a program of a million instructions is checked in about the time that it takes to read it once.
#include "checking.h"

#include "syntax/parser.h"

#include <gtest/gtest.h>

#include <chrono>

namespace ladderc::test {
namespace {

std::string big_list(unsigned rungs) {
  std::string text;
  for (unsigned i = 0; i < rungs; ++i)
    text += "LD X" + std::to_string(i % 1000) + "\nMPS\nAND M1\nSET Y2\nMPP\nLD X3\nOR X4\nANB\nMOV D0 D1\n+ K5 D2 D3\n";
  return text + "END\n";
}

double seconds_for(unsigned rungs) {
  const FamilyInfo &family = *find_family("melsec-qs");
  SourceSet sources;
  unsigned file = sources.add("big.il", big_list(rungs));
  Diagnostics diagnostics(sources);
  ListProgram list = parse_list(family, sources, file, ListFormat::Plain, diagnostics);
  auto begin = std::chrono::steady_clock::now();
  CheckedProgram program = check(std::move(list), "QS001CPU", default_parameters(family, "QS001CPU"), diagnostics);
  std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  EXPECT_TRUE(program.ok);
  EXPECT_EQ(program.rungs, rungs + 1);
  return time.count();
}

// Generous, for loaded machines and sanitizers: what must not happen is quadratic growth, which would take minutes.
TEST(Speed, AMillionInstructions) {
  double seconds = seconds_for(100'000);
  RecordProperty("milliseconds", static_cast<int>(seconds * 1000));
  EXPECT_LT(seconds, 10.0);
}

}  // namespace
}  // namespace ladderc::test
