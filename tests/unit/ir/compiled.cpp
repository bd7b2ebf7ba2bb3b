// A list compiled as far as IR, for tests.
#include "compiled.h"

#include "lower/lower.h"
#include "source/decode.h"
#include "syntax/parser.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Path.h"

#include <gtest/gtest.h>

namespace ladderc::test {

static std::unique_ptr<Compiled> check_list(std::string list, llvm::StringRef json, std::string name) {
  auto c = std::make_unique<Compiled>();
  const FamilyInfo &family = *find_family("melsec-qs");
  const unsigned file = c->sources.add(std::move(name), std::move(list));
  c->diagnostics = std::make_unique<Diagnostics>(c->sources);
  Parameters parameters = default_parameters(family, family.models.front());
  if (const auto problem = read_parameters(json, family, parameters))
    ADD_FAILURE() << *problem;
  ListProgram program = parse_list(family, c->sources, file, ListFormat::Auto, *c->diagnostics);
  c->program = check(std::move(program), family.models.front(), std::move(parameters), *c->diagnostics);
  return c;
}

std::string Compiled::ir() const {
  std::string text;
  llvm::raw_string_ostream out(text);
  ir::print(module, sources, out);
  return text;
}

std::unique_ptr<Compiled> compile(std::string list, llvm::StringRef parameters, std::string name) {
  auto c = check_list(list, parameters, std::move(name));
  if (!c->program.ok) {
    std::string messages;
    llvm::raw_string_ostream out(messages);
    print_text(*c->diagnostics, "melsec-qs", out);
    ADD_FAILURE() << list << messages;
    return c;
  }
  c->module = lower(c->program);
  return c;
}

std::unique_ptr<Compiled> compile_rungs(llvm::StringRef rungs, llvm::StringRef parameters) {
  std::string list;
  llvm::SmallVector<llvm::StringRef> lines;
  rungs.split(lines, " / ");
  for (llvm::StringRef line : lines)
    list += line.trim().str() + "\n";
  return compile(list + "END\n", parameters);
}

bool is_correct(const std::string &list) {
  return check_list(list, R"({"ST_points": 64})", "test.il")->program.ok;
}

ir::Module parse_module(llvm::StringRef text) {
  ir::Module module;
  module.family = find_family("melsec-qs");
  std::string error;
  const std::string whole = text.contains("routine") ? text.str() : "routine main {\nrung 0\n" + text.str() + "\n}\n";
  if (!ir::parse(whole, module, error))
    ADD_FAILURE() << error << "\n" << whole;
  if (const std::string problem = ir::verify(module); !problem.empty())
    ADD_FAILURE() << problem << "\n" << whole;
  return module;
}

std::string print(const ir::Module &module) {
  std::string text;
  llvm::raw_string_ostream out(text);
  ir::print(module, SourceSet(), out);
  return text;
}

std::vector<std::pair<std::string, std::string>> known_lists() {
  std::vector<std::pair<std::string, std::string>> lists;
  // compile() is for MELSEC QS; lists of other families are not correct there and drop out below, too.
  for (const InstructionInfo &info : find_family("melsec-qs")->instructions)
    lists.emplace_back(info.form.str(), info.example.str());
  std::error_code ec;
  for (const char *folder : {"/samples", "/tests"})
    for (llvm::sys::fs::recursive_directory_iterator it(std::string(LADDERC_SOURCE_DIR) + folder, ec), end; it != end && !ec;
         it.increment(ec)) {
      if (llvm::sys::path::extension(it->path()) != ".il")
        continue;
      auto file = llvm::MemoryBuffer::getFile(it->path());
      if (!file)
        continue;
      std::string text = decode((*file)->getBuffer()).text;
      if (is_correct(text))
        lists.emplace_back(it->path(), std::move(text));
    }
  return lists;
}

}  // namespace ladderc::test
