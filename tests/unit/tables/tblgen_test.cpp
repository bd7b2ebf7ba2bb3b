// ladder-tblgen refuses records that break a rule, with a message at the record.
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Program.h"
#include "llvm/Support/raw_ostream.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"

#include <optional>
#include <string>

using testing::HasSubstr;

namespace {

struct Outcome {
  int exit_code;
  std::string messages;
};

std::string temporary_file(llvm::StringRef suffix) {
  llvm::SmallString<128> path;
  EXPECT_FALSE(llvm::sys::fs::createTemporaryFile("tblgen-test", suffix, path));
  return path.str().str();
}

std::string contents(const std::string &path) {
  auto buffer = llvm::MemoryBuffer::getFile(path);
  EXPECT_TRUE(buffer) << path;
  return buffer ? (*buffer)->getBuffer().str() : "";
}

Outcome run(llvm::StringRef action, const std::string &input, const std::string &output) {
  std::string program = LADDERC_BINARY_DIR "/bin/ladder-tblgen", errors = temporary_file("err");
  std::optional<llvm::StringRef> redirects[] = {llvm::StringRef(""), std::nullopt, llvm::StringRef(errors)};
  const llvm::StringRef environment[] = {"ASAN_OPTIONS=detect_leaks=0"};  // TableGen keeps its records
  const llvm::StringRef arguments[] = {program, "-I", LADDERC_SOURCE_DIR "/grammar", action, input, "-o", output};
  int code = llvm::sys::ExecuteAndWait(program, arguments, llvm::ArrayRef<llvm::StringRef>(environment), redirects);
  Outcome outcome = {code, contents(errors)};
  llvm::sys::fs::remove(errors);
  return outcome;
}

Outcome run_on_text(llvm::StringRef action, const std::string &text) {
  std::string input = temporary_file("td"), output = temporary_file("out");
  {
    std::error_code error;
    llvm::raw_fd_ostream(input, error) << text;
    EXPECT_FALSE(error);
  }
  Outcome outcome = run(action, input, output);
  llvm::sys::fs::remove(input);
  llvm::sys::fs::remove(output);
  return outcome;
}

/// A family of one device and one instruction; `instruction` is added to the latter's body, `more` to the file.
Outcome check_family(const std::string &instruction, const std::string &more = "", const std::string &devices = "[DevD]") {
  return run_on_text("-gen-family", R"(include "ladder.td"
let behaviour = "b", section = "1" in {
def DevD : Device<"D", "data register", Word, 10, 16>;
def DevM : Device<"M", "relay", Bit, 10, 16>;
}
def Words : Classes<[DevD]>;
def In : Operand<"S", "In", OpWord, Words> { let decimal = 1; }
def Out : Operand<"D", "Out", OpWord, Words>;
def E4100 : ErrorCode<4100, "n", "c", "a", 1, "1">;
class Good<string f> : Instruction<f, f> {
  let title = "t";
  let description = "d";
  let section = "1";
  let example = "END";
  let style = StyleValue;
  let operands = [In, Out];
  let inputs = [0];
  let outputs = [1];
}
)" + more + "\ndef MOVE : Good<\"MOVE\"> { " +
                                        instruction + R"( }
def F : Family<"f", "t", "m"> {
  let header = "h";
  let ns = "f";
  let models = ["A"];
  let devices = )" + devices + ";\n}\n");
}

void expect_message(const Outcome &outcome, const std::string &message) {
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_THAT(outcome.messages, HasSubstr("error: " + message));
}

TEST(Tblgen, TakesAGoodFamily) {
  Outcome outcome = check_family("");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_EQ(outcome.messages, "");
}

TEST(Tblgen, RefusesIndexesOutOfRange) {
  expect_message(check_family("let inputs = [2];"), "inputs names operand 2, there are 2");
  expect_message(check_family("let outputs = [-1];"), "outputs names operand -1, there are 2");
}

TEST(Tblgen, RefusesIndexesOfTheWrongDirection) {
  expect_message(check_family("let inputs = [1];"), "inputs name operand D, which is only written");
  expect_message(check_family("let outputs = [0];"), "outputs name operand S, which is only read");
}

TEST(Tblgen, RefusesAStatusCallWithoutErrorCode) {
  expect_message(check_family("let style = StyleStatus; let function = \"f\";"), "a Status call can fail and needs an errorCode");
  expect_message(check_family("let style = StyleStatus; let function = \"f\"; let errorCode = 4101;"),
                 "the family has no error code 4101");
  expect_message(check_family("let errorCode = 4100;"), "only a Status or Memory call has an errorCode");
}

TEST(Tblgen, RefusesMissingTexts) {
  expect_message(check_family("let title = \"\";"), "the instruction has no title");
  expect_message(check_family("let section = \"\";"), "the instruction has no section");
  expect_message(check_family("let example = \"\";"), "the instruction has no example");
}

TEST(Tblgen, RefusesTwoEntriesForTheSameLine) {
  expect_message(check_family("", "def AGAIN : Good<\"MOVE\">;"), "'MOVE' is duplicated: 'MOVE' takes the same operands");
  expect_message(check_family("", "def OTHER : Good<\"OTHER\"> { let aliases = [\"MOVE\"]; }"), "'MOVE' is duplicated");
  EXPECT_EQ(check_family("", "def OTHER : Good<\"MOVE\"> { let operands = [In, In, Out]; let outputs = [2]; }").exit_code, 0);
}

TEST(Tblgen, RefusesDevicesThatAreNotOfTheFamily) {
  expect_message(check_family("", "", "[DevM]"), "operand S takes 'D', which is not a device of the family");
}

TEST(Tblgen, RefusesMoreThan63DeviceClasses) {
  std::string records = "let behaviour = \"b\", section = \"1\" in {\n", names = "[DevD";
  for (int i = 0; i < 63; ++i) {
    records += "def Dev" + std::to_string(i) + " : Device<\"A" + std::to_string(i) + "\", \"t\", Bit, 10, 1>;\n";
    names += ", Dev" + std::to_string(i);
  }
  expect_message(check_family("", records + "}\n", names + "]"), "a family has at most 63 device classes, this one has 64");
}

TEST(Tblgen, RefusesUnknownNames) {
  expect_message(check_family("let models = [\"B\"];"), "'B' is no model of the family");
  expect_message(check_family("let errorMask = \"M1\";"), "errorMask 'M1' is no special device of the family");
  EXPECT_NE(check_family("let placement = AtNowhere;").exit_code, 0);
}

TEST(Tblgen, RefusesAnEdgeInstructionWithoutEdge) {
  expect_message(check_family("let style = StyleNone; let lowering = LowerPulseStore;"),
                 "lowering PulseStore needs an edge, RisingEdge or FallingEdge");
}

TEST(Tblgen, PointsAtTheRecord) {
  Outcome outcome = check_family("", "\ndef BAD : Good<\"BAD\"> { let title = \"\"; }");
  EXPECT_THAT(outcome.messages, HasSubstr("def BAD"));
}

std::string diagnostic(const std::string &id, const std::string &message, const std::string &body) {
  return R"(class Ref<string f> { string family = f; string section = ""; string plc = ""; }
class Diagnostic { string id; string severity = "Error"; string message; string explanation = "e"; string family = ""; string wrong = ""; string right = "";
                   list<Ref> references = []; }
def One : Diagnostic { let id = ")" +
         id + "\"; let message = \"" + message + "\"; " + body + " }\n";
}

TEST(Tblgen, RefusesDiagnosticsThatBreakARule) {
  auto check = [](const std::string &text) { return run_on_text("-gen-diagnostics", text); };
  EXPECT_EQ(check(diagnostic("bad-word", "'{word}' is none", "")).exit_code, 0);
  expect_message(check(diagnostic("BadWord", "text", "")), "'BadWord' is not an id in kebab case");
  expect_message(check(diagnostic("bad-word", "text.", "")), "a message is a text without full stop");
  expect_message(check(diagnostic("bad-word", "{Word} and {}", "")), "arguments are written {name} in lower case");
  expect_message(check(diagnostic("bad-word", "text", "let explanation = \"\";")), "errors and warnings need an explanation");
  expect_message(check(diagnostic("bad-word", "text", "let severity = \"Fatal\";")), "the severity is Error, Warning or Note");
}

}  // namespace
