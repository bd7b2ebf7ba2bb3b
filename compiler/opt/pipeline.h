// The pass manager.
#pragma once

#include "ir/ir.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringSet.h"

#include <functional>

namespace ladderc::opt {

/// What the passes of one run share: which rewrites are allowed, and how many were made.
class Context {
public:
  /// True where the rewrite may be made; counts it. With a bisection limit, only the first `limit` rewrites of all passes are made.
  bool may_rewrite(llvm::StringRef pass, llvm::StringRef statistic) {
    if (limit >= 0 && made_ >= limit)
      return false;
    ++made_;
    ++counts_[pass.str() + "." + statistic.str()];
    return true;
  }
  /// Name ("dead-coil.removed") to count.
  const llvm::StringMap<unsigned> &counts() const { return counts_; }

  long long limit = -1;  ///< --bisect

private:
  long long made_ = 0;
  llvm::StringMap<unsigned> counts_;
};

struct Pass {
  llvm::StringLiteral name;
  void (*run)(ir::Module &, Context &);
  unsigned level;            ///< runs from this -O level on
  llvm::StringLiteral what;  ///< one line for help and docs
};

llvm::ArrayRef<Pass> passes();

struct Options {
  unsigned level = 2;
  llvm::StringSet<> disabled;     ///< --no-PASS
  std::vector<std::string> only;  ///< --pass: these passes in this order, whatever the level; empty: the pipeline
  long long bisect = -1;
  bool verify = true;
  std::function<void(const Pass &, const ir::Module &)> after;  ///< --print-after
};

/// Runs the pipeline. Returns what the verifier found (a fault of ours), or an empty text.
[[nodiscard]] std::string run(ir::Module &module, const Options &options, Context &context);
/// The pass of that name, or null.
const Pass *find_pass(llvm::StringRef name);

void run_const_contact(ir::Module &, Context &);
void run_redundant_load(ir::Module &, Context &);
void run_simplify(ir::Module &, Context &);
void run_dead_coil(ir::Module &, Context &);
void run_dead_value(ir::Module &, Context &);

}  // namespace ladderc::opt
