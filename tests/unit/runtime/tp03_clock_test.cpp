// Times of day and the clock of the TP03.
#include "ladder/image.h"
#include "ladder/tp03/ops/clock.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace ladder;
using tp03::Fault;

namespace {

struct FakeSystem {
  struct Flags {
    bit bits[3] = {off, on, off};  // M8020 to M8022
    bit &operator[](unsigned number) { return bits[number - 8020]; }
  } M;
  Calendar clock{2024, 2, 29, 13, 45, 10, 4};
  bool accepts = true;

  const Calendar &calendar() const { return clock; }
  bool set_calendar(Calendar time) {
    if (accepts)
      clock = time;
    return accepts;
  }
  std::string flags() { return std::string(M[8020] ? "z" : "") + (M[8021] ? "b" : "") + (M[8022] ? "c" : ""); }
};

struct Tp03Clock : testing::Test {
  Words<40> D;
  Bits<4> M;
  FakeSystem sys;

  void set(unsigned first, const std::vector<int> &values) {
    for (unsigned i = 0; i < values.size(); ++i)
      D[first + i] = static_cast<word>(values[i]);
  }
  std::vector<int> get(unsigned first, unsigned count) {
    std::vector<int> values;
    for (unsigned i = 0; i < count; ++i)
      values.push_back(D[first + i]);
    return values;
  }
  /// 1, 0 or -1 by the one of three bits that is ON.
  int which() { return M[0] & !M[1] & !M[2] ? 1 : M[1] & !M[0] & !M[2] ? 0 : M[2] & !M[0] & !M[1] ? -1 : 99; }
};

using Time = std::vector<int>;
const std::vector<Time> kNoTimes = {{24, 0, 0}, {-1, 0, 0}, {0, 60, 0}, {0, -1, 0}, {0, 0, 60}, {0, 0, -32768}};

}  // namespace

TEST_F(Tp03Clock, CompareTimes) {
  const auto compare = [&](const Time &time) {
    set(0, time);
    EXPECT_EQ(tp03::tcmp(10, 30, 50, D.block(0), M.run(0), sys), Fault::None);
    return which();
  };
  EXPECT_EQ(compare({10, 30, 49}), 1);
  EXPECT_EQ(compare({10, 30, 50}), 0);
  EXPECT_EQ(compare({11, 0, 0}), -1);
  EXPECT_EQ(compare({9, 59, 59}), 1);
  EXPECT_EQ(sys.flags(), "b") << "no flags";
}

TEST_F(Tp03Clock, CompareRefusesWhatIsNoTime) {
  for (const Time &bad : kNoTimes) {
    set(0, bad);
    EXPECT_EQ(tp03::tcmp(10, 30, 50, D.block(0), M.run(0), sys), Fault::Range);
    set(0, {10, 0, 0});
    EXPECT_EQ(
        tp03::tcmp(static_cast<word>(bad[0]), static_cast<word>(bad[1]), static_cast<word>(bad[2]), D.block(0), M.run(0), sys),
        Fault::Range);
  }
  EXPECT_EQ(which(), 99) << "nothing written";
}

TEST_F(Tp03Clock, CompareWithAZone) {
  const auto zone = [&](const Time &low, const Time &high, const Time &time) {
    set(20, low);
    set(30, high);
    set(0, time);
    EXPECT_EQ(tp03::tzcp(D.block(20), D.block(30), D.block(0), M.run(0), sys), Fault::None);
    return which();
  };
  const Time morning{8, 0, 0}, evening{17, 30, 0};
  EXPECT_EQ(zone(morning, evening, {7, 59, 59}), 1);
  EXPECT_EQ(zone(morning, evening, {8, 0, 0}), 0);
  EXPECT_EQ(zone(morning, evening, {17, 30, 0}), 0);
  EXPECT_EQ(zone(morning, evening, {17, 30, 1}), -1);
  EXPECT_EQ(zone(evening, morning, {12, 0, 0}), 1) << "the lower limit is both";
  EXPECT_EQ(zone(evening, morning, {17, 30, 0}), 0);
  EXPECT_EQ(zone(evening, morning, {17, 30, 1}), -1);
  for (const unsigned place : {0U, 20U, 30U}) {
    zone(morning, evening, {12, 0, 0});
    for (const Time &bad : kNoTimes) {
      set(place, bad);
      EXPECT_EQ(tp03::tzcp(D.block(20), D.block(30), D.block(0), M.run(0), sys), Fault::Range);
    }
    EXPECT_EQ(which(), 0);
  }
}

TEST_F(Tp03Clock, AddTimes) {
  const auto sum = [&](const Time &a, const Time &b) {
    set(10, a);
    set(20, b);
    EXPECT_EQ(tp03::tadd(D.block(10), D.block(20), D.block(30), sys), Fault::None);
    return get(30, 3);
  };
  EXPECT_EQ(sum({10, 30, 10}, {3, 10, 5}), (Time{13, 40, 15}));
  EXPECT_EQ(sys.flags(), "b") << "M8021 stays";
  EXPECT_EQ(sum({18, 10, 30}, {10, 20, 5}), (Time{4, 30, 35}));
  EXPECT_EQ(sys.flags(), "bc");
  EXPECT_EQ(sum({1, 59, 59}, {0, 0, 1}), (Time{2, 0, 0}));
  EXPECT_EQ(sum({0, 0, 0}, {0, 0, 0}), (Time{0, 0, 0}));
  EXPECT_EQ(sys.flags(), "zb");
  EXPECT_EQ(sum({12, 0, 0}, {12, 0, 0}), (Time{0, 0, 0}));
  EXPECT_EQ(sys.flags(), "zbc");
  EXPECT_EQ(sum({23, 59, 59}, {23, 59, 59}), (Time{23, 59, 58}));
}

TEST_F(Tp03Clock, SubtractTimes) {
  const auto difference = [&](const Time &a, const Time &b) {
    set(10, a);
    set(20, b);
    EXPECT_EQ(tp03::tsub(D.block(10), D.block(20), D.block(30), sys), Fault::None);
    return get(30, 3);
  };
  EXPECT_EQ(difference({10, 30, 10}, {3, 10, 5}), (Time{7, 20, 5}));
  EXPECT_EQ(sys.flags(), "b");
  EXPECT_EQ(difference({5, 20, 40}, {18, 10, 5}), (Time{11, 10, 35}));
  EXPECT_EQ(sys.flags(), "bc");
  EXPECT_EQ(difference({5, 20, 40}, {5, 20, 40}), (Time{0, 0, 0}));
  EXPECT_EQ(sys.flags(), "zb");
  EXPECT_EQ(difference({0, 0, 0}, {0, 0, 1}), (Time{23, 59, 59}));
}

TEST_F(Tp03Clock, SumsRefuseWhatIsNoTime) {
  for (const Time &bad : kNoTimes) {
    for (const unsigned place : {10U, 20U}) {
      set(10, {1, 0, 0});
      set(20, {1, 0, 0});
      set(30, {7, 7, 7});
      set(place, bad);
      EXPECT_EQ(tp03::tadd(D.block(10), D.block(20), D.block(30), sys), Fault::Range);
      EXPECT_EQ(tp03::tsub(D.block(10), D.block(20), D.block(30), sys), Fault::Range);
      EXPECT_EQ(get(30, 3), (Time{7, 7, 7}));
    }
  }
  EXPECT_EQ(sys.flags(), "b");
}

TEST_F(Tp03Clock, TheResultMayReplaceAnOperand) {
  set(10, {23, 0, 0});
  EXPECT_EQ(tp03::tadd(D.block(10), D.block(10), D.block(11), sys), Fault::None);
  EXPECT_EQ(get(10, 4), (std::vector<int>{23, 22, 0, 0}));
}

TEST_F(Tp03Clock, ReadsTheClock) {
  tp03::trd(D.block(0), sys);
  EXPECT_EQ(get(0, 8), (std::vector<int>{2024, 2, 29, 13, 45, 10, 4, 0}));
}

TEST_F(Tp03Clock, SetsTheClock) {
  set(0, {2099, 12, 31, 23, 59, 58, 0});
  EXPECT_EQ(tp03::twr(D.block(0), sys), Fault::None);
  EXPECT_EQ(sys.clock.year, 2099);
  EXPECT_EQ(sys.clock.month, 12);
  EXPECT_EQ(sys.clock.day, 31);
  EXPECT_EQ(sys.clock.hour, 23);
  EXPECT_EQ(sys.clock.minute, 59);
  EXPECT_EQ(sys.clock.second, 58);
  EXPECT_EQ(sys.clock.weekday, 0);
}

TEST_F(Tp03Clock, RefusesDatesThatDoNotExist) {
  const std::vector<std::vector<int>> bad = {{1999, 12, 31, 0, 0, 0, 5}, {2100, 1, 1, 0, 0, 0, 5},  {2023, 2, 29, 0, 0, 0, 3},
                                             {2024, 0, 1, 0, 0, 0, 1},   {2024, 13, 1, 0, 0, 0, 1}, {2024, 4, 31, 0, 0, 0, 3},
                                             {2024, 1, 0, 0, 0, 0, 1},   {2024, 1, 1, 24, 0, 0, 1}, {2024, 1, 1, 0, 60, 0, 1},
                                             {2024, 1, 1, 0, 0, 60, 1},  {2024, 1, 1, 0, 0, 0, 7},  {2024, 1, 1, 0, 0, 0, -1},
                                             {-1, 1, 1, 0, 0, 0, 1},     {2024, -1, 1, 0, 0, 0, 1}, {2024, 1, -32768, 0, 0, 0, 1}};
  for (const auto &time : bad) {
    set(0, time);
    EXPECT_EQ(tp03::twr(D.block(0), sys), Fault::Range);
    EXPECT_EQ(sys.clock.year, 2024);
    EXPECT_EQ(sys.clock.minute, 45);
  }
  set(0, {2024, 1, 1, 0, 0, 0, 1});
  sys.accepts = false;
  EXPECT_EQ(tp03::twr(D.block(0), sys), Fault::Range);
}
