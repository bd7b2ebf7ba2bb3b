// Trees of contacts: made at random, written as lists and as C++.
#include "contact_tree.h"

#include <fmt/format.h>

namespace ladderc::bench {

namespace {

std::string contact_text(const Node &contact, const std::string &head) {
  if (!contact.sign.empty())
    return fmt::format("{}{} {}\n", head, contact.sign, contact.list);
  if (!contact.closed)
    return fmt::format("{} {}\n", head, contact.list);
  return fmt::format("{} {}\n", head == "AND" ? "ANI" : head + "I", contact.list);
}

}  // namespace

std::unique_ptr<Node> random_tree(Random &random, unsigned contacts, const MakeContact &make) {
  if (contacts == 1)
    return make(random);
  auto node = std::make_unique<Node>();
  node->kind = random.below(2) ? '&' : '|';
  const unsigned left = 1 + random.below(contacts - 1);
  node->children.push_back(random_tree(random, left, make));
  node->children.push_back(random_tree(random, contacts - left, make));
  return node;
}

unsigned write_list(const Node &node, const char *head, std::string &out) {
  if (node.kind == 'c') {
    out += contact_text(node, head);
    return 1;
  }
  unsigned count = write_list(*node.children[0], head, out);
  for (std::size_t i = 1; i < node.children.size(); ++i) {
    const Node &child = *node.children[i];
    if (child.kind == 'c') {
      count += write_list(child, node.kind == '&' ? "AND" : "OR", out);
    } else {
      count += write_list(child, "LD", out) + 1;
      out += node.kind == '&' ? "ANB\n" : "ORB\n";
    }
  }
  return count;
}

std::string cpp_text(const Node &node) {
  if (node.kind == 'c')
    return (node.closed ? "!" : "") + node.cpp;
  std::string text;
  for (const auto &child : node.children) {
    // Compilers warn of `!a & b`, which with numbers would often be a mistake.
    const bool bare = child->kind == 'c' ? !child->compound && !(child->closed && text.empty()) : child->kind == node.kind;
    text += (text.empty() ? "" : fmt::format(" {} ", node.kind)) + (bare ? cpp_text(*child) : "(" + cpp_text(*child) + ")");
  }
  return text;
}

}  // namespace ladderc::bench
