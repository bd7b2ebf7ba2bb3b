// The pipeline from a list file to C++.
#include "driver/compilation.h"

#include "lower/lower.h"
#include "source/decode.h"
#include "syntax/parser.h"

#include "llvm/Support/MemoryBuffer.h"

#include <fmt/format.h>

#include <chrono>

namespace ladderc::driver {

namespace {

/// Adds the time of a stage when it goes away.
class StageTimer {
public:
  StageTimer(Compilation &c, const char *stage) : c_(c), stage_(stage), start_(std::chrono::steady_clock::now()) {}
  ~StageTimer() {
    c_.times.emplace_back(stage_, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count());
  }

private:
  Compilation &c_;
  const char *stage_;
  std::chrono::steady_clock::time_point start_;
};

/// Places in a text are 32-bit numbers; decoding can make a text three times as long.
constexpr std::size_t kMaxFileSize = std::size_t{1} << 30;

ListFormat format_of(llvm::StringRef name) {
  return name == "plain" ? ListFormat::Plain : name == "csv" ? ListFormat::GxCsv : ListFormat::Auto;
}

bool is_model(const FamilyInfo &family, llvm::StringRef model) {
  return llvm::is_contained(family.models, model);
}

}  // namespace

bool Compilation::check_file(llvm::StringRef path) {
  auto file = llvm::MemoryBuffer::getFileOrSTDIN(path, false, false);
  if (!file) {
    usage_error(fmt::format("cannot read '{}': {}", path.str(), file.getError().message()));
    return false;
  }
  if ((*file)->getBufferSize() > kMaxFileSize) {
    usage_error(fmt::format("'{}' is larger than {} MiB", path.str(), kMaxFileSize >> 20));
    return false;
  }
  if (!is_known_encoding(options.encoding)) {
    usage_error(fmt::format("unknown encoding '{}'", options.encoding));
    return false;
  }
  Decoded decoded;
  {
    const StageTimer timer(*this, "decode");
    decoded = decode((*file)->getBuffer(), options.encoding);
  }
  file->reset();
  return check_text(path == "-" ? "<stdin>" : path.str(), std::move(decoded.text), nullptr);
}

bool Compilation::check_text(std::string name, std::string utf8, const Parameters *given) {
  const FamilyInfo *family = find_family(options.family);
  if (!family) {
    std::string known;
    for (const FamilyInfo &f : families())
      known += (known.empty() ? "" : ", ") + f.id.str();
    usage_error(fmt::format("unknown family '{}'; known: {}", options.family, known));
    return false;
  }
  const std::string model = options.model.empty() ? family->models.front().str() : options.model;
  if (!is_model(*family, model)) {
    usage_error(fmt::format("family {} has no model '{}'", family->id.str(), model));
    return false;
  }
  Parameters parameters = given ? *given : default_parameters(*family, model);
  if (!options.parameters_file.empty()) {
    auto text = llvm::MemoryBuffer::getFile(options.parameters_file);
    if (!text) {
      usage_error(fmt::format("cannot read '{}': {}", options.parameters_file, text.getError().message()));
      return false;
    }
    if (const auto problem = read_parameters((*text)->getBuffer(), *family, parameters)) {
      usage_error(fmt::format("{}: {}", options.parameters_file, *problem));
      return false;
    }
  }
  const unsigned file = sources.add(std::move(name), std::move(utf8));
  diagnostics = std::make_unique<Diagnostics>(sources, options.diag);
  ListProgram list;
  {
    const StageTimer timer(*this, "read and parse");
    list = parse_list(*family, sources, file, format_of(options.format), *diagnostics);
  }
  const StageTimer timer(*this, "check");
  program = check(std::move(list), is_model(*family, model) ? *llvm::find(family->models, model) : llvm::StringRef(),
                  std::move(parameters), *diagnostics);
  return true;
}

bool Compilation::report(llvm::raw_ostream &out) {
  const FamilyInfo *family = find_family(options.family);
  const llvm::StringRef cited = family ? cited_family(*family) : llvm::StringRef(options.family);
  if (options.diagnostics == "json")
    print_json(*diagnostics, cited, out);
  else
    print_text(*diagnostics, cited, out);
  return program.ok && diagnostics->ok();
}

bool Compilation::lower_and_optimize() {
  {
    const StageTimer timer(*this, "lower");
    module = lower(program);
  }
  return optimize();
}

int Compilation::read_ir(llvm::StringRef path) {
  auto file = llvm::MemoryBuffer::getFile(path);
  if (!file)
    return usage_error(fmt::format("cannot read '{}': {}", path.str(), file.getError().message()));
  module.family = find_family(options.family);
  if (!module.family)
    return usage_error(fmt::format("unknown family '{}'", options.family));
  std::string problem;
  if (ir::parse((*file)->getBuffer(), module, problem))
    problem = ir::verify(module);
  if (problem.empty())
    return 0;
  llvm::errs() << path << ": error: " << problem << "\n";
  return kExitErrors;
}

bool Compilation::optimize() {
  opt::Options o;
  o.level = options.level;
  o.bisect = options.bisect;
  for (const std::string &name : options.disabled_passes)
    o.disabled.insert(name);
  o.only = options.only_passes;
  o.after = [&](const opt::Pass &pass, const ir::Module &m) {
    if (!llvm::is_contained(options.print_after, "all") && !llvm::is_contained(options.print_after, pass.name))
      return;
    llvm::outs() << "; after " << pass.name << "\n";
    ir::print(m, sources, llvm::outs());
  };
  const StageTimer timer(*this, "optimize");
  std::string problem = ir::verify(module);
  if (problem.empty())
    problem = opt::run(module, o, rewrites);
  if (problem.empty())
    return true;
  llvm::errs() << "ladderc: this is a bug in ladderc: " << problem << "\nPlease report the list and the command line.\n";
  return false;
}

emit::EmitOptions Compilation::emit_options() const {
  emit::EmitOptions o;
  o.level = options.level;
  o.line_directives = options.debug;
  if (!options.name_space.empty())
    o.name_space = options.name_space;
  return o;
}

std::vector<emit::OutputFile> Compilation::emit() {
  const StageTimer timer(*this, "emit");
  return emit::emit_program(program, module, sources, emit_options());
}

std::optional<int> Compilation::print_stage(llvm::raw_ostream &out) {
  if (options.emit.empty())
    return std::nullopt;
  if (options.emit == "ir") {
    ir::print(module, sources, out);
  } else if (options.emit == "cpp-rungs") {
    out << emit::emit_rungs(program, module, sources, emit_options());
  } else {
    bool first = true;
    for (const emit::OutputFile &file : emit()) {
      out << (first ? "" : "\n") << file.text;
      first = false;
    }
  }
  return 0;
}

void Compilation::print_stats(llvm::raw_ostream &out) const {
  std::vector<std::pair<std::string, unsigned>> counts;
  for (const auto &entry : rewrites.counts())
    counts.emplace_back(entry.first().str(), entry.second);
  llvm::sort(counts);
  for (const auto &[name, count] : counts)
    out << fmt::format("{:>10} {}\n", count, name);
  double total = 0;
  for (const auto &[stage, ms] : times) {
    out << fmt::format("{:>10.2f} ms {}\n", ms, stage);
    total += ms;
  }
  out << fmt::format("{:>10.2f} ms in all\n", total);
}

/// An .ir file: nothing but its passes can be tried, as there is no list to make C++ of.
static int compile_ir(Compilation &c, llvm::StringRef path) {
  if (!c.options.emit.empty() && c.options.emit != "ir")
    return usage_error("an .ir file can be printed with --emit=ir only");
  if (const int code = c.read_ir(path))
    return code;
  if (!c.optimize())
    return kExitInternal;
  if (c.options.emit == "ir")
    ir::print(c.module, c.sources, llvm::outs());
  if (c.options.stats)
    c.print_stats(llvm::errs());
  return 0;
}

int compile_list(Compilation &c, llvm::StringRef path, bool &done) {
  done = false;
  if (!read_common_options(c.options))
    return kExitUsage;
  if (path.ends_with(".ir")) {
    done = true;
    return compile_ir(c, path);
  }
  if (!c.check_file(path))
    return kExitUsage;
  if (c.options.emit == "lines" || c.options.emit == "ast") {
    done = true;
    if (c.options.emit == "ast")
      print_ast(c.program.list, c.sources, llvm::outs());
    else {
      Diagnostics repeated(c.sources);  // what the reader says has been reported by the check already
      print_lines(c.sources[c.program.list.file], c.program.list.file, format_of(c.options.format), repeated, llvm::outs());
    }
    return c.report(llvm::errs()) ? 0 : kExitErrors;
  }
  if (!c.report(llvm::errs()))
    return kExitErrors;
  if (!c.lower_and_optimize())
    return kExitInternal;
  if (const auto code = c.print_stage(llvm::outs())) {
    done = true;
    if (c.options.stats)
      c.print_stats(llvm::errs());
    return *code;
  }
  return 0;
}

}  // namespace ladderc::driver
