// ladder-tblgen: from the records in grammar/*.td to C++ tables and documentation.
//
// TableGen reads the files; this program chooses what is made of them. An action is a row below.
#include "actions.h"

#include "llvm/Support/CommandLine.h"
#include "llvm/TableGen/Main.h"
#include "llvm/TableGen/TableGenBackend.h"

namespace {

using namespace ladderc::tblgen;
using llvm::TableGen::Emitter::Opt;

const Opt kActions[] = {
    {"gen-family", emit_family, "Constant arrays of one family"},
    {"gen-docs", emit_family_docs, "Instruction reference of one family, in Markdown"},
    {"gen-diagnostic-ids", emit_diagnostic_ids, "Enumerators of the diagnostics"},
    {"gen-diagnostics", emit_diagnostics, "Constant array of the diagnostics"},
    {"gen-diagnostic-docs", emit_diagnostic_docs, "Pages of the diagnostics, in Markdown"},
};

}  // namespace

int main(int argc, char **argv) {
  llvm::cl::ParseCommandLineOptions(argc, argv, "makes C++ tables and documentation of ladderc's records\n");
  return llvm::TableGenMain(argv[0]);
}
