// Random lists. Legal ones, made by the rules of the ladder, get no message; whatever the check accepts runs on the stack machine
// of the controller without an empty or a left-over stack; and nothing at all makes the check fall over. Seeds are fixed.
#include "checking.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

namespace ladderc::test {
namespace {

class ListMaker {
public:
  explicit ListMaker(unsigned seed) : random_(seed) {}

  unsigned below(unsigned n) { return std::uniform_int_distribution<unsigned>(0, n - 1)(random_); }

  /// A network of contacts that leaves one block, opened by LD.
  std::string block(unsigned depth) {
    std::string text = "LD X" + std::to_string(below(10)) + "\n";
    for (unsigned n = below(4); n > 0; --n)
      text += more(depth);
    return text;
  }

  /// Outputs behind a network, with branches. `open` branches are around it.
  std::string outputs(unsigned depth, unsigned open = 0) {
    switch (depth == 0 ? 0 : below(4)) {
    case 0:
      return output();
    case 1:
      return output() + behind_output(depth - 1, open) + outputs(depth - 1, open);
    case 2:
      return more(depth - 1) + outputs(depth - 1, open);
    default: {
      std::string text = "MPS\n" + outputs(depth - 1, open + 1);
      for (unsigned n = below(3); n > 0; --n)
        text += "MRD\n" + outputs(depth - 1, open + 1);
      return text + "MPP\n" + outputs(depth - 1, open);
    }
    }
  }

  std::string legal_list() {
    std::string text;
    for (unsigned n = below(8) + 1; n > 0; --n) {
      text += block(2) + outputs(3);
      if (below(4) == 0)
        text += "NOPLF\n";
      if (below(5) == 0)
        text += block(1) + "MC N0 M" + std::to_string(++master_) + "\n" + block(1) + outputs(1) + "MCR N0\n";
    }
    return text + "END\n";
  }

  /// Any sequence of instructions, some of them damaged.
  std::string any_list() {
    static constexpr const char *kLines[] = {"LD X0",     "LDI X1", "LD= D0 K5", "AND X2",   "OR X3",   "ANB",    "ORB",
                                             "MPS",       "MRD",    "MPP",       "INV",      "MEP",     "SET Y0", "SET M1",
                                             "MOV D0 D1", "NOP",    "NOPLF",     "MCR N0",   "MCR N1",  "LD X0",  "SET Y1",
                                             "LD X5",     "AND X1", "MPP",       "MC N0 M5", "MC N1 M6"};
    static constexpr const char *kDamaged[] = {
        "LD",      "FOO X0",         "MC N9",  "MCR",        "MOV K5X0 K5",      "OUT T0",   "END X0",   "OUT D0.G",
        "LD X0Z1", "DMOV K1 SD5119", "EGP V0", "OUT ST0 K1", "BMOV D0 K1Y0 K-1", "MOV H D0", "RST D0.5", "+ D0 D1 D2 D3",
        "K5",      "MC X0 N0"};
    std::string text;
    bool damaged = below(3) == 0;
    for (unsigned n = below(25) + 1; n > 0; --n)
      text +=
          std::string(damaged && below(4) == 0 ? kDamaged[below(std::size(kDamaged))] : kLines[below(std::size(kLines))]) + "\n";
    return text + (below(10) == 0 ? "" : "END\n");
  }

private:
  /// Something that changes the result of the block before.
  std::string more(unsigned depth) {
    switch (below(depth == 0 ? 3 : 5)) {
    case 0:
      return "AND M" + std::to_string(below(50)) + "\n";
    case 1:
      return "ORI Y" + std::to_string(below(8)) + "\n";
    case 2:
      return "INV\n";
    case 3:
      return block(depth - 1) + "ANB\n";
    default:
      return block(depth - 1) + "ORB\n";
    }
  }
  /// Where no branch is open, a block goes on from an output with ANB only, and has several contacts.
  std::string behind_output(unsigned depth, unsigned open) {
    if (open > 0)
      return more(depth);
    return below(2) == 0 ? more(0) : block(0) + "OR X5\nANB\n";
  }
  std::string output() { return below(2) == 0 ? "SET Y" + std::to_string(below(8)) + "\n" : "MOV D0 D1\n"; }

  std::mt19937 random_;
  unsigned master_ = 1000;
};

/// The machine: "" if the program uses its stacks well, otherwise what went wrong.
std::string run_on_stacks(const CheckedProgram &program) {
  unsigned blocks = 0, branches = 0, rung = 0, loops = 0, skips = 0, buses = 0;
  bool state = false, state_head = false, routine = false;
  std::vector<std::int64_t> levels;
  for (const Instruction &i : program.list.instructions) {
    if (!i.info)
      return "unknown instruction";
    if (i.rung != rung) {
      if (blocks > 1 || branches > 0 || i.rung != rung + 1)
        return "rung left open";
      rung = i.rung;
      blocks = 0;
    }
    switch (i.info->placement) {
    case Placement::Start:
      ++blocks;
      break;
    case Placement::JoinBlocks:
      if (blocks-- < 2)
        return "join";
      break;
    case Placement::PushBranch:
      if (++branches > program.family->max_branches)
        return "branches";
      [[fallthrough]];
    case Placement::Series:
    case Placement::Parallel:
      if (blocks == 0)
        return "no block";
      break;
    case Placement::PopBranch:
    case Placement::ReadBranch:
      if (branches == 0 || blocks == 0)
        return "no branch";
      branches -= i.info->placement == Placement::PopBranch;
      break;
    case Placement::Output:
      if (blocks != 1 && !(blocks == 0 && state_head))
        return "output";
      break;
    case Placement::Alone:
    case Placement::Label:
    case Placement::Anywhere:
    case Placement::BetweenRungs:
      break;
    case Placement::End:
      return branches == 0 && levels.empty() && loops == 0 && skips == 0 && buses == 0 && !state && !routine ? ""
                                                                                                             : "open at the end";
    }
    state_head = state_head && i.info->placement != Placement::Start;
    switch (i.info->lowering) {
    case Lowering::State:
      if (loops > 0 || routine)
        return "state";
      state = state_head = true;
      break;
    case Lowering::StateEnd:
      if (!std::exchange(state, false) || loops > 0)
        return "state end";
      break;
    case Lowering::Loop:
      ++loops;
      break;
    case Lowering::LoopEnd:
      if (loops-- == 0)
        return "loop end";
      break;
    case Lowering::BusStart:
      ++buses;
      break;
    case Lowering::BusEnd:
      buses = 0;
      break;
    case Lowering::Skip:
      ++skips;
      break;
    case Lowering::SkipEnd:
      skips = 0;
      break;
    case Lowering::MainEnd:
      if (routine || state || loops > 0 || buses > 0 || skips > 0)
        return "main end";
      break;
    case Lowering::InterruptLabel:
      if (routine || state || loops > 0)
        return "interrupt";
      routine = true;
      break;
    case Lowering::InterruptReturn:
      if (!std::exchange(routine, false))
        return "interrupt end";
      break;
    default:
      break;
    }
    std::int64_t level = i.operand_count > 0 ? program.list.operands_of(i)[0].value : 0;
    if (i.info->lowering == Lowering::MasterControl) {
      if (!levels.empty() && levels.back() >= level)
        return "level";
      levels.push_back(level);
    } else if (i.info->lowering == Lowering::MasterControlReset) {
      while (!levels.empty() && levels.back() > level)
        levels.pop_back();
      if (levels.empty() || levels.back() != level)
        return "region";
      levels.pop_back();
    }
  }
  return "no END";
}

/// Any sequence of instructions of the TP03, with flow in it.
std::string any_flow(unsigned seed) {
  static constexpr const char *kLines[] = {"LD X0\nOUT Y0",
                                           "LD X0\nOUT Y0",
                                           "LD M8000\nINC D0",
                                           "STL S0",
                                           "STL S20",
                                           "RET",
                                           "FOR K2",
                                           "NEXT",
                                           "LD X0\nMC N0 M5",
                                           "MCR N0",
                                           "LD X0\nSMCS",
                                           "SMCR",
                                           "LD X0\nJCS",
                                           "JCR",
                                           "P1",
                                           "P2",
                                           "LD X0\nCJ P1",
                                           "LD X0\nCALL P2",
                                           "SRET",
                                           "I001",
                                           "IRET",
                                           "FEND",
                                           "OUT Y1",
                                           "LD X0\nSET S20",
                                           "LD X0\nCJ P63",
                                           "EI",
                                           "AND X1",
                                           "LD X0\nMPS",
                                           "MPP",
                                           "LD X0\nCJ P0Z0",
                                           "LD X0\nOUT T0 K1",
                                           "NOP"};
  std::mt19937 random(seed);
  std::string text;
  for (unsigned n = random() % 14 + 1; n > 0; --n)
    text += std::string(kLines[random() % std::size(kLines)]) + "\n";
  return text + "END\n";
}

TEST(Random, AcceptedFlowIsClosed) {
  unsigned accepted = 0;
  for (unsigned seed = 0; seed < 5'000; ++seed) {
    std::string list = any_flow(seed);
    auto checked = check_text(list, "{}", Controller{"tp03"});
    ASSERT_EQ(checked->program.ok, checked->diagnostics->errors() == 0);
    if (!checked->program.ok)
      continue;
    ++accepted;
    ASSERT_EQ(run_on_stacks(checked->program), "") << "seed " << seed << "\n" << list;
  }
  EXPECT_GT(accepted, 80u);
}

TEST(Random, LegalListsGetNoMessage) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::string list = ListMaker(seed).legal_list();
    auto checked = check_text(list);
    ASSERT_THAT(checked->messages(), no_messages()) << "seed " << seed << "\n" << list;
    ASSERT_EQ(run_on_stacks(checked->program), "") << "seed " << seed << "\n" << list;
  }
}

TEST(Random, WhatIsAcceptedRuns) {
  unsigned accepted = 0;
  for (unsigned seed = 0; seed < 2'000; ++seed) {
    std::string list = ListMaker(seed).any_list();
    auto checked = check_text(list);
    ASSERT_EQ(checked->program.ok, checked->diagnostics->errors() == 0);
    if (!checked->program.ok)
      continue;
    ++accepted;
    ASSERT_EQ(run_on_stacks(checked->program), "") << "seed " << seed << "\n" << list;
  }
  EXPECT_GT(accepted, 10u);
}

}  // namespace
}  // namespace ladderc::test
