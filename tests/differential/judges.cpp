// The stimulus, and the comparison.
//
// The host flips inputs in every scan, now and then writes words, relays and the special devices that are there for it, turns the
// switch to STOP and back, and powers on again. When the CPU has stopped itself it stays so for two scans, then it is reset.
#include "judges.h"

#include "compiled_side.h"
#include "judge.h"
#include "stimulus.h"

#include "sema/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace ladderc::differential {

namespace {

class Trial {
public:
  explicit Trial(const CompiledCase &c)
      : family_(*c.c.generate.family), stimulus_(family_, c.c.generate.parameters), random_(c.c.seed ^ 0x5EED),
        plain_(*c.plain_symbols, family_, c.c.generate.parameters),
        optimized_(*c.optimized_symbols, family_, c.c.generate.parameters) {
    interpreter_ = make_judge(c.plain->program);
  }

  std::optional<std::string> run(unsigned scans, Counts &counts) {
    ++counts.programs;
    counts.judged += interpreter_ != nullptr;
    power_on();
    unsigned stopped_since = 0;
    for (unsigned scan = 1; scan <= scans; ++scan) {
      stimulate();
      now_ += random_.pick<std::uint32_t>({1'000, 3'700, 10'000, 10'000, 50'000, 123'456, 1'000'000});
      plain_.scan(now_);
      optimized_.scan(now_);
      if (interpreter_)
        interpreter_->scan(now_);
      if (auto difference = compare())
        return fmt::format("scan {}: {}", scan, *difference);
      const ladder::Status status = plain_.status();
      if (status.mode != ladder::Mode::Run || status.running)
        continue;
      counts.stops += stopped_since == 0;
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
    if (interpreter_)
      interpreter_->power_on();
    run_ = true;
    if (random_.one_in(2))
      for (const Poke &poke : stimulus_.fill(random_))
        write(poke);
  }
  void set_run(bool run) {
    run_ = run;
    plain_.set_run(run);
    optimized_.set_run(run);
    if (interpreter_)
      interpreter_->set_run(run);
  }

  /// Where RUN to STOP clears devices, those that the program has no memory for are left alone: nobody would clear them.
  void write(const Poke &poke) {
    if (interpreter_ && !interpreter_->keeps(poke.device))
      return;
    if (family_.clears_on_stop && poke.index >= std::min(plain_.count(poke.device), optimized_.count(poke.device)))
      return;
    if (poke.is_bit) {
      plain_.poke_bit(poke.device, poke.index, poke.value != 0);
      optimized_.poke_bit(poke.device, poke.index, poke.value != 0);
    } else {
      plain_.poke_word(poke.device, poke.index, poke.value);
      optimized_.poke_word(poke.device, poke.index, poke.value);
    }
    if (!interpreter_)
      return;
    DeviceArray &array = interpreter_->array(poke.device);
    if (poke.is_bit)
      array.on[poke.index] = poke.value != 0;
    else
      array.value[poke.index] = poke.value;
  }

  void stimulate() {
    constexpr std::uint32_t kInputs = 32;
    for (std::uint32_t n = 0; n < kInputs; ++n)
      if (random_.one_in(4))
        inputs_[n] = !inputs_[n];
    const std::uint32_t watched = family_.devices[stimulus_.inputs()].watched;
    for (unsigned pulses = watched ? random_.below(12) : 0; pulses > 0; --pulses) {
      const std::uint32_t n = random_.below(watched);
      inputs_[n] = !inputs_[n];
      if (plain_.input(n, inputs_[n]))
        optimized_.input(n, inputs_[n]);
    }
    for (std::uint32_t n = 0; n < kInputs; ++n)
      write({stimulus_.inputs(), n, true, inputs_[n]});  // a terminal does not care what the program wrote
    for (const Poke &poke : stimulus_.some(random_))
      write(poke);
    if (random_.one_in(run_ ? 60 : 2))
      set_run(!run_);
    if (random_.one_in(150))
      power_on();
  }

  std::optional<std::string> compare() {
    for (DeviceId id = 0; id < family_.devices.size(); ++id) {
      const DeviceArray &a = plain_.read(id), &b = optimized_.read(id),
                        &c = interpreter_ && interpreter_->keeps(id) ? interpreter_->array(id) : a;
      if (auto difference = differs(id, "", a.on, b.on, c.on))
        return difference;
      if (auto difference = differs(id, "coil of ", a.coil, b.coil, c.coil))
        return difference;
      if (auto difference = differs(id, a.on.empty() ? "" : "value of ", a.value, b.value, c.value))
        return difference;
      if (auto difference = differs(id, "value of ", a.wide, b.wide, c.wide))
        return difference;
    }
    const ladder::Status a = plain_.status(), b = optimized_.status();
    const std::string at = state_text(a.running, a.error, a.step), bt = state_text(b.running, b.error, b.step);
    const std::optional<std::string> ct = interpreter_ ? interpreter_->state() : std::nullopt;
    if (at == bt && (!ct || at == *ct))
      return std::nullopt;
    return fmt::format("-O0 {}, -O2 {}{}", at, bt, ct ? ", the interpreter " + *ct : "");
  }

  template <class T>
  std::optional<std::string> differs(DeviceId id, const char *part, const std::vector<T> &a, const std::vector<T> &b,
                                     const std::vector<T> &c) const {
    if (a == b && a == c)
      return std::nullopt;
    const DeviceInfo &device = family_.devices[id];
    if (a.size() != b.size() || a.size() != c.size())
      return fmt::format("{} has {}, {} and {} points", device.prefix.str(), a.size(), b.size(), c.size());
    std::size_t n = 0;
    while (a[n] == b[n] && a[n] == c[n])
      ++n;
    const std::string third = interpreter_ ? fmt::format(", {} in the interpreter", c[n]) : "";
    return fmt::format("{}{} is {} at -O0, {} at -O2{}", part, sema::device_name(family_, id, device.first + n), a[n], b[n], third);
  }

  const FamilyInfo &family_;
  const Stimulus stimulus_;
  Random random_;
  CompiledSide plain_, optimized_;
  std::unique_ptr<Judge> interpreter_;  ///< of programs that one knows
  bool inputs_[32] = {};
  bool run_ = true;
  std::uint32_t now_ = 0xFFF00000u;  // the clock wraps around early in the run
};

}  // namespace

std::optional<std::string> run_case(const CompiledCase &c, const RunSettings &settings, Counts &counts) {
  return Trial(c).run(settings.scans, counts);
}

}  // namespace ladderc::differential
