// -gen-family: the records of one family as constant arrays.
//
// Everything is constexpr, so that the tables cost nothing at start-up and live in read-only memory. Lists that many records share
// (operands, models, times) are written once and named by their number.
#include "actions.h"
#include "family.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/Support/FormatVariadic.h"

#include <algorithm>
#include <string>

namespace ladderc::tblgen {
namespace {

using llvm::raw_ostream;

std::string flag(bool value) {
  return value ? "true" : "false";
}

/// Writes array definitions as they are asked for; the same text is written once.
class Arrays {
public:
  explicit Arrays(raw_ostream &out) : out_(out) {}

  /// The name of an array with these elements, or `{}` where there are none.
  std::string add(StringRef type, llvm::ArrayRef<std::string> elements) {
    if (elements.empty())
      return "{}";
    std::string text = llvm::join(elements, ", ");
    std::string &name = names_[(type + "|" + text).str()];
    if (name.empty()) {
      name = "kList" + std::to_string(names_.size());
      out_ << "constexpr " << type << " " << name << "[] = {" << text << "};\n";
    }
    return name;
  }

  std::string strings(const std::vector<StringRef> &texts) {
    std::vector<std::string> elements;
    for (StringRef text : texts)
      elements.push_back(quoted(text));
    return add("llvm::StringRef", elements);
  }

private:
  raw_ostream &out_;
  llvm::StringMap<std::string> names_;
};

std::string device_set(const FamilyRecords &family, const Record &classes, StringRef field) {
  std::uint64_t mask = 0;
  for (const Record *device : classes.getValueAsListOfDefs(field))
    if (auto id = family.device_ids.find(device); id != family.device_ids.end())
      mask |= std::uint64_t(1) << (id->second & 63);
  return "0x" + llvm::utohexstr(mask) + "u";
}

/// Constants outside of int's range get the suffix that keeps the compiler quiet.
std::string number(std::int64_t value) {
  return std::to_string(value) + (value > 2147483647LL || value < -2147483647LL ? "LL" : "");
}

std::string operand_text(const FamilyRecords &family, const Record &operand) {
  const Record &classes = *operand.getValueAsDef("classes");
  ConstantRange range = constant_range(operand);
  std::string text;
  llvm::raw_string_ostream out(text);
  out << "{" << quoted(operand.getValueAsString("name")) << ", Direction::" << operand.getValueAsString("direction")
      << ", OperandType::" << enumerator(operand, "type") << ", " << device_set(family, classes, "devices") << ", "
      << device_set(family, classes, "wordBits") << ", " << device_set(family, classes, "digits") << ", "
      << flag(operand.getValueAsBit("decimal")) << ", " << flag(operand.getValueAsBit("hexadecimal")) << ", " << number(range.min)
      << ", " << number(range.max) << ", " << quoted(operand.getValueAsString("note")) << ", "
      << flag(operand.getValueAsBit("indexable")) << ", " << operand.getValueAsInt("first") << ", " << operand.getValueAsInt("last")
      << ", " << operand.getValueAsInt("count") << "}";
  return text;
}

std::string operand_array(const FamilyRecords &family, const Record &instruction, Arrays &arrays) {
  std::vector<std::string> elements;
  for (const Record *operand : instruction.getValueAsListOfDefs("operands"))
    elements.push_back(operand_text(family, *operand));
  return arrays.add("OperandInfo", elements);
}

std::string index_array(const Record &instruction, StringRef field, Arrays &arrays) {
  std::vector<std::string> elements;
  for (std::int64_t index : instruction.getValueAsListOfInts(field))
    elements.push_back(std::to_string(index));
  return arrays.add("std::uint8_t", elements);
}

std::string time_array(const Record &instruction, Arrays &arrays) {
  std::vector<std::string> elements;
  for (const Record *time : instruction.getValueAsListOfDefs("times"))
    elements.push_back("{" + quoted(time->getValueAsString("condition")) + ", " + quoted(time->getValueAsString("device")) + ", " +
                       std::to_string(time->getValueAsInt("nanoseconds")) + "}");
  return arrays.add("TimeInfo", elements);
}

std::string instruction_text(const FamilyRecords &family, const Record &r, Arrays &arrays) {
  auto text = [&](StringRef field) { return quoted(r.getValueAsString(field)); };
  auto bit = [&](StringRef field) { return flag(r.getValueAsBit(field)); };
  auto integer = [&](StringRef field) { return std::to_string(r.getValueAsInt(field)); };
  std::string result;
  llvm::raw_string_ostream out(result);
  out << "{" << text("form") << ", " << text("spelling") << ", " << arrays.strings(r.getValueAsListOfStrings("aliases")) << ", "
      << text("mnemonic") << ", " << text("title") << ", " << text("description") << ", " << text("category") << ", "
      << text("section") << ", " << text("example") << ", " << arrays.strings(r.getValueAsListOfStrings("models")) << ", "
      << operand_array(family, r, arrays) << ", Execution::" << enumerator(r, "execution")
      << ", Placement::" << enumerator(r, "placement") << ", Lowering::" << enumerator(r, "lowering") << ", " << bit("negated")
      << ", " << bit("drives") << ", Execution::" << enumerator(r, "edge") << ", CallStyle::" << enumerator(r, "style") << ", "
      << text("function") << ", " << index_array(r, "inputs", arrays) << ", " << index_array(r, "outputs", arrays) << ", "
      << bit("stopsScan") << ", " << integer("errorCode") << ", " << text("errorMask") << ", "
      << quoted(llvm::join(r.getValueAsListOfStrings("errors"), "\n")) << ", " << integer("steps") << ", "
      << integer("stepsPerConstant") << ", " << integer("stepsSubset") << ", " << (r.getValueAsBit("equalDigits") ? "1" : "0")
      << ", " << time_array(r, arrays) << ", " << integer("number") << ", " << bit("wide") << ", " << bit("passesSystem") << ", "
      << integer("maxUses") << ", Lowering::" << enumerator(r, "transferOutside") << ", "
      << arrays.strings(r.getValueAsListOfStrings("images")) << "}";
  return result;
}

std::string numbers_array(const Record &r, StringRef field, Arrays &arrays) {
  std::vector<std::string> elements;
  for (const Record *entry : r.getValueAsListOfDefs(field))
    elements.push_back("{" + quoted(entry->getValueAsString("model")) + ", " + std::to_string(entry->getValueAsInt("first")) +
                       ", " + std::to_string(entry->getValueAsInt("last")) + "}");
  return arrays.add("ModelNumbers", elements);
}

std::string device_text(const FamilyRecords &family, const Record &r, Arrays &arrays) {
  std::vector<std::string> points;
  for (const Record *entry : r.getValueAsListOfDefs("modelPoints"))
    points.push_back("{" + quoted(entry->getValueAsString("model")) + ", " + std::to_string(entry->getValueAsInt("points")) + "}");
  std::string model_points = arrays.add("ModelPoints", points);
  std::string missing = numbers_array(r, "missing", arrays), latched = numbers_array(r, "latched", arrays);
  std::string exclusive = numbers_array(r, "exclusive", arrays);
  std::vector<std::string> uses;
  for (const Record *entry : r.getValueAsListOfDefs("terminals"))
    uses.push_back(llvm::formatv("{{{0}, {1}, {2}}", entry->getValueAsInt("first"), entry->getValueAsInt("last"),
                                 entry->getValueAsInt("inputs")));
  std::string terminals = arrays.add("TerminalUse", uses);
  std::string high = "kNoDevice";
  for (const auto &[id, device] : llvm::enumerate(family.devices))
    if (!r.getValueAsString("highWords").empty() && device->getValueAsString("prefix") == r.getValueAsString("highWords"))
      high = std::to_string(id);
  std::string result;
  llvm::raw_string_ostream out(result);
  out << "{" << quoted(r.getValueAsString("prefix")) << ", " << quoted(r.getValueAsString("title"))
      << ", DeviceKind::" << enumerator(r, "kind") << ", " << r.getValueAsInt("radix") << ", " << r.getValueAsInt("points") << ", "
      << model_points << ", " << flag(r.getValueAsBit("bitOfWord")) << ", " << flag(r.getValueAsBit("externalInput")) << ", "
      << flag(r.getValueAsBit("externalOutput")) << ", " << r.getValueAsInt("memoryOrder") << ", "
      << quoted(r.getValueAsString("image")) << ", " << r.getValueAsInt("pointsRegister") << ", "
      << quoted(r.getValueAsString("behaviour")) << ", " << quoted(r.getValueAsString("section")) << ", "
      << quoted(r.getValueAsString("container")) << ", " << quoted(r.getValueAsString("beginHook")) << ", "
      << quoted(r.getValueAsString("endHook")) << ", " << flag(r.getValueAsBit("survivesStop")) << ", "
      << r.getValueAsInt("watched") << ", " << r.getValueAsInt("first") << ", "
      << r.getValueAsInt("nameDigits") << ", " << high << ", " << missing << ", " << latched << ", " << exclusive << ", " << terminals
      << "}";
  return result;
}

std::string special_text(const Record &r) {
  return "{" + quoted(r.getValueAsString("device")) + ", " + quoted(r.getValueAsString("name")) + ", " +
         quoted(r.getValueAsString("behaviour")) + ", " + flag(r.getValueAsBit("writable")) + ", " +
         flag(r.getValueAsBit("simulated")) + ", " + quoted(r.getValueAsString("section")) + ", " +
         std::to_string(r.getValueAsInt("constant")) + "}";
}

std::string error_text(const Record &r) {
  return "{" + std::to_string(r.getValueAsInt("number")) + ", " + quoted(r.getValueAsString("name")) + ", " +
         quoted(r.getValueAsString("cause")) + ", " + quoted(r.getValueAsString("action")) + ", " + flag(r.getValueAsBit("stops")) +
         ", " + quoted(r.getValueAsString("section")) + "}";
}

/// The records of one kind; `{}` stands for the array where there are none.
template <typename Text>
std::string emit_array(raw_ostream &out, StringRef type, StringRef name, const std::vector<const Record *> &records, Text text) {
  if (records.empty())
    return "{}";
  std::vector<std::string> rows;
  for (const Record *record : records)
    rows.push_back(text(*record));
  out << "constexpr " << type << " " << name << "[] = {\n";
  for (const std::string &row : rows)
    out << "    " << row << ",\n";
  out << "};\n";
  return name.str();
}

}  // namespace

void emit_family(llvm::RecordKeeper &records, raw_ostream &out) {
  FamilyRecords family = read_family(records);
  const Record &r = *family.family;
  auto integer = [&](StringRef field) { return std::to_string(r.getValueAsInt(field)); };
  std::string tables = family.id().str() + "_tables";
  std::replace(tables.begin(), tables.end(), '-', '_');
  out << "// Written by ladder-tblgen from grammar/" << family.id() << ".td. Included by compiler/tables/tables.cpp.\n"
      << "namespace ladderc::" << tables << " {\n\n";
  Arrays arrays(out);
  std::string models = arrays.strings(r.getValueAsListOfStrings("models"));
  std::string devices =
      emit_array(out, "DeviceInfo", "kDevices", family.devices, [&](const Record &d) { return device_text(family, d, arrays); });
  std::string instructions = emit_array(out, "InstructionInfo", "kInstructions", family.instructions,
                                        [&](const Record &i) { return instruction_text(family, i, arrays); });
  std::string specials = emit_array(out, "SpecialInfo", "kSpecials", family.specials, special_text);
  std::string errors = emit_array(out, "ErrorInfo", "kErrors", family.errors, error_text);
  out << "constexpr FamilyInfo kFamily = {\n    " << quoted(family.id()) << ", " << quoted(r.getValueAsString("title")) << ", "
      << quoted(r.getValueAsString("manual")) << ", " << quoted(r.getValueAsString("header")) << ", "
      << quoted(r.getValueAsString("ns")) << ", " << models << ", " << integer("maxBranches") << ", " << integer("maxLevels")
      << ", " << flag(r.getValueAsBit("hasIndexRegisters")) << ", " << flag(r.getValueAsBit("pairsCrossClasses")) << ",\n    "
      << devices << ", " << instructions << ", " << specials << ", " << errors << ", " << integer("endNs") << ", "
      << integer("ioRefreshNs") << ", " << integer("ioRefreshPointNs") << ", " << integer("notExecutedStepNs") << ",\n    "
      << quoted(r.getValueAsString("ops")) << ", " << flag(r.getValueAsBit("errorsStop")) << ", "
      << flag(r.getValueAsBit("firstScanPulses")) << ", " << flag(r.getValueAsBit("clearsOnStop")) << ", "
      << flag(r.getValueAsBit("spacedOperands")) << ", " << integer("warnedBranches") << ", " << integer("maxLoops") << ", "
      << integer("maxCalls") << ", " << integer("maxMerge") << ", " << integer("endLabel") << ", "
      << quoted(r.getValueAsString("base")) << ", " << integer("warnedMerge")
      << "};\n\n}  // namespace ladderc::" << tables << "\n";
}

}  // namespace ladderc::tblgen
