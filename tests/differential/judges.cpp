// The stimulus, and the comparison.
//
// The host flips inputs in every scan, now and then writes words, relays and the special devices that are there for it, turns the
// switch to STOP and back, and powers on again. When the CPU has stopped itself it stays so for two scans, then it is reset.
#include "judges.h"

#include "compiled_side.h"
#include "interpreter.h"

#include "generate/random.h"

#include <fmt/format.h>

#include <functional>

namespace ladderc::differential {

namespace {

class Trial {
public:
  explicit Trial(const CompiledCase &c)
      : family_(*c.c.generate.family), points_(c.c.generate.parameters.points), random_(c.c.seed ^ 0x5EED),
        plain_(*c.plain_symbols, family_, c.c.generate.parameters),
        optimized_(*c.optimized_symbols, family_, c.c.generate.parameters), interpreter_(c.plain->program) {}

  std::optional<std::string> run(unsigned scans, unsigned &stops) {
    power_on();
    unsigned stopped_since = 0;
    for (unsigned scan = 1; scan <= scans; ++scan) {
      stimulate();
      now_ += random_.pick<std::uint32_t>({1'000, 3'700, 10'000, 10'000, 50'000, 123'456, 1'000'000});
      plain_.scan(now_);
      optimized_.scan(now_);
      interpreter_.scan(now_);
      if (auto difference = compare())
        return fmt::format("scan {}: {}", scan, *difference);
      const ladder::Status status = plain_.status();
      if (status.mode != ladder::Mode::Run || status.running)
        continue;
      stops += stopped_since == 0;
      if (++stopped_since > 2) {
        power_on();
        stopped_since = 0;
      }
    }
    return std::nullopt;
  }

private:
  void power_on() {
    plain_.power_on();
    optimized_.power_on();
    interpreter_.power_on();
    run_ = true;
    if (random_.one_in(2))
      fill();
  }
  void set_run(bool run) {
    run_ = run;
    plain_.set_run(run);
    optimized_.set_run(run);
    interpreter_.set_run(run);
  }

  void poke_bit(const char *prefix, std::uint32_t number, bool on) {
    const DeviceId id = find_device(family_, prefix);
    if (number >= points_[id])
      return;
    plain_.poke_bit(id, number, on);
    optimized_.poke_bit(id, number, on);
    interpreter_.memory().array(id).on[number] = on;
  }
  void poke_word(const char *prefix, std::uint32_t number, std::uint32_t value) {
    const DeviceId id = find_device(family_, prefix);
    if (number >= points_[id])
      return;
    const auto word = static_cast<std::uint16_t>(value);
    plain_.poke_word(id, number, word);
    optimized_.poke_word(id, number, word);
    interpreter_.memory().array(id).value[number] = word;
  }
  std::uint32_t number() { return random_.one_in(2) ? random_.below(20) : static_cast<std::uint32_t>(random_.next()); }

  /// Devices hold something when the program starts.
  void fill() {
    for (const char *prefix : {"M", "B", "SB", "Y"})
      for (std::uint32_t n = 0; n < 24; ++n)
        poke_bit(prefix, n, random_.one_in(3));
    for (const char *prefix : {"D", "W", "SW"})
      for (std::uint32_t n = 0; n < 32; ++n)
        poke_word(prefix, n, number());
    for (std::uint32_t n = 1000; n < 1024; ++n) {
      poke_word("SD", n, number());
      poke_bit("SM", n, random_.one_in(2));
    }
  }

  void stimulate() {
    for (std::uint32_t n = 0; n < 32; ++n)
      if (random_.one_in(4))
        inputs_[n] = !inputs_[n];
    for (std::uint32_t n = 0; n < 32; ++n)
      poke_bit("X", n, inputs_[n]);  // a terminal does not care what the program wrote
    if (random_.one_in(8))
      poke_word("D", random_.below(32), number());
    if (random_.one_in(8))
      poke_bit("M", random_.below(32), random_.one_in(2));
    if (random_.one_in(12))
      poke_bit("SM", random_.pick<std::uint32_t>({50, 213, 722}), random_.one_in(2));
    if (random_.one_in(12))
      poke_word("SD", random_.pick<std::uint32_t>({50, 414}), random_.pick<std::uint32_t>({9000, 9007, 5010, 1, 2, 3}));
    if (random_.one_in(run_ ? 60 : 2))
      set_run(!run_);
    if (random_.one_in(150))
      power_on();
  }

  std::optional<std::string> compare() {
    for (DeviceId id = 0; id < family_.devices.size(); ++id) {
      const DeviceArray &a = plain_.read(id), &b = optimized_.read(id), &c = interpreter_.memory().array(id);
      if (auto difference = differs(id, "", a.on, b.on, c.on))
        return difference;
      if (auto difference = differs(id, "coil of ", a.coil, b.coil, c.coil))
        return difference;
      if (auto difference = differs(id, a.on.empty() ? "" : "value of ", a.value, b.value, c.value))
        return difference;
    }
    const ladder::Status a = plain_.status(), b = optimized_.status();
    const SystemModel &c = interpreter_.system();
    auto state = [](bool running, unsigned error, std::uint32_t step) {
      return fmt::format("{} with error {} at step {}", running ? "runs" : "stands", error, step);
    };
    const std::string at = state(a.running, a.error, a.step), bt = state(b.running, b.error, b.step),
                      ct = state(c.running(), c.error(), c.error_step());
    if (at != bt || at != ct)
      return fmt::format("-O0 {}, -O2 {}, the interpreter {}", at, bt, ct);
    return std::nullopt;
  }

  template <class T>
  std::optional<std::string> differs(DeviceId id, const char *part, const std::vector<T> &a, const std::vector<T> &b,
                                     const std::vector<T> &c) const {
    if (a == b && a == c)
      return std::nullopt;
    if (a.size() != b.size() || a.size() != c.size())
      return fmt::format("{} has {}, {} and {} points", family_.devices[id].prefix.str(), a.size(), b.size(), c.size());
    std::size_t n = 0;
    while (a[n] == b[n] && a[n] == c[n])
      ++n;
    const DeviceInfo &device = family_.devices[id];
    const std::string number = device.radix == 16 ? fmt::format("{:X}", n) : fmt::format("{}", n);
    return fmt::format("{}{}{} is {} at -O0, {} at -O2, {} in the interpreter", part, device.prefix.str(), number, a[n], b[n],
                       c[n]);
  }

  const FamilyInfo &family_;
  const std::vector<std::uint32_t> &points_;
  Random random_;
  CompiledSide plain_, optimized_;
  Interpreter interpreter_;
  bool inputs_[32] = {};
  bool run_ = true;
  std::uint32_t now_ = 0xFFF00000u;  // the clock wraps around early in the run
};

}  // namespace

std::optional<std::string> run_case(const CompiledCase &c, const RunSettings &settings, unsigned &stops) {
  return Trial(c).run(settings.scans, stops);
}

}  // namespace ladderc::differential
