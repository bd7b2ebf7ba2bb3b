// ladderc-bench-contacts: the scan of generated C++ against hand-written C++ of the same rungs.
//
// Both are compiled by the same compiler with the same flags in this run, linked into one program and measured in turns with the same
// inputs; the outputs of every turn are compared. Prints ns per scan, the ratio, and the time from list to native program.
#include "commands.h"
#include "contact_program.h"

#include <fmt/format.h>

namespace fs = std::filesystem;
using namespace ladderc::bench;

namespace {

const char *const kHarness = R"cpp(
#include "contacts.h"
#include "hand.h"
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

static plant::Contacts generated;
static Hand hand;
static std::uint32_t state = 1;
static bool random_bit() { state ^= state << 13; state ^= state >> 17; state ^= state << 5; return state >> 31; }

template <class F> static double turn(F scan) {
  constexpr int kScans = 200;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < kScans; ++i) {
    scan();
    asm volatile("" ::: "memory");
  }
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count() / kScans;
}

int main() {
  generated.power_on();
  std::vector<double> a, b, ratio;
  ladder::Micros now = 0;
  for (int round = 0; round < 400; ++round) {
    for (unsigned i = 0; i < decltype(generated.X)::kPoints; ++i) {
      const bool on = random_bit();
      generated.X[i] = ladder::bit(on);
      hand.X[i] = on;
    }
    const double first = turn([&] { generated.scan(now += 1000); });
    const double second = turn([&] { hand.scan(); });
    if (round >= 20) {
      a.push_back(first);
      b.push_back(second);
      ratio.push_back(first / second);
    }
    for (unsigned i = 0; i < decltype(generated.Y)::kPoints; ++i)
      if (bool(generated.Y[i]) != bool(hand.Y[i])) { std::printf("round %d: Y%X differs\n", round, i); return 1; }
    for (unsigned i = 0; i < decltype(generated.M)::kPoints; ++i)
      if (bool(generated.M[i]) != bool(hand.M[i])) { std::printf("round %d: M%u differs\n", round, i); return 1; }
  }
  auto median = [](std::vector<double> v) { std::nth_element(v.begin(), v.begin() + v.size() / 2, v.end()); return v[v.size() / 2]; };
  std::printf("generated_ns %.1f\nhand_ns %.1f\nratio %.4f\n", median(a), median(b), median(ratio));
  std::printf("generated_min_ns %.1f\nhand_min_ns %.1f\nratio_of_minimums %.4f\n", *std::min_element(a.begin(), a.end()),
              *std::min_element(b.begin(), b.end()), *std::min_element(a.begin(), a.end()) / *std::min_element(b.begin(), b.end()));
}
)cpp";

}  // namespace

int main(int argc, char **argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: %s LADDERC RUNTIME_INCLUDE FOLDER [RUNGS] [SEED]\n", argv[0]);
    return 2;
  }
  const std::string ladderc = argv[1], include = argv[2];
  const fs::path folder = fs::absolute(argv[3]);
  const unsigned rungs = argc > 4 ? static_cast<unsigned>(std::atoi(argv[4])) : 2000;
  const std::uint64_t seed = argc > 5 ? std::strtoull(argv[5], nullptr, 10) : 20;
  fs::create_directories(folder);
  const auto program = ladderc::bench::make_contact_program(rungs, seed);
  write(folder / "contacts.il", program.list);
  write(folder / "hand.h", program.hand_header);
  write(folder / "hand.cpp", program.hand_source);
  write(folder / "harness.cpp", kHarness);
  fmt::print("rungs {}\ninstructions {}\n", rungs, program.instructions);

  const std::string in = "cd '" + folder.string() + "' && ";
  int code = 0;
  // A fresh cache: list to native must not be answered from an earlier run.
  const double native = timed(in + "rm -rf cache && XDG_CACHE_HOME=$PWD/cache '" + ladderc + "' build contacts.il -o contacts --stats 2> stats.txt", code);
  if (code) {
    run(in + "cat stats.txt");
    return 1;
  }
  fmt::print("list_to_native_s {:.2f}\n", native);
  run(in + "awk '/ms in all/ {print \"of_which_ladderc_ms\", $1}' stats.txt");
  if (run(in + "'" + ladderc + "' emit contacts.il -o . > /dev/null") ||
      run(in + compiler() + " -std=c++20 -O2 -fno-exceptions -fno-rtti -I'" + include + "' contacts*.cpp hand.cpp harness.cpp -o harness"))
    return 1;
  if (run(in + "./harness > result.txt"))
    code = 1;
  run(in + "cat result.txt");
  run(in + "awk -v n=" + std::to_string(program.instructions) + " '/^(generated|hand)_ns/ {printf \"%s_per_instruction %.4f\\n\", $1, $2 / n}' result.txt");
  return code;
}
