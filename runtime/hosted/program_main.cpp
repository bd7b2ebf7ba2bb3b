// The main loop of a built program: wait, write inputs, scan, measure, watch, until the scans are done, a signal asks, or the CPU
// stops.
#include "ladder/hosted/program_main.h"

#include "hosted/bench.h"
#include "hosted/options.h"
#include "hosted/report.h"
#include "hosted/scan_times.h"
#include "hosted/scenario.h"
#include "hosted/stimulus.h"
#include "hosted/stop_signals.h"
#include "hosted/watch.h"

#include "ladder/hosted/instance.h"
#include "ladder/hosted/serial_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <thread>
#include <vector>

namespace ladder::hosted {
namespace {

using SteadyClock = std::chrono::steady_clock;

enum ExitCode : int { kDone = 0, kUsage = 2, kCpuStopped = 3 };

struct ResolvedSetting {
  std::uint64_t scan;
  DeviceRef ref;
  Value value;
};

std::vector<ResolvedSetting> resolve(const ProgramSymbols &symbols, const std::vector<Setting> &settings) {
  std::vector<ResolvedSetting> resolved;
  for (const Setting &setting : settings) {
    DeviceRef ref = find_device(symbols, setting.device);
    try {
      resolved.push_back({setting.scan, ref, value_of_text(ref, setting.value)});
    } catch (const DeviceError &error) {
      throw DeviceError(fmt::format("{}: {}", setting.device, error.what()));
    }
  }
  std::stable_sort(resolved.begin(), resolved.end(), [](const auto &a, const auto &b) { return a.scan < b.scan; });
  return resolved;
}

/// Sleeps in slices, since a signal does not end a sleep.
void wait_until(SteadyClock::time_point time, const StopSignals &stop) {
  constexpr auto kSlice = std::chrono::milliseconds(50);
  for (auto now = SteadyClock::now(); now < time && !stop.asked(); now = SteadyClock::now())
    std::this_thread::sleep_for(std::min<SteadyClock::duration>(time - now, kSlice));
}

class Run {
public:
  Run(const ProgramSymbols &symbols, const Options &options, std::FILE *out, std::FILE *err)
      : options_(options), pace_(options.bench ? Pace::Virtual : options.pace.value_or(Pace::Timed)),
        scan_time_(options.scan_time.value_or(kDefaultScanTime)), serial_(err),
        instance_(symbols, pace_ == Pace::Virtual ? Clock::virtual_steps(scan_time_) : Clock::real()), stimulus_(options.stimulus),
        settings_(resolve(symbols, options.settings)), out_(out), err_(err) {}

  int run() {
    connect();
    instance_.power_on();
    if (!options_.clock.empty())
      instance_.set_calendar(options_.clock == "system" ? system_calendar() : parse_calendar(options_.clock));
    return options_.bench ? bench() : scan_until_done();
  }

private:
  void connect();
  int bench();
  int scan_until_done();
  void scan_once(Watch &watch);
  void apply_settings();
  int finish();

  const Options &options_;
  Pace pace_;
  Micros scan_time_;
  SerialIo serial_;
  Instance instance_;
  Stimulus stimulus_;
  std::vector<ResolvedSetting> settings_;
  std::size_t settings_done_ = 0;
  ScanTimes times_;
  std::FILE *out_, *err_;
};

void Run::connect() {
  if (options_.serial.empty())
    return;
  for (const SerialDevice &device : options_.serial)
    serial_.attach(device.port, device.path);
  if (!instance_.connect(&serial_))
    throw SerialError("this controller has no serial ports");
}

void Run::apply_settings() {
  for (; settings_done_ < settings_.size() && settings_[settings_done_].scan <= instance_.scans() + 1; ++settings_done_)
    instance_.set(settings_[settings_done_].ref, settings_[settings_done_].value);
}

void Run::scan_once(Watch &watch) {
  apply_settings();
  stimulus_.apply(instance_);
  std::uint64_t time = instance_.now();
  auto begin = SteadyClock::now();
  instance_.scan();
  auto duration = std::chrono::duration_cast<std::chrono::nanoseconds>(SteadyClock::now() - begin);
  auto nanoseconds = static_cast<std::uint64_t>(duration.count());
  times_.add(nanoseconds * 1000);
  // In virtual time a scan takes none, and the computer's hiccups must not decide what a run does.
  std::uint32_t limit = instance_.symbols().watchdog_us;
  if (pace_ != Pace::Virtual && limit != 0 && nanoseconds > std::uint64_t{limit} * 1000)
    instance_.watchdog();
  if (watch.look(instance_, time, options_.json, out_) && pace_ == Pace::Timed)
    std::fflush(out_);
}

int Run::scan_until_done() {
  StopSignals stop;
  Watch watch(instance_, options_.watched);
  auto next = SteadyClock::now();
  while (!stop.asked() && !instance_.stopped_by_itself() && (!options_.scans || instance_.scans() < *options_.scans)) {
    if (pace_ == Pace::Timed) {
      wait_until(next, stop);
      if (stop.asked())
        break;
      // A late scan moves the following ones; they do not crowd to catch up.
      next = std::max(next, SteadyClock::now() - std::chrono::microseconds(scan_time_)) + std::chrono::microseconds(scan_time_);
    }
    scan_once(watch);
  }
  if (!options_.quiet)
    print_statistics(instance_, times_, watch, options_.json, out_);
  return finish();
}

int Run::bench() {
  apply_settings();
  BenchResult result = run_bench(instance_, stimulus_, options_.scans);
  if (!result.stopped)
    print_bench(instance_, result, out_);
  return finish();
}

int Run::finish() {
  std::fflush(out_);
  if (instance_.status().error != 0)
    print_error(instance_, err_);
  else if (instance_.stopped_by_itself())
    fmt::print(err_, "{}: the program stopped the CPU in scan {}\n", instance_.symbols().list_file, instance_.scans());
  return instance_.stopped_by_itself() && instance_.status().error != 0 ? kCpuStopped : kDone;
}

std::string_view name_of(std::string_view path) {
  return path.substr(path.find_last_of("/\\") + 1);
}

}  // namespace

int program_main(int argc, char **argv, const ProgramSymbols &symbols, std::FILE *out, std::FILE *err) {
  std::string_view program = argc > 0 ? name_of(argv[0]) : symbols.name;
  try {
    Options options = parse_options(argc, argv);
    if (options.help) {
      fmt::print(out, "{}", help_text(program));
      return kDone;
    }
    return Run(symbols, options, out, err).run();
  } catch (const UsageError &error) {
    fmt::print(err, "{}: {}; --help lists the options\n", program, error.what());
  } catch (const DeviceError &error) {
    fmt::print(err, "{}: {}\n", program, error.what());
  } catch (const SerialError &error) {
    fmt::print(err, "{}: {}\n", program, error.what());
  }
  return kUsage;
}

}  // namespace ladder::hosted
