// The pipeline as data.
#include "opt/pipeline.h"

namespace ladderc::opt {

static constexpr Pass kPipeline[] = {
    {"const-contact", run_const_contact, 1, "contacts of relays that are always on or always off become constants"},
    {"redundant-load", run_redundant_load, 1, "a contact that a rung has read already is not read again"},
    {"simplify", run_simplify, 1, "boolean rules: constants, complements, absorption, double inversion, common factors"},
    {"dead-coil", run_dead_coil, 2, "a coil that is written again before anyone can look is not written"},
    {"dead-value", run_dead_value, 1, "results that nobody uses are dropped"},
};

llvm::ArrayRef<Pass> passes() { return kPipeline; }

std::string run(ir::Module &module, const Options &options, Context &context) {
  context.limit = options.bisect;
  for (const Pass &pass : kPipeline) {
    if (options.level < pass.level || options.disabled.contains(pass.name))
      continue;
    pass.run(module, context);
    if (options.verify)
      if (std::string problem = ir::verify(module); !problem.empty())
        return "after " + pass.name.str() + ": " + problem;
    if (options.after)
      options.after(pass, module);
  }
  return {};
}

bool run_one(llvm::StringRef name, ir::Module &module, Context &context) {
  for (const Pass &pass : kPipeline)
    if (pass.name == name) {
      pass.run(module, context);
      return true;
    }
  return false;
}

}  // namespace ladderc::opt
