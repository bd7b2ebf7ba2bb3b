// Sorting of tables, and the rotary table, of the TP03.
#include "ladder/tp03/ops/convenience.h"
#include "ladder/words.h"
#include "printing.h"
#include "tp03_fake_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace ladder;
using tp03::Fault;

namespace {

constexpr std::array<word, 20> kPeople = {1, 2, 3, 4, 5, 150, 180, 160, 100, 150, 45, 50, 70, 20, 50, 20, 40, 30, 8, 45};

struct Sorter {
  ScanningSystem sys;
  tp03::sort sort;
  Words<512> d;

  Sorter() {
    for (unsigned i = 0; i < kPeople.size(); ++i)
      d[i] = kPeople[i];
  }
  Fault scan(word key, unsigned target = 100, bit condition = on) {
    sys.scan();
    return sort.run(condition, d.block(0), 5, 4, d.block(target), key, sys);
  }
  void expect_ids(unsigned target, std::array<word, 5> ids) {
    for (unsigned i = 0; i < 5; ++i)
      EXPECT_EQ(d[target + i], ids[i]) << "row " << i;
    for (unsigned i = 0; i < 20; ++i)
      EXPECT_EQ(d[target + i], kPeople[i / 5 * 5 + static_cast<unsigned>(ids[i % 5]) - 1]) << "whole rows";
  }
};

}  // namespace

TEST(Tp03Sort, TakesAsManyScansAsRows) {
  Sorter t;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(t.scan(2), Fault::None);
    EXPECT_EQ(t.sys.M[8029], off);
  }
  EXPECT_EQ(t.scan(2), Fault::None);
  EXPECT_EQ(t.sys.M[8029], on);
  t.expect_ids(100, {4, 1, 5, 3, 2});
}

TEST(Tp03Sort, RunsOnceForEachOn) {
  Sorter t;
  for (int i = 0; i < 5; ++i)
    t.scan(2);
  t.sys.M[8029] = off;
  t.scan(3);
  EXPECT_EQ(t.sys.M[8029], on) << "still complete";
  t.expect_ids(100, {4, 1, 5, 3, 2});
  t.scan(3, 100, off);
  EXPECT_EQ(t.sys.M[8029], on) << "OFF writes no flag";
  t.scan(3);
  EXPECT_EQ(t.sys.M[8029], off);
  for (int i = 0; i < 4; ++i)
    t.scan(3);
  t.expect_ids(100, {4, 1, 2, 5, 3});
}

TEST(Tp03Sort, InPlaceAndOverlapping) {
  for (const unsigned target : {0U, 7U}) {
    Sorter t;
    for (int i = 0; i < 5; ++i)
      EXPECT_EQ(t.scan(4, target), Fault::None);
    t.expect_ids(target, {4, 1, 3, 2, 5});
  }
}

TEST(Tp03Sort, IsSignedAndStable) {
  std::uint32_t random = 1;
  for (int round = 0; round < 200; ++round) {
    ScanningSystem sys;
    tp03::sort sort;
    Words<512> d;
    random = random * 1664525U + 1013904223U;
    const unsigned rows = 1 + random % 32;
    std::vector<std::pair<word, word>> model;
    for (unsigned i = 0; i < rows; ++i) {
      random = random * 1664525U + 1013904223U;
      d[i] = static_cast<word>(i);
      d[rows + i] = static_cast<word>(static_cast<int>(random >> 16 & 15U) - 8);
      model.emplace_back(d[rows + i], d[i]);
    }
    std::sort(model.begin(), model.end());
    for (unsigned i = 0; i < rows; ++i) {
      sys.scan();
      EXPECT_EQ(sort.run(on, d.block(0), to_word(rows), 2, d.block(200), 2, sys), Fault::None);
    }
    EXPECT_EQ(sys.M[8029], on);
    for (unsigned i = 0; i < rows; ++i) {
      EXPECT_EQ(d[200 + rows + i], model[i].first);
      EXPECT_EQ(d[200 + i], model[i].second);
    }
  }
}

TEST(Tp03Sort, RefusesWhatDoesNotFit) {
  ScanningSystem sys;
  tp03::sort sort;
  Words<200> d;
  const auto fault = [&](word m1, word m2, unsigned target, word n) {
    sys.scan();
    return sort.run(on, d.block(0), m1, m2, d.block(target), n, sys);
  };
  EXPECT_EQ(fault(0, 1, 0, 1), Fault::Range);
  EXPECT_EQ(fault(33, 1, 0, 1), Fault::Range);
  EXPECT_EQ(fault(2, 0, 0, 1), Fault::Range);
  EXPECT_EQ(fault(2, 7, 0, 1), Fault::Range);
  EXPECT_EQ(fault(2, -1, 0, 1), Fault::Range);
  EXPECT_EQ(fault(2, 2, 0, 0), Fault::Range);
  EXPECT_EQ(fault(2, 2, 0, 3), Fault::Range);
  EXPECT_EQ(fault(10, 2, 190, 1), Fault::Range);
  EXPECT_EQ(fault(1, 1, 199, 1), Fault::None) << "what was wrong is mended: it starts";
  EXPECT_EQ(sys.M[8029], on) << "one row, one scan";
}

// ---------------------------------------------------------------------------------------------- ROTC
namespace {
struct Table {
  ScanningSystem sys;
  tp03::rotc rotc;
  Words<4> d;
  Bits<8> m;

  Fault scan(bit condition = on) {
    sys.scan();
    return rotc.run(condition, d.block(0), 10, 2, m.run(0), sys);
  }
  /// The phases through which the table goes forward one division, or backward.
  void turn(bool forward) {
    const bool a[] = {true, true, false, false}, b[] = {false, true, true, false};
    for (unsigned i = 0; i < 4; ++i) {
      m[0] = bit(forward ? a[i] : b[i]);
      m[1] = bit(forward ? b[i] : a[i]);
      EXPECT_EQ(scan(), Fault::None);
    }
  }
  /// Which of D + 3 to D + 7 is ON, or -1.
  int output() {
    int result = -1, count = 0;
    for (unsigned i = 3; i < 8; ++i)
      if (m[i]) {
        result = static_cast<int>(i);
        ++count;
      }
    EXPECT_LE(count, 1);
    return result;
  }
};
}  // namespace

TEST(Tp03Rotc, TurnsTheShorterWay) {
  Table t;
  t.d[1] = 1;  // window
  t.d[2] = 5;  // item: 4 divisions forward
  t.scan();
  EXPECT_EQ(t.output(), 3);
  t.turn(true);
  EXPECT_EQ(t.output(), 3);
  t.turn(true);
  EXPECT_EQ(t.output(), 4) << "two divisions left";
  t.turn(true);
  t.turn(true);
  EXPECT_EQ(t.d[0], 4);
  EXPECT_EQ(t.output(), 5);
  t.d[2] = 1;  // 4 divisions backward
  t.scan();
  EXPECT_EQ(t.output(), 7);
  t.turn(false);
  t.turn(false);
  EXPECT_EQ(t.output(), 6);
  t.turn(false);
  t.turn(false);
  EXPECT_EQ(t.output(), 5);
  EXPECT_EQ(t.d[0], 0);
  t.turn(false);
  EXPECT_EQ(t.d[0], 9) << "a ring";
  t.turn(true);
  EXPECT_EQ(t.d[0], 0);
  t.d[2] = 6;
  t.scan();
  EXPECT_EQ(t.output(), 3) << "half way round: forward";
}

TEST(Tp03Rotc, TheZeroInputClearsTheCounter) {
  Table t;
  t.scan();
  t.turn(true);
  t.m[2] = on;
  t.scan();
  EXPECT_EQ(t.d[0], 0);
  t.turn(true);
  EXPECT_EQ(t.d[0], 0) << "held";
  t.m[2] = off;
  t.turn(true);
  EXPECT_EQ(t.d[0], 1);
}

TEST(Tp03Rotc, OffStopsEverythingOnce) {
  Table t;
  t.scan();
  EXPECT_EQ(t.output(), 5);
  t.scan(off);
  EXPECT_EQ(t.output(), -1);
  t.m[4] = on;
  t.m[0] = on;
  t.scan(off);
  EXPECT_EQ(t.output(), 4) << "free for others";
  t.scan();
  EXPECT_EQ(t.d[0], 0) << "what moved while it was OFF is not counted";
}

TEST(Tp03Rotc, RefusesWhatDoesNotFit) {
  Table t;
  EXPECT_EQ(t.rotc.run(on, t.d.block(0), 10, 11, t.m.run(0), t.sys), Fault::Range);
  EXPECT_EQ(t.rotc.run(on, t.d.block(0), 1, 1, t.m.run(0), t.sys), Fault::Range);
  EXPECT_EQ(t.rotc.run(on, t.d.block(2), 10, 1, t.m.run(0), t.sys), Fault::Range);
  EXPECT_EQ(t.rotc.run(on, t.d.block(0), 10, 1, t.m.run(1), t.sys), Fault::Range);
  t.d[1] = 10;
  EXPECT_EQ(t.scan(), Fault::Range);
  t.d[1] = 0;
  t.d[2] = -1;
  EXPECT_EQ(t.scan(), Fault::Range);
  EXPECT_EQ(t.scan(off), Fault::None);
  EXPECT_EQ(t.output(), -1);
}
