// ladderc generate [--profile P] [--seed N] [--rungs N] [-o FILE]
#include "driver/options.h"
#include "generate/generate.h"
#include "toolchain/toolchain.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/raw_ostream.h"

#include <fmt/format.h>

namespace ladderc::driver {

namespace cl = llvm::cl;

static cl::opt<std::string> kProfile("profile", cl::desc("contacts; mixed: all that cannot stop the CPU; all (default)"),
                                     cl::value_desc("NAME"), cl::init("all"), cl::sub(kGenerate));
static cl::opt<unsigned long long> kSeed("seed", cl::desc("The same seed gives the same list (default 1)"), cl::value_desc("N"),
                                         cl::init(1), cl::sub(kGenerate));
static cl::opt<unsigned> kRungs("rungs", cl::desc("At least so many rungs (default 20)"), cl::value_desc("N"), cl::init(20),
                                cl::sub(kGenerate));
static cl::opt<std::string> kOutput("o", cl::desc("The file to write (default: the terminal)"), cl::value_desc("FILE"),
                                    cl::sub(kGenerate));

int run_generate() {
  CommonOptions common;
  if (!read_common_options(common))
    return kExitUsage;
  GenerateOptions options;
  options.family = find_family(common.family);
  if (!options.family)
    return usage_error(fmt::format("unknown family '{}'", common.family));
  options.model = common.model.empty() ? options.family->models.front() : llvm::StringRef(common.model);
  if (!llvm::is_contained(options.family->models, options.model))
    return usage_error(fmt::format("family {} has no model '{}'", common.family, common.model));
  options.parameters = default_parameters(*options.family, options.model);
  if (!common.parameters_file.empty()) {
    auto text = llvm::MemoryBuffer::getFile(common.parameters_file);
    if (!text)
      return usage_error(fmt::format("cannot read '{}': {}", common.parameters_file, text.getError().message()));
    if (const auto problem = read_parameters((*text)->getBuffer(), *options.family, options.parameters))
      return usage_error(fmt::format("{}: {}", common.parameters_file, *problem));
  }
  const auto profile = find_generate_profile(kProfile);
  if (!profile)
    return usage_error(fmt::format("--profile={}: expected contacts, mixed or all", std::string(kProfile)));
  options.profile = *profile;
  options.seed = kSeed;
  options.rungs = kRungs;
  const std::string list = generate_list(options);
  if (kOutput.empty()) {
    llvm::outs() << list;
    return 0;
  }
  if (const auto problem = toolchain::write_file(std::string(kOutput), list))
    return usage_error(*problem);
  return 0;
}

}  // namespace ladderc::driver
