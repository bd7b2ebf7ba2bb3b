// ladderc check LIST...
#include "driver/compilation.h"

#include "llvm/Support/raw_ostream.h"

namespace ladderc::driver {

namespace cl = llvm::cl;

static cl::list<std::string> kLists(cl::Positional, cl::desc("LIST..."), cl::OneOrMore, cl::sub(kCheck));

int run_check() {
  int worst = 0;
  for (const std::string &path : kLists) {
    Compilation c;
    if (!read_common_options(c.options))
      return kExitUsage;
    if (!c.options.emit.empty() || llvm::StringRef(path).ends_with(".ir")) {
      bool done;
      worst = std::max(worst, compile_list(c, path, done));
      continue;
    }
    if (!c.check_file(path))
      return kExitUsage;
    if (!c.report(c.options.diagnostics == "json" ? llvm::outs() : llvm::errs()))
      worst = kExitErrors;
    if (c.options.stats)
      c.print_stats(llvm::errs());
  }
  return worst;
}

}  // namespace ladderc::driver
