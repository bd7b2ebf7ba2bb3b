// The files of a program: what is in them, that they do not depend on anything but the list, and how parameters show.
#include "emit/program.h"

#include "compiled.h"

#include <gmock/gmock.h>

namespace ladderc::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<emit::OutputFile> files_of(Compiled &c, emit::EmitOptions options = {}) {
  return emit::emit_program(c.program, c.module, c.sources, options);
}
std::string file(const std::vector<emit::OutputFile> &files, const std::string &name) {
  for (const emit::OutputFile &f : files)
    if (f.name == name)
      return f.text;
  ADD_FAILURE() << "no file " << name;
  return "";
}

TEST(Files, NamesComeFromTheList) {
  auto c = compile("LD X0\nOUT Y0\nEND\n", "{}", "/some/where/Press Line.il");
  std::vector<std::string> names;
  for (const emit::OutputFile &f : files_of(*c)) {
    names.push_back(f.name);
    EXPECT_THAT(f.text, Not(HasSubstr("/some/where"))) << "outputs do not depend on where they were made";
  }
  EXPECT_EQ(names, (std::vector<std::string>{"press_line.h", "press_line.cpp", "press_line.symbols.cpp"}));
}

TEST(Files, TheSameListGivesTheSameBytes) {
  for (const auto &[name, list] : known_lists()) {
    std::vector<std::string> texts[2];
    for (auto &text : texts) {
      auto c = compile(list, R"({"ST_points": 64})");
      for (const emit::OutputFile &f : files_of(*c))
        text.push_back(f.name + f.text);
    }
    EXPECT_EQ(texts[0], texts[1]) << name;
  }
}

TEST(Files, NoLineIsTooLongAndNoneHasBlanksAtItsEnd) {
  for (const auto &[name, list] : known_lists()) {
    auto c = compile(list, R"({"ST_points": 64})");
    for (const emit::OutputFile &f : files_of(*c)) {
      unsigned blank = 0;
      for (llvm::StringRef rest = f.text; !rest.empty();) {
        const auto [line, next] = rest.split('\n');
        rest = next;
        EXPECT_EQ(line, line.rtrim()) << name;
        blank = line.empty() ? blank + 1 : 0;
        EXPECT_LE(blank, 1u) << name << " " << f.name << ": two empty lines";
      }
      EXPECT_THAT(f.text, Not(HasSubstr("\n\n}\n"))) << name << " " << f.name;
    }
  }
}

TEST(Files, OptionsNameTheClassAndItsNamespace) {
  auto c = compile_rungs("LD X0 / OUT Y0");
  emit::EmitOptions options;
  options.name_space = "line::two";
  options.class_name = "Mixer";
  options.stem = "mixer";
  const auto files = files_of(*c, options);
  EXPECT_THAT(file(files, "mixer.h"), HasSubstr("namespace line::two {"));
  EXPECT_THAT(file(files, "mixer.h"), HasSubstr("class Mixer final {"));
  EXPECT_THAT(file(files, "mixer.symbols.cpp"), HasSubstr("kMixerSymbols"));
}

TEST(Files, LatchedDevicesAreNotCleared) {
  auto c = compile_rungs("LD X0 / OUT M20 / MOV K1 D9", R"({"latched": ["M0-M9", "M15-M15", "D0-D20"]})");
  const std::string text = file(files_of(*c), "test.cpp");
  EXPECT_THAT(text, HasSubstr("  X.clear();\n"));
  EXPECT_THAT(text, HasSubstr("  M.clear(10, 14);\n  M.clear(16, 20);\n"));
  EXPECT_THAT(text, Not(HasSubstr("D.clear")));
}

TEST(Files, OverlappingLatchRangesAreOne) {
  auto c = compile_rungs("LD X0 / OUT M20", R"({"latched": ["M5-M9", "M0-M12", "M7-M8"]})");
  EXPECT_THAT(file(files_of(*c), "test.cpp"), HasSubstr("  M.clear(13, 20);\n"));
}

TEST(Files, InitialValuesAreWrittenAtPowerOnAndWhenRunBegins) {
  auto c = compile_rungs("LD M3 / MOV D0 D5 / DMOV D10 D20",
                         R"({"device_initial_values": {"D0": -7, "M3": 1, "D10:d": 70000, "D900": 1}})");
  const std::string text = file(files_of(*c), "test.cpp");
  // D900 has memory because of its value alone: the host may look at it.
  for (const char *line : {"  D[0] = -7;\n", "  M[3] = on;\n", "  D.pair(10) = 70000;\n", "  D[900] = 1;\n"}) {
    const std::size_t first = text.find(line);
    ASSERT_NE(first, std::string::npos) << line;
    EXPECT_NE(text.find(line, first + 1), std::string::npos) << line << " at STOP to RUN";
  }
}

TEST(Files, ParametersOfTheSystem) {
  auto c = compile_rungs("LD X0 / OUT Y0",
                         R"({"low_speed_unit_ms": 50, "high_speed_unit_ms": 0.5, "watchdog_ms": 200, "program_name": "A1"})");
  const std::string text = file(files_of(*c), "test.cpp");
  EXPECT_THAT(text, HasSubstr("  \"A1      \","));
  EXPECT_THAT(text, HasSubstr("  50000, 500,"));
  EXPECT_THAT(text, HasSubstr("  0, 200000,"));
  EXPECT_THAT(text, HasSubstr("\nconstexpr melsec_qs::Parameters kParameters = {\n"));
}

TEST(Files, ALargeListIsCutIntoFilesThatAreAllCalled) {
  std::string list;
  for (unsigned i = 0; i < 300; ++i)
    list += i == 200 ? "LD X0\nBCD D0 D1\n" : "LD X0\nOUT M" + std::to_string(i) + "\n";
  auto c = compile(list + "END\n");
  emit::EmitOptions options;
  options.limits.operations_per_file = 200;
  const auto files = files_of(*c, options);
  ASSERT_GE(files.size(), 5u);
  EXPECT_EQ(files[2].name, "test_2.cpp");
  const std::string header = file(files, "test.h"), main = file(files, "test.cpp");
  std::string all;
  for (const emit::OutputFile &f : files)
    all += f.text;
  for (const auto &[call, declaration] :
       {std::pair<const char *, const char *>{"  rungs_1_to_64();\n", "  void rungs_1_to_64() noexcept;\n"},
        {"  if (!rungs_193_to_256()) return;\n", "  bool rungs_193_to_256() noexcept;\n"},
        {"  rungs_257_to_300();\n", "  void rungs_257_to_300() noexcept;\n"}}) {
    EXPECT_THAT(main, HasSubstr(call));
    EXPECT_THAT(header, HasSubstr(declaration));
  }
  EXPECT_THAT(all, HasSubstr("bool Test::rungs_193_to_256() noexcept {"));
  EXPECT_THAT(all, HasSubstr("\n\n  return true;\n}\n"));
}

TEST(Files, AnEmptyProgramScansNothing) {
  auto c = compile("END\n");
  EXPECT_THAT(file(files_of(*c), "test.cpp"),
              HasSubstr("if (!sys.begin_scan(now)) return;  // in STOP, or stopped by an error\n  sys.end_scan();\n}"));
}

TEST(Files, SymbolsNameStepsThatCanStopAndEnd) {
  auto c = compile_rungs("LD X0 / OUT Y0 / BCD D0 D1");
  EXPECT_THAT(file(files_of(*c), "test.symbols.cpp"), HasSubstr("  {2, 3, \"BCD D0 D1\"},\n  {5, 4, \"END\"},\n"));
}

TEST(Files, SymbolsOfLatchedContents) {
  auto c = compile_rungs("LD M3 / MOV D0 D5", R"({"latched": {"D0": 5, "M3": 1}})");
  const std::string text = file(files_of(*c), "test.symbols.cpp");
  EXPECT_THAT(text, HasSubstr("  program->D[0] = 5;\n"));
  EXPECT_THAT(text, HasSubstr("  program->M[3] = ladder::bit(true);\n"));
}

TEST(Files, TheCMakeFileNamesAllSources) {
  auto c = compile_rungs("LD X0 / OUT Y0");
  const emit::OutputFile cmake = emit::emit_cmake(files_of(*c), {});
  EXPECT_EQ(cmake.name, "test.cmake");
  EXPECT_THAT(cmake.text, HasSubstr("add_library(test STATIC\n  ${CMAKE_CURRENT_LIST_DIR}/test.cpp)"));
  EXPECT_THAT(cmake.text, HasSubstr("add_library(test_symbols STATIC ${CMAKE_CURRENT_LIST_DIR}/test.symbols.cpp)"));
}

}  // namespace
}  // namespace ladderc::test
