// Texts of a run. The message about a stop has the shape of the compiler's own messages, so that editors find the line.
#include "hosted/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace ladder::hosted {
namespace {

std::string error_name(const ProgramSymbols &symbols, std::uint16_t code) {
  std::span errors(symbols.errors, symbols.error_count);
  auto found = std::find_if(errors.begin(), errors.end(), [&](const ErrorSymbol &e) { return e.code == code; });
  return found == errors.end() ? std::string() : found->name;
}

/// Null where the error is not one of an instruction: a watchdog's, say.
const StepSymbol *find_step(const ProgramSymbols &symbols, std::uint32_t step) {
  std::span steps(symbols.step_symbols, symbols.step_symbol_count);
  auto found = std::find_if(steps.begin(), steps.end(), [&](const StepSymbol &s) { return s.step == step; });
  return found == steps.end() ? nullptr : &*found;
}

double per_instruction(const Instance &instance, const ScanTimes &times) {
  std::uint32_t instructions = instance.symbols().instructions;
  return instructions == 0 ? 0 : times.median() / instructions;
}

nlohmann::ordered_json error_json(const Instance &instance) {
  Status status = instance.status();
  if (status.error == 0)
    return nullptr;
  nlohmann::ordered_json error = {
      {"code", status.error}, {"name", error_name(instance.symbols(), status.error)}, {"stopped", instance.stopped_by_itself()}};
  if (const StepSymbol *step = find_step(instance.symbols(), status.step)) {
    error["step"] = step->step;
    error["file"] = instance.symbols().list_file;
    error["line"] = step->line;
    error["text"] = step->text;
  }
  return error;
}

void print_json(const Instance &instance, const ScanTimes &times, const Watch &watch, std::FILE *out) {
  nlohmann::ordered_json devices = nlohmann::ordered_json::object();
  for (const WatchedDevice &device : watch.devices())
    devices[device.text] = json_of(instance.get(device.ref));
  nlohmann::ordered_json line = {
      {"program", instance.symbols().name},
      {"scans", instance.scans()},
      {"time_us", instance.now()},
      {"scan_ns", {{"min", times.min()}, {"median", times.median()}, {"max", times.max()}, {"mean", times.mean()}}},
      {"instructions", instance.symbols().instructions},
      {"ns_per_instruction", per_instruction(instance, times)},
      {"devices", devices},
      {"error", error_json(instance)}};
  fmt::print(out, "{}\n", line.dump());
}

}  // namespace

nlohmann::ordered_json json_of(const Value &value) {
  if (value.format == Format::Float)
    return real_of(value);
  return integer_of(value);
}

std::string seconds_text(std::uint64_t micros) {
  std::uint64_t seconds = micros / 1'000'000, fraction = micros % 1'000'000;
  return fraction % 1000 == 0 ? fmt::format("{}.{:03} s", seconds, fraction / 1000) : fmt::format("{}.{:06} s", seconds, fraction);
}

std::string nanoseconds_text(double nanoseconds) {
  if (nanoseconds < 1e3)
    return fmt::format("{:.3g} ns", nanoseconds);
  if (nanoseconds < 1e6)
    return fmt::format("{:.4g} us", nanoseconds / 1e3);
  return fmt::format("{:.4g} ms", nanoseconds / 1e6);
}

void print_statistics(const Instance &instance, const ScanTimes &times, const Watch &watch, bool json, std::FILE *out) {
  if (json) {
    print_json(instance, times, watch, out);
    return;
  }
  fmt::print(out, "{}: {} scan{} in {}\n", instance.symbols().name, instance.scans(), instance.scans() == 1 ? "" : "s",
             seconds_text(instance.now()));
  if (times.scans() != 0)
    fmt::print(out, "  scan time: min {}, median {}, max {}; {} per instruction ({} instructions)\n", nanoseconds_text(times.min()),
               nanoseconds_text(times.median()), nanoseconds_text(times.max()), nanoseconds_text(per_instruction(instance, times)),
               instance.symbols().instructions);
  for (const WatchedDevice &device : watch.devices())
    fmt::print(out, "  {}={}\n", device.text, value_text(instance.get(device.ref)));
}

void print_error(const Instance &instance, std::FILE *err) {
  const ProgramSymbols &symbols = instance.symbols();
  Status status = instance.status();
  bool stopped = instance.stopped_by_itself();
  const StepSymbol *step = find_step(symbols, status.step);
  std::string place = step != nullptr ? fmt::format("{}:{}", symbols.list_file, step->line) : std::string(symbols.list_file);
  std::string name = error_name(symbols, status.error);
  fmt::print(err, "{}: {}: the CPU {} {}{}{}\n", place, stopped ? "error" : "warning",
             stopped ? fmt::format("stopped in scan {} with error", instance.scans()) : "reported error", status.error,
             name.empty() ? "" : " ", name);
  if (step != nullptr)
    fmt::print(err, "{:>5} | {}\n  = at: step {}\n", step->line, step->text, step->step);
}

}  // namespace ladder::hosted
