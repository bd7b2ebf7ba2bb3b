// The records of one family, read and checked.
//
// All actions that work on a family start here, so that a table that breaks a rule stops the build with a message at the record and
// no emitter has to look again. What the rules are is written beside each check in family.cpp.
#pragma once

#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/TableGen/Record.h"

#include <string>
#include <vector>

namespace ladderc::tblgen {

using llvm::Record;
using llvm::StringRef;

struct FamilyRecords {
  const Record *family = nullptr;
  std::vector<const Record *> devices;       ///< in the order of the family's list: the index is the DeviceId
  std::vector<const Record *> instructions;  ///< in the order of the files
  std::vector<const Record *> specials;      ///< in the order of the files
  std::vector<const Record *> errors;        ///< by code
  llvm::DenseMap<const Record *, unsigned> device_ids;

  StringRef id() const { return family->getValueAsString("id"); }
  /// Prefixes of the devices in the list field of a Classes record.
  std::vector<StringRef> prefixes(const Record &classes, StringRef field) const;
};

/// The range of a constant operand: what the record says, or what its type can hold.
struct ConstantRange {
  std::int64_t min, max;
};
ConstantRange constant_range(const Record &operand);

/// Reads the only Family of the input. Every broken rule is reported; with any, TableGen ends with a failure.
FamilyRecords read_family(llvm::RecordKeeper &records);

/// "Bit" of a record whose class has the field `cpp`, as OperandType and Execution have.
StringRef enumerator(const Record &record, StringRef field);

/// A C string literal.
std::string quoted(StringRef text);

}  // namespace ladderc::tblgen
