// The controller's scan, what acts between scans, and the table.
#include "fake_controller.h"

#include "ladder/io.h"

#include <cstddef>
#include <iterator>
#include <new>

namespace ladder::hosted::test {
namespace {

FakeController &self(void *program) {
  return *static_cast<FakeController *>(program);
}

void construct(void *memory) {
  new (memory) FakeController{};
}

void power_on(void *program) {
  FakeController &p = self(program);
  Io *io = p.io;
  p = FakeController{};
  p.io = io;
  p.state = {Mode::Run, true, 0, 0, 0};
}

void set_mode(void *program, Mode mode) {
  self(program).state.mode = mode;
}

void scan(void *program, Micros) {
  FakeController &p = self(program);
  if (!p.state.running)
    return;
  if (p.io != nullptr) {
    p.io->open_serial(0, {19200, 8, 1, 'N'});
    for (int byte = p.io->read_serial(0); byte >= 0; byte = p.io->read_serial(0)) {
      ++p.D[0];
      p.D[1] = static_cast<std::int16_t>(byte);
      p.io->write_serial(0, static_cast<std::uint8_t>(byte + 1));
      p.state.running &= byte != 'Z';
    }
    p.D[2] = static_cast<std::int16_t>(p.io->potentiometer(1));
    p.D[3] = static_cast<std::int16_t>(p.io->option_input(0));
  }
  ++p.state.scans;
}

Status status(const void *program) {
  return static_cast<const FakeController *>(program)->state;
}

void set_calendar(void *program, Calendar calendar) {
  self(program).calendar = calendar;
  self(program).D[7] = calendar.minute;
  self(program).special_D[0] = static_cast<std::int16_t>(calendar.year);
}

void connect(void *program, Io *io) {
  self(program).io = io;
}

void input(void *program, unsigned number, bool state) {
  FakeController &p = self(program);
  p.D[4] = static_cast<std::int16_t>(number);
  ++p.D[5];
  p.C32[35].value += number == 5 && state;
}

void interrupt(void *program, unsigned pointer) {
  self(program).D[6] = static_cast<std::int16_t>(pointer);
}

/// Places in kDevices.
enum : std::uint32_t { kClassV = 8 };

constexpr DeviceSymbol kDevices[] = {
    {"X", Shape::Bits, 8, true, false, 16, 256, offsetof(FakeController, X)},
    {"Y", Shape::Bits, 8, false, true, 16, 256, offsetof(FakeController, Y)},
    {"M", Shape::Bits, 10, false, false, 10, 7680, offsetof(FakeController, M)},
    {"M", Shape::Bits, 10, false, false, 8, 512, offsetof(FakeController, special_M), 8000, 1},
    {"S", Shape::PackedBits, 10, false, false, 40, 50, offsetof(FakeController, packed_S), 100},
    {"D", Shape::Words, 10, false, false, 4, 512, offsetof(FakeController, special_D), 8000, 2},
    {"D", Shape::Words, 10, false, false, 10, 8000, offsetof(FakeController, D), 0, 2},
    {"Z", Shape::Words, 10, false, false, 4, 16, offsetof(FakeController, Z), 0, 2, kClassV},
    {"V", Shape::Words, 10, false, false, 4, 16, offsetof(FakeController, V), 0, 2},
    {"T", Shape::Timers, 10, false, false, 3, 512, offsetof(FakeController, T), 0, sizeof(WideTimer)},
    {"C", Shape::Counters, 10, false, false, 3, 200, offsetof(FakeController, C), 0, sizeof(WideCounter)},
    {"C", Shape::LongCounters, 10, false, false, 40, 56, offsetof(FakeController, C32), 200, sizeof(LongCounter)},
};

}  // namespace

const ProgramSymbols kController = {.name = "controller",
                                    .family = "tp03",
                                    .model = "TP03H",
                                    .list_file = "controller.il",
                                    .size = sizeof(FakeController),
                                    .alignment = alignof(FakeController),
                                    .instructions = 10,
                                    .rungs = 4,
                                    .steps = 21,
                                    .devices = kDevices,
                                    .device_count = std::size(kDevices),
                                    .step_symbols = nullptr,
                                    .step_symbol_count = 0,
                                    .errors = nullptr,
                                    .error_count = 0,
                                    .construct = construct,
                                    .power_on = power_on,
                                    .set_mode = set_mode,
                                    .scan = scan,
                                    .status = status,
                                    .set_calendar = set_calendar,
                                    .watchdog_us = 0,
                                    .watchdog = nullptr,
                                    .connect = connect,
                                    .input = input,
                                    .interrupt = interrupt};

}  // namespace ladder::hosted::test
