// Expressions as C++ reads them: printed with as few parentheses as the operators need, and never with too few.
#include "compiled.h"

#include "emit/program.h"

#include <gtest/gtest.h>

#include <random>

namespace ladderc::test {
namespace {

/// The statements of one rung without its comment.
std::string statements(llvm::StringRef rungs) {
  auto c = compile_rungs(rungs);
  std::string text = emit::emit_rungs(c->program, c->module, c->sources, {}), result;
  for (llvm::StringRef rest = text; !rest.empty();) {
    const auto [line, next] = rest.split('\n');
    rest = next;
    if (!line.starts_with("//") && !line.empty())
      result += line.str() + "\n";
  }
  return result;
}

TEST(Expression, ParenthesesStandWhereTheyAreNeeded) {
  EXPECT_EQ(statements("LD X0 / AND X1 / ANI X2 / OUT Y0"), "Y[0] = X[0] & X[1] & !X[2];\n");
  EXPECT_EQ(statements("LD X0 / OR X1 / ORI X2 / OUT Y0"), "Y[0] = X[0] | X[1] | !X[2];\n");
  EXPECT_EQ(statements("LD X0 / OR X1 / AND X2 / OUT Y0"), "Y[0] = (X[0] | X[1]) & X[2];\n");
  EXPECT_EQ(statements("LD X0 / AND X1 / OR X2 / OUT Y0"), "Y[0] = (X[0] & X[1]) | X[2];\n");
  EXPECT_EQ(statements("LD X0 / LD X1 / OR X2 / INV / ORB / OUT Y0"), "Y[0] = X[0] | !(X[1] | X[2]);\n");
  EXPECT_EQ(statements("LD X0 / INV / INV / OUT Y0"), "Y[0] = !!X[0];\n");
  EXPECT_EQ(statements("LDI X0 / LD X1 / ANI X2 / ANB / OUT Y0"), "Y[0] = (!X[0]) & X[1] & !X[2];\n");
  EXPECT_EQ(statements("LD X0 / RST Y0"), "Y[0] &= !X[0];\n");
  EXPECT_EQ(statements("LD X0 / OR X1 / RST Y0"), "Y[0] &= !(X[0] | X[1]);\n");
  EXPECT_EQ(statements("LD X0 / OR X1 / FF Y0"), "Y[0] ^= rising(edge[0], X[0] | X[1]);\n");
}

/// Reads the expression that was printed: | binds loosest, then &, then !. The reference for the differential below.
class Reader {
public:
  Reader(std::string text, unsigned inputs) : text_(std::move(text)), inputs_(inputs) {}
  bool run() {
    const bool value = alternatives();
    EXPECT_EQ(at_, text_.size()) << text_;
    return value;
  }

private:
  bool take(const std::string &token) {
    if (text_.compare(at_, token.size(), token) != 0)
      return false;
    at_ += token.size();
    return true;
  }
  bool alternatives() {
    bool value = product();
    while (take(" | "))
      value |= product();
    return value;
  }
  bool product() {
    bool value = factor();
    while (take(" & "))
      value &= factor();
    return value;
  }
  bool factor() {
    if (take("!"))
      return !factor();
    if (take("(")) {
      const bool value = alternatives();
      EXPECT_TRUE(take(")")) << text_;
      return value;
    }
    EXPECT_TRUE(take("X[")) << text_ << " at " << at_;
    const unsigned number = static_cast<unsigned>(text_[at_] - '0');
    at_ += 2;
    return (inputs_ >> number & 1) != 0;
  }
  std::string text_;
  unsigned inputs_;
  std::size_t at_ = 0;
};

std::string random_block(std::mt19937 &random, unsigned depth) {
  auto below = [&](unsigned n) { return std::uniform_int_distribution<unsigned>(0, n - 1)(random); };
  auto contact = [&] { return "X" + std::to_string(below(4)); };
  std::string text = std::string(below(2) ? "LD " : "LDI ") + contact();
  for (unsigned n = below(4) + 1; n > 0; --n) {
    static constexpr const char *kNext[] = {"AND ", "ANI ", "OR ", "ORI "};
    const unsigned kind = below(depth ? 7 : 5);
    text += kind < 4    ? std::string(" / ") + kNext[kind] + contact()
            : kind == 4 ? " / INV"
                        : " / " + random_block(random, depth - 1) + (kind == 5 ? " / ANB" : " / ORB");
  }
  return text;
}

/// The list's own meaning, on a stack.
bool meaning(llvm::StringRef rungs, unsigned inputs) {
  std::vector<bool> stack;
  llvm::SmallVector<llvm::StringRef> lines;
  rungs.split(lines, " / ");
  for (llvm::StringRef line : lines) {
    const auto [mnemonic, operand] = line.split(' ');
    const bool contact = !operand.empty() && (inputs >> (operand.back() - '0') & 1) != 0;
    if (mnemonic == "LD" || mnemonic == "LDI")
      stack.push_back(contact != (mnemonic == "LDI"));
    else if (mnemonic == "INV")
      stack.back() = !stack.back();
    else if (mnemonic == "ANB" || mnemonic == "ORB") {
      const bool second = stack.back();
      stack.pop_back();
      stack.back() = mnemonic == "ANB" ? stack.back() && second : stack.back() || second;
    } else if (mnemonic.starts_with("AN"))
      stack.back() = stack.back() && contact != (mnemonic == "ANI");
    else
      stack.back() = stack.back() || contact != (mnemonic == "ORI");
  }
  return stack.back();
}

TEST(Expression, MeansWhatTheListMeans) {
  std::mt19937 random(7);
  for (unsigned n = 0; n < 400 && !testing::Test::HasFailure(); ++n) {
    const std::string block = random_block(random, 2);
    std::string text = statements(block + " / OUT Y0");
    if (!llvm::StringRef(text).starts_with("Y[0] = "))
      continue;  // too long for one expression
    text = text.substr(7, text.size() - 9);
    for (std::size_t at = text.find("\n    "); at != std::string::npos; at = text.find("\n    "))
      text.replace(at, 5, " ");
    for (unsigned inputs = 0; inputs < 16; ++inputs)
      ASSERT_EQ(Reader(text, inputs).run(), meaning(block, inputs)) << block << "\n" << text;
  }
}

TEST(Expression, NamesOfLinesAreUniqueInAFunction) {
  // One instruction can leave two values: the region's state and the result.
  const std::string text = statements("LD X0 / AND X1 / MPS / MEP / MPS / AND X2 / OUT Y0 / MPP / OUT Y1 / MPP / OUT Y2");
  std::vector<std::string> names;
  for (std::size_t at = text.find("const bit "); at != std::string::npos; at = text.find("const bit ", at + 1))
    names.push_back(text.substr(at + 10, text.find(' ', at + 10) - at - 10));
  EXPECT_EQ(names, (std::vector<std::string>{"line_1", "line_3"}));
}

// Every operand is written once: a chain that were written twice at each contact would not end in this life.
TEST(Expression, AMonstrousRungIsCutIntoNamedParts) {
  for (const char *contact : {" / AND X", " / OR X", " / ANI X", " / ORI X"}) {
    std::string rungs = "LDI X0";
    for (unsigned i = 1; i < 2000; ++i)
      rungs += contact + std::to_string(i % 8);
    const std::string text = statements(rungs + " / OUT Y0");
    for (llvm::StringRef rest = text; !rest.empty();) {
      const auto [line, next] = rest.split('\n');
      rest = next;
      EXPECT_LE(line.size(), 120u);
    }
    EXPECT_GT(llvm::StringRef(text).count("const bit"), 30u) << contact;
  }
}

}  // namespace
}  // namespace ladderc::test
