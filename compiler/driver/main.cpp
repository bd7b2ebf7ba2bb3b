// ladderc: mnemonic lists of industrial controllers to C++ and native code.
#include "driver/options.h"
#include "opt/pipeline.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/Support/InitLLVM.h"
#include "llvm/Support/raw_ostream.h"

#include <string>
#include <vector>

using namespace ladderc::driver;

namespace {

const char *const kOverview = "ladderc: mnemonic lists of industrial controllers to C++ and native code\n\n"
                              "  ladderc check press.il                        what is wrong or suspicious\n"
                              "  ladderc run press.il --set X0=1 --watch Y0    compile and run\n"
                              "  ladderc build press.il -o press               a native program\n"
                              "  ladderc emit press.il -o out                  the C++ for your own build\n"
                              "  ladderc test press.json                       run scenarios\n"
                              "  ladderc SUBCOMMAND --help                     the options of one subcommand\n";

struct Command {
  llvm::cl::SubCommand *subcommand;
  int (*run)();
};

const Command kCommands[] = {
    {&kBuild, run_build},
    {&kEmit, run_emit},
    {&kCheck, run_check},
    {&kRun, [] { return run_run(g_argv0); }},
    {&kTest, [] { return run_test(g_argv0); }},
    {&kBench, [] { return run_bench(g_argv0); }},
    {&kInstructions, run_instructions},
    {&kExplain, run_explain},
    {&kGenerate, run_generate},
};

/// --no-PASS is a spelling of --no-pass=PASS for every row of the pipeline.
std::vector<std::string> with_pass_switches(int argc, char **argv) {
  std::vector<std::string> arguments(argv, argv + argc);
  for (std::string &argument : arguments)
    for (const ladderc::opt::Pass &pass : ladderc::opt::passes())
      if (argument == "--no-" + pass.name.str() || argument == "-no-" + pass.name.str())
        argument = "--no-pass=" + pass.name.str();
  return arguments;
}

}  // namespace

int main(int argc, char **argv) {
  const llvm::InitLLVM init(argc, argv);
  g_argv0 = argv[0];
  const std::vector<std::string> arguments = with_pass_switches(argc, argv);
  std::vector<const char *> pointers = {"ladderc"};  // not argv[0]: messages do not depend on the path
  for (const std::string &argument : llvm::ArrayRef(arguments).drop_front())
    pointers.push_back(argument.c_str());
  llvm::cl::SetVersionPrinter([](llvm::raw_ostream &out) { out << "ladderc 0.1.0\n"; });
  if (!llvm::cl::ParseCommandLineOptions(static_cast<int>(pointers.size()), pointers.data(), kOverview, &llvm::errs()))
    return kExitUsage;
  for (const Command &command : kCommands)
    if (*command.subcommand)
      return command.run();
  llvm::outs() << kOverview;
  return argc > 1 ? kExitUsage : 0;
}
