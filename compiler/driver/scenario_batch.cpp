// Many scenario programs in few compiler calls.
//
// Every program becomes a class in a namespace of its own (s0, s1, ...); the texts are joined to as many files as keep the C++
// compilers busy side by side, linked with one main file that holds the table of programs, and the runner reads the steps from a
// file. The built runner is cached by the texts.
#include "driver/scenario.h"
#include "emit/list_text.h"
#include "ir/extent.h"
#include "syntax/parser.h"
#include "toolchain/toolchain.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Process.h"

#include <fmt/format.h>

#include <algorithm>

namespace ladderc::driver {

namespace {

using nlohmann::json;

constexpr std::size_t kProgramsPerFile = 40;
constexpr std::size_t kWriterLines = 12;  ///< of the report of one failure, about

/// A scenario's program on its way into the runner.
struct Candidate {
  std::size_t scenario;
  std::unique_ptr<Compilation> compilation;
};

/// Compares what was reported with what the scenario expects.
void check_messages(const Scenario &s, Compilation &c, ScenarioResult &result) {
  llvm::ArrayRef<Diagnostic> reported = c.diagnostics->sorted();
  auto line = [&](const Diagnostic &d) { return c.sources.position(d.range).line; };
  const FamilyInfo *family = find_family(s.family);
  const llvm::StringRef cited = family ? cited_family(*family) : llvm::StringRef(s.family);
  auto has_code = [&](const Diagnostic &d, const std::string &code) {
    return llvm::any_of(info(d.id).references, [&](const DiagReference &r) { return r.family == cited && r.code.contains(code); });
  };
  for (const ExpectedDiagnostic &e : s.diagnostics) {
    const Severity severity = e.severity == "warning" ? Severity::Warning : Severity::Error;
    const bool found = llvm::any_of(reported, [&](const Diagnostic &d) {
      return d.severity == severity && (e.line == 0 || line(d) == e.line) && (e.code.empty() || has_code(d, e.code));
    });
    if (!found)
      result.fail(fmt::format("expected an {} in line {}{}: {}", e.severity, e.line, e.code.empty() ? "" : " with code " + e.code,
                              e.about));
  }
  for (const Diagnostic &d : reported)
    if (d.severity == Severity::Error && llvm::none_of(s.diagnostics, [&](const ExpectedDiagnostic &e) {
          return e.severity == "error" && (e.line == 0 || e.line == line(d));
        }))
      result.fail(fmt::format("line {}: error: {} [{}]", line(d), d.message, info(d.id).id.str()));
}

std::unique_ptr<Compilation> compile(const Scenario &s, const BatchOptions &options, ScenarioResult &result) {
  auto c = std::make_unique<Compilation>();
  c->options = options.common;
  c->options.family = s.family;
  c->options.model = s.model;
  const FamilyInfo *family = find_family(s.family);
  if (!family) {
    result.fail(fmt::format("family {} is not supported", s.family));
    return nullptr;
  }
  Parameters parameters = default_parameters(*family, s.model.empty() ? family->models.front() : llvm::StringRef(s.model));
  if (const auto problem = read_parameters(s.parameters, *family, parameters)) {
    result.fail(*problem);
    return nullptr;
  }
  if (!c->check_text(s.list_name, s.list, &parameters)) {
    result.fail("the list was not read");
    return nullptr;
  }
  check_messages(s, *c, result);
  if (!c->program.ok || s.steps.empty())
    return nullptr;
  if (!c->lower_and_optimize()) {
    result.fail("internal fault");
    return nullptr;
  }
  return c;
}

/// The program's files as one text, without the includes that join them.
std::string joined_text(Compilation &c, std::size_t index) {
  emit::EmitOptions o = c.emit_options();
  o.name_space = fmt::format("s{}", index);
  o.class_name = "Program";
  o.stem = o.name_space;
  std::string text;
  for (const emit::OutputFile &file : emit::emit_program(c.program, c.module, c.sources, o)) {
    llvm::StringRef rest = file.text;
    while (!rest.empty()) {
      const auto [line, next] = rest.split('\n');
      if (line != "#pragma once" && !line.starts_with("#include \""))
        text += line.str() + "\n";
      rest = next;
    }
  }
  return text;
}

std::string table_text(std::size_t programs) {
  std::string text = "#include <ladder/hosted/scenario_main.h>\n\n";
  for (std::size_t i = 0; i < programs; ++i)
    text += fmt::format("namespace s{} {{ extern const ladder::ProgramSymbols kProgramSymbols; }}\n", i);
  text += "\nint main(int argc, char **argv) {\n  static const ladder::ProgramSymbols *const programs[] = {\n";
  for (std::size_t i = 0; i < programs; ++i)
    text += fmt::format("      &s{}::kProgramSymbols,\n", i);
  return text + "  };\n  return ladder::hosted::scenario_main(argc, argv, programs);\n}\n";
}

std::optional<std::string> build_runner(const std::vector<Candidate> &candidates, const BatchOptions &options,
                                        std::string &runner) {
  std::vector<std::pair<std::string, std::string>> files;
  const std::size_t per_file = std::min(kProgramsPerFile, candidates.size() / options.jobs + 1);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i % per_file == 0)
      files.emplace_back(fmt::format("batch{}.cpp", i / per_file), "");
    files.back().second += joined_text(*candidates[i].compilation, i);
  }
  files.emplace_back("main.cpp", table_text(candidates.size()));

  const toolchain::Locations locations = toolchain::find_runtime(g_argv0);
  std::vector<llvm::StringRef> parts = {options.common.level == 0 ? "O0" : options.common.level == 1 ? "O1" : "O2"};
  for (const auto &[name, text] : files)
    parts.insert(parts.end(), {name, text});
  const std::string folder = toolchain::cache_folder(toolchain::cache_key(parts, locations));
  runner = folder + "/runner";
  if (llvm::sys::fs::exists(runner))
    return std::nullopt;
  std::vector<std::string> sources;
  for (const auto &[name, text] : files) {
    if (auto problem = toolchain::write_file(folder + "/" + name, text))
      return problem;
    sources.push_back(name);
  }
  toolchain::CompileOptions compile;
  compile.level = options.common.level;
  compile.debug = options.common.debug;
  compile.jobs = options.jobs;
  compile.verbose = options.verbose;
  const std::string fresh = fmt::format("{}.{}", runner, llvm::sys::Process::getProcessId());
  if (auto problem = toolchain::build(folder, sources, fresh, locations, compile))
    return problem;
  if (const std::error_code ec = llvm::sys::fs::rename(fresh, runner))
    return fmt::format("cannot write {}: {}", runner, ec.message());
  return std::nullopt;
}

/// True where the operation writes the device: by name, or (`blocks`) by a block of its class whose length only the run tells.
bool writes(const ir::Module &module, const ir::Operation &o, const ir::Extent &wanted, bool blocks) {
  bool hit = false;
  ir::for_each_write(module, o, [&](const ir::Extent &e) {
    const bool block = e.all || e.last == ir::kEndOfClass;
    hit |= block == blocks && ir::overlap(e, wanted) && e.device == wanted.device;
  });
  return hit;
}

void add_lines(const Compilation &c, const ir::Rung &rung, std::vector<std::string> &lines) {
  for (std::uint32_t i = 0; i < rung.instruction_count; ++i) {
    const Instruction &instruction = c.program.list.instructions[rung.first_instruction + i];
    lines.push_back(fmt::format("  line {}, step {}: {}", c.sources.position(instruction.range).line, instruction.step,
                                emit::list_text(c.program, instruction)));
  }
}

/// List lines of the rungs that write the device, for the report of a failing step. Blocks count only where nothing else writes it.
std::vector<std::string> writers_of(const Compilation &c, llvm::StringRef device) {
  // TN0, CN0, TC0 and the like are names of scenarios only; the list knows the whole timer or counter.
  std::string name = device.split(':').first.str();
  if (llvm::StringRef(name).contains(' '))
    return {};  // a serial port
  if (const llvm::StringRef prefix = llvm::StringRef(name).take_while(llvm::isAlpha);
      prefix.size() > 1 && find_device(*c.program.family, prefix) == kNoDevice)
    name.erase(prefix.size() - 1, 1);
  const Operand operand = parse_operand(*c.program.family, name, {});
  std::vector<std::string> lines;
  if (operand.kind == OperandKind::Invalid)
    return lines;
  const ir::Extent wanted = ir::extent(c.module, ir::to_place(operand, OperandType::Word));
  for (const bool blocks : {false, true}) {
    for (const ir::Routine &routine : c.module.routines)
      for (const ir::Rung &rung : routine.rungs)
        if (lines.size() < kWriterLines &&
            llvm::any_of(rung.operations, [&](const ir::Operation &o) { return writes(c.module, o, wanted, blocks); }))
          add_lines(c, rung, lines);
    if (!lines.empty())
      break;
  }
  return lines;
}

/// A value as the runner gives it: a number, a pattern as text, or the bytes of a serial port.
std::string text_of(const json &failure, const char *key) {
  const auto found = failure.find(key);
  if (found == failure.end())
    return "?";
  if (*found == "")
    return "nothing";
  return found->is_string() ? found->get<std::string>() : found->dump();
}

void read_results(const json &results, const std::vector<Candidate> &candidates, const std::vector<Scenario> &scenarios,
                  std::vector<ScenarioResult> &out) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    ScenarioResult &result = out[candidates[i].scenario];
    if (i >= results.size()) {
      result.fail("the runner gave no result");
      continue;
    }
    const json &r = results[i];
    if (r.contains("error") && r["error"].is_string() && !r["error"].get<std::string>().empty())
      result.fail(r["error"].get<std::string>());
    for (const json &f : r.value("failures", json::array())) {
      const std::size_t step = f.value("step", std::size_t{0});
      const std::string device = f.value("device", "");
      result.failures.push_back(
          {{"step", step + 1}, {"scan", f.value("scan", 0)}, {"device", device}, {"expected", f["expected"]}, {"got", f["got"]}});
      result.fail(fmt::format("step {}, scan {}: {} is {}, expected {}", step + 1, f.value("scan", 0), device, text_of(f, "got"),
                              text_of(f, "expected")));
      const nlohmann::ordered_json &steps = scenarios[candidates[i].scenario].steps;
      if (step < steps.size() && steps[step].contains("why"))
        result.messages.push_back("  why: " + steps[step]["why"].get<std::string>());
      for (std::string &line : writers_of(*candidates[i].compilation, device))
        result.messages.push_back(std::move(line));
    }
    if (!r.value("passed", false) && result.passed)
      result.fail("the runner says that it failed");
  }
}

nlohmann::ordered_json steps_file(const std::vector<Candidate> &candidates, const std::vector<Scenario> &scenarios) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Scenario &s = scenarios[candidates[i].scenario];
    nlohmann::ordered_json entry = {{"program", i}, {"name", s.name}, {"clock_ms", s.clock_ms}, {"steps", s.steps}};
    if (!s.calendar.empty())
      entry["calendar"] = s.calendar;
    entry.update(s.connected);
    all.push_back(std::move(entry));
  }
  return all;
}

}  // namespace

std::optional<std::string> run_scenarios(const std::vector<Scenario> &scenarios, const BatchOptions &options,
                                         std::vector<ScenarioResult> &results) {
  results.assign(scenarios.size(), {});
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < scenarios.size(); ++i)
    if (auto c = compile(scenarios[i], options, results[i]))
      candidates.push_back({i, std::move(c)});
  if (candidates.empty())
    return std::nullopt;
  std::string runner;
  if (auto problem = build_runner(candidates, options, runner))
    return problem;
  const std::string base = fmt::format("{}.{}", runner, llvm::sys::Process::getProcessId());
  const std::string steps = base + ".steps.json", answers = base + ".results.json";
  if (auto problem = toolchain::write_file(steps, steps_file(candidates, scenarios).dump()))
    return problem;
  std::string error;
  const int code = toolchain::run(runner, {steps, answers}, error);
  auto text = llvm::MemoryBuffer::getFile(answers);
  llvm::sys::fs::remove(steps);
  llvm::sys::fs::remove(answers);
  if (code != 0 && code != 1)
    return fmt::format("the scenario runner failed with exit code {} {}", code, error);
  if (!text)
    return std::string("the scenario runner wrote no results");
  const json document = json::parse((*text)->getBuffer().begin(), (*text)->getBuffer().end(), nullptr, false);
  if (!document.is_array())
    return std::string("the scenario runner's results cannot be read");
  read_results(document, candidates, scenarios, results);
  return std::nullopt;
}

}  // namespace ladderc::driver
