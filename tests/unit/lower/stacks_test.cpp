// The symbolic stack machine against the real one: random lists, every state of their bits, the same bits afterwards; and once more
// after all passes, and as the emitter prints them.
#include "compiled.h"
#include "list_machine.h"
#include "machine.h"

#include "opt/pipeline.h"

#include <gtest/gtest.h>

#include <random>

namespace ladderc::test {
namespace {

const std::vector<std::string> kCells = {"X0", "X1", "X2", "M0", "M1", "M2", "V0", "edge0", "edge1"};

class ListMaker {
public:
  explicit ListMaker(unsigned seed) : random_(seed) {}

  std::string list() {
    std::string text;
    for (unsigned n = below(2) + 1; n > 0; --n) {
      if (below(3) == 0)
        text += block(1) + "MC N0 M10\n" + block(1) +
                (below(2) ? outputs(1) + "MCR N0\n" : "MC N1 M11\n" + block(1) + outputs(1) + "MCR N0\n");
      text += block(2) + outputs(2);
    }
    return text + "END\n";
  }

private:
  unsigned below(unsigned n) { return std::uniform_int_distribution<unsigned>(0, n - 1)(random_); }
  template <std::size_t N> std::string one_of(const char *const (&words)[N]) { return words[below(N)]; }
  std::string contact() {
    static constexpr const char *kDevices[] = {"X0", "X1", "X2", "M0", "M1", "M2"};
    return one_of(kDevices) + "\n";
  }
  std::string block(unsigned depth) {
    static constexpr const char *kFirst[] = {"LD ", "LDI ", "LD ", "LDP "};
    std::string text = one_of(kFirst) + contact();
    for (unsigned n = below(3); n > 0; --n)
      text += more(depth);
    return text;
  }
  std::string more(unsigned depth) {
    static constexpr const char *kNext[] = {"AND ", "ANI ", "OR ", "ORI ", "ANDP ", "ORF "};
    switch (below(depth == 0 ? 6 : 9)) {
    case 0:
      return "INV\n";
    case 1:
      return below(3) ? "MEP\n" : "MEF\n";
    case 6:
    case 7:
      return block(depth - 1) + "ANB\n";
    case 8:
      return block(depth - 1) + "ORB\n";
    default:
      return one_of(kNext) + contact();
    }
  }
  std::string output() {
    static constexpr const char *kOutputs[] = {"OUT M0\n", "OUT M1\n", "SET M2\n", "RST M0\n", "PLS M1\n", "PLF M2\n", "FF M0\n"};
    return one_of(kOutputs);
  }
  std::string outputs(unsigned depth) {
    if (depth == 0)
      return output();
    switch (below(4)) {
    case 0:
      return output();
    case 1:
      return output() + "AND " + contact() + outputs(depth - 1);
    default: {
      std::string text = "MPS\n" + more(0) + outputs(depth - 1);
      for (unsigned n = below(2); n > 0; --n)
        text += "MRD\n" + more(depth - 1) + outputs(depth - 1);
      return text + "MPP\n" + (below(2) ? more(0) : "") + outputs(depth - 1);
    }
    }
  }

  std::mt19937 random_;
};

/// The cells that a host can see, and the edges.
Cells without_master(Cells cells) {
  std::erase_if(cells, [](const auto &entry) { return entry.first.starts_with("master") || entry.first.starts_with("SM"); });
  return cells;
}

TEST(Stacks, RandomListsDoInIrWhatTheyDoOnTheStacks) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    const std::string list = ListMaker(seed).list();
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + list);
    auto c = compile(list);
    if (testing::Test::HasFailure())
      return;
    ir::Module optimized = c->module;
    opt::Context context;
    ASSERT_EQ(opt::run(optimized, {}, context), "");
    for_each_state(kCells, [&](const Cells &cells) {
      if (testing::Test::HasFailure())
        return;
      const Cells wanted = run_list(c->program, cells);
      EXPECT_EQ(without_master(run_scan(c->module, cells).cells), wanted);
      EXPECT_EQ(without_master(run_scan(optimized, cells, Way::RightFirst).cells), wanted) << print(optimized);
    });
    if (testing::Test::HasFailure())
      return;
  }
}

}  // namespace
}  // namespace ladderc::test
