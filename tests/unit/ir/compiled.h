// A list compiled as far as IR, for tests.
#pragma once

#include "ir/ir.h"
#include "sema/check.h"

#include <memory>
#include <string>
#include <vector>

namespace ladderc::test {

struct Compiled {
  SourceSet sources;
  std::unique_ptr<Diagnostics> diagnostics;
  CheckedProgram program;
  ir::Module module;

  std::string ir() const;
};

/// Compiles the list; errors fail the test, warnings do not count. `parameters` is JSON.
std::unique_ptr<Compiled> compile(std::string list, llvm::StringRef parameters = "{}", std::string name = "test.il");
/// The same for lines joined by `/`, without END: "LD X0 / OUT Y0".
std::unique_ptr<Compiled> compile_rungs(llvm::StringRef rungs, llvm::StringRef parameters = "{}");
/// True where the list has no errors.
bool is_correct(const std::string &list);

/// The module of that text: the lines of `main`, or a whole module. Errors fail the test.
ir::Module parse_module(llvm::StringRef text);
std::string print(const ir::Module &module);

/// Lists of the tables' examples and of the files of the repository that have no errors: name and text.
std::vector<std::pair<std::string, std::string>> known_lists();

}  // namespace ladderc::test
