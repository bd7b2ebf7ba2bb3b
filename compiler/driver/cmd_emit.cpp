// ladderc emit LIST -o DIR
#include "driver/compilation.h"
#include "toolchain/toolchain.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/raw_ostream.h"

#include <fmt/format.h>

namespace ladderc::driver {

namespace cl = llvm::cl;

static cl::opt<std::string> kList(cl::Positional, cl::desc("LIST"), cl::Required, cl::sub(kEmit));
static cl::opt<std::string> kFolder("o", cl::desc("The folder to write (default: here)"), cl::value_desc("DIR"), cl::init("."), cl::sub(kEmit));

int run_emit() {
  Compilation c;
  bool done;
  if (const int code = compile_list(c, kList, done); code || done)
    return code;
  std::vector<emit::OutputFile> files = c.emit();
  files.push_back(emit::emit_cmake(files, c.emit_options()));
  if (const std::error_code ec = llvm::sys::fs::create_directories(std::string(kFolder)))
    return usage_error(fmt::format("cannot make the folder '{}': {}", std::string(kFolder), ec.message()));
  for (const emit::OutputFile &file : files) {
    if (const auto problem = toolchain::write_file(std::string(kFolder) + "/" + file.name, file.text))
      return usage_error(*problem);
    llvm::outs() << std::string(kFolder) << "/" << file.name << "\n";
  }
  if (c.options.stats)
    c.print_stats(llvm::errs());
  return 0;
}

}  // namespace ladderc::driver
