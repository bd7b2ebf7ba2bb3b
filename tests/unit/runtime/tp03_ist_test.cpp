// IST: modes, initial states, relays, and what a change of mode resets.
#include "ladder/tp03/ops/ist.h"
#include "printing.h"
#include "tp03_fake_system.h"

#include <gtest/gtest.h>

using namespace ladder;

namespace {

enum : unsigned { kManual = 0, kReturn, kStep, kCycle, kContinuous, kReturnStart, kStart, kStop };

template <class States, class Outputs> class Machine {
public:
  Machine() { scan(); }  // the first scan, nothing selected

  tp03::Fault scan(bit condition = on) {
    sys.scan();
    return ist.run(condition, s, y, m.run(0), s.run(20), s.run(40), sys);
  }
  void select(unsigned mode) {
    for (unsigned i = kManual; i <= kContinuous; ++i)
      m[i] = bit(i == mode);
    scan();
  }
  void press(unsigned button) {
    m[button] = on;
    scan();
  }
  void release(unsigned button) {
    m[button] = off;
    scan();
  }
  bit inhibited() { return sys.M[8040]; }
  bit transfer() { return sys.M[8041]; }
  bit pulse() { return sys.M[8042]; }

  ScanningSystem sys;
  tp03::ist ist;
  States s;
  Outputs y;
  Bits<16> m;
};
using Plain = Machine<Bits<1024>, Bits<256>>;

}  // namespace

TEST(Tp03Ist, BeforeAModeIsSelectedNothingMoves) {
  Plain machine;
  EXPECT_EQ(machine.inhibited(), on);
  EXPECT_EQ(machine.transfer(), off);
  for (unsigned i = 0; i < 3; ++i)
    EXPECT_EQ(machine.s[i], off);
}

TEST(Tp03Ist, EachGroupOfModesHasItsInitialState) {
  const unsigned initial[] = {0, 1, 2, 2, 2};
  for (unsigned mode = kManual; mode <= kContinuous; ++mode) {
    Plain machine;
    machine.select(mode);
    for (unsigned i = 0; i < 3; ++i)
      EXPECT_EQ(machine.s[i], bit(i == initial[mode])) << "mode " << mode << ", S" << i;
  }
}

TEST(Tp03Ist, ManualInhibitsTransfers) {
  Plain machine;
  machine.select(kManual);
  EXPECT_EQ(machine.inhibited(), on);
  machine.press(kStart);
  EXPECT_EQ(machine.pulse(), on) << "the pulse belongs to every mode";
  EXPECT_EQ(machine.inhibited(), on);
  EXPECT_EQ(machine.transfer(), off);
  machine.scan();
  EXPECT_EQ(machine.pulse(), off) << "one scan";
}

TEST(Tp03Ist, ReturnIsInhibitedFromStopToStart) {
  for (const unsigned button : {unsigned{kReturnStart}, unsigned{kStart}}) {
    Plain machine;
    machine.select(kReturn);
    EXPECT_EQ(machine.inhibited(), off);
    machine.press(kStop);
    EXPECT_EQ(machine.inhibited(), on);
    machine.release(kStop);
    EXPECT_EQ(machine.inhibited(), on);
    machine.press(button);
    EXPECT_EQ(machine.inhibited(), off);
    EXPECT_EQ(machine.pulse(), on);
    EXPECT_EQ(machine.transfer(), off);
  }
}

TEST(Tp03Ist, StartOfTheReturnCountsInItsModeOnly) {
  Plain machine;
  machine.select(kCycle);
  machine.press(kReturnStart);
  EXPECT_EQ(machine.pulse(), off);
  machine.select(kReturn);
  EXPECT_EQ(machine.pulse(), off) << "held, not pressed";
}

TEST(Tp03Ist, StepLetsOneTransferThrough) {
  Plain machine;
  machine.select(kStep);
  EXPECT_EQ(machine.inhibited(), on);
  machine.press(kStart);
  EXPECT_EQ(machine.inhibited(), off);
  EXPECT_EQ(machine.transfer(), on);
  machine.scan();
  EXPECT_EQ(machine.inhibited(), on) << "held: no second step";
  EXPECT_EQ(machine.transfer(), on);
  machine.release(kStart);
  EXPECT_EQ(machine.transfer(), off);
}

TEST(Tp03Ist, OneCycleStopsAndGoesOn) {
  Plain machine;
  machine.select(kCycle);
  EXPECT_EQ(machine.inhibited(), off);
  machine.press(kStart);
  EXPECT_EQ(machine.transfer(), on);
  machine.release(kStart);
  EXPECT_EQ(machine.transfer(), off);
  machine.press(kStop);
  machine.release(kStop);
  EXPECT_EQ(machine.inhibited(), on);
  machine.select(kContinuous);
  EXPECT_EQ(machine.inhibited(), on) << "still stopped";
  machine.press(kStart);
  EXPECT_EQ(machine.inhibited(), off);
}

TEST(Tp03Ist, StopOutweighsStart) {
  Plain machine;
  machine.select(kCycle);
  machine.m[kStart] = machine.m[kStop] = on;
  machine.scan();
  EXPECT_EQ(machine.inhibited(), on);
  machine.release(kStop);
  EXPECT_EQ(machine.inhibited(), on) << "start is held, not pressed again";
  machine.select(kContinuous);
  EXPECT_EQ(machine.transfer(), off);
}

TEST(Tp03Ist, ContinuousHoldsFromStartToStop) {
  Plain machine;
  machine.select(kContinuous);
  EXPECT_EQ(machine.inhibited(), on) << "no start since RUN";
  EXPECT_EQ(machine.transfer(), off);
  machine.press(kStart);
  EXPECT_EQ(machine.inhibited(), off);
  machine.release(kStart);
  EXPECT_EQ(machine.transfer(), on);
  machine.press(kStop);
  EXPECT_EQ(machine.transfer(), off);
  EXPECT_EQ(machine.inhibited(), off) << "the cycle is finished";
  machine.release(kStop);
  EXPECT_EQ(machine.transfer(), off);
  machine.press(kStart);
  machine.select(kStep);
  machine.release(kStart);
  machine.select(kContinuous);
  EXPECT_EQ(machine.transfer(), off) << "another mode ends it";
}

TEST(Tp03Ist, OfSeveralModesTheLowestCounts) {
  Plain machine;
  machine.m[kReturn] = machine.m[kContinuous] = on;
  machine.scan();
  EXPECT_EQ(machine.s[1], on);
  machine.m[kReturn] = machine.m[kContinuous] = off;
  machine.scan();
  EXPECT_EQ(machine.s[1], on) << "none: as before";
}

TEST(Tp03Ist, AChangeAwayFromTheOriginResetsStatesAndOutputs) {
  Plain machine;
  machine.select(kContinuous);
  machine.s[2] = off;
  machine.s[25] = machine.s[899] = machine.s[900] = on;
  machine.y[0] = machine.y[255] = on;
  machine.select(kStep);
  EXPECT_EQ(machine.s[25], on) << "still automatic";
  EXPECT_EQ(machine.y[0], on);
  machine.select(kManual);
  EXPECT_EQ(machine.s[25], off);
  EXPECT_EQ(machine.s[899], off);
  EXPECT_EQ(machine.s[900], on) << "an annunciator";
  EXPECT_EQ(machine.y[0], off);
  EXPECT_EQ(machine.y[255], off);
  EXPECT_EQ(machine.s[0], on);
}

TEST(Tp03Ist, M8045KeepsTheOutputs) {
  Plain machine;
  machine.select(kContinuous);
  machine.s[25] = machine.y[0] = machine.sys.M[8045] = on;
  machine.select(kReturn);
  EXPECT_EQ(machine.s[25], off);
  EXPECT_EQ(machine.y[0], on);
}

TEST(Tp03Ist, AtTheOriginNothingIsReset) {
  for (const unsigned relay : {8043U, 8044U}) {
    Plain machine;
    machine.select(kReturn);
    machine.sys.M[relay] = machine.y[0] = machine.s[10] = on;
    machine.select(kManual);
    EXPECT_EQ(machine.y[0], on) << "M" << relay;
    EXPECT_EQ(machine.s[10], on) << "M" << relay;
    EXPECT_EQ(machine.s[1], off) << "M" << relay;
    EXPECT_EQ(machine.s[0], on) << "M" << relay;
  }
}

TEST(Tp03Ist, AnActiveSequenceGoesOn) {
  Plain machine;
  machine.s[40] = on;
  machine.select(kContinuous);
  EXPECT_EQ(machine.s[2], off);
  EXPECT_EQ(machine.s[40], on);
}

TEST(Tp03Ist, OffKeepsTheRelays) {
  Plain machine;
  machine.select(kCycle);
  machine.press(kStart);
  EXPECT_EQ(machine.pulse(), on);
  machine.scan(off);
  EXPECT_EQ(machine.pulse(), off);
  EXPECT_EQ(machine.transfer(), on);
  machine.release(kStart);
  machine.m[kStart] = on;
  machine.scan(off);
  machine.scan(on);
  EXPECT_EQ(machine.pulse(), off) << "pressed while it was not looking";
}

TEST(Tp03Ist, RunBeginsAnew) {
  Plain machine;
  machine.select(kContinuous);
  machine.press(kStart);
  machine.sys.restart();
  machine.s.clear();
  machine.scan();
  EXPECT_EQ(machine.s[2], on);
  EXPECT_EQ(machine.transfer(), off);
  EXPECT_EQ(machine.inhibited(), on);
  EXPECT_EQ(machine.pulse(), off) << "held since before";
}

TEST(Tp03Ist, SmallAndPackedImages) {
  Machine<Bits<64>, Bits<8>> small;
  small.select(kContinuous);
  small.s[25] = small.y[7] = on;
  small.select(kManual);
  EXPECT_EQ(small.s[25], off);
  EXPECT_EQ(small.y[7], off);
  Machine<Bits<1024, true>, Bits<256, true>> packed;
  packed.select(kContinuous);
  EXPECT_EQ(static_cast<bit>(packed.s[2]), on);
  packed.s[25] = on;
  packed.y[7] = on;
  packed.select(kManual);
  EXPECT_EQ(static_cast<bit>(packed.s[25]), off);
  EXPECT_EQ(static_cast<bit>(packed.y[7]), off);
  EXPECT_EQ(static_cast<bit>(packed.s[0]), on);
}

TEST(Tp03Ist, TheSequenceNeedsALowAndAHighEnd) {
  Plain machine;
  machine.select(kManual);
  machine.sys.scan();
  EXPECT_EQ(machine.ist.run(on, machine.s, machine.y, machine.m.run(0), machine.s.run(40), machine.s.run(40), machine.sys),
            tp03::Fault::Range);
  EXPECT_EQ(machine.ist.run(off, machine.s, machine.y, machine.m.run(0), machine.s.run(40), machine.s.run(40), machine.sys),
            tp03::Fault::None);
}
