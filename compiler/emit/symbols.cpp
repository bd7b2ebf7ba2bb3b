// NAME.symbols.cpp: names, addresses and entry points for hosts.
#include "emit/frame.h"
#include "emit/list_text.h"
#include "emit/names.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/Path.h"

namespace ladderc::emit {

namespace {

bool in_table(const DeviceInfo &device) {
  return device.kind != DeviceKind::Nesting && device.kind != DeviceKind::Label;
}

/// Place of a class in the table.
unsigned row_of(const Frame &frame, DeviceId wanted) {
  unsigned row = 0;
  for (DeviceId id = 0; id < wanted; ++id)
    row += in_table(frame.program.family->devices[id]);
  return row;
}

void write_devices(const Frame &frame, Writer &out) {
  out.line("const {} probe{{}};  // only its addresses are used", frame.class_name);
  out.blank();
  {
    const Block body = out.block("std::uint32_t offset_of(const void *member)");
    out.line("return static_cast<std::uint32_t>(static_cast<const char *>(member) - reinterpret_cast<const char *>(&probe));");
  }
  out.blank();
  const Block table = out.block("const ladder::DeviceSymbol kDevices[] =", "};");
  for (std::size_t id = 0; id < frame.layout.count.size(); ++id) {
    const DeviceInfo &device = frame.program.family->devices[id];
    const auto device_id = static_cast<DeviceId>(id);
    if (!in_table(device))
      continue;
    const char *shape = device.kind == DeviceKind::Bit           ? "Bits"
                        : device.kind == DeviceKind::Timer       ? "Timers"
                        : device.kind == DeviceKind::Counter     ? "Counters"
                        : device.kind == DeviceKind::LongCounter ? "LongCounters"
                                                                 : "Words";
    const bool present = frame.own_image(device_id) || frame.in_system(device_id);
    const std::string image = "probe." + device.image.str();
    std::string row = fmt::format(
        "{}, {}, {}, {}, {}, {}, {}, {}", quoted(device.prefix),
        present ? fmt::format("ladder::shape_of<decltype({})>()", image) : fmt::format("ladder::Shape::{}", shape),
        unsigned(device.radix), device.external_input, device.external_output,
        present ? fmt::format("ladder::count_of<decltype({})>()", image) : "0", frame.program.parameters.points[id],
        present ? fmt::format("offset_of(&{})", image) : "0");
    if (device.first || !device.container.empty() || device.high_words != kNoDevice)
      row += fmt::format(", {}, {}", device.first, present ? fmt::format("ladder::stride_of<decltype({})>()", image) : "0");
    if (device.high_words != kNoDevice)
      row += fmt::format(", {}", row_of(frame, device.high_words));
    out.line("{{{}}},", row);
  }
}

/// An index register can lead out of the devices: an operation error of instructions that have none themselves.
bool instruction_is_indexed(const Frame &frame, const Instruction &instruction) {
  return llvm::any_of(frame.program.list.operands_of(instruction), [](const Operand &o) { return o.index != kNoDevice; });
}

unsigned write_steps(const Frame &frame, Writer &out) {
  const Block table = out.block("const ladder::StepSymbol kSteps[] =", "};");
  unsigned count = 0;
  for (const Instruction &instruction : frame.program.list.instructions) {
    const InstructionInfo &info = *instruction.info;
    const bool end = info.lowering == Lowering::End;
    if (info.error_code || info.stops_scan || end || instruction_is_indexed(frame, instruction)) {
      out.line("{{{}, {}, {}}},", instruction.step, frame.sources.position(instruction.range).line,
               quoted(list_text(frame.program, instruction)));
      ++count;
    }
    if (end)
      break;
  }
  return count;
}

void write_latched(const Frame &frame, Writer &out) {
  for (const InitialValue &value : frame.program.parameters.latched_values) {
    const ir::Place place = place_of(*frame.program.family, value);
    if (place.type == OperandType::Bit)
      out.line("program->{} = ladder::bit({});", bit_text(frame.places, place), value.value ? "true" : "false");
    else
      out.line("program->{} = {};", output_text(frame.places, place), value.value);
  }
}

/// `2026-11-25T08:00:00` as the clock's fields; sema has checked the text. The runtime works out the day of the week.
void write_calendar(const Frame &frame, Writer &out) {
  const llvm::StringRef text = frame.program.parameters.calendar;
  if (text.empty())
    return;
  std::string fields;
  for (const auto &[start, length] : {std::pair{0, 4}, {5, 2}, {8, 2}, {11, 2}, {14, 2}, {17, 2}}) {
    unsigned value = 0;
    text.substr(start, length).getAsInteger(10, value);
    fields += fmt::format("{}, ", value);
  }
  out.line("program->sys.set_calendar({{{}0}});", fields);
}

void write_entries(const Frame &frame, Writer &out) {
  const std::string &name = frame.class_name;
  auto entry = [&](const char *signature, const char *body) {
    const Block block = out.block(signature);
    out.text(body);
  };
  out.line("{0} &self(void *program) {{ return *static_cast<{0} *>(program); }}", name);
  {
    const Block block = out.block("void construct(void *memory)");
    if (frame.program.parameters.latched_values.empty() && frame.program.parameters.calendar.empty()) {
      out.line("new (memory) {}{{}};", name);
    } else {
      out.line("auto *program = new (memory) {}{{}};", name);
      write_latched(frame, out);
      write_calendar(frame, out);
    }
  }
  entry("void power_on(void *program)", "self(program).power_on();");
  entry("void set_mode(void *program, ladder::Mode mode)", "self(program).set_mode(mode);");
  entry("void scan(void *program, ladder::Micros now)", "self(program).scan(now);");
  entry("ladder::Status status(const void *program)",
        fmt::format("return static_cast<const {} *>(program)->sys.status();", name).c_str());
  entry("void set_calendar(void *program, ladder::Calendar calendar)", "self(program).sys.set_calendar(calendar);");
  entry("void watchdog(void *program)", "self(program).sys.watchdog_error();");
  if (!frame.program.family->clears_on_stop)
    return;
  entry("void connect(void *program, ladder::Io *io)", "self(program).sys.connect(io);");
  if (has_events(frame.module))
    entry("void input(void *program, unsigned number, bool state)", "self(program).input(number, ladder::bit(state));");
  if (has_interrupts(frame.module))
    entry("void interrupt(void *program, unsigned pointer)", "self(program).sys.raise(pointer);");
}

void write_errors(const Frame &frame, Writer &out) {
  const Block table = out.block("const ladder::ErrorSymbol kErrors[] =", "};");
  for (const ErrorInfo &error : frame.program.family->errors)
    out.line("{{{}, {}}},", error.code, quoted(error.name));
}

std::uint32_t instruction_count(const Frame &frame) {
  std::uint32_t count = 0;
  for (const Instruction &instruction : frame.program.list.instructions) {
    ++count;
    if (instruction.info->lowering == Lowering::End)
      break;
  }
  return count;
}

}  // namespace

std::string write_symbols(const Frame &frame) {
  Writer out;
  const std::string file = frame.stem + ".symbols.cpp";
  out.comment(frame.head_line(file));
  out.comment("For hosts that look at devices by name. Firmware need not link it.");
  out.line("#include \"{}.h\"", frame.stem);
  out.blank();
  out.line("#include <ladder/describe.h>");
  out.line("#include <ladder/symbols.h>");
  out.blank();
  out.line("#include <new>");
  out.blank();
  out.line("namespace {} {{", frame.options.name_space);
  out.line("namespace {{");
  out.blank();
  write_devices(frame, out);
  out.blank();
  write_steps(frame, out);
  out.blank();
  write_errors(frame, out);
  out.blank();
  write_entries(frame, out);
  out.blank();
  out.line("}}  // namespace");
  out.blank();
  out.line("extern const ladder::ProgramSymbols k{}Symbols;", frame.class_name);
  {
    const Block table = out.block(fmt::format("const ladder::ProgramSymbols k{}Symbols =", frame.class_name), "};");
    out.line("{}, {}, {}, {},", quoted(frame.class_name), quoted(frame.program.family->id), quoted(frame.program.model),
             quoted(frame.list_name()));
    out.line("sizeof({0}), alignof({0}),", frame.class_name);
    out.line("{}, {}, {},", instruction_count(frame), frame.program.rungs, frame.program.steps);
    out.line("kDevices, sizeof kDevices / sizeof *kDevices,");
    out.line("kSteps, sizeof kSteps / sizeof *kSteps,");
    out.line("kErrors, sizeof kErrors / sizeof *kErrors,");
    out.line("construct, power_on, set_mode, scan, status, set_calendar,");
    out.line("{}, watchdog,", frame.program.parameters.watchdog_us);
    if (frame.program.family->clears_on_stop)
      out.line("connect, {}, {},", has_events(frame.module) ? "input" : "nullptr",
               has_interrupts(frame.module) ? "interrupt" : "nullptr");
  }
  out.blank();
  out.line("}}  // namespace {}", frame.options.name_space);
  return out.take();
}

OutputFile emit_cmake(const std::vector<OutputFile> &files, const EmitOptions &) {
  Writer out;
  std::string stem, sources;
  for (const OutputFile &file : files) {
    if (llvm::StringRef(file.name).ends_with(".h"))
      stem = llvm::sys::path::stem(file.name).str();
    else if (!llvm::StringRef(file.name).ends_with(".symbols.cpp"))
      sources += fmt::format("\n  ${{CMAKE_CURRENT_LIST_DIR}}/{}", file.name);
  }
  out.text("# " + stem + ".cmake: include() it, with LADDER_RUNTIME set to ladderc's runtime/include folder.");
  out.text(fmt::format("add_library({} STATIC{})", stem, sources));
  out.text(fmt::format("target_include_directories({} PUBLIC ${{CMAKE_CURRENT_LIST_DIR}} ${{LADDER_RUNTIME}})", stem));
  out.text(fmt::format("target_compile_features({} PUBLIC cxx_std_17)", stem));
  out.text("# Names, addresses and entry points for hosts; firmware need not link it.");
  out.text(fmt::format("add_library({0}_symbols STATIC ${{CMAKE_CURRENT_LIST_DIR}}/{0}.symbols.cpp)", stem));
  out.text(fmt::format("target_link_libraries({0}_symbols PUBLIC {0})", stem));
  return {stem + ".cmake", out.take()};
}

}  // namespace ladderc::emit
