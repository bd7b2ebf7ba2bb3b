// Reading and checking the records of one family.
//
// A check names the rule in its message and points at the record that breaks it. Errors are collected, not thrown: TableGen itself
// ends with a failure when any has been printed.
#include "family.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/Support/raw_ostream.h"
#include "llvm/TableGen/Error.h"

#include <algorithm>

namespace ladderc::tblgen {

using llvm::PrintError;
using llvm::PrintFatalError;
using llvm::Twine;

StringRef enumerator(const Record &record, StringRef field) {
  return record.getValueAsDef(field)->getValueAsString("cpp");
}

std::string quoted(StringRef text) {
  std::string result;
  llvm::raw_string_ostream out(result);
  out << '"';
  out.write_escaped(text);
  out << '"';
  return result;
}

std::vector<StringRef> FamilyRecords::prefixes(const Record &classes, StringRef field) const {
  std::vector<StringRef> result;
  for (const Record *device : classes.getValueAsListOfDefs(field))
    if (StringRef prefix = device->getValueAsString("prefix"); !llvm::is_contained(result, prefix))
      result.push_back(prefix);  // classes may share one
  return result;
}

ConstantRange constant_range(const Record &operand) {
  std::int64_t min = operand.getValueAsInt("min"), max = operand.getValueAsInt("max");
  if (min != 0 || max != 0)
    return {min, max};
  StringRef type = enumerator(operand, "type");
  if (type == "Word")
    return {-32768, 32767};
  if (type == "DWord" || type == "Real")
    return {-2147483648LL, 2147483647LL};
  return {0, 0};
}

namespace {

std::vector<const Record *> in_file_order(const llvm::RecordKeeper &records, StringRef class_name) {
  std::vector<const Record *> result;
  for (const Record *record : records.getAllDerivedDefinitions(class_name))
    result.push_back(record);
  llvm::sort(result, [](const Record *a, const Record *b) { return a->getID() < b->getID(); });
  return result;
}

// ---- devices

/// Classes may share a prefix where the numbers tell them apart.
bool share_numbers(const Record &a, const Record &b) {
  const std::int64_t a_first = a.getValueAsInt("first"), b_first = b.getValueAsInt("first");
  return a.getValueAsString("prefix") == b.getValueAsString("prefix") && a_first < b_first + b.getValueAsInt("points") &&
         b_first < a_first + a.getValueAsInt("points");
}

void check_devices(const FamilyRecords &family) {
  // A set of classes is one 64-bit mask, and index 0xFF says "none".
  if (family.devices.size() > 63)
    PrintError(family.family, "a family has at most 63 device classes, this one has " + Twine(family.devices.size()));
  llvm::StringSet<> prefixes;
  llvm::DenseMap<std::int64_t, const Record *> order;
  for (const Record *device : family.devices) {
    if (!prefixes.insert(device->getValueAsString("prefix")).second &&
        llvm::any_of(family.devices, [&](const Record *other) { return other != device && share_numbers(*other, *device); }))
      PrintError(device, "two device classes have the prefix '" + device->getValueAsString("prefix") + "'");
    std::int64_t radix = device->getValueAsInt("radix");
    if (radix != 8 && radix != 10 && radix != 16)
      PrintError(device, "the radix is 8, 10 or 16");
    if (device->getValueAsInt("points") < 0)
      PrintError(device, "points cannot be negative");
    std::int64_t place = device->getValueAsInt("memoryOrder");
    if (place < 0 || place > 255)
      PrintError(device, "memoryOrder is 0 to 255");
    if (place != 0 && !order.insert({place, device}).second)
      PrintError(device, "two device classes have the memory order " + Twine(place));
    for (StringRef field : {"title", "behaviour", "section"})
      if (device->getValueAsString(field).empty())
        PrintError(device, "the device class has no " + field);
  }
}

// ---- operands

void check_device_list(const FamilyRecords &family, const Record &owner, const Record &operand, StringRef field) {
  for (const Record *device : operand.getValueAsDef("classes")->getValueAsListOfDefs(field)) {
    StringRef prefix = device->getValueAsString("prefix");
    StringRef kind = enumerator(*device, "kind");
    if (!family.device_ids.contains(device))
      PrintError(&owner,
                 "operand " + operand.getValueAsString("name") + " takes '" + prefix + "', which is not a device of the family");
    if (field == "digits" && kind != "Bit")
      PrintError(&owner, "operand " + operand.getValueAsString("name") + ": digits are of bit devices, '" + prefix + "' is none");
    if (field == "wordBits" && !device->getValueAsBit("bitOfWord"))
      PrintError(&owner, "operand " + operand.getValueAsString("name") + ": bits of '" + prefix + "' cannot be named");
  }
}

void check_operand(const FamilyRecords &family, const Record &owner, const Record &operand) {
  StringRef direction = operand.getValueAsString("direction");
  if (direction != "In" && direction != "Out" && direction != "InOut")
    PrintError(&owner, "operand " + operand.getValueAsString("name") + ": the direction is In, Out or InOut");
  for (StringRef field : {"devices", "wordBits", "digits"})
    check_device_list(family, owner, operand, field);
  bool constant = operand.getValueAsBit("decimal") || operand.getValueAsBit("hexadecimal");
  if (constant && direction != "In")
    PrintError(&owner, "operand " + operand.getValueAsString("name") + ": a constant cannot be written");
  ConstantRange range = constant_range(operand);
  if (range.min > range.max || ((constant || enumerator(operand, "type") == "Level") && range.min == range.max))
    PrintError(&owner, "operand " + operand.getValueAsString("name") + ": the range of the constant is empty");
}

void check_indexes(const Record &instruction, StringRef field) {
  std::vector<Record *> operands = instruction.getValueAsListOfDefs("operands");
  for (std::int64_t index : instruction.getValueAsListOfInts(field)) {
    if (index < 0 || index >= static_cast<std::int64_t>(operands.size())) {
      PrintError(&instruction, Twine(field) + " names operand " + Twine(index) + ", there are " + Twine(operands.size()));
      continue;
    }
    const Record &operand = *operands[index];
    StringRef direction = operand.getValueAsString("direction");
    if (field == "outputs" && direction == "In")
      PrintError(&instruction, "outputs name operand " + operand.getValueAsString("name") + ", which is only read");
    // A block that is written is an argument as well: the function fills it.
    StringRef type = enumerator(operand, "type");
    if (field == "inputs" && direction == "Out" && !type.ends_with("Block") && type != "BitRun")
      PrintError(&instruction, "inputs name operand " + operand.getValueAsString("name") + ", which is only written");
  }
}

// ---- instructions

void check_call(const FamilyRecords &family, const Record &instruction) {
  StringRef lowering = enumerator(instruction, "lowering"), style = enumerator(instruction, "style");
  std::int64_t code = instruction.getValueAsInt("errorCode");
  bool calls = lowering == "Call" || lowering == "CallWithResult" || lowering == "CompareContact";
  if (calls == (style == "None"))
    PrintError(&instruction, "lowering " + lowering + " and call style " + style + " do not go together");
  if (calls && instruction.getValueAsString("function").empty() && style != "Value")
    PrintError(&instruction, "call style " + style + " needs a function; only an assignment (Value) has none");
  if ((style == "Status" && code == 0) || (code != 0 && style != "Status" && style != "Memory"))
    PrintError(&instruction, style == "Status" ? "a Status call can fail and needs an errorCode"
                                               : "only a Status or Memory call has an errorCode");
  if (code != 0 && llvm::none_of(family.errors, [&](const Record *e) { return e->getValueAsInt("number") == code; }))
    PrintError(&instruction, "the family has no error code " + Twine(code));
  StringRef mask = instruction.getValueAsString("errorMask");
  if (!mask.empty() && llvm::none_of(family.specials, [&](const Record *s) { return s->getValueAsString("device") == mask; }))
    PrintError(&instruction, "errorMask '" + mask + "' is no special device of the family");
  if (instruction.getValueAsBit("stopsScan") && style != "System")
    PrintError(&instruction, "only a System call can stop the scan");
  check_indexes(instruction, "inputs");
  check_indexes(instruction, "outputs");
}

void check_edges(const Record &instruction) {
  StringRef lowering = enumerator(instruction, "lowering"), edge = enumerator(instruction, "edge");
  bool needs = lowering == "EdgeOfResult" || lowering == "EdgeRelay" || lowering == "PulseStore";
  if (needs && edge != "RisingEdge" && edge != "FallingEdge")
    PrintError(&instruction, "lowering " + lowering + " needs an edge, RisingEdge or FallingEdge");
}

void check_instruction(const FamilyRecords &family, const Record &instruction) {
  for (StringRef field : {"form", "mnemonic", "title", "description", "section", "example"})
    if (instruction.getValueAsString(field).empty())
      PrintError(&instruction, "the instruction has no " + field);
  std::vector<StringRef> models = family.family->getValueAsListOfStrings("models");
  for (StringRef model : instruction.getValueAsListOfStrings("models"))
    if (!llvm::is_contained(models, model))
      PrintError(&instruction, "'" + model + "' is no model of the family");
  for (const Record *operand : instruction.getValueAsListOfDefs("operands"))
    check_operand(family, instruction, *operand);
  std::int64_t steps = instruction.getValueAsInt("steps");
  if (steps < 1 || steps > 255)
    PrintError(&instruction, "an instruction has 1 to 255 steps");
  if (instruction.getValueAsBit("equalDigits") && instruction.getValueAsListOfDefs("operands").size() < 2)
    PrintError(&instruction, "equalDigits compares operands 0 and 1");
  check_call(family, instruction);
  check_edges(instruction);
}

bool share_a_device(const Record &a, const Record &b, StringRef field) {
  std::vector<Record *> other = b.getValueAsDef("classes")->getValueAsListOfDefs(field);
  return llvm::any_of(a.getValueAsDef("classes")->getValueAsListOfDefs(field),
                      [&](Record *d) { return llvm::is_contained(other, d); });
}

/// True where one operand as written can stand in both positions.
bool overlap(const Record &a, const Record &b) {
  const bool restricted = a.getValueAsInt("last") != 0 && b.getValueAsInt("last") != 0;
  if (restricted && (a.getValueAsInt("last") < b.getValueAsInt("first") || b.getValueAsInt("last") < a.getValueAsInt("first")))
    return false;
  if (llvm::any_of(llvm::ArrayRef<StringRef>{"devices", "wordBits", "digits"},
                   [&](StringRef f) { return share_a_device(a, b, f); }))
    return true;
  return (a.getValueAsBit("decimal") && b.getValueAsBit("decimal")) ||
         (a.getValueAsBit("hexadecimal") && b.getValueAsBit("hexadecimal"));
}

bool same_lines_fit(const Record &a, const Record &b) {
  std::vector<Record *> left = a.getValueAsListOfDefs("operands"), right = b.getValueAsListOfDefs("operands");
  if (left.size() != right.size())
    return false;
  for (auto [l, r] : llvm::zip(left, right))
    if (!overlap(*l, *r))
      return false;
  return true;
}

/// A list line must choose its entry: no two entries of one spelling may take the same operands.
void check_choices(const FamilyRecords &family) {
  llvm::StringMap<std::vector<const Record *>> by_spelling;
  for (const Record *instruction : family.instructions) {
    std::vector<StringRef> spellings = instruction->getValueAsListOfStrings("aliases");
    spellings.push_back(instruction->getValueAsString("spelling"));
    for (StringRef spelling : spellings) {
      std::vector<const Record *> &others = by_spelling[spelling];
      for (const Record *other : others)
        if (same_lines_fit(*instruction, *other))
          PrintError(instruction, "'" + spelling + "' is duplicated: '" + other->getValueAsString("form") +
                                      "' takes the same operands (record " + other->getName() + ")");
      others.push_back(instruction);
    }
  }
}

void check_specials_and_errors(const FamilyRecords &family) {
  llvm::StringSet<> devices;
  for (const Record *special : family.specials) {
    if (!devices.insert(special->getValueAsString("device")).second)
      PrintError(special, "'" + special->getValueAsString("device") + "' has two records");
    for (StringRef field : {"device", "name", "behaviour", "section"})
      if (special->getValueAsString(field).empty())
        PrintError(special, "the special device has no " + field);
  }
  const Record *last = nullptr;
  for (const Record *error : family.errors) {
    if (last && last->getValueAsInt("number") == error->getValueAsInt("number"))
      PrintError(error, "error code " + Twine(error->getValueAsInt("number")) + " has two records");
    if (error->getValueAsInt("number") < 1 || error->getValueAsInt("number") > 65535)
      PrintError(error, "an error code is 1 to 65535");
    last = error;
  }
}

}  // namespace

FamilyRecords read_family(llvm::RecordKeeper &records) {
  FamilyRecords family;
  std::vector<const Record *> families = in_file_order(records, "Family");
  if (families.size() != 1)
    PrintFatalError("a family file defines one Family, this one defines " + Twine(families.size()));
  family.family = families.front();
  for (const Record *device : family.family->getValueAsListOfDefs("devices")) {
    family.device_ids[device] = family.devices.size();
    family.devices.push_back(device);
  }
  family.instructions = in_file_order(records, "Instruction");
  family.specials = in_file_order(records, "Special");
  family.errors = in_file_order(records, "ErrorCode");
  llvm::stable_sort(family.errors,
                    [](const Record *a, const Record *b) { return a->getValueAsInt("number") < b->getValueAsInt("number"); });
  for (StringRef field : {"id", "title", "manual", "header", "ns"})
    if (family.family->getValueAsString(field).empty())
      PrintError(family.family, "the family has no " + field);
  if (family.family->getValueAsListOfStrings("models").empty())
    PrintError(family.family, "the family has no models");
  check_devices(family);
  for (const Record *instruction : family.instructions)
    check_instruction(family, *instruction);
  check_choices(family);
  check_specials_and_errors(family);
  return family;
}

}  // namespace ladderc::tblgen
