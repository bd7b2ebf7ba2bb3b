// Random rungs. An expression tree is made first and then written twice: as a list (LD, AND, OR, ANB, ORB, OUT) and as a C++ expression
// over byte arrays. Relays and outputs are read and written across rungs, so neither form can be folded by a compiler.
#include "contact_program.h"

#include "contact_tree.h"

#include <fmt/format.h>

#include <vector>

namespace ladderc::bench {

namespace {

std::unique_ptr<Node> contact(Random &random) {
  auto node = std::make_unique<Node>();
  node->closed = random.below(3) == 0;
  const std::uint32_t what = random.below(10);
  if (what < 4) {
    const std::uint32_t n = random.below(kInputs);
    node->list = fmt::format("X{:X}", n);
    node->cpp = fmt::format("X[{}]", n);
  } else if (what < 6) {
    const std::uint32_t n = random.below(kOutputs);
    node->list = fmt::format("Y{:X}", n);
    node->cpp = fmt::format("Y[{}]", n);
  } else {
    const std::uint32_t n = random.below(kRelays);
    node->list = fmt::format("M{}", n);
    node->cpp = fmt::format("M[{}]", n);
  }
  return node;
}

}  // namespace

ContactProgram make_contact_program(unsigned rungs, std::uint64_t seed) {
  Random random(seed);
  ContactProgram program;
  std::string functions;
  std::vector<bool> driven[2] = {std::vector<bool>(kRelays), std::vector<bool>(kOutputs)};
  for (unsigned i = 0; i < rungs; ++i) {
    if (i % 64 == 0) {
      functions += fmt::format("{}void Hand::rungs_{}() {{\n", i ? "}\n\n" : "", i / 64);
    }
    const auto root = random_tree(random, 2 + random.below(5), contact);
    // Every coil is driven once: no form can win by dropping double coils.
    bool output;
    std::uint32_t n;
    do {
      output = random.below(3) == 0;
      n = random.below(output ? kOutputs : kRelays);
    } while (driven[output][n]);
    driven[output][n] = true;
    program.instructions += write_list(*root, "LD", program.list);
    program.list += output ? fmt::format("OUT Y{:X}\n", n) : fmt::format("OUT M{}\n", n);
    ++program.instructions;
    functions += fmt::format("  {}[{}] = {};\n", output ? 'Y' : 'M', n, cpp_text(*root));
  }
  program.list += "END\n";
  ++program.instructions;
  program.hand_header = fmt::format("#pragma once\n#include <cstdint>\n\nstruct Hand {{\n  std::uint8_t X[{}] = {{}}, Y[{}] = {{}}, M[{}] = {{}};\n  void scan();\n",
                                    kInputs, kOutputs, kRelays);
  std::string calls;
  for (unsigned i = 0; i <= (rungs - 1) / 64; ++i) {
    program.hand_header += fmt::format("  void rungs_{}();\n", i);
    calls += fmt::format("  rungs_{}();\n", i);
  }
  program.hand_header += "};\n";
  program.hand_source = "#include \"hand.h\"\n\n" + functions + "}\n\nvoid Hand::scan() {\n" + calls + "}\n";
  return program;
}

}  // namespace ladderc::bench
