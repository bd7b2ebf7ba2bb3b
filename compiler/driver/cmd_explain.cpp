// ladderc explain ID
#include "driver/options.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/raw_ostream.h"

#include <fmt/format.h>

namespace ladderc::driver {

namespace cl = llvm::cl;

static cl::opt<std::string> kId(cl::Positional, cl::desc("ID (without: all ids)"), cl::sub(kExplain));

int run_explain() {
  if (kId.empty()) {
    for (const DiagInfo &d : all_diagnostics())
      if (d.severity != Severity::Note)
        llvm::outs() << fmt::format("{:<28} {:<8} {}\n", d.id.str(), d.severity == Severity::Error ? "error" : "warning", d.message.str());
    return 0;
  }
  if (const DiagInfo *found = find_diagnostic(kId)) {
    print_explanation(*found, llvm::outs());
    return 0;
  }
  std::string near;
  for (const DiagInfo &d : all_diagnostics())
    if (d.severity != Severity::Note && (d.id.edit_distance(kId) <= 3 || d.id.contains(kId)))
      near += (near.empty() ? "; near: " : ", ") + d.id.str();
  return usage_error(fmt::format("there is no message '{}'{}", std::string(kId), near));
}

}  // namespace ladderc::driver
