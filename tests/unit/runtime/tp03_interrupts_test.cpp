// Interrupt requests of the TP03: order, waiting places, masks, timers.
#include "tp03_plant.h"

#include <gtest/gtest.h>

#include <vector>

using namespace ladder;
using tp03::Parameters;
using tp03_plant::Plant;

namespace {

/// The routines that would run now, in their order.
std::vector<int> routines(Plant &p) {
  std::vector<int> result;
  for (int pointer; (pointer = p.sys.next_interrupt()) >= 0;)
    result.push_back(pointer);
  return result;
}

using Routines = std::vector<int>;

/// What runs at the beginning of the next scan.
Routines of_scan(Plant &p, Micros us = 10000) {
  Routines result;
  p.scan([&] { result = routines(p); }, us);
  return result;
}

}  // namespace

TEST(Tp03Interrupts, DisabledAfterTheStart) {
  Plant p;
  p.idle();
  p.set(1, true);
  EXPECT_EQ(of_scan(p), Routines{});
  p.sys.enable_interrupts();
  EXPECT_EQ(routines(p), Routines{101}) << "was held";
  EXPECT_EQ(routines(p), Routines{});
}

TEST(Tp03Interrupts, BothEdgesOfEachInput) {
  Plant p;
  p.sys.enable_interrupts();
  p.idle();
  for (unsigned input = 0; input < 6; ++input) {
    p.set(input, true);
    EXPECT_EQ(of_scan(p), Routines{static_cast<int>(100 * input + 1)});
    EXPECT_EQ(of_scan(p), Routines{});
    p.set(input, false);
    EXPECT_EQ(of_scan(p), Routines{static_cast<int>(100 * input)});
  }
  p.set(6, true);
  EXPECT_EQ(of_scan(p), Routines{});
}

TEST(Tp03Interrupts, OnlyEdgesWithARoutineWait) {
  Plant p(Parameters{{0, 0, 0}, 1U << 5});  // I201
  p.idle();
  for (int i = 0; i < 20; ++i) {
    p.set(0, i % 2 == 0);
    p.idle();
  }
  p.set(2, true);
  p.idle();
  p.set(2, false);
  p.idle();
  p.sys.enable_interrupts();
  EXPECT_EQ(routines(p), Routines{201});
}

TEST(Tp03Interrupts, AnInputThatIsOnAtTheStartIsNoEdge) {
  Plant p;
  p.set(0, true);
  p.sys.enable_interrupts();
  EXPECT_EQ(of_scan(p), Routines{});
  p.sys.set_mode(Mode::Stop);
  p.set(0, false);
  p.idle(2);
  p.sys.set_mode(Mode::Run);
  p.sys.enable_interrupts();
  EXPECT_EQ(of_scan(p), Routines{});
  p.set(0, true);
  EXPECT_EQ(of_scan(p), Routines{1});
}

TEST(Tp03Interrupts, EarlierFirstThenLowerNumber) {
  Plant p;
  p.idle();
  p.set(4, true);
  p.idle();
  p.set(0, true);
  p.set(3, true);
  p.idle();
  p.sys.enable_interrupts();
  EXPECT_EQ(routines(p), (Routines{401, 1, 301}));
}

TEST(Tp03Interrupts, EightWait) {
  Plant p;
  p.idle();
  for (unsigned i = 1; i <= 10; ++i)
    p.sys.raise(100 * (i % 6));
  p.sys.enable_interrupts();
  EXPECT_EQ(routines(p), (Routines{100, 200, 300, 400, 500, 0, 100, 200}));
}

TEST(Tp03Interrupts, RequestsOfARoutineFollowIt) {
  Plant p;
  p.idle();
  p.sys.enable_interrupts();
  p.sys.raise(10);
  EXPECT_FALSE(p.sys.routine_running());
  EXPECT_EQ(p.sys.next_interrupt(), 10);
  EXPECT_TRUE(p.sys.routine_running());
  p.sys.raise(20);
  p.sys.raise(30);
  EXPECT_EQ(p.sys.next_interrupt(), 20);
  EXPECT_EQ(p.sys.next_interrupt(), 30);
  EXPECT_EQ(p.sys.next_interrupt(), -1);
  EXPECT_FALSE(p.sys.routine_running());
}

TEST(Tp03Interrupts, DiHoldsAgain) {
  Plant p;
  p.idle();
  p.sys.enable_interrupts();
  p.sys.disable_interrupts();
  p.sys.raise(1);
  EXPECT_EQ(routines(p), Routines{});
  p.sys.enable_interrupts();
  EXPECT_EQ(routines(p), Routines{1});
}

TEST(Tp03Interrupts, MasksRefuseRequests) {
  Plant p(Parameters{{10, 20, 30}});
  p.sys.enable_interrupts();
  p.idle();
  const unsigned pointers[] = {0, 1, 100, 201, 301, 400, 501, 610, 720, 830, 10, 20, 60};
  const unsigned relays[] = {8050, 8050, 8051, 8052, 8053, 8054, 8055, 8056, 8057, 8058, 8059, 8059, 8059};
  for (unsigned i = 0; i < 13; ++i) {
    p.sys.M[relays[i]] = on;
    p.sys.raise(pointers[i]);
    EXPECT_EQ(routines(p), Routines{}) << pointers[i];
    p.sys.M[relays[i]] = off;
    EXPECT_EQ(routines(p), Routines{}) << "refused, not held: " << pointers[i];
    p.sys.raise(pointers[i]);
    EXPECT_EQ(routines(p), Routines{static_cast<int>(pointers[i])});
  }
}

TEST(Tp03Interrupts, StopForgetsThem) {
  Plant p;
  p.idle();
  p.sys.enable_interrupts();
  p.sys.raise(1);
  p.sys.set_mode(Mode::Stop);
  EXPECT_EQ(p.sys.next_interrupt(), -1);
  p.sys.raise(1);
  p.sys.set_mode(Mode::Run);
  p.sys.enable_interrupts();
  EXPECT_EQ(of_scan(p), Routines{});
}

TEST(Tp03Interrupts, TimersEveryPeriod) {
  Plant p(Parameters{{10, 0, 25}});
  p.sys.enable_interrupts();
  EXPECT_EQ(of_scan(p), Routines{});
  EXPECT_EQ(of_scan(p), Routines{610});         // 10 ms
  EXPECT_EQ(of_scan(p), Routines{610});         // 20
  EXPECT_EQ(of_scan(p), (Routines{825, 610}));  // 30
  EXPECT_EQ(of_scan(p, 5000), Routines{610});   // 40
  EXPECT_EQ(of_scan(p, 3000), Routines{});      // 45
  EXPECT_EQ(of_scan(p, 2000), Routines{});      // 48
  EXPECT_EQ(of_scan(p), (Routines{610, 825}));  // 50: at one time the lower number first
}

TEST(Tp03Interrupts, ALongScanServesEveryPeriod) {
  Plant p(Parameters{{10, 15, 0}});
  p.sys.enable_interrupts();
  of_scan(p, 60000);
  EXPECT_EQ(of_scan(p, 200000), (Routines{610, 715, 610, 610, 715, 610, 715, 610, 610, 715}));
  EXPECT_EQ(of_scan(p).size(), 20u + 13u) << "more than could wait";
  EXPECT_EQ(of_scan(p).size(), 1u + 1u);
}

TEST(Tp03Interrupts, TimersComeBeforeTheEdgesOfTheirScan) {
  Plant p(Parameters{{10, 0, 0}});
  p.sys.enable_interrupts();
  p.idle();
  p.idle();  // nobody asks, the request waits
  p.set(0, true);
  EXPECT_EQ(of_scan(p), (Routines{610, 610, 1}));
  p.sys.disable_interrupts();
  p.set(0, false);
  p.idle();
  p.idle();
  p.sys.enable_interrupts();
  EXPECT_EQ(routines(p), (Routines{610, 0, 610}));
}

TEST(Tp03Interrupts, HeldTimersAreLimited) {
  Plant p(Parameters{{10, 0, 0}});
  p.idle(100);
  p.sys.enable_interrupts();
  EXPECT_EQ(routines(p), Routines(8, 610));
  EXPECT_EQ(of_scan(p), Routines{610});
}

TEST(Tp03Interrupts, InhibitedTimersKeepTheirRhythm) {
  Plant p(Parameters{{20, 0, 0}});
  p.sys.enable_interrupts();
  p.sys.M[8056] = on;
  for (int i = 0; i < 6; ++i)
    EXPECT_EQ(of_scan(p), Routines{});
  p.sys.M[8056] = off;
  EXPECT_EQ(of_scan(p), Routines{620}) << "60 ms";
  EXPECT_EQ(of_scan(p), Routines{});
  EXPECT_EQ(of_scan(p), Routines{620});
}

TEST(Tp03Interrupts, LongestElapsedTimeEnds) {
  Plant p(Parameters{{99, 0, 0}});
  p.idle();
  p.now += 4294967295U - 20000;
  p.idle();
  p.sys.enable_interrupts();
  EXPECT_EQ(routines(p), Routines(8, 699));
}
