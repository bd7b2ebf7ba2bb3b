// Edges compare with what the same place saw at its last execution.
#include "ladder/edge.h"
#include "ladder/image.h"
#include "printing.h"

#include <gtest/gtest.h>

using namespace ladder;

TEST(Edge, RisingIsOnForOneExecution) {
  Bits<40> edge;
  EXPECT_EQ(rising(edge[35], off), off);
  EXPECT_EQ(rising(edge[35], on), on);
  EXPECT_EQ(rising(edge[35], on), off);
  EXPECT_EQ(rising(edge[35], off), off);
  EXPECT_EQ(rising(edge[35], on), on);
}

TEST(Edge, FallingIsOnForOneExecution) {
  Bits<40> edge;
  EXPECT_EQ(falling(edge[3], off), off);
  EXPECT_EQ(falling(edge[3], on), off);
  EXPECT_EQ(falling(edge[3], on), off);
  EXPECT_EQ(falling(edge[3], off), on);
  EXPECT_EQ(falling(edge[3], off), off);
}

TEST(Edge, FirstExecutionWithOnRises) {
  Bits<1> edge;
  EXPECT_EQ(rising(edge[0], on), on);
}

TEST(Edge, MemoryMayBeADeviceOrABitOfAWord) {
  Words<1> D;
  Bits<1> V;
  EXPECT_EQ(rising(D.bit(0, 9), on), on);
  EXPECT_EQ(D[0], 512);
  EXPECT_EQ(falling(D.bit(0, 9), off), on);
  EXPECT_EQ(D[0], 0);
  EXPECT_EQ(rising(V[0], on), on);
  EXPECT_EQ(static_cast<bit>(V[0]), on);
}

TEST(Edge, SkippedExecutionComparesWithTheLastOne) {
  Bits<1> edge;
  rising(edge[0], on);
  // The state went OFF and ON again while the instruction was not executed.
  EXPECT_EQ(rising(edge[0], on), off);
}
