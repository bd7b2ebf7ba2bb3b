// ladderc-bench-mixed: the scan of generated C++ against hand-written C++ of the same TP03 program of contacts, timers, counters
// and words.
//
// Both are compiled by the same compiler with the same flags in this run, in as many files and functions each, linked into one
// program, compared in every scan of a check, and measured in turns. Prints the mix, ns per scan and per instruction, and the
// ratio.
#include "commands.h"
#include "mixed_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace fs = std::filesystem;
using namespace ladderc::bench;

namespace {

/// Files that hold functions of the generated program.
unsigned generated_files(const fs::path &folder) {
  unsigned count = 0;
  for (const auto &entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    count +=
        name.rfind("mixed", 0) == 0 && name.size() > 4 && name.substr(name.size() - 4) == ".cpp" && name != "mixed.symbols.cpp";
  }
  return count;
}

/// The functions in as many files of equal size as the generated program has.
void write_hand(const fs::path &folder, const MixedProgram &program, unsigned files) {
  write(
      folder / "hand_sizes.h",
      fmt::format("#pragma once\nconstexpr unsigned kHandRelays = {}, kHandRegisters = 1000, kHandEdges = {}, kHandPulses = {};\n",
                  program.relays, std::max(program.places_of_edges, 1U), std::max(program.places_of_pulses, 1U)));
  std::string declarations, calls;
  std::vector<std::string> texts(files, "#include \"mixed_plain.h\"\n");
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    declarations += fmt::format("  void rungs_{}();\n", i);
    calls += fmt::format("  rungs_{}();\n", i);
    texts[i * files / program.functions.size()] += "\n" + program.functions[i];
  }
  texts[0] += "\nvoid Hand::scan(std::uint32_t now) {\n"
              "  elapsed = timed ? now - last_now : 0;\n  last_now = now;\n  timed = true;\n" +
              calls + "}\n";
  write(folder / "hand_functions.h", declarations);
  for (std::size_t i = 0; i < texts.size(); ++i)
    write(folder / fmt::format("hand_{}.cpp", i), texts[i]);
}

/// Numbers of a harness by their names.
std::map<std::string, double> results(const fs::path &file) {
  std::map<std::string, double> found;
  std::ifstream stream(file);
  std::string name;
  for (double value; stream >> name >> value;)
    found[name] = value;
  return found;
}

/// Runs the harness in several copies, because a file keeps the pages that it has in memory, and pages can be unlucky for the
/// caches. Prints the fastest turns of all copies.
bool measure(const fs::path &folder, const std::string &rounds, unsigned instructions) {
  constexpr int kCopies = 6;
  const std::string in = "cd '" + folder.string() + "' && ";
  double generated = 0, hand = 0;
  for (int copy = 0; copy < kCopies; ++copy) {
    fs::copy_file(folder / "harness", folder / "copy", fs::copy_options::overwrite_existing);
    const int code = run(in + "./copy " + rounds + " > result.txt");
    auto found = results(folder / "result.txt");
    if (code) {
      run(in + "cat result.txt");
      return false;
    }
    generated = copy ? std::min(generated, found["generated_min_ns"]) : found["generated_min_ns"];
    hand = copy ? std::min(hand, found["hand_min_ns"]) : found["hand_min_ns"];
    if (copy == 0)
      fmt::print("checked_scans {}\nscans_with_error {}\n", found["checked_scans"], found["scans_with_error"]);
    fmt::print("ratio_of_copy_{} {:.4f}\n", copy + 1, found["ratio_of_minimums"]);
    fs::remove(folder / "copy");
  }
  fmt::print("generated_min_ns {:.1f}\nhand_min_ns {:.1f}\nratio_of_minimums {:.4f}\n", generated, hand, generated / hand);
  fmt::print("generated_ns_per_instruction {:.4f}\nhand_ns_per_instruction {:.4f}\n", generated / instructions,
             hand / instructions);
  return true;
}

}  // namespace

int main(int argc, char **argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: %s LADDERC RUNTIME_INCLUDE FOLDER [INSTRUCTIONS] [SEED] [ROUNDS]\n", argv[0]);
    return 2;
  }
  const std::string ladderc = argv[1], include = argv[2], parts = LADDERC_BENCH_PARTS;
  const fs::path folder = fs::absolute(argv[3]);
  const unsigned instructions = argc > 4 ? static_cast<unsigned>(std::atoi(argv[4])) : 10000;
  const std::uint64_t seed = argc > 5 ? std::strtoull(argv[5], nullptr, 10) : 20;
  const std::string rounds = argc > 6 ? argv[6] : "400";
  fs::remove_all(folder);  // files of another size must not be compiled
  fs::create_directories(folder);
  const MixedProgram program = make_mixed_program(instructions, seed);
  const Mix &mix = program.mix;
  write(folder / "mixed.il", program.list);
  fmt::print("instructions {}\ncontacts {}\ntimers_and_counters {}\nwords {}\nrungs {}\n", mix.all(), mix.contacts, mix.timing,
             mix.words, program.rungs);

  const std::string in = "cd '" + folder.string() + "' && ";
  if (run(in + "'" + ladderc + "' emit --family tp03 -O2 mixed.il -o . > emit.txt 2>&1")) {
    run(in + "cat emit.txt");
    return 1;
  }
  write_hand(folder, program, generated_files(folder));
  if (run(in + compiler() + " -std=c++20 -O2 -fno-exceptions -fno-rtti -I'" + include + "' -I. -I'" + parts +
          "' mixed*.cpp hand_*.cpp '" + parts + "/mixed_harness.cpp' -o harness"))
    return 1;
  return measure(folder, rounds, mix.all()) ? 0 : 1;
}
