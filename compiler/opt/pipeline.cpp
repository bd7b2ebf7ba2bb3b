// The pipeline as data.
#include "opt/pipeline.h"

#include "llvm/ADT/STLExtras.h"

namespace ladderc::opt {

static constexpr Pass kPipeline[] = {
    {"const-contact", run_const_contact, 1, "contacts of relays that are always on or always off become constants"},
    {"redundant-load", run_redundant_load, 1, "a contact that a rung has read already is not read again"},
    {"simplify", run_simplify, 1, "boolean rules: constants, complements, absorption, double inversion, common factors"},
    {"dead-coil", run_dead_coil, 2, "a coil that is written again before anyone can look is not written"},
    {"dead-value", run_dead_value, 1, "results that nobody uses are dropped"},
};

llvm::ArrayRef<Pass> passes() {
  return kPipeline;
}

const Pass *find_pass(llvm::StringRef name) {
  const auto *found = llvm::find_if(kPipeline, [&](const Pass &pass) { return pass.name == name; });
  return found == std::end(kPipeline) ? nullptr : found;
}

/// The passes that the options ask for, in the order in which they run.
static std::vector<const Pass *> chosen(const Options &options) {
  std::vector<const Pass *> list;
  for (const std::string &name : options.only)
    if (const Pass *pass = find_pass(name))
      list.push_back(pass);
  if (options.only.empty())
    for (const Pass &pass : kPipeline)
      if (options.level >= pass.level && !options.disabled.contains(pass.name))
        list.push_back(&pass);
  return list;
}

std::string run(ir::Module &module, const Options &options, Context &context) {
  context.limit = options.bisect;
  for (const Pass *pass : chosen(options)) {
    pass->run(module, context);
    if (options.verify)
      if (std::string problem = ir::verify(module); !problem.empty())
        return "after " + pass->name.str() + ": " + problem;
    if (options.after)
      options.after(*pass, module);
  }
  return {};
}

}  // namespace ladderc::opt
