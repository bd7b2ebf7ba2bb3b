// Options are `--name`, `--name VALUE` or `--name=VALUE`. There are no others and no other arguments.
#include "hosted/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

namespace ladder::hosted {
namespace {

struct OptionRow {
  std::string_view name;
  std::string_view argument;  ///< as the help shows it; empty: takes none
  std::string_view help;      ///< lines
  void (*apply)(Options &options, std::string_view argument);
};

std::uint64_t parse_count(std::string_view what, std::string_view text, std::uint64_t smallest) {
  std::uint64_t number = 0;
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number < smallest)
    throw UsageError(fmt::format("{} takes a whole number from {} on, not '{}'", what, smallest, text));
  return number;
}

std::vector<std::string_view> split_commas(std::string_view what, std::string_view list) {
  std::vector<std::string_view> items;
  for (std::size_t start = 0; start <= list.size();) {
    std::size_t end = std::min(list.find(',', start), list.size());
    if (end == start)
      throw UsageError(fmt::format("{} has an empty entry in '{}'", what, list));
    items.push_back(list.substr(start, end - start));
    start = end + 1;
  }
  return items;
}

void set_pace(Options &options, Pace pace) {
  if (options.pace && *options.pace != pace)
    throw UsageError("--free-running and --virtual exclude each other");
  options.pace = pace;
}

void add_settings(Options &options, std::string_view list) {
  for (std::string_view item : split_commas("--set", list)) {
    std::size_t equals = item.find('='), at = item.find('@');
    if (equals == std::string_view::npos || equals == 0 || at < equals)
      throw UsageError(fmt::format("--set takes DEVICE=VALUE or DEVICE=VALUE@SCAN, not '{}'", item));
    bool timed = at != std::string_view::npos;
    std::uint64_t scan = timed ? parse_count("the scan behind '@'", item.substr(at + 1), 1) : 1;
    std::string_view value = item.substr(equals + 1, timed ? at - equals - 1 : std::string_view::npos);
    options.settings.push_back({std::string(item.substr(0, equals)), std::string(value), scan, timed});
  }
}

void add_watched(Options &options, std::string_view list) {
  for (std::string_view item : split_commas("--watch", list))
    options.watched.emplace_back(item);
}

void set_stimulus(Options &options, std::string_view text) {
  if (text == "none")
    options.stimulus = {StimulusKind::None, 1};
  else if (text == "toggle")
    options.stimulus = {StimulusKind::Toggle, 1};
  else if (text.starts_with("random:"))
    options.stimulus = {StimulusKind::Random, parse_count("--stimulus=random:SEED", text.substr(7), 0)};
  else
    throw UsageError(fmt::format("--stimulus takes random:SEED, toggle or none, not '{}'", text));
}

void add_serial(Options &options, std::string_view text) {
  constexpr std::uint64_t kPorts = 16;
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals + 1 == text.size())
    throw UsageError(fmt::format("--serial takes PORT=DEVICE such as 0=/dev/ttyUSB0, not '{}'", text));
  const std::uint64_t port = parse_count("the port of --serial", text.substr(0, equals), 0);
  if (port >= kPorts)
    throw UsageError(fmt::format("--serial has the ports 0 to {}, not {}", kPorts - 1, port));
  if (std::any_of(options.serial.begin(), options.serial.end(), [&](const SerialDevice &d) { return d.port == port; }))
    throw UsageError(fmt::format("--serial has two devices for port {}", port));
  options.serial.push_back({static_cast<unsigned>(port), std::string(text.substr(equals + 1))});
}

constexpr OptionRow kOptions[] = {
    {"scans", "N", "end after N scans; without it the program runs until it is interrupted",
     [](Options &o, std::string_view text) { o.scans = parse_count("--scans", text, 1); }},
    {"scan-time", "TIME", "a scan every TIME, in us, ms or s (default 10ms); the step of the\nclock with --virtual and --bench",
     [](Options &o, std::string_view text) { o.scan_time = parse_duration(text); }},
    {"free-running", "", "scan as fast as possible, on the real clock",
     [](Options &o, std::string_view) { set_pace(o, Pace::FreeRunning); }},
    {"virtual", "",
     "scan as fast as possible; the program's clock moves by the scan time\nfrom scan to scan, so that every run is the same",
     [](Options &o, std::string_view) { set_pace(o, Pace::Virtual); }},
    {"set", "DEV=VALUE[@SCAN],...",
     "write a device before the first scan, or before scan SCAN; an input\nstays as set. X0=1  D0=-5  D0=0x1234  D0:d=70000  "
     "D0:f=1.5",
     add_settings},
    {"watch", "DEV,...", "print a device whenever a scan changed it, and all of them at the end", add_watched},
    {"stimulus", "KIND",
     "give every input a new value before each scan: random:SEED, toggle or\nnone (default); --set inputs stay as set",
     set_stimulus},
    {"serial", "PORT=DEVICE",
     "connect a serial port of the program (0 is the built-in one) to a device\nsuch as /dev/ttyUSB0; can be repeated", add_serial},
    {"clock", "TIME", "start the calendar with the time of this computer (system) or with\n1998-11-30T11:50:20",
     [](Options &o, std::string_view text) { o.clock = text; }},
    {"bench", "", "measure the time of a scan and print it as JSON, in nanoseconds; with\nno --scans for about half a second",
     [](Options &o, std::string_view) { o.bench = true; }},
    {"json", "", "print watched changes and statistics as JSON, one object a line",
     [](Options &o, std::string_view) { o.json = true; }},
    {"quiet", "", "print no statistics", [](Options &o, std::string_view) { o.quiet = true; }},
    {"help", "", "print this text", [](Options &o, std::string_view) { o.help = true; }},
};

const OptionRow &find_option(std::string_view name) {
  auto row = std::find_if(std::begin(kOptions), std::end(kOptions), [&](const OptionRow &o) { return o.name == name; });
  if (row == std::end(kOptions))
    throw UsageError(fmt::format("unknown option '--{}'", name));
  return *row;
}

/// What is well-formed by itself but would be ignored together.
void check_together(const Options &options) {
  if (options.pace == Pace::FreeRunning && options.scan_time)
    throw UsageError("--free-running has no scan time");
  if (options.clock == "system" && (options.pace == Pace::Virtual || options.bench))
    throw UsageError("in virtual time every run is the same; leave out --clock system");
  if (!options.bench)
    return;
  if (!options.serial.empty())
    throw UsageError("--bench talks to nobody; leave out --serial");
  if (options.pace == Pace::FreeRunning)
    throw UsageError("--bench has a clock of its own; leave out --free-running");
  if (!options.watched.empty())
    throw UsageError("--bench watches no devices");
  if (options.quiet)
    throw UsageError("--bench prints nothing but statistics; leave out --quiet");
  if (std::any_of(options.settings.begin(), options.settings.end(), [](const Setting &s) { return s.timed; }))
    throw UsageError("--bench counts no scans; leave out '@' in --set");
}

}  // namespace

Options parse_options(int argc, const char *const *argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    std::string_view word = argv[i];
    if (word == "-h")
      word = "--help";
    if (!word.starts_with("--") || word.size() == 2)
      throw UsageError(fmt::format("'{}' is no option", word));
    std::size_t equals = word.find('=');
    const OptionRow &row = find_option(word.substr(2, equals == std::string_view::npos ? equals : equals - 2));
    std::string_view argument;
    if (row.argument.empty() && equals != std::string_view::npos)
      throw UsageError(fmt::format("--{} takes no value", row.name));
    if (equals != std::string_view::npos)
      argument = word.substr(equals + 1);
    else if (!row.argument.empty() && ++i < argc)
      argument = argv[i];
    else if (!row.argument.empty())
      throw UsageError(fmt::format("--{} needs a value: --{} {}", row.name, row.name, row.argument));
    row.apply(options, argument);
  }
  if (!options.help)
    check_together(options);
  return options;
}

std::string help_text(std::string_view program) {
  std::string text = fmt::format("usage: {} [options]\n\nRuns the compiled program on this computer.\n\n", program);
  for (const OptionRow &row : kOptions) {
    std::string left = fmt::format("--{}{}{}", row.name, row.argument.empty() ? "" : " ", row.argument);
    std::string_view rest = row.help;
    for (bool first = true; !rest.empty(); first = false) {
      std::size_t end = std::min(rest.find('\n'), rest.size());
      text += fmt::format("  {:<28}  {}\n", first ? left : "", rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return text + "\nExit code: 0 done, or ended by SIGINT or SIGTERM; 2 wrong options; 3 the CPU stopped on an error.\n";
}

Micros parse_duration(std::string_view text) {
  struct Unit {
    std::string_view name;
    double micros;
  };
  constexpr Unit kUnits[] = {{"us", 1}, {"ms", 1e3}, {"s", 1e6}};
  double number = 0;
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
  std::string_view unit_text(end, static_cast<std::size_t>(text.data() + text.size() - end));
  auto unit = std::find_if(std::begin(kUnits), std::end(kUnits), [&](const Unit &u) { return u.name == unit_text; });
  if (error != std::errc{} || unit == std::end(kUnits))
    throw UsageError(fmt::format("'{}' is no time: write 500us, 10ms or 1s", text));
  double micros = std::round(number * unit->micros);
  if (!(micros >= 1 && micros <= 3.6e9))
    throw UsageError(fmt::format("'{}' is not between 1us and 3600s", text));
  return static_cast<Micros>(micros);
}

}  // namespace ladder::hosted
