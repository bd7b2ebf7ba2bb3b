// Measures reading and parsing of a million lines, or of the files that are named. Not a test: times depend on the machine.
//
//   ninja -C build syntax_timing && build/bin/syntax_timing [FILE...]
#include "syntax/parser.h"

#include "llvm/Support/MemoryBuffer.h"

#include <chrono>
#include <random>

namespace {

using namespace ladderc;

std::string million_lines() {
  static constexpr const char *kLines[] = {"LD X{}",       "OR M{}",   "ANI T{}",       "OUT Y{}",       "LD= K{} D{}",
                                           "OUT T{} K100", "LD D{}.A", "+ D{} K{} D{}", "MOV K4X{} D{}", "MPS ; note {}"};
  std::mt19937 random(1);
  std::string text;
  for (unsigned i = 0; i < 1'000'000; ++i) {
    llvm::StringRef line = kLines[i % std::size(kLines)];
    while (!line.empty()) {
      auto [plain, rest] = line.split("{}");
      text.append(plain.data(), plain.size());
      if (plain.size() != line.size())
        text += std::to_string(random() % 1000);
      line = rest;
    }
    text += '\n';
  }
  return text + "END\n";
}

void measure(llvm::StringRef name, const std::string &bytes) {
  auto start = std::chrono::steady_clock::now();
  auto lap = [&](const char *what) {
    const auto now = std::chrono::steady_clock::now();
    llvm::outs() << "  " << what << ' ' << std::chrono::duration_cast<std::chrono::milliseconds>(now - start).count() << " ms\n";
    start = now;
  };
  llvm::outs() << name << '\n';
  Decoded decoded = decode(bytes);
  lap("decode");
  SourceSet sources;
  const unsigned file = sources.add(name.str(), std::move(decoded.text));
  lap("find lines");
  Diagnostics diagnostics(sources);
  const ListProgram program = parse_list(families().front(), sources, file, ListFormat::Auto, diagnostics);
  lap("read and parse");
  llvm::outs() << "  " << program.instructions.size() << " instructions, " << program.operands.size() << " operands, "
               << diagnostics.errors() << " errors\n";
}

}  // namespace

int main(int argc, char **argv) {
  if (argc == 1)
    measure("a million lines", million_lines());
  for (int i = 1; i < argc; ++i) {
    auto file = llvm::MemoryBuffer::getFile(argv[i]);
    if (!file) {
      llvm::errs() << argv[i] << ": " << file.getError().message() << '\n';
      return 1;
    }
    measure(argv[i], (*file)->getBuffer().str());
  }
  return 0;
}
