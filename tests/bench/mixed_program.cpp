// Random rungs of a plant program: coils, timers, counters, and words under conditions. Each is written twice as it is made, as
// list and as C++ over the arrays of mixed_plain.h.
//
// The C++ is what a good hand would write: what is ON always is not asked for, P forms of one rung share an edge, an instruction
// that cannot fail has no check.
#include "mixed_program.h"

#include "contact_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace ladderc::bench {

namespace {

constexpr unsigned kTerminals = 256, kCoilRelays = 1024, kSetRelays = 128, kOrderRelays = 1152;  // M1152 on: results of comparisons
constexpr unsigned kRegisters = 900, kDivisors = 900, kSetValues = 950, kSettings = 50;          // D0-D899, D900-D949, D950-D999
constexpr unsigned kRungsPerFunction = 64;                                                       // as ladderc cuts
constexpr unsigned kLongest = 24;                                                                // instructions of a rung

struct Text {
  std::string list, cpp;
};

Text constant(std::uint32_t value) {
  return {fmt::format("K{}", value), fmt::format("{}", value)};
}
Text reg(std::uint32_t number) {
  return {fmt::format("D{}", number), fmt::format("d[{}]", number)};
}

/// Numbers in random order, each handed out once.
class Pool {
public:
  Pool(Random &random, std::vector<unsigned> numbers) : numbers_(std::move(numbers)) {
    for (std::size_t i = numbers_.size(); i > 1; --i)
      std::swap(numbers_[i - 1], numbers_[random.below(static_cast<std::uint32_t>(i))]);
  }
  bool empty() const { return numbers_.empty(); }
  unsigned take() {
    const unsigned number = numbers_.back();
    numbers_.pop_back();
    return number;
  }

private:
  std::vector<unsigned> numbers_;
};

std::vector<unsigned> range(unsigned first, unsigned last) {
  std::vector<unsigned> numbers(last - first + 1);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

/// Timers that only count where they are executed: not those for routines and those in the background.
std::vector<unsigned> timers() {
  std::vector<unsigned> numbers = range(0, 511);
  numbers.erase(
      std::remove_if(numbers.begin(), numbers.end(), [](unsigned n) { return (n >= 192 && n <= 199) || (n >= 246 && n <= 249); }),
      numbers.end());
  return numbers;
}

class Maker {
public:
  Maker(unsigned instructions, std::uint64_t seed)
      : instructions_(instructions), random_(seed), relays_(random_, range(0, kCoilRelays - 1)),
        outputs_(random_, range(0, kTerminals - 1)), timers_(random_, timers()), counters_(random_, range(0, 199)),
        long_counters_(random_, range(200, 234)), resets_(random_, timers()) {}

  MixedProgram make();

private:
  std::unique_ptr<Node> contact(unsigned edges, unsigned comparisons);
  std::unique_ptr<Node> comparison();
  std::unique_ptr<Node> tree(unsigned contacts, unsigned edges, unsigned comparisons);
  void condition(const Node &node);

  void begin_rung();
  void line(const std::string &text) { program_.list += text + "\n"; }
  void statement(const std::string &text) { function_ += "  " + text + "\n"; }

  Text coil();
  Text set_value(unsigned most);
  Text source();
  void coil_rung();
  void branch_rung();
  void timer_rung();
  void counter_rung(bool is_long);
  void reset_timer_rung();
  void timing_rung();
  void word_rung();
  std::string word_instruction(const char *form);
  std::string compare_instruction(const char *form);
  std::string pair_instruction(const char *form, std::uint32_t what);
  void last_rungs();

  unsigned instructions_;
  Random random_;
  Pool relays_, outputs_, timers_, counters_, long_counters_, resets_;
  unsigned places_that_fail_ = 0, order_relay_ = kOrderRelays;
  std::string function_;
  MixedProgram program_;
};

// ---- contacts

std::unique_ptr<Node> Maker::comparison() {
  static constexpr std::array<std::array<const char *, 2>, 6> kSigns = {
      {{"=", "=="}, {">", ">"}, {"<", "<"}, {"<>", "!="}, {"<=", "<="}, {">=", ">="}}};
  auto node = std::make_unique<Node>();
  const auto sign = kSigns[random_.below(6)];
  const Text a = reg(random_.below(kRegisters)), b = source();
  node->sign = sign[0];
  node->list = a.list + " " + b.list;
  node->cpp = fmt::format("{} {} {}", a.cpp, sign[1], b.cpp);
  node->compound = true;
  return node;
}

/// Of 100 contacts, `edges` see edges, and `comparisons` are comparisons.
std::unique_ptr<Node> Maker::contact(unsigned edges, unsigned comparisons) {
  if (random_.chance(comparisons))
    return comparison();
  auto node = std::make_unique<Node>();
  const std::uint32_t what = random_.below(100);
  if (what < 40) {
    const std::uint32_t n = random_.below(kTerminals);
    node->list = fmt::format("X{:o}", n);
    node->cpp = fmt::format("x[{}]", n);
  } else if (what < 53) {
    const std::uint32_t n = random_.below(kTerminals);
    node->list = fmt::format("Y{:o}", n);
    node->cpp = fmt::format("y[{}]", n);
  } else if (what < 90) {
    const std::uint32_t n = random_.below(order_relay_);
    node->list = fmt::format("M{}", n);
    node->cpp = fmt::format("m[{}]", n);
  } else if (what < 96) {
    const std::uint32_t n = random_.below(512);
    node->list = fmt::format("T{}", n);
    node->cpp = fmt::format("t[{}].contact", n);
  } else {
    const std::uint32_t n = random_.below(235);
    node->list = fmt::format("C{}", n);
    node->cpp = n < 200 ? fmt::format("c[{}].contact", n) : fmt::format("c32[{}].contact", n - 200);
  }
  if (random_.chance(edges)) {
    const bool rising = random_.chance(75);
    node->sign = rising ? "P" : "F";
    node->cpp = fmt::format("{}(edge[{}], {})", rising ? "rising" : "falling", program_.places_of_edges++, node->cpp);
  } else {
    node->closed = random_.below(3) == 0;
  }
  return node;
}

std::unique_ptr<Node> Maker::tree(unsigned contacts, unsigned edges, unsigned comparisons) {
  return random_tree(random_, contacts, [&](Random &) { return contact(edges, comparisons); });
}

unsigned comparisons_in(const Node &node) {
  unsigned count = node.kind == 'c' && !node.sign.empty() && node.sign != "P" && node.sign != "F" ? 1 : 0;
  for (const auto &child : node.children)
    count += comparisons_in(*child);
  return count;
}

/// Writes the block into the list.
void Maker::condition(const Node &node) {
  const unsigned all = write_list(node, "LD", program_.list), comparisons = comparisons_in(node);
  program_.mix.contacts += all - comparisons;
  program_.mix.words += comparisons;
}

// ---- coils

/// A coil that is driven nowhere else: no form can win by dropping double coils.
Text Maker::coil() {
  ++program_.mix.contacts;
  if (relays_.empty() || (!outputs_.empty() && random_.below(4) == 0)) {
    const unsigned n = outputs_.take();
    return {fmt::format("Y{:o}", n), fmt::format("y[{}]", n)};
  }
  const unsigned n = relays_.take();
  return {fmt::format("M{}", n), fmt::format("m[{}]", n)};
}

void Maker::coil_rung() {
  const std::uint32_t what = random_.below(100);
  if (what < 8)
    return branch_rung();
  begin_rung();
  const auto root = tree(2 + random_.below(4), 4, 2);
  condition(*root);
  if (what < 20) {
    const bool set = random_.below(2) == 0;
    const unsigned n = kCoilRelays + random_.below(kSetRelays);
    ++program_.mix.contacts;
    line(fmt::format("{} M{}", set ? "SET" : "RST", n));
    return statement(set ? fmt::format("m[{}] |= {};", n, cpp_text(*root)) : fmt::format("m[{}] &= !({});", n, cpp_text(*root)));
  }
  const Text target = coil();
  if (what < 24) {
    line("PLS " + target.list);
    return statement(fmt::format("{} = rising(edge[{}], {});", target.cpp, program_.places_of_edges++, cpp_text(*root)));
  }
  line("OUT " + target.list);
  statement(fmt::format("{} = {};", target.cpp, cpp_text(*root)));
}

/// MPS: two or three coils, each behind one more contact.
void Maker::branch_rung() {
  begin_rung();
  const auto root = tree(2 + random_.below(2), 0, 0);
  condition(*root);
  statement("{");
  statement(fmt::format("  const Bit line = {};", cpp_text(*root)));
  const unsigned branches = 2 + random_.below(2);
  for (unsigned i = 0; i < branches; ++i) {
    line(i == 0 ? "MPS" : i + 1 < branches ? "MRD" : "MPP");
    const auto more = contact(0, 0);
    program_.mix.contacts += 1 + write_list(*more, "AND", program_.list);
    const Text target = coil();
    line("OUT " + target.list);
    statement(fmt::format("  {} = line & {};", target.cpp, cpp_text(*more)));
  }
  statement("}");
}

// ---- timers and counters

/// A constant, or sometimes a register with a setting.
Text Maker::set_value(unsigned most) {
  return random_.chance(20) ? reg(kSetValues + random_.below(kSettings)) : constant(1 + random_.below(most));
}

void Maker::timer_rung() {
  begin_rung();
  const unsigned n = timers_.take();
  auto root = tree(1 + random_.below(3), 0, 4);
  if (random_.chance(15)) {  // an oscillator
    auto both = std::make_unique<Node>(), own = std::make_unique<Node>();
    own->list = fmt::format("T{}", n);
    own->cpp = fmt::format("t[{}].contact", n);
    own->closed = true;
    both->kind = '&';
    both->children.push_back(std::move(root));
    both->children.push_back(std::move(own));
    root = std::move(both);
  }
  condition(*root);
  const Text set = set_value(n < 200 ? 50 : n < 256 ? 500 : 5000);
  ++program_.mix.timing;
  line(fmt::format("OUT T{} {}", n, set.list));
  statement(fmt::format("t[{}].{}({}, {}, elapsed);", n,
                        n < 200    ? "on_delay<100000>"
                        : n < 246  ? "on_delay<10000>"
                        : n >= 256 ? "on_delay<1000>"
                                   : "measure<100000>",
                        cpp_text(*root), set.cpp));
}

void Maker::counter_rung(bool is_long) {
  begin_rung();
  const unsigned n = is_long ? long_counters_.take() : counters_.take();
  const std::string object = is_long ? fmt::format("c32[{}]", n - 200) : fmt::format("c[{}]", n);
  const auto counted = tree(1 + random_.below(2), 0, 0);
  condition(*counted);
  const Text set = is_long ? constant(1 + random_.below(100)) : set_value(20);
  line(fmt::format("OUT C{} {}", n, set.list));
  statement(
      fmt::format("{}.count({}, {}{});", object, cpp_text(*counted), set.cpp, is_long ? fmt::format(", down[{}]", n - 200) : ""));
  begin_rung();
  const auto reset = tree(1 + random_.below(2), 0, 0);
  condition(*reset);
  line(fmt::format("RST C{}", n));
  statement(fmt::format("{}.reset({});", object, cpp_text(*reset)));
  program_.mix.timing += 2;
}

void Maker::reset_timer_rung() {
  begin_rung();
  const unsigned n = resets_.take();
  const auto root = tree(1 + random_.below(2), 0, 0);
  condition(*root);
  ++program_.mix.timing;
  line(fmt::format("RST T{}", n));
  statement(fmt::format("if ({})", cpp_text(*root)));
  statement(fmt::format("  t[{}] = HandTimer();", n));
}

void Maker::timing_rung() {
  const std::uint32_t what = random_.below(100);
  if (what < 65 && !timers_.empty())
    timer_rung();
  else if (what < 92 && !counters_.empty())
    counter_rung(false);
  else if (what < 97 && !long_counters_.empty())
    counter_rung(true);
  else if (!resets_.empty())
    reset_timer_rung();
}

// ---- words

Text Maker::source() {
  const std::uint32_t what = random_.below(100);
  if (what < 30)
    return constant(random_.below(1000));
  if (what < 35) {
    const std::uint32_t n = random_.below(512);
    return {fmt::format("T{}", n), fmt::format("t[{}].value", n)};
  }
  if (what < 40) {
    const std::uint32_t n = random_.below(200);
    return {fmt::format("C{}", n), fmt::format("c[{}].value", n)};
  }
  return reg(random_.below(kRegisters));
}

std::string Maker::pair_instruction(const char *form, std::uint32_t what) {
  const unsigned a = random_.below(kRegisters - 1), b = random_.below(kRegisters - 1), to = random_.below(kRegisters - 1);
  if (what < 5) {
    line(fmt::format("DMOV{} D{} D{}", form, a, to));
    return fmt::format("set_pair({}, pair({}));", to, a);
  }
  const bool add = what < 9;
  line(fmt::format("{}{} D{} D{} D{}", add ? "DADD" : "DSUB", form, a, b, to));
  return fmt::format("set_pair({}, {}(pair({}), pair({})));", to, add ? "add32" : "sub32", a, b);
}

std::string Maker::compare_instruction(const char *form) {
  const Text value = reg(random_.below(kRegisters));
  const unsigned to = order_relay_;
  order_relay_ += 3;
  if (random_.chance(75)) {
    const Text b = source();
    line(fmt::format("CMP{} {} {} M{}", form, value.list, b.list, to));
    return fmt::format("compare({}, {}, {});", value.cpp, b.cpp, to);
  }
  const Text low = constant(random_.below(500)), high = constant(500 + random_.below(500));
  line(fmt::format("ZCP{} {} {} {} M{}", form, low.list, high.list, value.list, to));
  return fmt::format("zone({}, {}, {}, {});", low.cpp, high.cpp, value.cpp, to);
}

/// Writes one instruction, with `P` behind its name perhaps, and returns the statement.
std::string Maker::word_instruction(const char *form) {
  const std::uint32_t what = random_.below(100);
  const Text to = reg(random_.below(kRegisters));
  ++program_.mix.words;
  if (what < 11)
    return pair_instruction(form, what);
  if (what < 19)
    return compare_instruction(form);
  if (what < 32) {
    const bool up = what < 27;
    line(fmt::format("{}{} {}", up ? "INC" : "DEC", form, to.list));
    return fmt::format("{}{};", up ? "++" : "--", to.cpp);
  }
  if (what < 60) {
    const Text from = source();
    line(fmt::format("MOV{} {} {}", form, from.list, to.list));
    return fmt::format("{} = {};", to.cpp, from.cpp);
  }
  const Text a = random_.chance(40) ? to : reg(random_.below(kRegisters));
  if (what < 85) {
    const bool add = what < 75;
    const Text b = source();
    line(fmt::format("{}{} {} {} {}", add ? "ADD" : "SUB", form, a.list, b.list, to.list));
    return fmt::format("{} = {}({}, {});", to.cpp, add ? "add" : "sub", a.cpp, b.cpp);
  }
  const unsigned pair = random_.below(kRegisters - 1);
  if (what < 91) {
    const Text b = source();
    line(fmt::format("MUL{} {} {} D{}", form, a.list, b.list, pair));
    return fmt::format("set_pair({}, {} * {});", pair, a.cpp, b.cpp);
  }
  if (what < 95) {
    const bool fixed = random_.chance(70);
    const Text b = fixed ? constant(2 + random_.below(99)) : reg(kDivisors + random_.below(kSettings));
    line(fmt::format("DIV{} {} {} D{}", form, a.list, b.list, pair));
    return fmt::format("{}({}, {}, {}{});", fixed ? "divide_by" : "divide", a.cpp, b.cpp, pair,
                       fixed ? "" : fmt::format(", {}", ++places_that_fail_));
  }
  static constexpr std::array<std::array<const char *, 2>, 3> kLogic = {{{"WAND", "&"}, {"WOR", "|"}, {"WXOR", "^"}}};
  const auto logic = kLogic[random_.below(3)];
  const Text b = source();
  line(fmt::format("{}{} {} {} {}", logic[0], form, a.list, b.list, to.list));
  return fmt::format("{} = {} {} {};", to.cpp, a.cpp, logic[1], b.cpp);
}

/// One to four instructions under a condition, or always.
void Maker::word_rung() {
  begin_rung();
  const bool always = random_.chance(12), all_pulsed = !always && random_.chance(30);
  std::string on = "true";
  if (always) {
    line("LD M8000");
    ++program_.mix.contacts;
  } else {
    const auto root = tree(1 + random_.below(3), 0, 18);
    condition(*root);
    on = cpp_text(*root);
  }
  const unsigned count = 1 + random_.below(4);
  std::vector<std::pair<bool, std::string>> statements;
  bool any[2] = {};
  for (unsigned i = 0; i < count; ++i) {
    const bool pulsed = all_pulsed || (!always && random_.chance(10));
    any[pulsed] = true;
    statements.emplace_back(pulsed, word_instruction(pulsed ? "P" : ""));
  }
  if (always) {
    for (const auto &each : statements)
      statement(each.second);
    return;
  }
  std::string edge;
  if (any[true])
    edge = fmt::format("rising(pulse_edge[{}], {})", program_.places_of_pulses++, any[false] ? "on" : on);
  if (any[false] && any[true]) {
    statement("{");
    statement(fmt::format("const bool on = {}, edge_of_on = {};", on, edge));
    on = "on";
    edge = "edge_of_on";
  }
  for (std::size_t i = 0; i < statements.size(); ++i) {
    if (i == 0 || statements[i].first != statements[i - 1].first)
      statement(fmt::format("{}if ({}) {{", i ? "} " : "", statements[i].first ? edge : on));
    statement("  " + statements[i].second);
  }
  statement("}");
  if (any[false] && any[true])
    statement("}");
}

// ---- the whole

void Maker::begin_rung() {
  if (program_.rungs % kRungsPerFunction == 0) {
    if (program_.rungs != 0)
      program_.functions.push_back(function_ + "}\n");
    function_ = fmt::format("void Hand::rungs_{}() {{\n", program_.rungs / kRungsPerFunction);
  }
  ++program_.rungs;
}

/// Contacts in series, so that the number of instructions is met.
void Maker::last_rungs() {
  while (program_.mix.all() + 1 < instructions_) {
    begin_rung();
    const unsigned left = instructions_ - 1 - program_.mix.all(), length = left <= 8 ? left : std::min(left - 2, 7U);
    std::string text;
    for (unsigned i = 1; i < length; ++i) {
      const auto one = contact(0, 0);
      program_.mix.contacts += write_list(*one, i == 1 ? "LD" : "AND", program_.list);
      text += i > 1 ? " & " + cpp_text(*one) : one->closed ? "(" + cpp_text(*one) + ")" : cpp_text(*one);
    }
    const Text target = coil();
    line("OUT " + target.list);
    statement(fmt::format("{} = {};", target.cpp, text));
  }
}

MixedProgram Maker::make() {
  Mix &mix = program_.mix;
  while (mix.all() + kLongest < instructions_) {
    const bool timing_left = !timers_.empty() || !counters_.empty() || !long_counters_.empty() || !resets_.empty();
    if (mix.words * 100 < mix.all() * 20)
      word_rung();
    else if (mix.timing * 100 < mix.all() * 10 && timing_left)
      timing_rung();
    else
      coil_rung();
  }
  last_rungs();
  line("END");
  ++mix.contacts;
  program_.relays = order_relay_;
  program_.functions.push_back(function_ + "}\n");
  return std::move(program_);
}

}  // namespace

MixedProgram make_mixed_program(unsigned instructions, std::uint64_t seed) {
  return Maker(instructions, seed).make();
}

}  // namespace ladderc::bench
