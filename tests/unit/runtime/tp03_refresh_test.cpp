// Direct input and output, matrix input, pulse density (F50, F52, F56).
#include "ladder/tp03/ops/highspeed.h"
#include "tp03_plant.h"

#include <gtest/gtest.h>

#include <map>

using namespace ladder;
using tp03::Fault;
using tp03_plant::Counting;
using tp03_plant::Plant;
using tp03_plant::Terminals;

// F50 REF

TEST(Tp03Refresh, RefreshesInputs) {
  Plant p;
  Terminals io;
  p.sys.connect(&io);
  p.X[8] = on;
  io.inputs = {{8, 0}, {9, 1}, {15, 1}, {16, 1}, {7, 1}};
  p.X[10] = on;
  EXPECT_EQ(tp03::refresh_inputs(p.X.run(8), 8, p.sys), Fault::None);
  EXPECT_EQ(bit(p.X[8]), off);
  EXPECT_EQ(bit(p.X[9]), on);
  EXPECT_EQ(bit(p.X[10]), on) << "the host does not know it";
  EXPECT_EQ(bit(p.X[15]), on);
  EXPECT_EQ(bit(p.X[16]) | bit(p.X[7]), off);
  EXPECT_EQ(tp03::refresh_inputs(p.X.run(0), 16, p.sys), Fault::None);
  EXPECT_EQ(bit(p.X[7]), on);
  EXPECT_EQ(tp03::refresh_inputs(p.X.run(8), 16, p.sys), Fault::None);
  EXPECT_EQ(bit(p.X[16]), off) << "X17 is the last";
}

TEST(Tp03Refresh, RefreshesOutputs) {
  Plant p;
  Terminals io;
  p.sys.connect(&io);
  p.Y[3] = on;
  EXPECT_EQ(tp03::refresh_outputs(p.Y.run(0), 16, p.sys), Fault::None);
  EXPECT_EQ(io.outputs.size(), 8u);
  EXPECT_TRUE(io.outputs[3]);
  p.sys.M[8034] = on;
  io.outputs.clear();
  EXPECT_EQ(tp03::refresh_outputs(p.Y.run(0), 8, p.sys), Fault::None);
  EXPECT_EQ(io.outputs.size(), 0u);
}

TEST(Tp03Refresh, RefreshesNothingElse) {
  Plant p;
  for (const word n : {word{0}, word{5}, word{7}, word{9}, word{-8}, word{24}}) {
    EXPECT_EQ(tp03::refresh_inputs(p.X.run(0), n, p.sys), Fault::Range) << n;
    EXPECT_EQ(tp03::refresh_outputs(p.Y.run(0), n, p.sys), Fault::Range) << n;
  }
  EXPECT_EQ(tp03::refresh_inputs(p.X.run(1), 8, p.sys), Fault::Range);
  EXPECT_EQ(tp03::refresh_inputs(p.X.run(16), 8, p.sys), Fault::Range);
  EXPECT_EQ(tp03::refresh_outputs(p.Y.run(8), 8, p.sys), Fault::Range);
}

// F52 MTR

TEST(Tp03Refresh, MatrixIsReadRowByRow) {
  Plant p;
  Terminals io;
  p.sys.connect(&io);
  tp03::ReadMatrix matrix;
  bit drive = on;
  const unsigned keys[] = {0x81, 0x42, 0x3C};
  int completed = 0;
  auto scan = [&] {
    for (unsigned column = 0; column < 3; ++column)
      if (p.Y[4 + column])
        for (unsigned i = 0; i < 8; ++i)
          p.X[16 + i] = bit::lowest_of(keys[column] >> i);
    p.scan([&] { EXPECT_EQ(matrix.run(drive, p.X.run(16), p.Y.run(4), p.M.run(10), 3, p.sys), Fault::None); });
    completed += p.m(8029).value();
  };
  for (int t = 0; t < 60; t += 10) {
    scan();
    for (int column = 0; column < 3; ++column) {
      ASSERT_EQ(bit(p.Y[4 + static_cast<unsigned>(column)]), bit(column == t / 20)) << t;
      ASSERT_EQ(io.outputs[4 + static_cast<unsigned>(column)], column == t / 20) << t;
    }
  }
  EXPECT_EQ(completed, 0);
  scan();
  EXPECT_EQ(completed, 1);
  EXPECT_EQ(bit(p.Y[4]), on) << "begins again";
  for (unsigned column = 0; column < 3; ++column)
    for (unsigned i = 0; i < 8; ++i)
      EXPECT_EQ(bit(p.M[10 + 10 * column + i]), bit::lowest_of(keys[column] >> i)) << column << ' ' << i;
  EXPECT_EQ(bit(p.M[18]) | bit(p.M[19]), off) << "between the rows";
  scan();
  EXPECT_EQ(completed, 1) << "M8029 for one execution";
  drive = off;
  scan();
  EXPECT_EQ(bit(p.Y[4]), off);
  EXPECT_EQ(bit(p.M[10]), on) << "the table stays";
}

TEST(Tp03Refresh, MatrixRowsOfOutputsAreEightApart) {
  Plant p;
  tp03::ReadMatrixToOutputs matrix;
  p.X[3] = on;
  auto program = [&] { EXPECT_EQ(matrix.run(on, p.X.run(0), p.Y.run(0), p.Y.run(8), 2, p.sys), Fault::None); };
  for (int i = 0; i < 5; ++i)
    p.scan(program);
  EXPECT_EQ(bit(p.Y[11]), on);
  EXPECT_EQ(bit(p.Y[19]), on);
  EXPECT_EQ(matrix.run(on, p.X.run(0), p.Y.run(0), p.Y.run(17), 2, p.sys), Fault::Range);
  EXPECT_EQ(matrix.run(on, p.X.run(25), p.Y.run(0), p.Y.run(8), 2, p.sys), Fault::Range);
  EXPECT_EQ(matrix.run(on, p.X.run(0), p.Y.run(31), p.Y.run(8), 2, p.sys), Fault::Range);
}

TEST(Tp03Refresh, MatrixKnowsInputsAtTheMoment) {
  Plant p;
  Terminals io;
  p.sys.connect(&io);
  tp03::ReadMatrix matrix;
  io.inputs = {{16, 1}};
  for (int i = 0; i < 3; ++i)
    p.scan([&] { matrix.run(on, p.X.run(16), p.Y.run(4), p.M.run(10), 2, p.sys); });
  EXPECT_EQ(bit(p.M[10]), on);
}

// F56 SPD

TEST(Tp03Density, DensityInWindows) {
  Counting p(240);
  tp03::PulseDensity density;
  auto scan = [&] { p.scan([&] { EXPECT_EQ(density.run(on, p.X.run(0), 100, p.D.block(4), p.sys), Fault::None); }); };
  p.pulse(0, 5);
  scan();
  EXPECT_EQ(p.D[5], 0) << "counts from here on";
  EXPECT_EQ(p.D[6], 100);
  p.pulse(0, 3);
  scan();
  EXPECT_EQ(p.D[4], 0);
  EXPECT_EQ(p.D[5], 3);
  EXPECT_EQ(p.D[6], 90);
  for (int i = 0; i < 8; ++i)
    scan();
  EXPECT_EQ(p.D[6], 10);
  p.pulse(0);
  scan();
  EXPECT_EQ(p.D[4], 4);
  EXPECT_EQ(p.D[5], 0);
  EXPECT_EQ(p.D[6], 100);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(p.D[4], 4);
    scan();
  }
  EXPECT_EQ(p.D[4], 0);
}

TEST(Tp03Density, DensityOfWindowsShorterThanAScan) {
  Counting p(240);
  tp03::PulseDensity density;
  auto program = [&] { density.run(on, p.X.run(1), 3, p.D.block(0), p.sys); };
  p.scan(program, 10000);
  p.pulse(1, 12);
  p.scan(program, 5000);
  EXPECT_EQ(p.D[0], 4);
  EXPECT_EQ(p.D[2], 2) << "the next window has begun";
  p.pulse(1, 7);
  p.scan(program, 5000);
  EXPECT_EQ(p.D[0], 3) << "two windows";
}

TEST(Tp03Density, DensityStandsStillWhileOff) {
  Counting p(240);
  tp03::PulseDensity density;
  auto scan = [&](bit drive) { p.scan([&] { density.run(drive, p.X.run(0), 20, p.D.block(0), p.sys); }); };
  scan(on);
  p.pulse(0, 7);
  scan(on);
  scan(off);
  p.pulse(0, 50);
  p.idle(20);
  EXPECT_EQ(p.D[1], 7);
  scan(on);
  EXPECT_EQ(p.D[1], 0);
  EXPECT_EQ(p.D[2], 20);
  p.pulse(0, 2);
  p.sys.set_mode(Mode::Stop);
  p.idle(20);
  p.sys.set_mode(Mode::Run);
  scan(on);
  EXPECT_EQ(p.D[0], 0) << "a new window in RUN";
  EXPECT_EQ(p.D[1], 0);
}

TEST(Tp03Density, DensityNeedsItsOperands) {
  Plant p;
  tp03::PulseDensity density;
  EXPECT_EQ(density.run(on, p.X.run(0), 0, p.D.block(0), p.sys), Fault::Range);
  EXPECT_EQ(density.run(on, p.X.run(0), -1, p.D.block(0), p.sys), Fault::Range);
  EXPECT_EQ(density.run(on, p.X.run(6), 10, p.D.block(0), p.sys), Fault::Range);
  EXPECT_EQ(density.run(on, p.X.run(5), 10, p.D.block(30), p.sys), Fault::Range);
  EXPECT_EQ(density.run(off, p.X.run(0), 0, p.D.block(0), p.sys), Fault::None);
}
