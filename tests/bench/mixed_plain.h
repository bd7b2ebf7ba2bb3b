// What an engineer without a compiler for lists would write by hand: plain arrays, plain structs, and a function for everything
// that comes more than once. The functions of the program itself are in hand_*.cpp, written by the benchmark.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>

#include "hand_sizes.h"

using Bit = std::uint8_t;

struct HandTimer {
  std::uint32_t rest = 0;  // microseconds beyond the value
  std::int16_t value = 0;
  Bit contact = 0, coil = 0;

  template <unsigned Unit> void measure(bool on, int set, std::uint32_t elapsed) {
    if (!on) {
      coil = 0;
      return;
    }
    if (!coil) {
      coil = 1;
      return;
    }
    if (contact)
      return;
    rest += elapsed;
    int now = value;
    if (rest >= Unit) {
      now += static_cast<int>(rest / Unit);
      rest %= Unit;
    }
    if (now >= set) {
      now = std::max(set, 0);
      contact = 1;
    }
    value = static_cast<std::int16_t>(now);
  }
  template <unsigned Unit> void on_delay(bool on, int set, std::uint32_t elapsed) {
    if (on)
      measure<Unit>(true, set, elapsed);
    else
      *this = HandTimer();
  }
};

struct HandCounter {
  std::int16_t value = 0;
  Bit contact = 0, coil = 0, reset_coil = 0;

  void count(bool on, int set) {
    const bool pulse = on && !coil;
    coil = on;
    if (!pulse || reset_coil || contact)
      return;
    const int last = std::max(set, 1);
    if (value < last)
      ++value;
    if (value >= last) {
      value = static_cast<std::int16_t>(last);
      contact = 1;
    }
  }
  void reset(bool on) {
    reset_coil = on;
    if (on)
      value = contact = 0;
  }
};

struct HandLongCounter {
  std::int32_t value = 0;
  Bit contact = 0, coil = 0, reset_coil = 0;

  void count(bool on, std::int32_t set, bool down) {
    const bool pulse = on && !coil;
    coil = on;
    if (!pulse || reset_coil)
      return;
    const std::int32_t before = value;
    value = static_cast<std::int32_t>(static_cast<std::uint32_t>(value) + (down ? -1U : 1U));
    if (!down && value == set)
      contact = 1;
    else if (down && before == set)
      contact = 0;
  }
  void reset(bool on) {
    reset_coil = on;
    if (on)
      value = contact = 0;
  }
};

struct Hand {
  Bit x[256] = {}, y[256] = {}, m[kHandRelays] = {};
  HandTimer t[512];
  HandCounter c[200];
  HandLongCounter c32[35];  // C200-C234
  Bit down[35] = {};        // M8200-M8234
  std::int16_t d[kHandRegisters] = {};
  Bit zero = 0, borrow = 0, carry = 0;  // M8020-M8022
  Bit failed = 0;                       // M8067
  std::int16_t error = 0;               // D8067

  void scan(std::uint32_t now);

private:
#include "hand_functions.h"

  static bool rising(Bit &memory, bool now) {
    const bool edge = now && !memory;
    memory = now;
    return edge;
  }
  static bool falling(Bit &memory, bool now) {
    const bool edge = !now && memory;
    memory = now;
    return edge;
  }
  std::int16_t flagged(int result) {
    const std::int16_t stored = static_cast<std::int16_t>(result);
    zero = stored == 0;
    borrow = result < -32768;
    carry = result > 32767;
    return stored;
  }
  std::int16_t add(int a, int b) {
    return flagged(a + b);
  }
  std::int16_t sub(int a, int b) {
    return flagged(a - b);
  }
  std::int32_t add32(std::int32_t a, std::int32_t b) {
    std::int32_t sum;
    const bool overflow = __builtin_add_overflow(a, b, &sum);
    zero = sum == 0;
    borrow = overflow && a < 0;
    carry = overflow && a >= 0;
    return sum;
  }
  std::int32_t sub32(std::int32_t a, std::int32_t b) {
    std::int32_t difference;
    const bool overflow = __builtin_sub_overflow(a, b, &difference);
    zero = difference == 0;
    borrow = overflow && a < 0;
    carry = overflow && a >= 0;
    return difference;
  }
  std::int32_t pair(unsigned number) const {
    std::int32_t value;
    std::memcpy(&value, &d[number], sizeof value);
    return value;
  }
  void set_pair(unsigned number, std::int32_t value) {
    std::memcpy(&d[number], &value, sizeof value);
  }
  void divide(int a, int b, unsigned number, std::uint32_t step) {
    if (b == 0) {
      failed = 1;
      error = 6706;
      failed_step = step;
      return;
    }
    divide_by(a, b, number);
    if (failed && failed_step == step)
      failed = 0;
  }
  void divide_by(int a, int b, unsigned number) {
    d[number] = static_cast<std::int16_t>(a / b);
    d[number + 1] = static_cast<std::int16_t>(a % b);
  }
  void compare(int a, int b, unsigned relay) {
    m[relay] = a > b;
    m[relay + 1] = a == b;
    m[relay + 2] = a < b;
  }
  void zone(int low, int high, int value, unsigned relay) {
    high = std::max(high, low);
    m[relay] = value < low;
    m[relay + 1] = value >= low && value <= high;
    m[relay + 2] = value > high;
  }

  Bit edge[kHandEdges] = {};
  Bit pulse_edge[kHandPulses];  // of P forms: ON at power-on, so that none acts in the first scan
  std::uint32_t last_now = 0, elapsed = 0, failed_step = 0;
  bool timed = false;

public:
  Hand() {
    std::fill(std::begin(pulse_edge), std::end(pulse_edge), Bit(1));
  }
};
