// Random numbers and random trees of contacts, which the benchmarks write twice: as a list and as a C++ expression.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ladderc::bench {

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
  bool chance(std::uint32_t percent) { return below(100) < percent; }

private:
  std::uint64_t state_;
};

/// A block of contacts.
struct Node {
  char kind = 'c';        ///< 'c' contact, '&', '|'
  std::string list, cpp;  ///< of a contact: operands of the list, expression of the device
  std::string sign;       ///< of a contact: what follows LD, AND, OR, as `>` or `P`; such contacts are not closed
  bool closed = false;
  bool compound = false;  ///< of a contact: `cpp` needs parentheses between & and |
  std::vector<std::unique_ptr<Node>> children;
};

using MakeContact = std::function<std::unique_ptr<Node>(Random &)>;

/// Contacts in series and parallel, at random.
std::unique_ptr<Node> random_tree(Random &random, unsigned contacts, const MakeContact &make);

/// Writes the block; `head` is LD, or AND or OR for a contact alone. Returns how many instructions that were.
unsigned write_list(const Node &node, const char *head, std::string &out);

/// The block as a C++ expression with & and |.
std::string cpp_text(const Node &node);

}  // namespace ladderc::bench
