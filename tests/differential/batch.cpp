// From seeds to loaded libraries.
//
// Each program stands in a namespace of its own; one file holds all of a batch. The -O0 library is made of the -O0 C++ by `g++
// -O0`, the other by -O2 of both. The two C++ compilers run side by side.
#include "batch.h"

#include "judge.h"

#include "emit/program.h"
#include "generate/random.h"
#include "toolchain/toolchain.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Program.h"

#include <fmt/format.h>

#include <dlfcn.h>

namespace ladderc::differential {

namespace {

/// What the engineering tool sets, by family: allocations in which many operands reach over the end of their class, latched
/// devices.
struct ParameterChoice {
  llvm::StringLiteral family, json;
};
const ParameterChoice kParameters[] = {
    {"melsec-qs", R"({"ST_points": 8})"},
    {"melsec-qs",
     R"({"device_points": {"X": 48, "Y": 32, "M": 40, "B": 16, "F": 40, "SB": 12, "V": 16, "T": 8, "ST": 4, "C": 6, "D": 28, "W": 12,
        "SW": 10}, "low_speed_unit_ms": 10, "high_speed_unit_ms": 1})"},
    {"melsec-qs",
     R"({"device_points": {"X": 256, "Y": 256, "M": 512, "B": 64, "F": 64, "SB": 32, "V": 32, "T": 16, "ST": 8, "C": 16, "D": 128,
        "W": 64, "SW": 32}, "program_name": "RANDOM", "low_speed_unit_ms": 50, "high_speed_unit_ms": 0.7,
        "latched": ["X3", "Y4-Y7", "M8-M19", "M18-M22", "B0-B3", "F2-F5", "V1-V4", "T1-T2", "ST0", "C0-C1", "D4-D11", "D120-D127",
        "W0-W3"], "device_initial_values": {"D9": 7, "D20": -5, "M30": 1, "W2": 300}})"}};

std::string joined_text(const driver::Compilation &c, const std::string &space) {
  emit::EmitOptions options = c.emit_options();
  options.name_space = options.stem = space;
  options.class_name = "Program";
  std::string text;
  for (const emit::OutputFile &file : emit::emit_program(c.program, c.module, c.sources, options)) {
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
  std::string text =
      "extern \"C\" __attribute__((visibility(\"default\"))) const ladder::ProgramSymbols *const ladderc_programs[];\n"
      "const ladder::ProgramSymbols *const ladderc_programs[] = {\n";
  for (std::size_t i = 0; i < programs; ++i)
    text += fmt::format("    &p{}::kProgramSymbols,\n", i);
  return text + "};\n";
}

struct Library {
  std::string name, text;
  unsigned level;
  bool packed;
  std::string path;
};

std::string compile_libraries(llvm::MutableArrayRef<Library> libraries, const BatchSettings &settings) {
  const std::string compiler = toolchain::find_compiler();
  const auto program = llvm::sys::findProgramByName(compiler);
  if (!program)
    return "no C++ compiler";
  const std::string include = "-I" + toolchain::find_runtime("").runtime_include;
  std::vector<llvm::sys::ProcessInfo> running;
  std::string error;
  for (Library &library : libraries) {
    const std::string source = fmt::format("{}/{}.cpp", settings.folder, library.name);
    library.path = fmt::format("{}/{}.so", settings.folder, library.name);
    if (const auto problem = toolchain::write_file(source, library.text))
      return *problem;
    std::vector<std::string> command = {*program,
                                        "-std=c++20",
                                        fmt::format("-O{}", library.level),
                                        "-fPIC",
                                        "-shared",
                                        "-fvisibility=hidden",
                                        "-fno-exceptions",
                                        "-fno-rtti",
                                        include,
                                        source,
                                        "-o",
                                        library.path};
    if (library.packed)
      command.push_back("-DLADDER_PACKED_BITS=1");
    if (settings.trap_undefined)
      command.insert(command.end(), {"-fsanitize=undefined", "-fsanitize-undefined-trap-on-error"});
    const std::vector<llvm::StringRef> arguments(command.begin(), command.end());
    running.push_back(llvm::sys::ExecuteNoWait(*program, arguments, std::nullopt, {}, 0, &error));
  }
  bool failed = false;
  for (const llvm::sys::ProcessInfo &process : running)
    failed |= llvm::sys::Wait(process, std::nullopt, &error).ReturnCode != 0;
  return failed ? "the C++ compiler refused " + settings.folder : "";
}

std::string load(const Library &library, std::vector<CompiledCase> &compiled,
                 const ladder::ProgramSymbols *CompiledCase::*symbols) {
  void *handle = dlopen(library.path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle)
    return dlerror();
  const auto *table = static_cast<const ladder::ProgramSymbols *const *>(dlsym(handle, "ladderc_programs"));
  if (!table)
    return dlerror();
  for (std::size_t i = 0; i < compiled.size(); ++i)
    compiled[i].*symbols = table[i];
  return {};
}

}  // namespace

Case make_case(const FamilyInfo &family, std::uint64_t seed) {
  Random random(seed * 31 + 17);
  Case c;
  c.seed = seed;
  c.generate.family = &family;
  c.generate.model = family.models[random.below(static_cast<std::uint32_t>(family.models.size()))];
  c.generate.parameters = default_parameters(*c.generate.family, c.generate.model);
  c.generate.seed = seed;
  c.generate.profile = random.pick<GenerateProfile>({GenerateProfile::Contacts, GenerateProfile::Mixed, GenerateProfile::Mixed,
                                                     GenerateProfile::All, GenerateProfile::All, GenerateProfile::All});
  c.generate.rungs = 4 + random.below(30);
  std::vector<llvm::StringRef> choices;
  for (const ParameterChoice &choice : kParameters)
    if (choice.family == family.id)
      choices.push_back(choice.json);
  if (!choices.empty())
    if (const auto problem = read_parameters(random.pick(llvm::ArrayRef(choices)), family, c.generate.parameters))
      llvm::errs() << *problem << "\n";
  if (has_partial_judge(family) && seed % 2 == 0) {
    c.generate.accepts = [&family](const InstructionInfo &info) { return is_judged(family, info); };
    c.generate.without = not_judged(family);
  }
  c.list = generate_list(c.generate);
  return c;
}

std::string compile_case(const Case &c, unsigned level, std::unique_ptr<driver::Compilation> &compilation) {
  compilation = std::make_unique<driver::Compilation>();
  compilation->options.family = c.generate.family->id.str();
  compilation->options.model = c.generate.model.str();
  compilation->options.format = "auto";
  compilation->options.level = level;
  if (!compilation->check_text(fmt::format("seed{}.il", c.seed), c.list, &c.generate.parameters) || !compilation->program.ok) {
    compilation->report(llvm::errs());
    return fmt::format("seed {}: the list is refused", c.seed);
  }
  return compilation->lower_and_optimize() ? "" : fmt::format("seed {}: internal fault at -O{}", c.seed, level);
}

std::string build_batch(std::vector<Case> cases, const BatchSettings &settings, std::vector<CompiledCase> &compiled) {
  Library libraries[] = {{"plain", "", 0, settings.packed, ""}, {"optimized", "", 2, false, ""}};
  for (Case &c : cases) {
    CompiledCase &one = compiled.emplace_back();
    one.c = std::move(c);
    const std::string space = fmt::format("p{}", compiled.size() - 1);
    for (const auto &[library, compilation] : {std::pair{&libraries[0], &one.plain}, {&libraries[1], &one.optimized}}) {
      if (std::string problem = compile_case(one.c, library->level, *compilation); !problem.empty())
        return problem;
      library->text += joined_text(**compilation, space);
    }
  }
  for (Library &library : libraries)
    library.text += table_text(compiled.size());
  if (const std::error_code ec = llvm::sys::fs::create_directories(settings.folder))
    return ec.message();
  if (std::string problem = compile_libraries(libraries, settings); !problem.empty())
    return problem;
  if (std::string problem = load(libraries[0], compiled, &CompiledCase::plain_symbols); !problem.empty())
    return problem;
  return load(libraries[1], compiled, &CompiledCase::optimized_symbols);
}

}  // namespace ladderc::differential
