// -gen-docs: the instruction reference of one family, docs/instructions/<family>.md.
//
// An index by category comes first, then a section per mnemonic that gathers all its forms, then devices, special devices and error
// codes. Forms with the same operands share a table. The order is that of the records.
#include "actions.h"
#include "family.h"

#include "llvm/ADT/APInt.h"
#include "llvm/ADT/MapVector.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringMap.h"

namespace ladderc::tblgen {
namespace {

using llvm::raw_ostream;
using Records = std::vector<const Record *>;
using Groups = llvm::MapVector<StringRef, Records>;

/// Text that Markdown must take literally.
std::string markdown(StringRef text) {
  std::string result;
  for (char c : text) {
    if (StringRef("*_<>|").contains(c))
      result += '\\';
    result += c;
  }
  return result;
}

Groups group_by(const Records &records, StringRef field) {
  Groups groups;
  for (const Record *record : records)
    groups[record->getValueAsString(field)].push_back(record);
  return groups;
}

std::string code(StringRef text) {
  return ("`" + text + "`").str();
}

// ---- one instruction

StringRef execution_text(const Record &r) {
  return llvm::StringMap<StringRef>{{"EveryScan", "in every scan"},
                                    {"WhileOn", "while the condition is ON"},
                                    {"RisingEdge", "when the condition turns ON"},
                                    {"FallingEdge", "when the condition turns OFF"}}
      .lookup(enumerator(r, "execution"));
}

StringRef direction_text(const Record &operand) {
  return llvm::StringMap<StringRef>{{"In", "read"}, {"Out", "written"}, {"InOut", "read and written"}}.lookup(
      operand.getValueAsString("direction"));
}

struct TypeText {
  StringRef name;
  StringRef digits;  ///< how many may stand there
};

TypeText type_text(const Record &operand) {
  return llvm::StringMap<TypeText>{{"Bit", {"bit", ""}},
                                   {"Word", {"16 bits", "K1-K4"}},
                                   {"DWord", {"32 bits", "K1-K8"}},
                                   {"QWord", {"64 bits", "K1-K8"}},
                                   {"WordTwice", {"two 16-bit words", "K1-K4"}},
                                   {"DWordTwice", {"two 32-bit pairs", "K1-K8"}},
                                   {"WordBlock", {"n words", "K1-K4"}},
                                   {"Timer", {"timer", ""}},
                                   {"Counter", {"counter", ""}},
                                   {"Annunciator", {"annunciator", ""}},
                                   {"Level", {"level", ""}},
                                   {"Number", {"number", ""}},
                                   {"Label", {"label", ""}}}
      .lookup(enumerator(operand, "type"));
}

std::string places_text(const FamilyRecords &family, const Record &operand) {
  const Record &classes = *operand.getValueAsDef("classes");
  std::vector<std::string> parts;
  if (auto plain = family.prefixes(classes, "devices"); !plain.empty())
    parts.push_back(llvm::join(plain, " "));
  if (auto words = family.prefixes(classes, "wordBits"); !words.empty())
    parts.push_back("bits of " + llvm::join(words, " "));
  if (auto bits = family.prefixes(classes, "digits"); !bits.empty())
    parts.push_back(type_text(operand).digits.str() + " digits of " + llvm::join(bits, " "));
  return llvm::join(parts, "; ");
}

std::string constants_text(const Record &operand) {
  bool decimal = operand.getValueAsBit("decimal"), hexadecimal = operand.getValueAsBit("hexadecimal");
  bool level = enumerator(operand, "type") == "Level";
  if (!decimal && !hexadecimal && !level)
    return "";
  ConstantRange range = constant_range(operand);
  std::string kinds = level ? "" : decimal && hexadecimal ? "K, H: " : decimal ? "K: " : "H: ";
  return kinds + std::to_string(range.min) + " to " + std::to_string(range.max);
}

std::string steps_text(const Record &r) {
  std::string text = std::to_string(r.getValueAsInt("steps"));
  if (std::int64_t subset = r.getValueAsInt("stepsSubset"))
    text = std::to_string(subset) + " or " + text;
  if (std::int64_t more = r.getValueAsInt("stepsPerConstant"))
    text += ", +" + std::to_string(more) + " for each constant";
  return text;
}

/// "`+ S D`": the form's spelling with its operands' names.
std::string shape(const Record &r) {
  std::string text = r.getValueAsString("spelling").str();
  for (const Record *operand : r.getValueAsListOfDefs("operands"))
    text += (" " + operand->getValueAsString("name")).str();
  return text;
}

/// What tells an entry from the others of its mnemonic: the shape, or the form, or the form and what its first operand is.
std::string label(const Record &r, const Records &entries) {
  auto only = [&](auto text) { return llvm::count_if(entries, [&](const Record *other) { return text(*other) == text(r); }) == 1; };
  if (only(shape))
    return code(shape(r));
  auto form = [](const Record &entry) { return entry.getValueAsString("form").str(); };
  if (only(form))
    return code(form(r));
  std::vector<Record *> operands = r.getValueAsListOfDefs("operands");
  return code(form(r)) + (operands.empty() ? "" : " (" + type_text(*operands.front()).name.str() + ")");
}

void print_forms(const Records &entries, raw_ostream &out) {
  out << "| form | written | executed | steps |\n| --- | --- | --- | --- |\n";
  for (const Record *r : entries) {
    std::string name = label(*r, entries);
    out << "| " << (name == code(shape(*r)) ? code(r->getValueAsString("form")) : name) << " | " << code(shape(*r));
    for (StringRef alias : r->getValueAsListOfStrings("aliases"))
      out << ", also " << code(alias);
    out << " | " << execution_text(*r) << " | " << steps_text(*r) << " |\n";
  }
  out << "\n";
}

bool same_operands(const Record &a, const Record &b) {
  auto key = [](const Record &operand) {
    return std::make_tuple(operand.getValueAsString("name"), operand.getValueAsString("direction"), operand.getValueAsDef("type"),
                           operand.getValueAsDef("classes"), operand.getValueAsBit("decimal"), operand.getValueAsBit("hexadecimal"),
                           operand.getValueAsInt("min"), operand.getValueAsInt("max"));
  };
  return llvm::equal(a.getValueAsListOfDefs("operands"), b.getValueAsListOfDefs("operands"),
                     [&](const Record *l, const Record *r) { return key(*l) == key(*r); });
}

void print_operands(const FamilyRecords &family, const Record &r, raw_ostream &out) {
  out << "| operand | | type | devices | constants | |\n| --- | --- | --- | --- | --- | --- |\n";
  for (const Record *operand : r.getValueAsListOfDefs("operands"))
    out << "| " << operand->getValueAsString("name") << " | " << direction_text(*operand) << " | " << type_text(*operand).name
        << " | " << places_text(family, *operand) << " | " << constants_text(*operand) << " | "
        << markdown(operand->getValueAsString("note")) << " |\n";
  out << "\n";
}

/// Entries that take the same operands, with the table once and the first one's example.
void print_operand_lists(const FamilyRecords &family, const Records &entries, raw_ostream &out) {
  std::vector<Records> lists;
  for (const Record *r : entries) {
    auto found = llvm::find_if(lists, [&](const Records &list) { return same_operands(*list.front(), *r); });
    if (found == lists.end())
      lists.push_back({r});
    else
      found->push_back(r);
  }
  for (const Records &list : lists) {
    if (!list.front()->getValueAsListOfDefs("operands").empty()) {
      if (lists.size() > 1) {
        std::vector<std::string> labels;
        for (const Record *r : list)
          labels.push_back(label(*r, entries));
        out << llvm::join(labels, ", ") << ":\n\n";
      }
      print_operands(family, *list.front(), out);
    }
    out << "```\n" << list.front()->getValueAsString("example") << "\n```\n\n";
  }
}

void print_errors(const Records &entries, raw_ostream &out) {
  std::vector<StringRef> errors;
  for (const Record *r : entries)
    for (StringRef error : r->getValueAsListOfStrings("errors"))
      if (!llvm::is_contained(errors, error))
        errors.push_back(error);
  for (StringRef error : errors)
    out << "* error " << markdown(error) << "\n";
  if (!errors.empty())
    out << "\n";
}

std::string microseconds(std::int64_t nanoseconds) {
  std::string text = std::to_string(nanoseconds / 1000);
  if (std::int64_t rest = nanoseconds % 1000) {
    std::string decimals = std::to_string(1000 + rest).substr(1);
    text += "." + StringRef(decimals).rtrim('0').str();
  }
  return text;
}

/// One line a form: its times with what they depend on.
void print_times(const Records &entries, raw_ostream &out) {
  llvm::MapVector<StringRef, std::vector<std::string>> by_time;  // text of the times -> labels
  std::vector<std::string> texts(entries.size());
  for (auto [r, text] : llvm::zip(entries, texts)) {
    std::vector<std::string> parts;
    for (const Record *time : r->getValueAsListOfDefs("times")) {
      StringRef condition = time->getValueAsString("condition"), device = time->getValueAsString("device");
      std::string part = microseconds(time->getValueAsInt("nanoseconds")) + " us";
      if (!device.empty())
        part += " with " + markdown(device);
      if (!condition.empty())
        part += " (" + markdown(condition) + ")";
      parts.push_back(part);
    }
    text = llvm::join(parts, ", ");
    if (!text.empty())
      by_time[text].push_back(label(*r, entries));
  }
  for (const auto &[text, labels] : by_time)
    out << "* " << (by_time.size() > 1 ? llvm::join(labels, ", ") + ": " : std::string()) << text << "\n";
  if (!by_time.empty())
    out << "\n";
}

void print_instruction(const FamilyRecords &family, StringRef mnemonic, const Records &entries, raw_ostream &out) {
  const Record &first = *entries.front();
  out << "<a id=\"" << first.getName() << "\"></a>\n\n### " << code(mnemonic) << " " << first.getValueAsString("title") << "\n\n"
      << markdown(first.getValueAsString("description")) << "\n\nManual section " << first.getValueAsString("section") << ".";
  if (std::vector<StringRef> models = first.getValueAsListOfStrings("models"); !models.empty())
    out << " Only " << llvm::join(models, ", ") << ".";
  out << "\n\n";
  print_forms(entries, out);
  print_operand_lists(family, entries, out);
  print_errors(entries, out);
  print_times(entries, out);
}

// ---- the page

void print_index(const Groups &by_category, raw_ostream &out) {
  out << "## Index\n\n| category | instructions |\n| --- | --- |\n";
  for (const auto &[category, records] : by_category) {
    std::vector<std::string> links;
    for (const auto &[mnemonic, entries] : group_by(records, "mnemonic"))
      links.push_back(("[" + code(mnemonic) + "](#" + entries.front()->getName() + ")").str());
    out << "| " << category << " | " << llvm::join(links, " ") << " |\n";
  }
  out << "\n";
}

/// Numbers as they are written in lists: "X0-X17FF".
std::string number_range(const Record &device) {
  std::int64_t points = device.getValueAsInt("points");
  unsigned radix = device.getValueAsInt("radix");
  if (points == 0)
    return "none";
  std::string last = llvm::toString(llvm::APInt(64, points - 1), radix, /*Signed=*/false);
  StringRef prefix = device.getValueAsString("prefix");
  return (prefix + "0-" + prefix + last).str();
}

void print_devices(const FamilyRecords &family, raw_ostream &out) {
  out << "## Devices\n\nCounts are defaults; the parameters change them.\n\n| device | | numbers | count | |\n| --- | --- | --- | "
         "--- | --- "
         "|\n";
  for (const Record *device : family.devices) {
    StringRef radix = llvm::StringMap<StringRef>{{"16", "hexadecimal"}, {"10", "decimal"}, {"8", "octal"}}.lookup(
        std::to_string(device->getValueAsInt("radix")));
    out << "| " << device->getValueAsString("prefix") << " | " << device->getValueAsString("title") << ", " << radix << " | "
        << number_range(*device) << " | " << device->getValueAsInt("points") << " | "
        << markdown(device->getValueAsString("behaviour"))
        << (device->getValueAsBit("bitOfWord") ? " Bits are written " + code(device->getValueAsString("prefix").str() + "0.5") + "."
                                               : "")
        << " |\n";
  }
  out << "\n";
}

void print_specials(const FamilyRecords &family, raw_ostream &out) {
  out << "## Special devices\n\nThe runtime keeps those marked *kept*; the others are memory that a host may fill. The program "
         "writes those "
         "marked *rw*.\n\n| device | | | section | |\n| --- | --- | --- | --- | --- |\n";
  for (const Record *r : family.specials)
    out << "| " << r->getValueAsString("device") << " | " << markdown(r->getValueAsString("name")) << " | "
        << (r->getValueAsBit("writable") ? "rw" : "r") << (r->getValueAsBit("simulated") ? ", kept" : "") << " | "
        << r->getValueAsString("section") << " | " << markdown(r->getValueAsString("behaviour")) << " |\n";
  out << "\n";
}

void print_error_codes(const FamilyRecords &family, raw_ostream &out) {
  out << "## Error codes\n\n| code | | CPU | section | cause | what to do |\n| --- | --- | --- | --- | --- | --- |\n";
  for (const Record *r : family.errors)
    out << "| " << r->getValueAsInt("number") << " | " << markdown(r->getValueAsString("name")) << " | "
        << (r->getValueAsBit("stops") ? "stops" : "goes on") << " | " << r->getValueAsString("section") << " | "
        << markdown(r->getValueAsString("cause")) << " | " << markdown(r->getValueAsString("action")) << " |\n";
}

}  // namespace

void emit_family_docs(llvm::RecordKeeper &records, raw_ostream &out) {
  FamilyRecords family = read_family(records);
  Groups by_category = group_by(family.instructions, "category");
  out << "# " << family.family->getValueAsString("title") << ": instructions\n\n"
      << "Made from `grammar/" << family.id() << ".td`; do not edit.\n\n"
      << "Sections are those of the " << family.family->getValueAsString("manual")
      << " manual.";
  if (const std::int64_t step = family.family->getValueAsInt("notExecutedStepNs"); step != 0)
    out << " Times are guide values of the real controller; a word instruction whose condition is OFF takes " << microseconds(step)
        << " us for each step and one more. Steps \"2 or 3\": 2 where every operand is a constant, a word device or K4 digits from a "
           "multiple of 16.";
  out << "\n\n";
  print_index(by_category, out);
  for (const auto &[category, in_category] : by_category) {
    out << "## " << category << "\n\n";
    for (const auto &[mnemonic, entries] : group_by(in_category, "mnemonic"))
      print_instruction(family, mnemonic, entries, out);
  }
  print_devices(family, out);
  print_specials(family, out);
  print_error_codes(family, out);
}

}  // namespace ladderc::tblgen
