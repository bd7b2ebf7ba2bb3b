// -gen-docs
#include "actions.h"
#include "family.h"
namespace ladderc::tblgen { void emit_family_docs(llvm::RecordKeeper &records, llvm::raw_ostream &) { read_family(records); } }
