// What ladder-tblgen can make of the records. Each action writes one file.
#pragma once

#include "llvm/Support/raw_ostream.h"
#include "llvm/TableGen/Record.h"

namespace ladderc::tblgen {

/// -gen-family: constant arrays of compiler/tables/tables.h, to be included by compiler/tables/tables.cpp.
void emit_family(llvm::RecordKeeper &records, llvm::raw_ostream &out);
/// -gen-docs: docs/instructions/<family>.md.
void emit_family_docs(llvm::RecordKeeper &records, llvm::raw_ostream &out);
/// -gen-diagnostic-ids: LADDERC_DIAG(Name), one a line, in the order of the records.
void emit_diagnostic_ids(llvm::RecordKeeper &records, llvm::raw_ostream &out);
/// -gen-diagnostics: `kDiagnostics`, in the same order.
void emit_diagnostics(llvm::RecordKeeper &records, llvm::raw_ostream &out);
/// -gen-diagnostic-docs: docs/diagnostics.md.
void emit_diagnostic_docs(llvm::RecordKeeper &records, llvm::raw_ostream &out);

}  // namespace ladderc::tblgen
