// Scan bookkeeping of the QS controller as the interpreter knows it.
#include "interpreter_system.h"

#include <algorithm>
#include <string>

namespace ladderc::differential {

namespace {

constexpr std::uint64_t kSecond = 1'000'000;
constexpr unsigned kPlaces = 16;      ///< of the annunciator list
constexpr unsigned kFirstPlace = 64;  ///< SD64
constexpr unsigned kAnnunciatorBit = 1 << 5, kScanTimeBit = 1 << 4;

unsigned bcd(unsigned n) {
  return n / 10 % 10 * 16 + n % 10;
}
std::uint16_t two(unsigned high, unsigned low) {
  return static_cast<std::uint16_t>(bcd(high) << 8 | bcd(low));
}

struct Date {
  unsigned month = 1, day = 1, hour, minute, second, weekday;
};
/// Within the year 2000, long enough for a test.
Date date_of(std::uint64_t us) {
  static constexpr unsigned kDays[] = {31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const std::uint64_t seconds = us / kSecond;
  unsigned days = static_cast<unsigned>(seconds / 86400);
  Date d;
  d.weekday = (6 + days) % 7;  // 1 January 2000 was a Saturday
  for (; days >= kDays[d.month - 1]; ++d.month)
    days -= kDays[d.month - 1];
  d.day = days + 1;
  d.hour = static_cast<unsigned>(seconds / 3600 % 24);
  d.minute = static_cast<unsigned>(seconds / 60 % 60);
  d.second = static_cast<unsigned>(seconds % 60);
  return d;
}

}  // namespace

SystemModel::SystemModel(const FamilyInfo &family, const Parameters &parameters, Memory &memory)
    : family_(family), parameters_(parameters), sm_(memory.array("SM")), sd_(memory.array("SD")), f_(memory.array("F")) {}

void SystemModel::power_on() {
  sm(660) = 1;
  sd(414) = 30;
  static constexpr const char *kOrder[] = {"X", "Y", "M", "", "B", "F", "SB", "V", "", "T", "ST", "C", "D", "W", "SW"};
  for (unsigned i = 0; i < std::size(kOrder); ++i)
    if (*kOrder[i])
      sd(290 + i) = static_cast<std::uint16_t>(parameters_.points[find_device(family_, kOrder[i])]);
  since_power_on_us_ = 0;
  flicker_seconds_ = 0;
  flicker_ = reset_command_ = stopped_ = timed_ = false;
  error_ = 0;
  error_step_ = 0;
  run_ = true;
  start_run();
}

void SystemModel::start_run() {
  sm(203) = 0;
  sm(400) = sm(402) = 1;
  sm(401) = sm(403) = 0;
  sd(420) = 0;
  for (unsigned n = 520; n <= 527; ++n)
    sd(n) = 0;
  low_rest_us_ = high_rest_us_ = low_ticks_ = high_ticks_ = 0;
  shortest_us_ = UINT32_MAX;
  longest_us_ = 0;
  first_scan_ = true;
}

void SystemModel::set_run(bool run) {
  if (run == run_)
    return;
  run_ = run;
  if (!run)
    sm(203) = 1;
  else if (stopped_)
    sm(203) = 0;
  else
    start_run();
}

void SystemModel::pass_time(std::uint32_t us) {
  const std::uint64_t before = since_power_on_us_ / kSecond;
  since_power_on_us_ += us;
  calendar_us_ += us;
  const std::uint64_t seconds = since_power_on_us_ / kSecond;
  for (std::uint64_t s = before; s < seconds; ++s) {
    const int half = static_cast<std::int16_t>(sd(414));
    if (half >= 1 && ++flicker_seconds_ >= half) {
      flicker_seconds_ = 0;
      flicker_ = !flicker_;
    }
    if (running())
      ++sd(412);
  }
  const auto half_of = [&](std::uint64_t period) { return since_power_on_us_ % period >= period / 2; };
  sm(410) = half_of(100'000);
  sm(411) = half_of(200'000);
  sm(412) = half_of(kSecond);
  sm(413) = half_of(2 * kSecond);
  sm(414) = flicker_;
}

void SystemModel::show_clock() {
  if (!sm(213))
    return;
  const Date d = date_of(calendar_us_);
  sd(210) = two(0, d.month);
  sd(211) = two(d.day, d.hour);
  sd(212) = two(d.minute, d.second);
  sd(213) = two(20, d.weekday);
}

bool SystemModel::begin_scan(std::uint32_t now_us) {
  const std::uint32_t us = timed_ ? now_us - last_us_ : 0;
  last_us_ = now_us;
  timed_ = true;
  pass_time(us);
  show_clock();
  if (!running())
    return false;
  if (first_scan_) {
    first_scan_ = false;
    return true;
  }
  low_rest_us_ += us;
  low_ticks_ = std::min<std::uint32_t>(low_rest_us_ / parameters_.low_speed_unit_us, 32767);
  low_rest_us_ %= parameters_.low_speed_unit_us;
  high_rest_us_ += us;
  high_ticks_ = std::min<std::uint32_t>(high_rest_us_ / parameters_.high_speed_unit_us, 32767);
  high_rest_us_ %= parameters_.high_speed_unit_us;

  const auto store = [&](unsigned n) {
    sd(n) = static_cast<std::uint16_t>(us / 1000);
    sd(n + 1) = static_cast<std::uint16_t>(us / 100 % 10 * 100);
  };
  store(520);
  if (us < shortest_us_) {
    shortest_us_ = us;
    store(524);
  }
  if (us > longest_us_) {
    longest_us_ = us;
    store(526);
  }
  return true;
}

void SystemModel::end_scan() {
  sm(400) = sm(403) = 1;
  sm(401) = sm(402) = 0;
  ++sd(420);
  if (sm(50) && !reset_command_)
    reset_errors();
  reset_command_ = sm(50);
  show_clock();
}

void SystemModel::report(unsigned code, unsigned category, std::uint32_t step) {
  error_ = static_cast<std::uint16_t>(code);
  error_step_ = step;
  for (unsigned n = 0; n <= 27; ++n)
    sd(n) = 0;
  const Date d = date_of(calendar_us_);
  sd(0) = error_;
  sd(1) = two(0, d.month);
  sd(2) = two(d.day, d.hour);
  sd(3) = two(d.minute, d.second);
  sd(4) = static_cast<std::uint16_t>(category);
  sd(27) = 1;
  sm(0) = sm(5) = 1;  // every error of a running program tells its place
  sm(16) = category >= 0x100;
  std::string name = parameters_.program_name;
  name.resize(8, ' ');
  name += ".QPG";
  for (unsigned i = 0; i < 6; ++i)
    sd(5 + i) =
        static_cast<std::uint16_t>(static_cast<unsigned char>(name[2 * i]) | static_cast<unsigned char>(name[2 * i + 1]) << 8);
  sd(14) = static_cast<std::uint16_t>(step);
  sd(15) = static_cast<std::uint16_t>(step >> 16);
}

void SystemModel::operation_error(unsigned code, std::uint32_t step) {
  report(code, 0x0004, step);
  sm(1) = sm(56) = 1;
  stopped_ = true;
}

void SystemModel::abort(std::uint16_t code, std::uint32_t step) {
  report(4700, 0x0B04, step);
  sd(16) = code;
  stopped_ = true;
}

std::vector<unsigned> SystemModel::entries() {
  const int count = std::clamp<int>(static_cast<std::int16_t>(sd(63)), 0, kPlaces);
  std::vector<unsigned> numbers;
  for (int i = 0; i < count; ++i)
    numbers.push_back(sd(kFirstPlace + unsigned(i)));
  return numbers;
}

void SystemModel::store_entries(const std::vector<unsigned> &numbers) {
  for (unsigned i = 0; i < kPlaces; ++i)
    sd(kFirstPlace + i) = static_cast<std::uint16_t>(i < numbers.size() ? numbers[i] : 0);
  sd(63) = static_cast<std::uint16_t>(numbers.size());
  sd(62) = sd(kFirstPlace);
}

void SystemModel::annunciator_on(unsigned number, std::uint32_t step) {
  if (f_.on[number])
    return;
  f_.on[number] = 1;
  std::vector<unsigned> numbers = entries();
  if (numbers.size() < kPlaces && std::find(numbers.begin(), numbers.end(), number) == numbers.end()) {
    numbers.push_back(number);
    store_entries(numbers);
  }
  sm(62) = 1;
  report(9000, 0x0604, step);
  sd(16) = static_cast<std::uint16_t>(number);
  sd(81) |= kAnnunciatorBit;
}

void SystemModel::annunciator_reset(unsigned number) {
  f_.on[number] = 0;
  std::vector<unsigned> numbers = entries();
  const bool was_full = numbers.size() == kPlaces;
  const auto place = std::find(numbers.begin(), numbers.end(), number);
  if (place != numbers.end()) {
    numbers.erase(place);
    for (unsigned n = 0; was_full && n < f_.on.size() && numbers.size() < kPlaces; ++n)
      if (f_.on[n] && std::find(numbers.begin(), numbers.end(), n) == numbers.end())
        numbers.push_back(n);
    store_entries(numbers);
  }
  if (numbers.empty())
    sm(62) = 0;
}

/// SM50 has turned ON: the cause that SD50 names is cleared, and what is shown if that is the error reported last. The manual says
/// that of several annunciators the first goes; that the report of a later one then stays is what the runtime has decided.
void SystemModel::reset_errors() {
  const unsigned group = sd(50) / 10;
  unsigned causes = sd(81);
  bool shown = error_ / 10u == group;
  if (group == 900) {
    const std::vector<unsigned> before = entries();
    if (!before.empty())
      annunciator_reset(before.front());
    if (entries().empty())
      causes &= ~kAnnunciatorBit;
    else if (sd(16) != before.front())
      shown = false;
  } else if (group == 501) {
    causes &= ~kScanTimeBit;
  } else {
    return;
  }
  sd(81) = static_cast<std::uint16_t>(causes);
  if (!shown)
    return;
  for (unsigned n = 0; n <= 27; ++n)
    sd(n) = 0;
  sm(0) = sm(1) = sm(5) = sm(16) = 0;
  error_ = 0;
  error_step_ = 0;
}

}  // namespace ladderc::differential
