// Building the native program of a compilation.
#include "driver/native.h"

#include "emit/names.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Process.h"

#include <fmt/format.h>

#include <cstdlib>

namespace ladderc::driver {

std::string main_text(const std::vector<emit::OutputFile> &files, const std::string &name_space, const std::string &class_name) {
  return fmt::format("// The main program of a hosted build, written by ladderc.\n"
                     "#include \"{0}\"\n\n"
                     "#include <ladder/hosted/program_main.h>\n\n"
                     "namespace {1} {{\nextern const ladder::ProgramSymbols k{2}Symbols;\n}}\n\n"
                     "int main(int argc, char **argv) {{ return ladder::hosted::program_main(argc, argv, {1}::k{2}Symbols); }}\n",
                     files.front().name, name_space, class_name);
}

std::string build_native(Compilation &c, llvm::StringRef executable, bool verbose) {
  std::vector<emit::OutputFile> files = c.emit();
  const std::string list = c.sources[c.program.list.file].name().str();
  files.push_back({emit::file_stem(list) + ".main.cpp", main_text(files, c.emit_options().name_space, emit::class_name(list))});

  const toolchain::Locations locations = toolchain::find_runtime(g_argv0);
  std::vector<std::string> parts = {fmt::format("O{} g{}", c.options.level, c.options.debug)};
  for (const char *variable : {"CXXFLAGS", "LDFLAGS"})
    parts.push_back(std::getenv(variable) ? std::getenv(variable) : "");
  for (const emit::OutputFile &file : files)
    parts.insert(parts.end(), {file.name, file.text});
  const std::vector<llvm::StringRef> refs(parts.begin(), parts.end());
  const std::string folder = toolchain::cache_folder(toolchain::cache_key(refs, locations));
  const std::string target = executable.empty() ? folder + "/program" : executable.str();
  if (executable.empty() && llvm::sys::fs::exists(target))
    return target;

  std::vector<std::string> sources;
  for (const emit::OutputFile &file : files) {
    if (const auto problem = toolchain::write_file(folder + "/" + file.name, file.text)) {
      usage_error(*problem);
      return {};
    }
    if (llvm::StringRef(file.name).ends_with(".cpp"))
      sources.push_back(file.name);
  }
  toolchain::CompileOptions options;
  options.level = c.options.level;
  options.debug = c.options.debug;
  options.verbose = verbose;
  // A program that another run is building at this moment must not be started half-written: link beside, then rename.
  const std::string fresh = executable.empty() ? fmt::format("{}.{}", target, llvm::sys::Process::getProcessId()) : target;
  if (const auto problem = toolchain::build(folder, sources, fresh, locations, options)) {
    usage_error(*problem);
    return {};
  }
  if (fresh != target)
    if (const std::error_code ec = llvm::sys::fs::rename(fresh, target)) {
      usage_error(fmt::format("cannot write {}: {}", target, ec.message()));
      return {};
    }
  return target;
}

}  // namespace ladderc::driver
