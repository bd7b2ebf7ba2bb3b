// F88 PID in a closed loop: a process of first order with dead time, run in scans, and automatic tuning of it.
#include "ladder/image.h"
#include "ladder/tp03/ops/pid.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <deque>

using namespace ladder;
using tp03::Fault;

namespace {

constexpr double kScan = 0.1;  // seconds

struct FakeSystem {
  std::uint32_t now = 0;
  std::uint32_t now_us() const { return now; }
  static std::uint32_t elapsed_us() { return 100'000; }
  static bit first_scan() { return off; }
  static bool routine_running() { return false; }
};

/// T dy/dt = gain u(t - dead) - y
struct Process {
  double gain, time_constant, dead_time;
  double value = 0;
  std::deque<double> pipe{};
  void step(double input) {
    pipe.push_back(input);
    if (static_cast<double>(pipe.size()) <= dead_time / kScan)
      return;
    value += (1 - std::exp(-kScan / time_constant)) * (gain * pipe.front() - value);
    pipe.pop_front();
  }
};

/// PID D0 D1 D100 D150 around a process.
struct Plant {
  Words<200> D;
  FakeSystem sys;
  tp03::Pid pid;
  Process process;
  Fault fault = Fault::None;
  word highest = 0;
  double strongest = 32767;  ///< what the output can do

  explicit Plant(Process p) : process(p) {
    const word parameters[] = {500, 1, 0, 400, 60, 10, 150};
    for (unsigned i = 0; i < 7; ++i)
      D[100 + i] = parameters[i];
  }
  void run(double seconds) {
    for (double t = 0; t < seconds - kScan / 2; t += kScan) {
      D[1] = static_cast<word>(std::lround(process.value));
      highest = D[1] > highest ? D[1] : highest;
      fault = pid.run(on, D[0], D[1], D.block(100), D[150], D[150], sys);
      process.step(D[150] < strongest ? D[150] : strongest);
      sys.now += 100'000;
    }
  }
};

const Process kOven{2, 20, 3};

}  // namespace

TEST(Tp03PidLoop, SettlesAtTheSetValue) {
  Plant plant(kOven);
  plant.D[103] = 200;
  plant.D[104] = 150;
  plant.run(1);
  plant.D[0] = 1000;
  plant.run(120);
  EXPECT_NEAR(plant.D[1], 1000, 2);
  EXPECT_NEAR(plant.D[150], 500, 3);
  EXPECT_LT(plant.highest, 1300);
  plant.process.gain = 1.8;  // a disturbance
  plant.run(120);
  EXPECT_NEAR(plant.D[1], 1000, 2);
  EXPECT_NEAR(plant.D[150], 556, 3);
  EXPECT_EQ(plant.fault, Fault::None);
}

TEST(Tp03PidLoop, ForwardActionCools) {
  Plant plant(Process{-1, 10, 1});
  plant.D[101] = 0;
  plant.D[103] = 200;
  plant.D[104] = 100;
  plant.D[106] = 0;
  plant.run(1);
  plant.D[0] = -400;
  plant.run(200);
  EXPECT_NEAR(plant.D[1], -400, 2);
  EXPECT_NEAR(plant.D[150], 400, 3);
}

TEST(Tp03PidLoop, LimitsKeepTheIntegralFromWindingUp) {
  const auto output_after_a_long_deviation = [](word action) {
    Plant plant(kOven);
    plant.strongest = 700;
    plant.D[101] = action;
    plant.D[103] = 200;
    plant.D[104] = 150;
    plant.D[122] = 700;
    plant.D[123] = 0;
    plant.run(1);
    plant.D[0] = 1600;  // out of reach
    plant.run(300);
    EXPECT_NEAR(plant.D[1], 1400, 2);
    plant.D[0] = 1300;
    plant.run(1);
    return plant.D[150];
  };
  EXPECT_LT(output_after_a_long_deviation(33), 700) << "leaves the limit with the first sample";
  EXPECT_GT(output_after_a_long_deviation(1), 5000) << "without limits it has to come down first";
}

TEST(Tp03PidLoop, TuningFindsTheProcess) {
  Plant plant(kOven);
  plant.D[101] = 16;  // the direction is found too
  plant.D[103] = 0;
  plant.D[0] = 1500;
  plant.D[150] = 1000;
  double seconds = 0;
  while ((plant.D[101] & 16) != 0 && seconds < 60) {
    EXPECT_EQ(plant.D[150], 1000) << "the step";
    plant.run(0.5);
    seconds += 0.5;
    EXPECT_EQ(plant.fault, Fault::None);
  }
  // 500 of 2000 (1 - e^(-t/20)) are reached after 5.8 s and the dead time.
  EXPECT_NEAR(seconds, 9.3, 1);
  EXPECT_EQ(plant.D[101], 1) << "reverse, tuning ended";
  // R is 2 x 1000 / 20 per second, L 3 s, of which one sample may be wrong.
  EXPECT_NEAR(plant.D[103], 120 * 1000 / (100 * 3), 60);
  EXPECT_NEAR(plant.D[104], 20 * 3, 8);
  EXPECT_NEAR(plant.D[106], 50 * 3, 20);
  plant.run(120);
  EXPECT_NEAR(plant.D[1], 1500, 3);
  EXPECT_NEAR(plant.D[150], 750, 20) << "whole numbers of the input make the derivative part uneasy";
}

TEST(Tp03PidLoop, TuningFindsForwardAction) {
  Plant plant(Process{-2, 20, 3});
  plant.D[101] = 17;
  plant.D[0] = -1500;
  plant.D[150] = 1000;
  plant.run(30);
  EXPECT_EQ(plant.D[101], 0);
  plant.run(120);
  EXPECT_NEAR(plant.D[1], -1500, 3);
}

TEST(Tp03PidLoop, TuningWithoutAStepOrAWayFails) {
  Plant plant(kOven);
  plant.D[101] = 17;
  plant.D[0] = 1000;
  plant.run(kScan);
  EXPECT_EQ(plant.fault, tp03::pid::kTuningResult) << "output 0";
  EXPECT_EQ(plant.D[101], 1);
  plant.run(2);
  EXPECT_EQ(plant.fault, tp03::pid::kTuningResult) << "shown while ON";
  EXPECT_EQ(plant.pid.run(off, 0, 0, plant.D.block(100), 0, plant.D[150], plant.sys), Fault::None);

  plant.D[101] = 17;
  plant.D[0] = plant.D[1];
  plant.D[150] = 500;
  plant.run(kScan);
  EXPECT_EQ(plant.fault, tp03::pid::kTuningResult) << "no distance";
}

TEST(Tp03PidLoop, TuningTellsTheWrongDirection) {
  Plant plant(Process{-2, 20, 3});
  plant.D[101] = 17;
  plant.D[0] = 1500;
  plant.D[150] = 1000;
  plant.run(10);
  EXPECT_EQ(plant.fault, tp03::pid::kTuningDirection);
  EXPECT_EQ(plant.D[101], 17) << "goes on";
  EXPECT_EQ(plant.D[103], 400);
  plant.pid.run(off, 0, 0, plant.D.block(100), 0, plant.D[150], plant.sys);
  plant.D[150] = -1000;
  plant.run(60);
  EXPECT_EQ(plant.fault, Fault::None) << "put right";
  EXPECT_EQ(plant.D[101], 0) << "an output that falls for the value to rise: forward";
}

TEST(Tp03PidLoop, TuningEndsWhereTheValueGoesUpAndDown) {
  Plant plant(kOven);
  plant.D[101] = 17;
  plant.D[0] = 1500;
  plant.D[150] = 1000;
  plant.run(6);
  plant.process.value = 400;
  plant.run(1);
  plant.process.value = 200;
  plant.run(1);
  EXPECT_EQ(plant.fault, tp03::pid::kTuningRestless);
  EXPECT_EQ(plant.D[101], 1);
  EXPECT_EQ(plant.D[103], 400) << "the parameters stay";
}

TEST(Tp03PidLoop, TuningCanBeCalledOff) {
  Plant plant(kOven);
  plant.D[101] = 17;
  plant.D[0] = 1500;
  plant.D[150] = 100;
  plant.run(3);
  plant.D[101] = 1;
  plant.run(kScan);
  EXPECT_EQ(plant.D[150], 100) << "control begins without a jump";
  plant.run(1);
  EXPECT_GT(plant.D[150], 100);
}
