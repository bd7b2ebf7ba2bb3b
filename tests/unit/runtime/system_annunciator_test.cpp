// Annunciators: registration, removal, refill, error 9000.
#include "plant.h"

#include <gtest/gtest.h>

#include <vector>

using namespace ladder;
using plant::Plant;

namespace {

void expect_list(const Plant &p, const std::vector<word> &numbers) {
  EXPECT_EQ(p.sd(62), numbers.empty() ? 0 : numbers.front());
  EXPECT_EQ(p.sd(63), static_cast<word>(numbers.size()));
  for (unsigned i = 0; i < 16; ++i)
    EXPECT_EQ(p.sd(64 + i), i < numbers.size() ? numbers[i] : 0) << "SD" << 64 + i;
}

void clear_first(Plant &p) {
  p.sys.SD[50] = 9000;
  p.sys.SM[50] = on;
  p.scan();
  p.sys.SM[50] = off;
  p.scan();
}

}  // namespace

TEST(Annunciator, OnIsReportedAndTheCpuGoesOn) {
  Plant p;
  p.scan();
  p.sys.annunciator_set(p.F, 12, 33);
  EXPECT_TRUE(p.F[12]);
  EXPECT_EQ(p.sm(0), on);
  EXPECT_EQ(p.sm(1), off);
  EXPECT_EQ(p.sm(5), on);
  EXPECT_EQ(p.sm(16), on);
  EXPECT_EQ(p.sm(62), on);
  EXPECT_EQ(p.sd(0), 9000);
  EXPECT_EQ(p.hex(4), 0x0604U);
  EXPECT_EQ(p.sd(14), 33);
  EXPECT_EQ(p.sd(16), 12);
  EXPECT_EQ(p.sd(81), 1 << 5);
  EXPECT_EQ(p.sys.status().error, 9000);
  EXPECT_TRUE(p.sys.running());
  EXPECT_TRUE(p.scan());
}

TEST(Annunciator, OutWritesOffWithoutTakingTheEntryOut) {
  Plant p;
  p.sys.annunciator_out(p.F, 7, on);
  p.sys.annunciator_out(p.F, 7, on);
  expect_list(p, {7});
  p.sys.annunciator_out(p.F, 7, off);
  EXPECT_FALSE(p.F[7]);
  expect_list(p, {7});
  EXPECT_EQ(p.sm(62), on);
  p.sys.annunciator_out(p.F, 7, on);
  EXPECT_TRUE(p.F[7]);
  expect_list(p, {7});
  p.sys.annunciator_out(p.F, 7, off);
  p.sys.annunciator_reset(p.F, 7);
  expect_list(p, {});
  EXPECT_EQ(p.sm(62), off);
  EXPECT_EQ(p.sm(0), on) << "the error stays reported";
}

TEST(Annunciator, SteadyOnIsReportedOnce) {
  Plant p;
  p.sys.annunciator_set(p.F, 1);
  p.sys.annunciator_set(p.F, 2);
  p.sys.annunciator_set(p.F, 1);
  EXPECT_EQ(p.sd(16), 2);
  expect_list(p, {1, 2});
}

TEST(Annunciator, TableOfTwelve) {
  Plant p;
  p.sys.annunciator_set(p.F, 50);
  p.sys.annunciator_set(p.F, 25);
  p.sys.annunciator_set(p.F, 99);
  expect_list(p, {50, 25, 99});
  p.sys.annunciator_reset(p.F, 25);
  expect_list(p, {50, 99});
  for (const unsigned number : {15U, 70U, 65U, 38U, 110U, 151U, 210U})
    p.sys.annunciator_set(p.F, number);
  expect_list(p, {50, 99, 15, 70, 65, 38, 110, 151, 210});
  p.sys.annunciator_reset(p.F, 50);
  expect_list(p, {99, 15, 70, 65, 38, 110, 151, 210});
}

TEST(Annunciator, SeventeenthIsOnButNotListed) {
  Plant p;
  std::vector<word> expected;
  for (word number = 100; number < 116; ++number) {
    p.sys.annunciator_set(p.F, static_cast<unsigned>(number));
    expected.push_back(number);
  }
  p.sys.annunciator_set(p.F, 116);
  EXPECT_TRUE(p.F[116]);
  EXPECT_EQ(p.sd(16), 116) << "reported all the same";
  expect_list(p, expected);
}

TEST(Annunciator, FreedPlaceGoesToTheLowestUnlisted) {
  Plant p;
  for (unsigned number = 100; number < 116; ++number)
    p.sys.annunciator_set(p.F, number);
  p.sys.annunciator_set(p.F, 900);
  p.sys.annunciator_set(p.F, 30);
  p.sys.annunciator_reset(p.F, 100);
  expect_list(p, {101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 30});
  p.sys.annunciator_reset(p.F, 110);
  expect_list(p, {101, 102, 103, 104, 105, 106, 107, 108, 109, 111, 112, 113, 114, 115, 30, 900});
  p.sys.annunciator_reset(p.F, 30);
  expect_list(p, {101, 102, 103, 104, 105, 106, 107, 108, 109, 111, 112, 113, 114, 115, 900});
}

TEST(Annunciator, ResettingAnUnlistedOneLeavesTheList) {
  Plant p;
  for (unsigned number = 0; number < 17; ++number)
    p.sys.annunciator_set(p.F, number);
  p.sys.annunciator_reset(p.F, 16);
  EXPECT_FALSE(p.F[16]);
  expect_list(p, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
}

TEST(Annunciator, ErrorResetClearsTheOldestOnly) {
  Plant p;
  p.scan();
  p.sys.annunciator_set(p.F, 5);
  p.sys.annunciator_set(p.F, 6);
  clear_first(p);
  EXPECT_FALSE(p.F[5]);
  EXPECT_TRUE(p.F[6]);
  expect_list(p, {6});
  EXPECT_EQ(p.sm(0), on) << "F6 is still reported";
  EXPECT_EQ(p.sd(0), 9000);
  EXPECT_EQ(p.sd(16), 6);
  clear_first(p);
  EXPECT_FALSE(p.F[6]);
  expect_list(p, {});
  EXPECT_EQ(p.sm(0), off);
  EXPECT_EQ(p.sm(62), off);
  EXPECT_EQ(p.sd(0), 0);
  EXPECT_EQ(p.sd(81), 0);
  EXPECT_EQ(p.sys.status().error, 0);
}

TEST(Annunciator, ErrorResetAfterTheListIsEmpty) {
  Plant p;
  p.sys.annunciator_set(p.F, 5);
  p.sys.annunciator_reset(p.F, 5);
  EXPECT_EQ(p.sd(0), 9000);
  clear_first(p);
  EXPECT_EQ(p.sd(0), 0);
  EXPECT_EQ(p.sm(0), off);
}

TEST(Annunciator, ErrorResetLeavesTheLastReportAlone) {
  Plant p;
  p.scan();
  for (unsigned number = 5; number <= 7; ++number)
    p.sys.annunciator_set(p.F, number);
  clear_first(p);
  expect_list(p, {6, 7});
  EXPECT_EQ(p.sd(0), 9000);
  EXPECT_EQ(p.sd(16), 7) << "F7 came last";
}

TEST(Annunciator, ClearingTheLastErrorShowsNone) {
  Plant p;
  p.scan();
  p.sys.scan_time_error(25000);
  p.sys.annunciator_set(p.F, 5);
  EXPECT_EQ(p.sm(1), on) << "left alone by the annunciator";
  clear_first(p);
  EXPECT_EQ(p.sm(0), off);
  EXPECT_EQ(p.sm(1), off);
  EXPECT_EQ(p.sd(0), 0);
  EXPECT_EQ(p.sd(81), 1 << 4) << "the scan time error is not cleared";
}

TEST(Annunciator, ClearingTheEarlierErrorChangesNothingElse) {
  Plant p;
  p.scan();
  p.sys.annunciator_set(p.F, 5);
  p.sys.scan_time_error(25000);
  clear_first(p);
  EXPECT_EQ(p.sm(0), on);
  EXPECT_EQ(p.sm(1), on);
  EXPECT_EQ(p.sd(0), 5010);
  EXPECT_EQ(p.sd(81), 1 << 4);
}

TEST(Annunciator, AProgramWithoutAnnunciatorsClearsToo) {
  melsec_qs::System<> sys;
  sys.power_on(plant::kParameters);
  ASSERT_TRUE(sys.begin_scan(0));
  sys.SD[50] = 9000;
  sys.SM[50] = on;
  sys.end_scan();
  EXPECT_TRUE(sys.running());
  EXPECT_EQ(sys.SD[63], 0);
}

TEST(Annunciator, SpoiltCountDoesNoHarm) {
  Plant p;
  p.sys.annunciator_set(p.F, 3);
  p.sys.SD[63] = 32767;
  p.sys.annunciator_set(p.F, 4);
  EXPECT_TRUE(p.F[4]);
  p.sys.SD[63] = -5;
  p.sys.annunciator_set(p.F, 9);
  EXPECT_EQ(p.sd(63), 1);
  EXPECT_EQ(p.sd(64), 9);
}
