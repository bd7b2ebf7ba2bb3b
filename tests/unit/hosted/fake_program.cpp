// The fake's scan and its table. W, SD, S and ST exist in the controller only.
#include "fake_program.h"

#include <chrono>
#include <cstddef>
#include <cstring>
#include <new>

namespace ladder::hosted::test {
namespace {

FakeProgram &self(void *program) {
  return *static_cast<FakeProgram *>(program);
}

void construct(void *memory) {
  new (memory) FakeProgram{};
}

void power_on(void *program) {
  FakeProgram &p = self(program);
  std::int16_t latched = p.D[9];
  p = FakeProgram{};
  p.D[9] = latched;
  p.state = {Mode::Run, true, 0, 0, 0};
}

void set_mode(void *program, Mode mode) {
  self(program).state.mode = mode;
  self(program).state.running = mode == Mode::Run;
}

void stop(FakeProgram &p, std::uint16_t error, std::uint32_t step) {
  p.state.error = error;
  p.state.step = step;
  p.state.running = false;
}

void scan(void *program, Micros now) {
  FakeProgram &p = self(program);
  if (!p.state.running)
    return;
  p.Y[0] = p.X[0];
  p.D[0] = static_cast<std::int16_t>(p.D[0] + p.X[1]);
  p.D[1] = static_cast<std::int16_t>(now / 1000);
  float real = 1.5F;
  std::memcpy(&p.D[2], &real, sizeof real);
  p.T[0].coil = 1;
  p.T[0].contact = ++p.T[0].value >= 3;
  p.Y[1] = p.X[5];
  p.X[5] = 1;
  if (p.X[2] != 0) {
    stop(p, 4100, 8);
    return;
  }
  if (p.X[3] != 0) {
    p.state.error = 9000;
    p.state.step = 12;
  }
  for (auto start = std::chrono::steady_clock::now(); p.X[4] != 0;)
    if (std::chrono::steady_clock::now() - start > std::chrono::milliseconds(3))
      break;
  if (p.X[6] != 0)
    p.state.running = false;
  ++p.state.scans;
}

Status status(const void *program) {
  return static_cast<const FakeProgram *>(program)->state;
}

void set_calendar(void *program, Calendar calendar) {
  self(program).calendar = calendar;
  self(program).D[8] = calendar.weekday;
}

void watchdog(void *program) {
  ++self(program).watchdogs;
  stop(self(program), 5001, 0xFFFF);
}

constexpr DeviceSymbol kDevices[] = {
    {"X", Shape::Bits, 16, true, false, 32, 0x1800, offsetof(FakeProgram, X)},
    {"Y", Shape::Bits, 16, false, true, 16, 0x1800, offsetof(FakeProgram, Y)},
    {"B", Shape::PackedBits, 16, false, false, 40, 0x800, offsetof(FakeProgram, B)},
    {"IB", Shape::PackedBits, 10, true, false, 70, 70, offsetof(FakeProgram, IB)},
    {"S", Shape::Bits, 10, false, false, 0, 100, 0},
    {"SD", Shape::Words, 10, false, false, 0, 5120, 0},
    {"D", Shape::Words, 10, false, false, 10, 6144, offsetof(FakeProgram, D)},
    {"W", Shape::Words, 16, false, false, 0, 0x800, 0},
    {"T", Shape::Timers, 10, false, false, 2, 512, offsetof(FakeProgram, T)},
    {"ST", Shape::Timers, 10, false, false, 0, 16, 0},
    {"C", Shape::Counters, 10, false, false, 2, 512, offsetof(FakeProgram, C)},
    {"L", Shape::Bits, 10, false, false, 0, 0, 0},
};

constexpr DeviceSymbol kOctalDevices[] = {
    {"X", Shape::Bits, 8, true, false, 16, 16, offsetof(FakeProgram, X)},
    {"Y", Shape::Bits, 8, false, true, 16, 16, offsetof(FakeProgram, Y)},
};

constexpr StepSymbol kSteps[] = {{8, 12, "BIN D0 D1"}, {12, 15, "SET F3"}, {20, 19, "END"}};
constexpr ErrorSymbol kErrors[] = {{4100, "OPERATION ERROR"}, {5001, "WDT ERROR"}, {9000, "F****"}};

constexpr ProgramSymbols table(const char *family, const DeviceSymbol *devices, std::uint32_t count) {
  return {.name = "fake",
          .family = family,
          .model = "QS001CPU",
          .list_file = "fake.il",
          .size = sizeof(FakeProgram),
          .alignment = alignof(FakeProgram),
          .instructions = 10,
          .rungs = 4,
          .steps = 21,
          .devices = devices,
          .device_count = count,
          .step_symbols = kSteps,
          .step_symbol_count = std::size(kSteps),
          .errors = kErrors,
          .error_count = std::size(kErrors),
          .construct = construct,
          .power_on = power_on,
          .set_mode = set_mode,
          .scan = scan,
          .status = status,
          .set_calendar = set_calendar,
          .watchdog_us = 2000,
          .watchdog = watchdog};
}

}  // namespace

const ProgramSymbols kFake = table("melsec-qs", kDevices, std::size(kDevices));
const ProgramSymbols kOctal = table("octal", kOctalDevices, std::size(kOctalDevices));

}  // namespace ladder::hosted::test
