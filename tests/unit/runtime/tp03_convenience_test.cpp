// Annunciator timer, searching, cams, timers, alternation, ramp, rotary table and sorting of the TP03.
#include "ladder/tp03/ops/convenience.h"
#include "ladder/words.h"
#include "printing.h"
#include "tp03_fake_system.h"

#include <gtest/gtest.h>

using namespace ladder;
using tp03::Fault;

// ---------------------------------------------------------------------------------------------- ANS
TEST(Tp03Ans, SetsWhatHasLastedLongEnough) {
  ScanningSystem sys;
  tp03::ans ans;
  tp03::Timer timer;
  Bits<1000> s;
  const auto scan = [&](bit condition) {
    sys.scan(100000);
    EXPECT_EQ(ans.run(condition, timer, 3, s.run(900), sys), Fault::None);
  };
  for (int i = 0; i < 3; ++i)
    scan(on);
  EXPECT_EQ(s[900], off) << "0.2 s";
  scan(off);
  EXPECT_EQ(timer.value, 0);
  for (int i = 0; i < 3; ++i)
    scan(on);
  EXPECT_EQ(s[900], off) << "from the beginning";
  scan(on);
  EXPECT_EQ(s[900], on);
  scan(off);
  EXPECT_EQ(s[900], on);
  EXPECT_EQ(timer.contact, off);
}

TEST(Tp03Ans, TakesAnnunciatorsOnly) {
  ScanningSystem sys;
  tp03::ans ans;
  tp03::Timer timer;
  Bits<1001> s;
  sys.scan();
  EXPECT_EQ(ans.run(on, timer, 3, s.run(899), sys), Fault::Range);
  EXPECT_EQ(ans.run(on, timer, 3, s.run(1000), sys), Fault::Range);
  EXPECT_EQ(ans.run(off, timer, 3, s.run(1000), sys), Fault::None);
}

// ---------------------------------------------------------------------------------------------- SER
TEST(Tp03Ser, FindsEqualSmallestAndLargest) {
  ScanningSystem sys;
  Words<64> d;
  const word items[] = {100, 111, 100, 98, 123, 66, 100, 95, 210, 88};
  for (unsigned i = 0; i < 10; ++i)
    d[i] = items[i];
  EXPECT_EQ(tp03::ser(d.block(0), 100, d.block(50), 10, sys), Fault::None);
  const word found[] = {3, 0, 6, 5, 8};
  for (unsigned i = 0; i < 5; ++i)
    EXPECT_EQ(d[50 + i], found[i]) << i;
  EXPECT_EQ(tp03::ser(d.block(0), 7, d.block(50), 10, sys), Fault::None);
  const word nothing[] = {0, 0, 0, 5, 8};
  for (unsigned i = 0; i < 5; ++i)
    EXPECT_EQ(d[50 + i], nothing[i]) << i;
}

TEST(Tp03Ser, ComparesSignedDoubleWordsAndMayOverwriteTheTable) {
  ScanningSystem sys;
  Words<64> d;
  const dword items[] = {-70000, 70000, -70000, 5, 70000};
  for (unsigned i = 0; i < 5; ++i)
    d.dblock(0).set(i, items[i]);
  EXPECT_EQ(tp03::dser(d.dblock(0), -70000, d.dblock(0), 5, sys), Fault::None);
  const dword found[] = {2, 0, 2, 2, 4};
  for (unsigned i = 0; i < 5; ++i)
    EXPECT_EQ(d.dblock(0).get(i), found[i]) << i;
}

TEST(Tp03Ser, RefusesWhatDoesNotFit) {
  ScanningSystem sys;
  Words<300> d;
  EXPECT_EQ(tp03::ser(d.block(0), 1, d.block(290), 0, sys), Fault::Range);
  EXPECT_EQ(tp03::ser(d.block(0), 1, d.block(290), 257, sys), Fault::Range);
  EXPECT_EQ(tp03::ser(d.block(45), 1, d.block(290), 256, sys), Fault::Range);
  EXPECT_EQ(tp03::ser(d.block(0), 1, d.block(296), 5, sys), Fault::Range);
  EXPECT_EQ(tp03::dser(d.dblock(0), 1, d.dblock(290), 129, sys), Fault::Range);
  for (unsigned i = 290; i < 300; ++i)
    EXPECT_EQ(d[i], 0);
}

// ---------------------------------------------------------------------------------------------- ABSD
TEST(Tp03Absd, FollowsTheCounter) {
  ScanningSystem sys;
  Words<16> d;
  Bits<16> m;
  tp03::Counter counter;
  const word table[] = {40, 104, 160, 60};
  for (unsigned i = 0; i < 4; ++i)
    d[i] = table[i];
  for (int value = -5; value < 200; ++value) {
    counter.value = to_word(static_cast<std::uint32_t>(value));
    EXPECT_EQ(tp03::absd(d.block(0), counter, m.run(3), 2, sys), Fault::None);
    EXPECT_EQ(m[3], bit(value >= 40 && value < 104)) << value;
    EXPECT_EQ(m[4], bit(value >= 160 || value < 60)) << value;
  }
  EXPECT_EQ(m[2], off);
  EXPECT_EQ(m[5], off);
}

TEST(Tp03Absd, DoubleWords) {
  ScanningSystem sys;
  Words<16> d;
  Bits<16> m;
  tp03::LongCounter counter;
  d.dblock(0).set(0, -100000);
  d.dblock(0).set(1, 100000);
  counter.value = 99999;
  EXPECT_EQ(tp03::dabsd(d.dblock(0), counter, m.run(0), 1, sys), Fault::None);
  EXPECT_EQ(m[0], on);
  counter.value = 100000;
  EXPECT_EQ(tp03::dabsd(d.dblock(0), counter, m.run(0), 1, sys), Fault::None);
  EXPECT_EQ(m[0], off);
}

TEST(Tp03Absd, RefusesWhatDoesNotFit) {
  ScanningSystem sys;
  Words<7> d;
  Bits<128> m;
  tp03::Counter counter;
  EXPECT_EQ(tp03::absd(d.block(0), counter, m.run(0), 4, sys), Fault::Range) << "eight words";
  EXPECT_EQ(tp03::absd(d.block(0), counter, m.run(126), 3, sys), Fault::Range) << "three bits";
  EXPECT_EQ(tp03::absd(d.block(0), counter, m.run(0), 0, sys), Fault::Range);
  EXPECT_EQ(tp03::absd(m.digit_block<4>(16), counter, m.run(0), 1, sys), Fault::None);
  EXPECT_EQ(tp03::absd(m.digit_block<4>(8), counter, m.run(0), 1, sys), Fault::Range);
  EXPECT_EQ(tp03::absd(m.digit_block<3>(16), counter, m.run(0), 1, sys), Fault::Range);
  tp03::LongCounter wide;
  EXPECT_EQ(tp03::dabsd(m.digit_dblock<8>(16), wide, m.run(0), 1, sys), Fault::None);
  EXPECT_EQ(tp03::dabsd(m.digit_dblock<4>(16), wide, m.run(0), 1, sys), Fault::Range);
}

// ---------------------------------------------------------------------------------------------- INCD
namespace {
struct Stages {
  ScanningSystem sys;
  tp03::incd incd;
  tp03::Counters<4> c;
  Words<8> d;
  Bits<16> m;

  Fault scan(bit condition, word n = 3) {
    sys.scan();
    return incd.run(condition, c, d.block(0), c.block(1), m.run(4), n, sys);
  }
  void expect(unsigned stage) {
    for (unsigned i = 0; i < 3; ++i)
      EXPECT_EQ(m[4 + i], bit(i == stage)) << i;
  }
};
}  // namespace

TEST(Tp03Incd, GoesThroughItsStages) {
  Stages t;
  t.d[0] = 2, t.d[1] = 1, t.d[2] = 3;
  EXPECT_EQ(t.scan(on), Fault::None);
  unsigned stage = 0;
  for (int round = 0; round < 2; ++round)
    for (const unsigned length : {2U, 1U, 3U}) {
      for (unsigned i = 0; i < length; ++i) {
        t.expect(stage);
        EXPECT_EQ(t.c[2].value, static_cast<word>(stage));
        ++t.c[1].value;
        t.scan(on);
      }
      EXPECT_EQ(t.c[1].value, 0);
      EXPECT_EQ(t.sys.M[8029], bit(stage == 2));
      stage = (stage + 1) % 3;
    }
  t.scan(on);
  EXPECT_EQ(t.sys.M[8029], off) << "for one execution";
}

TEST(Tp03Incd, TheCounterLosesItsContactToo) {
  Stages t;
  t.d[0] = 1;
  t.scan(on);
  t.c[1].count_up(on, 1, t.sys);
  EXPECT_EQ(t.c[1].contact, on);
  t.scan(on);
  EXPECT_EQ(t.c[1].contact, off);
  EXPECT_EQ(t.c[2].value, 1);
}

TEST(Tp03Incd, OffClearsAndOnBeginsAnew) {
  Stages t;
  t.d[0] = t.d[2] = 5;
  t.c[1].value = 3, t.c[2].value = 2;
  t.scan(on);
  t.expect(2);
  EXPECT_EQ(t.c[1].value, 3) << "RUN finds the condition ON: latched counters go on";
  t.scan(off);
  t.expect(9);
  EXPECT_EQ(t.c[2].value, 0);
  t.m[4] = on;
  t.c[1].value = 3;
  t.scan(off);
  EXPECT_EQ(t.m[4], on) << "the bits are free while the instruction is OFF";
  t.scan(on);
  EXPECT_EQ(t.c[1].value, 0);
  t.expect(0);
}

TEST(Tp03Incd, RefusesWhatDoesNotFit) {
  Stages t;
  t.m[4] = on;
  EXPECT_EQ(t.scan(on, 9), Fault::Range) << "nine words";
  EXPECT_EQ(t.scan(on, 0), Fault::Range);
  EXPECT_EQ(t.m[4], on);
  t.scan(off, 9);
  EXPECT_EQ(t.incd.run(on, t.c, t.d.block(0), t.c.block(3), t.m.run(4), 3, t.sys), Fault::Range) << "one counter";
  t.c[2].value = 77;
  EXPECT_EQ(t.scan(on), Fault::None);
  t.expect(1);
}

// ---------------------------------------------------------------------------------------------- TTMR
TEST(Tp03Ttmr, MultipliesTheTime) {
  const word expected[] = {5, 52, 523};
  for (word n = 0; n < 3; ++n) {
    ScanningSystem sys;
    tp03::ttmr ttmr;
    Words<4> d;
    const auto scan = [&](bit condition) {
      sys.scan(7000);
      EXPECT_EQ(ttmr.run(condition, d.block(1), n, sys), Fault::None);
    };
    d[2] = 99;
    scan(off);
    EXPECT_EQ(d[2], 0) << "RUN begins with the condition OFF";
    for (int i = 0; i <= 748; ++i)
      scan(on);  // 5.236 s
    EXPECT_EQ(d[1], expected[n]);
    EXPECT_EQ(d[2], 52);
    scan(off);
    EXPECT_EQ(d[1], expected[n]);
    EXPECT_EQ(d[2], 0);
    d[2] = 7;
    scan(off);
    EXPECT_EQ(d[2], 7) << "once";
    scan(on);
    EXPECT_EQ(d[1], 0);
  }
}

TEST(Tp03Ttmr, StopsAtTheHighestNumber) {
  ScanningSystem sys;
  tp03::ttmr ttmr;
  Words<2> d;
  for (int i = 0; i < 8; ++i) {
    sys.scan(600000000);
    EXPECT_EQ(ttmr.run(on, d.block(0), 2, sys), Fault::None);
  }
  EXPECT_EQ(d[0], 32767);
  EXPECT_EQ(d[1], 32767);
  EXPECT_EQ(ttmr.run(on, d.block(1), 2, sys), Fault::Range);
  EXPECT_EQ(ttmr.run(on, d.block(0), 3, sys), Fault::Range);
}

// ---------------------------------------------------------------------------------------------- STMR
namespace {
struct SpecialTimer {
  ScanningSystem sys;
  tp03::stmr stmr;
  tp03::Timer timer;
  Bits<8> m;

  /// The four outputs behind so many scans of 100 ms, as digits.
  std::uint32_t scans(int count, bit condition) {
    for (int i = 0; i < count; ++i) {
      sys.scan(100000);
      EXPECT_EQ(stmr.run(condition, timer, 5, m.run(0), sys), Fault::None);
    }
    std::uint32_t digits = 0;
    for (unsigned i = 0; i < 4; ++i)
      digits = digits * 10 + static_cast<bit>(m[i]).value();
    return digits;
  }
};
}  // namespace

TEST(Tp03Stmr, LongOn) {
  SpecialTimer t;
  EXPECT_EQ(t.scans(3, off), 0U);
  EXPECT_EQ(t.scans(1, on), 1010U);
  EXPECT_EQ(t.scans(4, on), 1010U);
  EXPECT_EQ(t.scans(1, on), 1001U);
  EXPECT_EQ(t.scans(20, on), 1001U);
  EXPECT_EQ(t.scans(1, off), 1101U);
  EXPECT_EQ(t.scans(4, off), 1101U);
  EXPECT_EQ(t.scans(1, off), 0U);
  EXPECT_EQ(t.timer.value, 0);
  EXPECT_EQ(t.timer.contact, off);
  EXPECT_EQ(t.scans(20, off), 0U);
}

TEST(Tp03Stmr, ShortOnAndOnAgain) {
  SpecialTimer t;
  EXPECT_EQ(t.scans(2, on), 1010U);
  EXPECT_EQ(t.scans(1, off), 1100U) << "too short for D + 3";
  EXPECT_EQ(t.scans(1, on), 1010U) << "the one shot is cut";
  EXPECT_EQ(t.scans(6, on), 1001U);
  EXPECT_EQ(t.scans(2, off), 1101U);
  EXPECT_EQ(t.scans(2, on), 1011U) << "D + 3 has not gone OFF yet";
  EXPECT_EQ(t.scans(6, on), 1001U);
}

TEST(Tp03Stmr, Flickers) {
  SpecialTimer t;
  int changes = 0;
  bit before = off;
  for (int i = 0; i < 62; ++i) {
    t.scans(1, !t.m[3]);
    EXPECT_EQ(t.m[1] & t.m[2], off);
    changes += t.m[2] != before;
    before = t.m[2];
  }
  EXPECT_EQ(changes, 11) << "about 5 scans each";
}

TEST(Tp03Stmr, RunBeginsAnew) {
  SpecialTimer t;
  t.scans(8, on);
  t.sys.restart();
  t.timer.reset();
  EXPECT_EQ(t.scans(1, off), 0U) << "no one shot for what went OFF in STOP";
  EXPECT_EQ(t.stmr.run(on, t.timer, 5, t.m.run(5), t.sys), Fault::Range);
}

// ---------------------------------------------------------------------------------------------- ALT, RAMP
TEST(Tp03Alt, Inverts) {
  EXPECT_EQ(tp03::alt(on), off);
  EXPECT_EQ(tp03::alt(off), on);
}

namespace {
struct Ramp {
  ScanningSystem sys;
  tp03::ramp ramp;
  Words<4> d;
  word from = 100, to = -900;

  word scans(int count, bit condition = on) {
    for (int i = 0; i < count; ++i) {
      sys.scan();
      EXPECT_EQ(ramp.run(condition, from, to, d.block(0), 10, sys), Fault::None);
    }
    return d[0];
  }
};
}  // namespace

TEST(Tp03Ramp, GoesEvenlyAndStartsAgain) {
  Ramp t;
  t.scans(1, off);
  EXPECT_EQ(t.scans(1), 100);
  EXPECT_EQ(t.scans(1), 0);
  EXPECT_EQ(t.scans(8), -800);
  EXPECT_EQ(t.sys.M[8029], off);
  EXPECT_EQ(t.scans(1), -900);
  EXPECT_EQ(t.d[1], 10);
  EXPECT_EQ(t.sys.M[8029], on);
  EXPECT_EQ(t.scans(1), 100);
  EXPECT_EQ(t.d[1], 0);
  EXPECT_EQ(t.sys.M[8029], off);
}

TEST(Tp03Ramp, M8026StaysAtTheEnd) {
  Ramp t;
  t.sys.M[8026] = on;
  t.scans(1, off);
  EXPECT_EQ(t.scans(30), -900);
  EXPECT_EQ(t.sys.M[8029], on);
  t.sys.M[8026] = off;
  EXPECT_EQ(t.scans(1), 100);
}

TEST(Tp03Ramp, OffInterrupts) {
  Ramp t;
  t.scans(1, off);
  EXPECT_EQ(t.scans(4), -200);
  EXPECT_EQ(t.scans(3, off), -200);
  EXPECT_EQ(t.d[1], 3);
  EXPECT_EQ(t.scans(1), 100);
}

TEST(Tp03Ramp, GoesOnWhereRunFindsItOn) {
  Ramp t;
  t.d[1] = 7;
  EXPECT_EQ(t.scans(1), -600);
  EXPECT_EQ(t.scans(1), -700);
  t.sys.restart();
  t.d[1] = -5;
  EXPECT_EQ(t.scans(1), 100);
}

TEST(Tp03Ramp, ReachesAcrossTheWholeRange) {
  ScanningSystem sys;
  tp03::ramp ramp;
  Words<4> d;
  d[1] = 32766;
  sys.scan();
  EXPECT_EQ(ramp.run(on, 32767, -32768, d.block(0), 32767, sys), Fault::None);
  EXPECT_EQ(d[0], -32765) << "cut towards the start";
  sys.scan();
  EXPECT_EQ(ramp.run(on, 32767, -32768, d.block(0), 32767, sys), Fault::None);
  EXPECT_EQ(d[0], -32768);
  EXPECT_EQ(ramp.run(on, 0, 1, d.block(3), 1, sys), Fault::Range);
  EXPECT_EQ(ramp.run(on, 0, 1, d.block(0), 0, sys), Fault::Range);
}
