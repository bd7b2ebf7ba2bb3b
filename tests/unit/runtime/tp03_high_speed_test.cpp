// High-speed counters of the TP03, and the instructions that compare with them (F53-F55).
#include "ladder/tp03/ops/highspeed.h"
#include "tp03_plant.h"

#include <gtest/gtest.h>

#include <map>

using namespace ladder;
using tp03::Fault;
using tp03_plant::Counting;

TEST(Tp03HighSpeed, OneInputOfEachCounter) {
  const unsigned inputs[] = {0, 1, 2, 3, 4, 5, 0, 2, 4};
  for (unsigned i = 0; i < 9; ++i) {
    Counting p(235 + i);
    for (unsigned input = 0; input < 6; ++input)
      if (input != inputs[i])
        p.pulse(input);
    EXPECT_EQ(p.counter().value, 0) << p.number;
    p.pulse(inputs[i], 3);
    EXPECT_EQ(p.counter().value, 3) << p.number;
    p.sys.M[8235 + i] = on;
    p.pulse(inputs[i], 5);
    EXPECT_EQ(p.counter().value, -2) << p.number;
  }
}

TEST(Tp03HighSpeed, CountsEdgesOfTheImage) {
  Counting p(235, 2);
  for (int i = 0; i < 3; ++i) {
    p.set(0, true);
    p.run();
    p.run();
    p.set(0, false);
    p.run();
  }
  EXPECT_EQ(p.counter().value, 3);
  EXPECT_EQ(p.counter().contact, on);
}

TEST(Tp03HighSpeed, NotWithoutItsCoil) {
  Counting p(235);
  p.enable = off;
  p.run();
  p.pulse(0, 3);
  EXPECT_EQ(p.counter().value, 0);
  EXPECT_EQ(p.counter().coil, off);
  p.enable = on;
  p.run();
  p.idle(3);
  p.pulse(0, 3);
  EXPECT_EQ(p.counter().value, 3) << "goes on where OUT is skipped";
}

TEST(Tp03HighSpeed, ContactAtTheSetValue) {
  Counting p(235, 3);
  p.pulse(0, 2);
  EXPECT_EQ(p.counter().contact, off);
  p.pulse(0);
  EXPECT_EQ(p.counter().contact, on);
  p.pulse(0);
  EXPECT_EQ(p.counter().contact, on);
  p.sys.M[8235] = on;
  p.pulse(0);
  EXPECT_EQ(p.counter().contact, on);
  p.pulse(0);
  EXPECT_EQ(p.counter().contact, off) << "below the set value";
}

TEST(Tp03HighSpeed, ResetCoilHolds) {
  Counting p(235);
  p.pulse(0, 3);
  p.counter().drive_reset(on, p.sys);
  p.pulse(0, 3);
  EXPECT_EQ(p.counter().value, 0);
  p.counter().drive_reset(off, p.sys);
  p.pulse(0);
  EXPECT_EQ(p.counter().value, 1);
}

TEST(Tp03HighSpeed, ResetInputs) {
  const unsigned rows[][3] = {{241, 0, 1}, {242, 2, 3}, {243, 4, 5}, {247, 0, 2}, {248, 3, 5}};
  for (const auto &[number, count, reset] : rows) {
    Counting p(number, 2);
    p.pulse(count, 3);
    EXPECT_EQ(p.counter().value, 3) << number;
    p.sys.input(reset, on);
    EXPECT_EQ(p.counter().value, 0) << number;
    EXPECT_EQ(p.counter().contact, off) << number;
    p.pulse(count, 3);
    EXPECT_EQ(p.counter().value, 0) << number << ": held";
    p.sys.input(reset, off);
    p.pulse(count);
    EXPECT_EQ(p.counter().value, 1) << number;
  }
}

TEST(Tp03HighSpeed, StartInputs) {
  const unsigned rows[][3] = {{244, 0, 4}, {245, 2, 5}, {249, 0, 5}};
  for (const auto &[number, count, start] : rows) {
    Counting p(number);
    p.pulse(count, 3);
    EXPECT_EQ(p.counter().value, 0) << number;
    p.sys.input(start, on);
    p.pulse(count, 3);
    EXPECT_EQ(p.counter().value, 3) << number;
    p.sys.input(start, off);
    p.pulse(count, 3);
    EXPECT_EQ(p.counter().value, 3) << number;
  }
}

TEST(Tp03HighSpeed, UpAndDownInputs) {
  const unsigned rows[][3] = {{246, 0, 1}, {247, 0, 1}, {248, 3, 4}};
  for (const auto &[number, up, down] : rows) {
    Counting p(number);
    p.pulse(up, 5);
    EXPECT_EQ(p.m(8000 + number), off);
    p.pulse(down, 2);
    EXPECT_EQ(p.counter().value, 3) << number;
    EXPECT_EQ(p.m(8000 + number), on) << "tells the direction";
    p.pulse(up);
    EXPECT_EQ(p.m(8000 + number), off);
  }
}

TEST(Tp03HighSpeed, TwoPhases) {
  const unsigned rows[][4] = {{251, 0, 1, 9}, {252, 0, 1, 9}, {253, 2, 3, 9}, {254, 0, 1, 5}};
  for (const auto &[number, a, b, start] : rows) {
    Counting p(number);
    p.sys.input(start, on);
    for (int i = 0; i < 3; ++i) {  // A leads
      p.sys.input(a, on);
      p.sys.input(b, on);
      p.sys.input(a, off);
      p.sys.input(b, off);
    }
    EXPECT_EQ(p.counter().value, 3) << number;
    EXPECT_EQ(p.m(8000 + number), off);
    for (int i = 0; i < 5; ++i) {  // B leads
      p.sys.input(b, on);
      p.sys.input(a, on);
      p.sys.input(b, off);
      p.sys.input(a, off);
    }
    EXPECT_EQ(p.counter().value, -2) << number;
    EXPECT_EQ(p.m(8000 + number), on);
    p.sys.input(a, on);
    for (int i = 0; i < 4; ++i) {  // trembling B: up and down
      p.sys.input(b, on);
      p.sys.input(b, off);
    }
    EXPECT_EQ(p.counter().value, -2) << number;
  }
}

TEST(Tp03HighSpeed, StopEndsIt) {
  Counting p(235);
  p.pulse(0);
  p.sys.set_mode(Mode::Stop);
  p.pulse(0);
  p.sys.set_mode(Mode::Run);
  p.idle();
  p.pulse(0);
  EXPECT_EQ(p.counter().value, 1);
  p.run();
  p.pulse(0);
  EXPECT_EQ(p.counter().value, 2);
}

TEST(Tp03HighSpeed, InterruptsSeeEdgesBetweenScans) {
  Counting p(235);
  p.sys.enable_interrupts();
  p.sys.input(2, on);
  p.sys.input(2, off);
  p.run([&] {
    EXPECT_EQ(p.sys.next_interrupt(), 201);
    EXPECT_EQ(p.sys.next_interrupt(), 200);
    EXPECT_EQ(p.sys.next_interrupt(), -1);
  });
}

// F53-F55

TEST(Tp03HighSpeed, SetsABitFromBothSides) {
  Counting p(235);
  tp03::SetAtCount set;
  auto program = [&] { EXPECT_EQ(set.run(on, 100, p.counter(), p.M.run(5), p.sys), Fault::None); };
  p.counter().value = 98;
  p.run(program);
  p.pulse(0);
  EXPECT_EQ(bit(p.M[5]), off);
  p.pulse(0);
  EXPECT_EQ(bit(p.M[5]), on) << "at once";
  p.M[5] = off;
  p.pulse(0);
  p.sys.M[8235] = on;
  p.pulse(0);
  EXPECT_EQ(bit(p.M[5]), on) << "101 to 100";
  p.M[5] = off;
  p.counter().value = 100;
  p.run(program);
  EXPECT_EQ(bit(p.M[5]), off) << "only counts compare";
  EXPECT_EQ(p.io.writes, 0);
}

TEST(Tp03HighSpeed, OutputsGoStraightToTheirTerminals) {
  Counting p(235);
  tp03::SetOutputAtCount set;
  tp03::ResetOutputAtCount reset;
  p.run([&] {
    set.run(on, 3, p.counter(), p.Y.run(8), p.sys);
    reset.run(on, 5, p.counter(), p.Y.run(8), p.sys);
  });
  p.pulse(0, 3);
  EXPECT_EQ(bit(p.Y[8]), on);
  EXPECT_EQ(p.io.outputs, (std::map<unsigned, bool>{{8, true}}));
  p.pulse(0, 2);
  EXPECT_EQ(bit(p.Y[8]), off);
  EXPECT_EQ(p.io.outputs, (std::map<unsigned, bool>{{8, false}}));
  p.sys.M[8034] = on;
  p.counter().value = 2;
  p.pulse(0);
  EXPECT_EQ(bit(p.Y[8]), on);
  EXPECT_EQ(p.io.writes, 2) << "M8034 disables terminals";
}

TEST(Tp03HighSpeed, GoesOnWhereItIsSkippedUntilItsConditionIsOff) {
  Counting p(235);
  tp03::SetAtCount set;
  p.run([&] { set.run(on, 3, p.counter(), p.M.run(5), p.sys); });
  p.idle(5);
  p.pulse(0, 3);
  EXPECT_EQ(bit(p.M[5]), on);
  p.M[5] = off;
  p.counter().value = 0;
  p.run([&] { set.run(off, 3, p.counter(), p.M.run(5), p.sys); });
  p.pulse(0, 3);
  EXPECT_EQ(bit(p.M[5]), off);
}

TEST(Tp03HighSpeed, TheValueFollowsItsOperand) {
  Counting p(235);
  tp03::SetAtCount set;
  p.run([&] { set.run(on, 3, p.counter(), p.M.run(5), p.sys); });
  p.run([&] { set.run(on, 5, p.counter(), p.M.run(6), p.sys); });
  p.pulse(0, 4);
  EXPECT_EQ(bit(p.M[5]) | bit(p.M[6]), off);
  p.pulse(0);
  EXPECT_EQ(bit(p.M[5]), off);
  EXPECT_EQ(bit(p.M[6]), on);
}

TEST(Tp03HighSpeed, ClearsItself) {
  Counting p(235, 2);
  tp03::ClearAtCount clear;
  tp03::SetAtCount set;
  p.run([&] {
    EXPECT_EQ(clear.run(on, 4, p.counter(), p.counter(), p.sys), Fault::None);
    set.run(on, 4, p.counter(), p.M.run(5), p.sys);
  });
  p.pulse(0, 3);
  EXPECT_EQ(p.counter().contact, on);
  p.pulse(0);
  EXPECT_EQ(p.counter().value, 0);
  EXPECT_EQ(p.counter().contact, off);
  EXPECT_EQ(bit(p.M[5]), on) << "the same count";
  p.pulse(0, 9);
  EXPECT_EQ(p.counter().value, 1);
  p.run([&] { EXPECT_EQ(clear.run(on, 4, p.counter(), p.C32[236], p.sys), Fault::Operand); });
  p.pulse(0, 9);
  EXPECT_EQ(p.counter().value, 10) << "not entered";
}

TEST(Tp03HighSpeed, InterruptsAtACount) {
  Counting p(235);
  tp03::InterruptAtCount first, second;
  auto program = [&] {
    first.run(on, 3, p.counter(), 20, p.sys);
    second.run(on, 3, p.counter(), 10, p.sys);
  };
  p.run(program);
  p.sys.enable_interrupts();
  p.pulse(0, 3);
  EXPECT_EQ(p.sys.next_interrupt(), 20);
  EXPECT_EQ(p.sys.next_interrupt(), 10);
  EXPECT_EQ(p.sys.next_interrupt(), -1);
  p.sys.M[8059] = on;
  p.counter().value = 0;
  p.pulse(0, 3);
  EXPECT_EQ(p.sys.next_interrupt(), -1);
}

TEST(Tp03HighSpeed, Zones) {
  Counting p(251);
  tp03::ZoneOfCountToOutputs zone;
  bit drive = on;
  auto program = [&] { EXPECT_EQ(zone.run(drive, 1, 2, p.counter(), p.Y.run(4), p.sys), Fault::None); };
  auto zones = [&] { return bit(p.Y[4]).value() * 4 + bit(p.Y[5]).value() * 2 + bit(p.Y[6]).value(); };
  auto up = [&] {
    p.sys.input(0, on);
    p.sys.input(1, on);
    p.sys.input(0, off);
    p.sys.input(1, off);
  };
  p.run(program);
  EXPECT_EQ(zones(), 4) << "without a count in the first execution";
  EXPECT_EQ(p.io.outputs, (std::map<unsigned, bool>{{4, true}, {5, false}, {6, false}}));
  p.counter().value = 7;
  p.run(program);
  EXPECT_EQ(zones(), 4) << "only counts compare";
  p.counter().value = 0;
  const int expected[] = {2, 2, 1, 1};
  for (const int each : expected) {
    up();
    EXPECT_EQ(zones(), each);
  }
  drive = off;
  p.run(program);
  p.counter().value = 0;
  up();
  EXPECT_EQ(zones(), 1) << "OFF keeps them";
  drive = on;
  p.run(program);
  EXPECT_EQ(zones(), 2);
  p.sys.set_mode(Mode::Stop);
  p.Y.clear();
  p.sys.set_mode(Mode::Run);
  p.run(program);
  EXPECT_EQ(zones(), 2) << "and again in RUN";
}

TEST(Tp03HighSpeed, ZonesAtTheirLimits) {
  Counting p(235);
  tp03::ZoneOfCount zone;
  auto first = [&](dword lower, dword upper, dword value) {
    p.counter().value = value;
    p.run([&] {
      EXPECT_EQ(zone.run(off, 0, 0, p.counter(), p.M.run(61), p.sys), Fault::None);
      EXPECT_EQ(zone.run(on, lower, upper, p.counter(), p.M.run(61), p.sys), Fault::None);
    });
    return bit(p.M[61]).value() * 4 + bit(p.M[62]).value() * 2 + bit(p.M[63]).value();
  };
  EXPECT_EQ(first(-3, 5, -4), 4);
  EXPECT_EQ(first(-3, 5, -3), 2);
  EXPECT_EQ(first(-3, 5, 5), 2);
  EXPECT_EQ(first(-3, 5, 6), 1);
  EXPECT_EQ(first(5, -3, 4), 4) << "the upper limit is below the lower one";
  EXPECT_EQ(first(5, -3, 5), 2);
  EXPECT_EQ(first(5, -3, 6), 1);
  p.run([&] { EXPECT_EQ(zone.run(on, 1, 2, p.counter(), p.M.run(62), p.sys), Fault::Range); });
}

TEST(Tp03HighSpeed, SixCompareAtATime) {
  Counting p(235);
  tp03::SetAtCount sets[7];
  auto program = [&](unsigned last, bit condition) {
    for (unsigned i = 0; i < last; ++i)
      EXPECT_EQ(sets[i].run(condition, 3, p.counter(), p.M.run(i), p.sys), Fault::None) << i;
  };
  p.run([&] {
    program(6, on);
    EXPECT_EQ(sets[6].run(on, 3, p.counter(), p.M.run(6), p.sys), Fault::Operand);
    EXPECT_EQ(sets[0].run(off, 3, p.counter(), p.M.run(0), p.sys), Fault::None);
    EXPECT_EQ(sets[6].run(on, 3, p.counter(), p.M.run(6), p.sys), Fault::None);
  });
  p.pulse(0, 3);
  for (unsigned i = 0; i < 7; ++i)
    EXPECT_EQ(bit(p.M[i]), bit(i > 0)) << i;
}
