// The built ladderc, run as a user does: exit codes, the files that it writes, and the programs that it builds.
#include "scratch.h"

#include "llvm/Support/Program.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace ladderc::test {
namespace {

using testing::HasSubstr;

class CommandLine : public testing::Test {
protected:
  /// Runs ladderc; its streams are in `out` and `err`.
  int run(std::vector<std::string> arguments) { return execute(LADDERC_EXECUTABLE, std::move(arguments)); }
  int execute(const std::string &program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program);
    const std::vector<llvm::StringRef> words(arguments.begin(), arguments.end());
    const std::string out_file = scratch.path("stdout"), err_file = scratch.path("stderr");
    const std::optional<llvm::StringRef> redirects[] = {llvm::StringRef("/dev/null"), llvm::StringRef(out_file),
                                                        llvm::StringRef(err_file)};
    const int code = llvm::sys::ExecuteAndWait(program, words, std::nullopt, redirects);
    out = scratch.read("stdout");
    err = scratch.read("stderr");
    return code;
  }
  Scratch scratch;
  std::string out, err;
};

const char *const kGood = "LD X0\nOR Y0\nANI X1\nOUT Y0\nEND\n";

TEST_F(CommandLine, ExitCodes) {
  const std::string good = scratch.write("good.il", kGood), wrong = scratch.write("wrong.il", "LD X0\nOUT Q0\nEND\n");
  EXPECT_EQ(run({"check", good}), 0);
  EXPECT_EQ(run({"check", wrong}), 1);
  EXPECT_EQ(run({"check", good, wrong}), 1) << "the worst of all files";
  EXPECT_EQ(run({"emit", wrong, "-o", scratch.path("out")}), 1);
  EXPECT_FALSE(llvm::sys::fs::exists(scratch.path("out"))) << "nothing is written for a wrong list";
  EXPECT_EQ(run({"check", scratch.path("none.il")}), 2);
  EXPECT_EQ(run({"check"}), 2);
  EXPECT_EQ(run({"frobnicate"}), 2);
  EXPECT_EQ(run({"check", "--no-such-option", good}), 2);
  EXPECT_EQ(run({"explain", "no-such-id"}), 2);
  EXPECT_EQ(run({"test", scratch.path("none.json")}), 2);
  EXPECT_EQ(run({}), 0);
  EXPECT_THAT(out, HasSubstr("ladderc SUBCOMMAND --help"));
}

TEST_F(CommandLine, AFolderIsNoList) {
  EXPECT_EQ(run({"check", scratch.path("")}), 2);
  EXPECT_THAT(err, HasSubstr("cannot read"));
}

TEST_F(CommandLine, EmitWritesTheFilesAndNamesThem) {
  const std::string list = scratch.write("press line.il", kGood);
  ASSERT_EQ(run({"emit", list, "-o", scratch.path("a/b")}), 0) << err;
  for (const char *name : {"press_line.h", "press_line.cpp", "press_line.symbols.cpp", "press_line.cmake"}) {
    EXPECT_THAT(out, HasSubstr(scratch.path("a/b") + "/" + name + "\n"));
    EXPECT_NE(scratch.read(std::string("a/b/") + name), "") << name;
  }
  scratch.write("file", "");
  EXPECT_EQ(run({"emit", list, "-o", scratch.path("file/x")}), 2);
  EXPECT_THAT(err, HasSubstr("cannot"));
}

TEST_F(CommandLine, BuildMakesAProgramThatRuns) {
  const std::string list = scratch.write("press.il", kGood), program = scratch.path("press");
  ASSERT_EQ(run({"build", list, "-o", program}), 0) << err;
  EXPECT_EQ(execute(program, {"--virtual", "--scans", "3", "--set", "X0=1", "--set", "X0=0@2", "--watch", "Y0", "--quiet"}), 0)
      << err;
  EXPECT_THAT(out, HasSubstr("Y0=1"));
  EXPECT_THAT(out, testing::Not(HasSubstr("Y0=0"))) << "the rung holds itself";
  EXPECT_EQ(run({"build", list, "-o", scratch.path("none/press")}), 2);
}

TEST_F(CommandLine, RunEndsWithThreeWhereTheCpuStopped) {
  const std::string list = scratch.write("stop.il", "LD SM400\nS.QSABORT K5\nEND\n");
  EXPECT_EQ(run({"run", list, "--virtual", "--scans=3"}), 3);
  EXPECT_THAT(out + err, HasSubstr("4700"));
}

TEST_F(CommandLine, AMissingCompilerIsNamed) {
  const std::string list = scratch.write("press.il", "LD X0\nOUT Y1\nEND\n");
  ::setenv("CXX", "no-such-compiler", 1);
  EXPECT_EQ(run({"build", list, "-o", scratch.path("press")}), 2);
  ::unsetenv("CXX");
  EXPECT_THAT(err, HasSubstr("no-such-compiler"));
}

const char *const kScenarios = R"([
  {"name": "good", "program": ["LD X0", "OUT Y0", "END"], "steps": [{"set": {"X0": 1}, "expect": {"Y0": 1}}]},
  {"name": "bad", "program": ["LD X0", "MOV K5 D0", "END"],
   "steps": [{"set": {"X0": 1}, "scans": 2, "expect": {"D0": 7, "D0:u": 8}}, {"expect": {"D0": "0x0006"}}]},
  {"name": "unknown device", "program": ["LD X0", "OUT Y0", "END"], "steps": [{"expect": {"Q0": 1}}]},
  {"name": "beside", "list": "beside.il", "steps": [{"set": {"X0": 1}, "expect": {"Y3": 1}}]}
])";

TEST_F(CommandLine, TestReportsInEveryForm) {
  const std::string file = scratch.write("s.json", kScenarios);
  scratch.write("beside.il", "LD X0\nOUT Y3\nEND\n");
  EXPECT_EQ(run({"test", file, "--json", scratch.path("out.json"), "--junit", scratch.path("out.xml"), "--verbose"}), 1) << err;
  EXPECT_THAT(out, HasSubstr("passed: good\n"));
  EXPECT_THAT(out, HasSubstr("passed: beside\n"));
  EXPECT_THAT(out, HasSubstr("FAILED: bad"));
  EXPECT_THAT(out, HasSubstr("step 1, scan 2: D0 is 5, expected 7\n"));
  EXPECT_THAT(out, HasSubstr("line 2, step 1: MOV K5 D0\n"));
  EXPECT_THAT(out, HasSubstr("FAILED: unknown device"));
  EXPECT_THAT(out, HasSubstr("2 passed, 2 failed\n"));
  const auto json = nlohmann::json::parse(scratch.read("out.json"));
  ASSERT_EQ(json.size(), 4u);
  const auto failure = json[1]["failures"][0];
  EXPECT_EQ(failure["device"], "D0");
  EXPECT_TRUE(failure["got"].is_number());
  EXPECT_EQ(failure["got"], 5);
  EXPECT_EQ(failure["expected"], 7);
  EXPECT_EQ(json[1]["failures"].back()["expected"], "0x0006") << "a pattern stays a pattern";
  const std::string xml = scratch.read("out.xml");
  EXPECT_THAT(xml, HasSubstr("tests=\"4\" failures=\"2\""));
  EXPECT_THAT(xml, HasSubstr("<?xml"));
}

TEST_F(CommandLine, TestCanChoose) {
  const std::string file = scratch.write("s.json", kScenarios);
  scratch.write("beside.il", "LD X0\nOUT Y3\nEND\n");
  EXPECT_EQ(run({"test", file, "--filter=goo", "-O0"}), 0) << out << err;
  EXPECT_EQ(out, "1 passed, 0 failed\n");
  EXPECT_EQ(run({"test", file, "--filter=nothing"}), 2);
  EXPECT_THAT(err, HasSubstr("no scenario to run"));
}

TEST_F(CommandLine, InstructionsAsJson) {
  ASSERT_EQ(run({"instructions", "--json"}), 0);
  const auto json = nlohmann::json::parse(out);
  EXPECT_GT(json.size(), 100u);
  for (const auto &row : json)
    EXPECT_TRUE(row.contains("form") && row.contains("section") && !row["shapes"].empty());
  ASSERT_EQ(run({"instructions"}), 0);
  EXPECT_THAT(out, HasSubstr("MOV S D"));
}

TEST_F(CommandLine, BenchMeasuresAndCompares) {
  const std::string list = scratch.write("press.il", kGood);
  ASSERT_EQ(run({"bench", list, "--scans=1000", "--json"}), 0) << err;
  const auto json = nlohmann::json::parse(out);
  EXPECT_EQ(json["instructions"], 5);
  EXPECT_GT(json["real_cpu"]["scan_us"].get<double>(), 8200);
  EXPECT_GT(json["median"].get<double>(), 0);
}

}  // namespace
}  // namespace ladderc::test
