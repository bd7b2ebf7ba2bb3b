// A failed expectation does not end a scenario, a mistake in it does: an unknown device, an unknown key, a value that does not fit.
#include "hosted/scenario.h"

#include "hosted/scenario_io.h"
#include "hosted/scenario_json.h"
#include "hosted/simulated_io.h"

#include "ladder/hosted/instance.h"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <string>

namespace ladder::hosted {
namespace {

constexpr double kTolerance = 1e-6;
constexpr double kDefaultClockMs = 10;
constexpr std::uint64_t kMostPulses = 10'000'000;

class ScenarioRun {
public:
  ScenarioRun(const ProgramSymbols &symbols, Micros clock) : instance_(symbols, Clock::virtual_steps(clock)) {
    instance_.connect(&io_);  // a controller with nothing to connect needs none of it
  }

  void start(const Json &scenario);
  void step(const Json &step, std::size_t index);
  Json take_failures() { return std::move(failures_); }

private:
  void switch_mode(const Json &step);
  void set(const Json &devices);
  /// What happens between the last scan and the next.
  void act(const Json &step);
  void expect(const Json &step, std::size_t index);
  void expect_sent(const Json &step, std::size_t index);
  /// Calls `use(text, ref, json)` for each device of the object, and names the device in what it throws.
  template <typename Use> void for_each_device(const Json &devices, Use use);

  SimulatedIo io_;
  Instance instance_;
  Json failures_ = Json::array();
};

void ScenarioRun::start(const Json &scenario) {
  read_io(scenario, io_);
  instance_.power_on();
  if (auto calendar = scenario.find("calendar"); calendar != scenario.end()) {
    if (!calendar->is_string())
      throw ScenarioError("'calendar' is a string such as 1998-11-30T11:50:20");
    instance_.set_calendar(parse_calendar(calendar->get_ref<const std::string &>()));
  }
}

template <typename Use> void ScenarioRun::for_each_device(const Json &devices, Use use) {
  if (!devices.is_object())
    throw ScenarioError(fmt::format("{} is no object of devices", devices.dump()));
  for (const auto &[text, json] : devices.items()) {
    DeviceRef ref = find_device(instance_.symbols(), text);
    try {
      use(text, ref, json);
    } catch (const DeviceError &error) {
      throw DeviceError(fmt::format("{}: {}", text, error.what()));
    }
  }
}

void ScenarioRun::switch_mode(const Json &step) {
  if (auto cycle = step.find("power_cycle"); cycle != step.end()) {
    if (!cycle->is_boolean())
      throw ScenarioError("'power_cycle' is true or false");
    if (cycle->get<bool>())
      instance_.power_on();
  }
  if (auto mode = step.find("mode"); mode != step.end()) {
    if (*mode != "run" && *mode != "stop")
      throw ScenarioError(fmt::format("'mode' is \"run\" or \"stop\", not {}", mode->dump()));
    instance_.set_mode(*mode == "run" ? Mode::Run : Mode::Stop);
  }
}

void ScenarioRun::set(const Json &devices) {
  for_each_device(
      devices, [&](const std::string &, const DeviceRef &ref, const Json &json) { instance_.set(ref, value_of_json(ref, json)); });
}

void ScenarioRun::act(const Json &step) {
  io_.set_time(instance_.now());
  if (auto pulses = step.find("pulses"); pulses != step.end())
    for_each_device(*pulses, [&](const std::string &, const DeviceRef &ref, const Json &json) {
      if (!json.is_number_unsigned() || json.get<std::uint64_t>() > kMostPulses)
        throw DeviceError(fmt::format("{} is no number of pulses from 0 to {}", json.dump(), kMostPulses));
      instance_.pulse(ref, json.get<std::uint64_t>());
    });
  if (auto interrupts = step.find("interrupts"); interrupts != step.end())
    for (unsigned pointer : pointers_of(*interrupts))
      instance_.interrupt(pointer);
}

void ScenarioRun::expect(const Json &step, std::size_t index) {
  auto devices = step.find("expect");
  if (devices == step.end())
    return;
  double tolerance = number_at(step, "tolerance", kTolerance, 1e9);
  for_each_device(*devices, [&](const std::string &text, const DeviceRef &ref, const Json &json) {
    Value wanted = value_of_json(ref, json), got = instance_.get(ref);
    if (!matches(got, wanted, json, tolerance))
      failures_.push_back(
          {{"step", index}, {"scan", instance_.scans()}, {"device", text}, {"expected", json}, {"got", json_of(ref, got, json)}});
  });
}

void ScenarioRun::expect_sent(const Json &step, std::size_t index) {
  auto expected = step.find("serial_sent");
  if (expected == step.end())
    return;
  for (const SerialText &wanted : serial_texts(*expected, "hex", {"port", "hex"})) {
    SimulatedIo::Bytes got = io_.take_sent(wanted.port);
    if (got != wanted.bytes)
      failures_.push_back({{"step", index},
                           {"scan", instance_.scans()},
                           {"device", fmt::format("serial port {}", wanted.port)},
                           {"expected", hex_text(wanted.bytes)},
                           {"got", hex_text(got)}});
  }
}

void ScenarioRun::step(const Json &step, std::size_t index) {
  check_keys(step, {"power_cycle", "mode", "set", "pulses", "interrupts", "scans", "expect", "serial_sent", "tolerance", "why"});
  switch_mode(step);
  if (auto devices = step.find("set"); devices != step.end())
    set(*devices);
  act(step);
  for (std::uint64_t scans = count_at(step, "scans", 1); scans > 0; --scans) {
    io_.set_time(instance_.now());
    instance_.scan();
  }
  expect(step, index);
  expect_sent(step, index);
}

/// Runs the steps; what is wrong goes into `result`.
void run_steps(const Json &scenario, std::span<const ProgramSymbols *const> programs, Json &result) {
  check_keys(scenario, {"program", "name", "clock_ms", "calendar", "serial", "potentiometers", "expansion_card", "steps"});
  std::uint64_t program = count_at(scenario, "program", 0);
  if (program >= programs.size())
    throw ScenarioError(fmt::format("program {} of {} does not exist", program, programs.size()));
  auto steps = scenario.find("steps");
  if (steps == scenario.end() || !steps->is_array())
    throw ScenarioError("'steps' is missing or no array");
  auto clock = static_cast<Micros>(std::lround(number_at(scenario, "clock_ms", kDefaultClockMs, 3'600'000) * 1000));
  ScenarioRun run(*programs[program], clock);
  std::size_t index = 0;
  try {
    run.start(scenario);
    for (; index < steps->size(); ++index)
      run.step((*steps)[index], index);
  } catch (const std::runtime_error &error) {
    result["error"] = fmt::format("step {}: {}", index, error.what());
  }
  result["failures"] = run.take_failures();
}

unsigned calendar_field(std::string_view text, std::size_t start, std::size_t length) {
  unsigned number = 0;
  const char *end = text.data() + start + length;
  auto parsed = std::from_chars(text.data() + start, end, number);
  return parsed.ec == std::errc{} && parsed.ptr == end ? number : ~0u;
}

}  // namespace

Json run_scenario(const Json &scenario, std::span<const ProgramSymbols *const> programs) {
  Json result = {{"name", ""}, {"passed", false}, {"failures", Json::array()}};
  if (scenario.is_object() && scenario.contains("name"))
    result["name"] = scenario["name"];
  try {
    run_steps(scenario, programs, result);
  } catch (const ScenarioError &error) {
    result["error"] = error.what();
  }
  result["passed"] = result["failures"].empty() && !result.contains("error");
  return result;
}

Calendar parse_calendar(std::string_view text) {
  bool shaped = text.size() == 19 && text[4] == '-' && text[7] == '-' && text[10] == 'T' && text[13] == ':' && text[16] == ':';
  if (shaped) {
    unsigned year = calendar_field(text, 0, 4), month = calendar_field(text, 5, 2), day = calendar_field(text, 8, 2);
    unsigned hour = calendar_field(text, 11, 2), minute = calendar_field(text, 14, 2), second = calendar_field(text, 17, 2);
    bool date_in_range = year >= 1980 && year <= 2079 && month <= 12 && day <= 31;
    std::chrono::year_month_day date{std::chrono::year(static_cast<int>(year)), std::chrono::month(month), std::chrono::day(day)};
    if (date_in_range && date.ok() && hour < 24 && minute < 60 && second < 60) {
      std::chrono::weekday weekday{std::chrono::sys_days(date)};
      return {static_cast<std::uint16_t>(year),
              static_cast<std::uint8_t>(month),
              static_cast<std::uint8_t>(day),
              static_cast<std::uint8_t>(hour),
              static_cast<std::uint8_t>(minute),
              static_cast<std::uint8_t>(second),
              static_cast<std::uint8_t>(weekday.c_encoding())};
    }
  }
  throw DeviceError(fmt::format("'{}' is no date and time from 1980 to 2079 such as 1998-11-30T11:50:20", text));
}

}  // namespace ladder::hosted
