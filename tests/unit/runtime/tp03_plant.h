// A TP03 without a list: tests write what a generated program would be.
#pragma once

#include "ladder/numbered.h"
#include "ladder/tp03/system.h"
#include "printing.h"

#include <map>

namespace tp03_plant {

using ladder::bit;
using ladder::off;
using ladder::on;
using ladder::word;

struct Plant {
  ladder::tp03::System sys;
  ladder::Bits<32> X, Y;
  ladder::Bits<64> M;
  ladder::Bits<1024> S;
  ladder::tp03::Timers<300> T;
  ladder::Numbered<ladder::tp03::LongCounters<56>, 200> C32;
  ladder::Words<32> D;
  ladder::Micros now = 0;

  explicit Plant(ladder::tp03::Parameters parameters = {{0, 0, 0}}) { sys.power_on(parameters); }
  Plant(const Plant &) = delete;  // comparisons know where it is

  /// One scan of `program`, which runs between the hooks; the clock moves after it.
  template <class Program> bool scan(Program program, ladder::Micros us = 10000) {
    const bool ran = sys.begin_scan(now);
    if (ran) {
      sys.watch_inputs(X);
      sys.begin_timers(T);
      program();
      sys.end_timers(T);
      sys.show_states(S);
      sys.end_scan();
    }
    now += us;
    return ran;
  }
  /// Scans of an empty program.
  bool idle(int count = 1, ladder::Micros us = 10000) {
    bool ran = false;
    for (int i = 0; i < count; ++i)
      ran = scan([] {}, us);
    return ran;
  }
  void set(unsigned input, bool state) { X[input] = bit(state); }
  bit m(unsigned number) const { return sys.M[number]; }
  word d(unsigned number) const { return sys.D[number]; }
};

/// Terminals: what is written before END, and inputs that are known at every moment.
struct Terminals final : ladder::Io {
  std::map<unsigned, bool> outputs;
  std::map<unsigned, int> inputs;
  int writes = 0;

  int input(unsigned number) noexcept override {
    const auto found = inputs.find(number);
    return found == inputs.end() ? -1 : found->second;
  }
  void output(unsigned number, bool state) noexcept override {
    ++writes;
    outputs[number] = state;
  }
};

/// A plant whose program enables one counter.
struct Counting : Plant {
  unsigned number;
  ladder::dword preset;
  bit enable = on;
  Terminals io;

  explicit Counting(unsigned n, ladder::dword set_value = 1000)
      : Plant(ladder::tp03::Parameters{{0, 0, 0}, 0x30}), number(n), preset(set_value) {
    sys.connect(&io);
    run();
  }
  ladder::tp03::LongCounter &counter() { return C32[number]; }
  void run() {
    run([] {});
  }
  template <class Rest> void run(Rest rest) {
    scan([&] {
      sys.enable_high_speed(counter(), number, enable, preset);
      rest();
    });
  }
  void pulse(unsigned input, int count = 1) {
    for (; count > 0; --count) {
      sys.input(input, on);
      sys.input(input, off);
    }
  }
};

}  // namespace tp03_plant
