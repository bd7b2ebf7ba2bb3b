// Random rungs. An expression tree is made first and then written twice: as a list (LD, AND, OR, ANB, ORB, OUT) and as a C++ expression
// over byte arrays. Relays and outputs are read and written across rungs, so neither form can be folded by a compiler.
#include "contact_program.h"

#include <fmt/format.h>

#include <memory>
#include <vector>

namespace ladderc::bench {

namespace {

/// SplitMix64: small, the same on every machine.
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint32_t below(std::uint32_t limit) {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<std::uint32_t>((z ^ (z >> 31)) % limit);
  }

private:
  std::uint64_t state_;
};

struct Node {
  char kind;  ///< 'c' contact, '&', '|'
  std::string list, cpp;
  bool closed = false;
  std::vector<std::unique_ptr<Node>> children;
};

std::unique_ptr<Node> contact(Random &random) {
  auto node = std::make_unique<Node>();
  node->kind = 'c';
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

std::unique_ptr<Node> tree(Random &random, unsigned contacts) {
  if (contacts == 1)
    return contact(random);
  auto node = std::make_unique<Node>();
  node->kind = random.below(2) ? '&' : '|';
  const unsigned left = 1 + random.below(contacts - 1);
  node->children.push_back(tree(random, left));
  node->children.push_back(tree(random, contacts - left));
  return node;
}

/// Writes the block that `node` is; `head` is LD, AND or OR for its first contact.
void write_list(const Node &node, const char *head, std::string &out, unsigned &count) {
  auto line = [&](const std::string &text) {
    out += text + "\n";
    ++count;
  };
  if (node.kind == 'c')
    return line(fmt::format("{}{} {}", head, node.closed ? (head[0] == 'L' ? "I" : head[0] == 'A' ? "" : "I") : "", node.list));
  write_list(*node.children[0], "LD", out, count);
  for (std::size_t i = 1; i < node.children.size(); ++i) {
    const Node &child = *node.children[i];
    if (child.kind == 'c') {
      const char *name = node.kind == '&' ? (child.closed ? "ANI" : "AND") : (child.closed ? "ORI" : "OR");
      line(fmt::format("{} {}", name, child.list));
    } else {
      write_list(child, "LD", out, count);
      line(node.kind == '&' ? "ANB" : "ORB");
    }
  }
}

std::string cpp(const Node &node) {
  if (node.kind == 'c')
    return (node.closed ? "!" : "") + node.cpp;
  std::string text;
  for (const auto &child : node.children) {
    const bool bare = child->kind == 'c' || child->kind == node.kind;
    text += (text.empty() ? "" : fmt::format(" {} ", node.kind)) + (bare ? cpp(*child) : "(" + cpp(*child) + ")");
  }
  return text;
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
    const auto root = tree(random, 2 + random.below(5));
    // Every coil is driven once: no form can win by dropping double coils.
    bool output;
    std::uint32_t n;
    do {
      output = random.below(3) == 0;
      n = random.below(output ? kOutputs : kRelays);
    } while (driven[output][n]);
    driven[output][n] = true;
    write_list(*root, "LD", program.list, program.instructions);
    program.list += output ? fmt::format("OUT Y{:X}\n", n) : fmt::format("OUT M{}\n", n);
    ++program.instructions;
    functions += fmt::format("  {}[{}] = {};\n", output ? 'Y' : 'M', n, cpp(*root));
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
