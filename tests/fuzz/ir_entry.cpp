// Bytes as IR text: what can be read is printed, read again and printed the same; what the verifier accepts survives the passes.
#include "ir/ir.h"
#include "opt/pipeline.h"

#include <cstdlib>

using namespace ladderc;

static std::string printed(const ir::Module &module, const SourceSet &sources) {
  std::string text;
  llvm::raw_string_ostream out(text);
  ir::print(module, sources, out);
  return text;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  SourceSet sources;
  sources.add("fuzz.il", "");
  ir::Module module, again;
  module.family = again.family = find_family("melsec-qs");
  std::string error;
  if (!ir::parse({reinterpret_cast<const char *>(data), size}, module, error))
    return 0;
  const std::string text = printed(module, sources);
  if (!ir::parse(text, again, error) || printed(again, sources) != text)
    std::abort();
  opt::Context rewrites;
  if (ir::verify(module).empty() && !opt::run(module, opt::Options(), rewrites).empty())
    std::abort();
  return 0;
}
