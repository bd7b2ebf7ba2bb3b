// Runs the program that ladderc wrote and the one written by hand side by side: first to see that they do the same, with new random
// inputs, settings and times in every scan, then in turns against the clock.
#include "mixed.h"
#include "mixed_plain.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

namespace {

plant::Mixed generated;
Hand hand;
std::uint32_t state = 1;
std::uint32_t now = 0;

std::uint32_t random_number() {
  state ^= state << 13;
  state ^= state >> 17;
  state ^= state << 5;
  return state;
}
bool random_bit() {
  return random_number() >> 31;
}

/// Sets a register of both.
void set_register(unsigned number, int value) {
  hand.d[number] = static_cast<std::int16_t>(value);
  if (number < generated.D.kPoints)
    generated.D[number] = static_cast<std::int16_t>(value);
}

/// Some inputs of both change. All of them, where `one_in` is 1.
void change_inputs(unsigned one_in) {
  for (unsigned i = 0; i < generated.X.kPoints; ++i) {
    if (one_in > 1 && random_number() % one_in != 0)
      continue;
    const bool on = random_bit();
    generated.X[i] = ladder::bit(on);
    hand.x[i] = on;
  }
}

void power_on() {
  new (&generated) plant::Mixed{};
  new (&hand) Hand;
  generated.power_on();
  now = 0;
  for (unsigned i = 0; i < 900; ++i)
    set_register(i, static_cast<int>(random_number() % 2000) - 1000);
  for (unsigned i = 900; i < 1000; ++i)
    set_register(i, 2 + static_cast<int>(random_number() % 50));
}

[[noreturn]] void differs(const char *what, unsigned number, long a, long b) {
  std::printf("differs: %s%u is %ld in the generated program and %ld by hand, %u us after power-on\n", what, number, a, b, now);
  std::exit(1);
}
void expect(const char *what, unsigned number, long a, long b) {
  if (a != b)
    differs(what, number, a, b);
}

void compare() {
  for (unsigned i = 0; i < generated.Y.kPoints; ++i)
    expect("Y", i, bool(generated.Y[i]), hand.y[i]);
  for (unsigned i = 0; i < generated.M.kPoints && i < kHandRelays; ++i)
    expect("M", i, bool(generated.M[i]), hand.m[i]);
  for (unsigned i = 0; i < generated.D.kPoints; ++i)
    expect("D", i, generated.D[i], hand.d[i]);
  for (unsigned i = 0; i < generated.T.kPoints; ++i) {
    expect("value of T", i, generated.T[i].value, hand.t[i].value);
    expect("contact of T", i, bool(generated.T[i].contact), hand.t[i].contact);
    expect("coil of T", i, bool(generated.T[i].coil), hand.t[i].coil);
  }
  for (unsigned i = 0; i < generated.C.kPoints; ++i) {
    expect("value of C", i, generated.C[i].value, hand.c[i].value);
    expect("contact of C", i, bool(generated.C[i].contact), hand.c[i].contact);
    expect("reset coil of C", i, bool(generated.C[i].reset_coil), hand.c[i].reset_coil);
  }
  for (unsigned i = 200; i < 200 + generated.C32.kPoints && i < 235; ++i) {
    expect("value of C", i, generated.C32[i].value, hand.c32[i - 200].value);
    expect("contact of C", i, bool(generated.C32[i].contact), hand.c32[i - 200].contact);
    expect("reset coil of C", i, bool(generated.C32[i].reset_coil), hand.c32[i - 200].reset_coil);
  }
  expect("M", 8020, bool(generated.sys.M[8020]), hand.zero);
  expect("M", 8021, bool(generated.sys.M[8021]), hand.borrow);
  expect("M", 8022, bool(generated.sys.M[8022]), hand.carry);
  expect("M", 8067, bool(generated.sys.M[8067]), hand.failed);
  expect("D", 8067, generated.sys.D[8067], hand.error);
}

/// Every scan with other inputs. Settings change too, divisors to 0 among them, and times up to some units of the slowest timers.
void check(unsigned scans) {
  power_on();
  unsigned failed = 0;
  for (unsigned i = 0; i < scans; ++i) {
    change_inputs(i % 50 == 0 ? 1 : 20);
    if (random_number() % 8 == 0)
      set_register(900 + random_number() % 50, random_bit() ? 0 : 1 + static_cast<int>(random_number() % 20));
    if (random_number() % 8 == 0)
      set_register(950 + random_number() % 50, static_cast<int>(random_number() % 40) - 2);
    for (unsigned n = 200; n < 235; ++n) {
      const bool down = random_number() % 4 == 0;
      generated.sys.M[8000 + n] = ladder::bit(down);
      hand.down[n - 200] = down;
    }
    now += random_number() % (i % 10 == 0 ? 300000 : 4000);
    generated.scan(now);
    hand.scan(now);
    compare();
    failed += hand.failed;
  }
  std::printf("checked_scans %u\nscans_with_error %u\n", scans, failed);
}

constexpr unsigned kScans = 50;

/// Nanoseconds per scan.
template <class Scan> double turn(std::uint32_t from, Scan scan) {
  const auto start = std::chrono::steady_clock::now();
  for (unsigned i = 1; i <= kScans; ++i) {
    scan(from + i * 1000);
    asm volatile("" ::: "memory");
  }
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count() / kScans;
}

void measure(unsigned rounds) {
  power_on();
  std::vector<double> a, b, ratio;
  for (unsigned round = 0; round < rounds; ++round) {
    change_inputs(20);
    double first, second;
    // Who is first changes, because the second finds the caches in another state.
    if (round % 2 == 0) {
      first = turn(now, [](std::uint32_t t) { generated.scan(t); });
      second = turn(now, [](std::uint32_t t) { hand.scan(t); });
    } else {
      second = turn(now, [](std::uint32_t t) { hand.scan(t); });
      first = turn(now, [](std::uint32_t t) { generated.scan(t); });
    }
    now += kScans * 1000;
    compare();
    if (round < rounds / 20)
      continue;
    a.push_back(first);
    b.push_back(second);
    ratio.push_back(first / second);
  }
  const auto median = [](std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + static_cast<long>(v.size() / 2), v.end());
    return v[v.size() / 2];
  };
  const double fastest = *std::min_element(a.begin(), a.end()), fastest_hand = *std::min_element(b.begin(), b.end());
  std::printf("generated_median_ns %.1f\nhand_median_ns %.1f\nmedian_ratio %.4f\n", median(a), median(b), median(ratio));
  std::printf("generated_min_ns %.1f\nhand_min_ns %.1f\nratio_of_minimums %.4f\n", fastest, fastest_hand, fastest / fastest_hand);
}

}  // namespace

int main(int argc, char **argv) {
  check(3000);
  measure(argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 1000);
}
