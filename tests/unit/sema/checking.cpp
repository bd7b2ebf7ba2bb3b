// Compiles a list as far as sema and shows its messages in one line each.
#include "checking.h"

#include "syntax/parser.h"

#include "fmt/format.h"

namespace ladderc::test {

std::vector<std::string> Checked::messages() const {
  std::vector<std::string> result;
  for (const Diagnostic &d : diagnostics->sorted()) {
    LineColumn place = sources.position(d.range);
    result.push_back(fmt::format("{}:{} {}", place.line, place.column, info(d.id).id.str()));
  }
  return result;
}

std::vector<std::string> Checked::texts() const {
  std::vector<std::string> result;
  for (const Diagnostic &d : diagnostics->sorted())
    result.push_back(d.message);
  return result;
}

std::unique_ptr<Checked> check_text(std::string list, llvm::StringRef json, Controller controller) {
  auto checked = std::make_unique<Checked>();
  const FamilyInfo &family = *find_family(controller.family);
  const llvm::StringRef model = controller.model.empty() ? family.models.front() : controller.model;
  unsigned file = checked->sources.add("test.il", std::move(list));
  checked->diagnostics = std::make_unique<Diagnostics>(checked->sources);
  Parameters parameters = default_parameters(family, model);
  if (auto problem = read_parameters(json, family, parameters))
    ADD_FAILURE() << *problem;
  ListProgram program = parse_list(family, checked->sources, file, ListFormat::Auto, *checked->diagnostics);
  checked->program = check(std::move(program), model, std::move(parameters), *checked->diagnostics);
  return checked;
}

std::vector<std::string> messages_of(std::string lines, llvm::StringRef parameters, Controller controller) {
  return check_text(std::move(lines) + "\nEND\n", parameters, controller)->messages();
}

}  // namespace ladderc::test
