// Random IR with so few bits that all of their states can be tried.
#include "random_ir.h"

#include "compiled.h"

#include <random>

namespace ladderc::test {

namespace {

class Maker {
public:
  explicit Maker(unsigned seed) : random_(seed) {}

  std::string module(unsigned operations) {
    std::string text = "edges 1, 2\nroutine main {\n";
    for (unsigned rungs = below(3) + 1; rungs > 0; --rungs) {
      text += "rung 0\n";
      values_ = 0;
      text += load();
      for (unsigned n = below(operations) + 1; n > 0; --n)
        text += operation();
    }
    return text + "}\n";
  }

private:
  unsigned below(unsigned n) { return std::uniform_int_distribution<unsigned>(0, n - 1)(random_); }
  template <std::size_t N> std::string one_of(const char *const (&words)[N]) { return words[below(N)]; }
  std::string value() { return "%" + std::to_string(below(values_)); }
  std::string result() { return "%" + std::to_string(values_++) + " = "; }

  std::string load() {
    static constexpr const char *kContacts[] = {"X0", "X1", "X2", "M0", "M1", "M2", "M3", "SM400", "SM401"};
    return result() + "load " + one_of(kContacts) + "\n";
  }
  std::string logic() {
    static constexpr const char *kTwo[] = {"and", "andn", "or", "orn", "xor"};
    const std::string a = value(), b = value();
    if (below(6) == 0)
      return result() + "not " + a + "\n";
    return result() + one_of(kTwo) + " " + a + ", " + b + "\n";
  }
  std::string edge() {
    static constexpr const char *kEdges[] = {"rising", "falling"};
    static constexpr const char *kMemories[] = {"edge0", "edge1", "V0"};
    const std::string a = value();
    return result() + one_of(kEdges) + " " + one_of(kMemories) + ", " + a + "\n";
  }
  std::string effect() {
    static constexpr const char *kCoils[] = {"M0", "M1", "M2", "M3"};
    switch (below(9)) {
    case 0:
    case 1:
    case 2:
      return "store " + one_of(kCoils) + ", " + value() + "\n";
    case 3:
      return "set " + one_of(kCoils) + " if " + value() + "\n";
    case 4:
      return "reset " + one_of(kCoils) + " if " + value() + "\n";
    case 5:
      return "call MOV if " + value() + " (" + std::to_string(below(16)) + ") -> (K1M0)\n";
    case 6:
      return "call MOV if " + value() + " (K1M0) -> (D0)\n";
    case 7:
      return "call BIN if " + value() + " (D0) -> (D1) at 5\n";
    default:
      return "run \"OUT T\" with " + value() + " (50) -> (T0)\n";
    }
  }
  std::string operation() {
    switch (below(10)) {
    case 0:
    case 1:
      return load();
    case 2:
      return result() + "const " + std::to_string(below(2)) + "\n";
    case 3:
      return edge();
    case 4:
    case 5:
    case 6:
      return effect();
    default:
      return logic();
    }
  }

  std::mt19937 random_;
  unsigned values_ = 0;
};

}  // namespace

const std::vector<std::string> &random_cells() {
  static const std::vector<std::string> cells = {"X0", "X1", "X2", "M0", "M1", "M2", "M3", "V0", "edge0", "edge1"};
  return cells;
}

ir::Module random_module(unsigned seed, unsigned operations) {
  return parse_module(Maker(seed).module(operations));
}

}  // namespace ladderc::test
