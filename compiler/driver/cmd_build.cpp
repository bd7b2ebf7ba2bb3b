// ladderc build LIST -o EXE
#include "driver/native.h"
#include "emit/names.h"

#include "llvm/Support/raw_ostream.h"

namespace ladderc::driver {

namespace cl = llvm::cl;

static cl::opt<std::string> kList(cl::Positional, cl::desc("LIST"), cl::Required, cl::sub(kBuild));
static cl::opt<std::string> kOutput("o", cl::desc("The program to write (default: the list's name)"), cl::value_desc("EXE"), cl::sub(kBuild));
static cl::opt<bool> kVerbose("verbose", cl::desc("Print the commands of the C++ compiler"), cl::sub(kBuild));

int run_build() {
  Compilation c;
  bool done;
  if (const int code = compile_list(c, kList, done); code || done)
    return code;
  const std::string output = kOutput.empty() ? emit::file_stem(kList) : std::string(kOutput);
  if (build_native(c, output, kVerbose).empty())
    return kExitUsage;
  if (c.options.stats)
    c.print_stats(llvm::errs());
  return 0;
}

}  // namespace ladderc::driver
