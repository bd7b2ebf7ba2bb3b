// Options that several subcommands share.
#include "driver/options.h"

#include "opt/pipeline.h"
#include "tables/tables.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/raw_ostream.h"

#include <fmt/format.h>

namespace ladderc::driver {

namespace cl = llvm::cl;

cl::SubCommand kBuild("build", "compile a list to a native program");
cl::SubCommand kEmit("emit", "write the C++ of a list into a folder");
cl::SubCommand kCheck("check", "report what is wrong or suspicious in a list");
cl::SubCommand kRun("run", "compile a list and run it, showing watched devices as they change");
cl::SubCommand kTest("test", "run scenario files");
cl::SubCommand kBench("bench", "measure the scan time of a list");
cl::SubCommand kInstructions("instructions", "list the instructions that ladderc knows");
cl::SubCommand kExplain("explain", "explain a message by its id");
cl::SubCommand kGenerate("generate", "write a random legal list, for tests");

std::string g_argv0;

namespace {

cl::OptionCategory kLanguage("The list");
cl::OptionCategory kCode("Code");
cl::OptionCategory kMessages("Messages");

#define LADDERC_LIST_COMMANDS cl::sub(kBuild), cl::sub(kEmit), cl::sub(kCheck), cl::sub(kRun), cl::sub(kBench)
#define LADDERC_CODE_COMMANDS cl::sub(kBuild), cl::sub(kEmit), cl::sub(kRun), cl::sub(kBench), cl::sub(kTest)

cl::opt<std::string> kFamily("family", cl::desc("Controller family (default melsec-qs)"), cl::value_desc("ID"),
                             cl::init("melsec-qs"), cl::cat(kLanguage), LADDERC_LIST_COMMANDS, cl::sub(kInstructions),
                             cl::sub(kGenerate));
cl::opt<std::string> kModel("model", cl::desc("CPU model (default: the family's largest)"), cl::value_desc("NAME"),
                            cl::cat(kLanguage), LADDERC_LIST_COMMANDS, cl::sub(kGenerate));
cl::opt<std::string> kParameters("parameters", cl::desc("PC parameters: device points, latch ranges, timer units"),
                                 cl::value_desc("FILE.json"), cl::cat(kLanguage), LADDERC_LIST_COMMANDS, cl::sub(kGenerate));
cl::opt<std::string> kEncoding("encoding", cl::desc("Encoding of the list: auto, utf-8, utf-16le, gb18030, shift_jis"),
                               cl::value_desc("NAME"), cl::init("auto"), cl::cat(kLanguage), LADDERC_LIST_COMMANDS);
cl::opt<std::string> kFormat("format", cl::desc("Shape of the list: auto, plain, csv"), cl::value_desc("NAME"), cl::init("auto"),
                             cl::cat(kLanguage), LADDERC_LIST_COMMANDS);
cl::opt<std::string> kEmitStage("emit", cl::desc("Print a stage instead: lines, ast, ir, cpp, cpp-rungs"), cl::value_desc("STAGE"),
                                cl::cat(kCode), LADDERC_LIST_COMMANDS);
cl::opt<unsigned> kLevel("O", cl::desc("Optimization level 0-2 (default 2)"), cl::value_desc("N"), cl::Prefix, cl::init(2),
                         cl::cat(kCode), LADDERC_LIST_COMMANDS, cl::sub(kTest));
cl::opt<bool> kDebug("g", cl::desc("Let debuggers step through the list (#line)"), cl::cat(kCode), LADDERC_CODE_COMMANDS);
cl::opt<std::string> kNamespace("namespace", cl::desc("Namespace of the generated class (default plant)"), cl::value_desc("NAME"),
                                cl::init("plant"), cl::cat(kCode), cl::sub(kBuild), cl::sub(kEmit), cl::sub(kCheck));
cl::list<std::string> kNoPass("no-pass", cl::desc("Do not run this pass (also --no-PASS)"), cl::value_desc("PASS"), cl::cat(kCode),
                              LADDERC_LIST_COMMANDS);
cl::list<std::string> kPass("pass", cl::desc("Run this pass only; several run in the order given"), cl::value_desc("PASS"),
                            cl::cat(kCode), LADDERC_LIST_COMMANDS);
cl::list<std::string> kPrintAfter("print-after", cl::desc("Print the IR after this pass, or after 'all'"), cl::value_desc("PASS"),
                                  cl::cat(kCode), LADDERC_LIST_COMMANDS);
cl::opt<long long> kBisect("bisect", cl::desc("Make only the first N rewrites of the passes"), cl::value_desc("N"), cl::init(-1),
                           cl::cat(kCode), LADDERC_LIST_COMMANDS);
cl::opt<bool> kStats("stats", cl::desc("Print how many rewrites each pass made, and the time of each stage"), cl::cat(kCode),
                     LADDERC_LIST_COMMANDS);
cl::opt<std::string> kDiagnostics("diagnostics", cl::desc("Form of messages: text or json"), cl::value_desc("FORM"),
                                  cl::init("text"), cl::cat(kMessages), LADDERC_LIST_COMMANDS);
cl::list<std::string> kWarn("W", cl::desc("-Wno-ID silences a warning, -Werror makes warnings errors, -Werror=ID one of them"),
                            cl::value_desc("WHAT"), cl::Prefix, cl::cat(kMessages), LADDERC_LIST_COMMANDS);
cl::opt<unsigned> kMaxErrors("max-errors", cl::desc("Print at most N errors, 0: all (default 20)"), cl::value_desc("N"),
                             cl::init(20), cl::cat(kMessages), LADDERC_LIST_COMMANDS);

bool read_warnings(DiagOptions &diag) {
  for (llvm::StringRef what : kWarn) {
    if (what == "error") {
      diag.all_warnings_are_errors = true;
      continue;
    }
    const bool silence = what.consume_front("no-");
    if (!silence && !what.consume_front("error=")) {
      usage_error(fmt::format("-W{}: expected -Wno-ID, -Werror or -Werror=ID", what.str()));
      return false;
    }
    const DiagInfo *found = find_diagnostic(what);
    if (!found || found->severity != Severity::Warning) {
      usage_error(fmt::format("-W...: there is no warning '{}'", what.str()));
      return false;
    }
    (silence ? diag.silenced : diag.as_errors).insert(what);
  }
  return true;
}

/// NAME or NAME::NAME, as C++ takes it in `namespace NAME {`.
bool is_namespace(llvm::StringRef name) {
  llvm::SmallVector<llvm::StringRef> parts;
  name.split(parts, "::");
  return llvm::all_of(parts, [](llvm::StringRef part) {
    return !part.empty() && !llvm::isDigit(part.front()) && llvm::all_of(part, [](char c) { return llvm::isAlnum(c) || c == '_'; });
  });
}

}  // namespace

int usage_error(llvm::StringRef text) {
  llvm::errs() << "ladderc: error: " << text << "\n";
  return kExitUsage;
}

bool read_common_options(CommonOptions &o) {
  o.family = kFamily;
  o.model = kModel;
  o.parameters_file = kParameters;
  o.encoding = kEncoding;
  o.format = kFormat;
  o.emit = kEmitStage;
  o.diagnostics = kDiagnostics;
  o.name_space = kNamespace;
  o.level = kLevel;
  o.debug = kDebug;
  o.stats = kStats;
  o.disabled_passes.assign(kNoPass.begin(), kNoPass.end());
  o.only_passes.assign(kPass.begin(), kPass.end());
  o.print_after.assign(kPrintAfter.begin(), kPrintAfter.end());
  o.bisect = kBisect;
  o.diag.max_errors = kMaxErrors;
  auto one_of = [](llvm::StringRef option, llvm::StringRef value, std::initializer_list<llvm::StringRef> values) {
    if (llvm::is_contained(values, value))
      return true;
    std::string known;
    for (llvm::StringRef v : values)
      if (!v.empty())
        known += (known.empty() ? "" : ", ") + v.str();
    usage_error(fmt::format("--{}={}: expected one of {}", option.str(), value.str(), known));
    return false;
  };
  if (o.level > 2) {
    usage_error("-O takes 0, 1 or 2");
    return false;
  }
  if (!is_namespace(o.name_space)) {
    usage_error(fmt::format("--namespace={}: expected a C++ name, or several joined by '::'", o.name_space));
    return false;
  }
  for (const std::vector<std::string> *names : {&o.disabled_passes, &o.only_passes, &o.print_after})
    for (const std::string &name : *names)
      if (!opt::find_pass(name) && !(names == &o.print_after && name == "all")) {
        usage_error(fmt::format("there is no pass '{}'", name));
        return false;
      }
  return one_of("format", o.format, {"auto", "plain", "csv"}) && one_of("diagnostics", o.diagnostics, {"text", "json"}) &&
         one_of("emit", o.emit, {"", "lines", "ast", "ir", "cpp", "cpp-rungs"}) && read_warnings(o.diag);
}

}  // namespace ladderc::driver
