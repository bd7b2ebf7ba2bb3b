// Bytes as a list file of the family LADDERC_FUZZ_FAMILY: decoding, reading, parsing, checking; what is accepted is lowered, optimized
// and written as C++.
#include "emit/program.h"
#include "lower/lower.h"
#include "opt/pipeline.h"
#include "source/decode.h"
#include "syntax/parser.h"

#include <cstdlib>

using namespace ladderc;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const FamilyInfo &family = *find_family(LADDERC_FUZZ_FAMILY);
  SourceSet sources;
  Diagnostics diagnostics(sources);
  const unsigned file = sources.add("fuzz.il", decode({reinterpret_cast<const char *>(data), size}).text);
  const CheckedProgram program =
      check(parse_list(family, sources, file, ListFormat::Auto, diagnostics), "", default_parameters(family, ""), diagnostics);
  std::string text;
  llvm::raw_string_ostream out(text);
  print_ast(program.list, sources, out);
  print_text(diagnostics, family.id, out);
  print_json(diagnostics, family.id, out);
  if (!program.ok)
    return 0;
  ir::Module module = lower(program);
  opt::Context rewrites;
  if (!ir::verify(module).empty() || !opt::run(module, opt::Options(), rewrites).empty())
    std::abort();
  emit::emit_program(program, module, sources, emit::EmitOptions());
  return 0;
}
