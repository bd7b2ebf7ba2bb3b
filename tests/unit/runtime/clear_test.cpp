// Clearing a part of a device class, as power-on does where the parameters latch the rest.
#include "ladder/counter.h"
#include "ladder/image.h"
#include "ladder/timer.h"
#include "printing.h"

#include <gtest/gtest.h>

using namespace ladder;

TEST(ClearPart, BitsOutsideKeepTheirState) {
  Bits<70> M;
  for (unsigned i = 0; i < 70; ++i)
    M[i] = on;
  M.clear(30, 65);  // across two packed cells
  for (unsigned i = 0; i < 70; ++i)
    EXPECT_EQ(static_cast<bit>(M[i]), bit(i < 30 || i > 65)) << i;
}

TEST(ClearPart, WordsOutsideKeepTheirValue) {
  Words<5> D;
  for (unsigned i = 0; i < 5; ++i)
    D[i] = 7;
  D.clear(1, 1);
  D.clear(3, 4);
  EXPECT_EQ(D[0], 7);
  EXPECT_EQ(D[1], 0);
  EXPECT_EQ(D[2], 7);
  EXPECT_EQ(D[3], 0);
  EXPECT_EQ(D[4], 0);
}

TEST(ClearPart, TimersAndCountersLoseContactCoilAndValue) {
  Timers<2> T;
  Counters<2> C;
  for (unsigned i = 0; i < 2; ++i) {
    T[i].accumulate(on, 1, 1);
    C[i].count_up(on, 1);
  }
  T.clear(0, 0);
  C.clear(1, 1);
  EXPECT_EQ(T[0].contact, off);
  EXPECT_EQ(T[0].value, 0);
  EXPECT_EQ(T[1].contact, on);
  EXPECT_EQ(C[0].contact, on);
  EXPECT_EQ(C[1].contact, off);
  EXPECT_EQ(C[1].coil, off);
}
