// ladderc instructions [--family F] [--json]
#include "driver/options.h"
#include "tables/tables.h"

#include "llvm/ADT/StringSet.h"
#include "llvm/Support/raw_ostream.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ladderc::driver {

namespace cl = llvm::cl;

static cl::opt<bool> kJson("json", cl::desc("As a JSON array"), cl::sub(kInstructions));

namespace {

std::string shape(const InstructionInfo &info) {
  std::string text = info.spelling.str();
  for (const OperandInfo &operand : info.operands)
    text += " " + operand.name.str();
  return text;
}

/// One object a form; its operand lists are in `shapes`.
nlohmann::ordered_json forms(const FamilyInfo &family) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const InstructionInfo &info : family.instructions) {
    nlohmann::ordered_json *row = nullptr;
    for (auto &known : rows)
      if (known["form"] == info.form.str())
        row = &known;
    if (!row) {
      row = &rows.emplace_back();
      (*row)["form"] = info.form.str();
      (*row)["mnemonic"] = info.mnemonic.str();
      (*row)["aliases"] = nlohmann::ordered_json::array();
      (*row)["family"] = family.id.str();
      (*row)["models"] = nlohmann::ordered_json::array();
      for (llvm::StringRef model : info.models.empty() ? family.models : info.models)
        (*row)["models"].push_back(model.str());
      (*row)["section"] = info.section.str();
      (*row)["title"] = info.title.str();
      (*row)["category"] = info.category.str();
      (*row)["steps"] = info.steps;
      (*row)["shapes"] = nlohmann::ordered_json::array();
    }
    for (llvm::StringRef alias : info.aliases)
      if (std::find((*row)["aliases"].begin(), (*row)["aliases"].end(), alias.str()) == (*row)["aliases"].end())
        (*row)["aliases"].push_back(alias.str());
    (*row)["shapes"].push_back(shape(info));
  }
  return rows;
}

}  // namespace

int run_instructions() {
  CommonOptions options;
  if (!read_common_options(options))
    return kExitUsage;
  const FamilyInfo *family = find_family(options.family);
  if (!family)
    return usage_error(fmt::format("unknown family '{}'", options.family));
  const nlohmann::ordered_json rows = forms(*family);
  if (kJson) {
    llvm::outs() << rows.dump(1) << "\n";
    return 0;
  }
  for (const auto &row : rows)
    for (const auto &text : row["shapes"])
      llvm::outs() << fmt::format("{:<24} {:<10} {}\n", text.get<std::string>(), row["section"].get<std::string>(),
                                  row["title"].get<std::string>());
  return 0;
}

}  // namespace ladderc::driver
