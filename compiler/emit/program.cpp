// The header and the sources of one program.
#include "emit/frame.h"
#include "emit/list_text.h"
#include "emit/names.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/Path.h"

namespace ladderc::emit {

namespace {

std::string counted(std::uint32_t count, const char *what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string first_and_last(const DeviceInfo &device, std::uint32_t count) {
  const char *format = device.radix == 16 ? "{}{:X}" : device.radix == 8 ? "{}{:o}" : "{}{}";
  std::string text = fmt::format(fmt::runtime(format), device.prefix.str(), device.first);
  if (count > 1)
    text += fmt::format(fmt::runtime("-" + std::string(format)), device.prefix.str(), device.first + count - 1);
  return text;
}

std::string image_type(const DeviceInfo &device, std::uint32_t count) {
  std::string type = device.container.str();
  if (type.empty())
    type = device.kind == DeviceKind::Bit       ? "Bits"
           : device.kind == DeviceKind::Timer   ? "Timers"
           : device.kind == DeviceKind::Counter ? "Counters"
                                                : "Words";
  type = fmt::format("ladder::{}<{}>", type, count);
  if (device.first)
    type = fmt::format("ladder::Numbered<{}, {}>", type, device.first);
  return fmt::format("{} {};", type, device.image.str());
}

std::string edge_note(const Frame &frame) {
  std::string note = "last state seen";
  const std::vector<ir::EdgeMemory> &edges = frame.module.edges;
  if (edges.size() > 8)
    return note + ", by place in the list";
  for (std::size_t i = 0; i < edges.size(); ++i)
    note += fmt::format("{} [{}] step {}", i ? "," : " at", i, edges[i].step);
  return note;
}

void write_members(const Frame &frame, Writer &out) {
  for (std::size_t id = 0; id < frame.layout.count.size(); ++id) {
    const DeviceInfo &device = frame.program.family->devices[id];
    if (!frame.own_image(static_cast<DeviceId>(id)))
      continue;
    const std::uint32_t count = frame.layout.count[id];
    out.line("{:<30} ///< {}, {}", image_type(device, count), first_and_last(device, count), device.title.str());
  }
  out.line("{} sys;  ///< special devices, errors, clocks", "ladder::" + frame.system_type());
}

void write_private(const Frame &frame, Writer &out) {
  Writer members;
  write_routine_members(frame, members);
  if (frame.program.family->clears_on_stop) {
    members.line("void restart() noexcept;          ///< forgets edges and what instructions were doing");
    members.line("void clear_unlatched() noexcept;");
    members.line("void clear_latched() noexcept;");
  }
  if (!frame.module.edges.empty())
    members.line("{:<30} ///< {}", fmt::format("ladder::Bits<{}> edge;", frame.module.edges.size()), edge_note(frame));
  if (frame.module.master_levels)
    members.line("{:<30} ///< master control: {}", fmt::format("ladder::Bits<{}> master;", frame.module.master_levels),
                 frame.module.master_levels > frame.program.family->max_levels ? "state of each level, then of each SMCS"
                                                                               : "state of level N0 and so on");
  llvm::StringRef text = members.text_so_far();
  if (text.empty())
    return;
  out.blank();
  out.left("private:", 1);
  for (; !text.empty(); text = text.split('\n').second)
    out.text(text.split('\n').first);
}

/// The ranges of a class that are latched, or those that are not, inside of the image.
std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges_to_clear(const Frame &frame, std::size_t id, bool latched) {
  const std::uint32_t begin = frame.program.family->devices[id].first, end = begin + frame.layout.count[id];
  std::vector<std::pair<std::uint32_t, std::uint32_t>> kept, others;
  for (const DeviceRange &range : frame.program.parameters.latched)
    if (range.device == id && range.first < end)
      kept.emplace_back(range.first, std::min(range.last, end - 1));
  llvm::sort(kept);
  std::uint32_t next = begin;
  for (const auto &[first, last] : kept) {
    if (first > next)
      others.emplace_back(next, first - 1);
    next = std::max(next, last + 1);
  }
  if (next < end)
    others.emplace_back(next, end - 1);
  return latched ? kept : others;
}

/// Clears what is latched or what is not, class by class.
void write_clear_images(const Frame &frame, Writer &out, bool latched) {
  for (std::size_t id = 0; id < frame.layout.count.size(); ++id) {
    const DeviceInfo &device = frame.program.family->devices[id];
    if (!frame.own_image(static_cast<DeviceId>(id)) || device.survives_stop)
      continue;
    for (const auto &[first, last] : ranges_to_clear(frame, id, latched)) {
      const bool whole = first == device.first && last + 1 == device.first + frame.layout.count[id];
      out.text(whole ? fmt::format("{}.clear();", device.image.str())
                     : fmt::format("{}.clear({}, {});", device.image.str(), subscript(device, first), subscript(device, last)));
    }
  }
}

void write_clear_memories(const Frame &frame, Writer &out) {
  if (!frame.module.edges.empty())
    out.line("edge.clear();");
  if (frame.module.master_levels)
    out.line("master.clear();");
  if (frame.has_states())
    out.line("states.clear();");
  for (const MemoryObject &memory : frame.layout.memories)
    out.line("{} = {{}};", memory.name);
}

void write_clear(const Frame &frame, Writer &out) {
  if (frame.program.family->clears_on_stop) {
    out.line("clear_unlatched();");
    for (std::size_t id = 0; id < frame.layout.count.size(); ++id)
      if (const DeviceInfo &device = frame.program.family->devices[id]; frame.layout.count[id] && device.survives_stop)
        out.line("{}.clear();", device.image.str());
    out.line("restart();");
    return;
  }
  write_clear_images(frame, out, false);
  write_clear_memories(frame, out);
}

void write_initial_values(const Frame &frame, Writer &out) {
  for (const InitialValue &initial : frame.program.parameters.initial_values) {
    const ir::Place place = place_of(*frame.program.family, initial);
    if (place.type == OperandType::Bit)
      out.line("{} = {};", bit_text(frame.places, place), initial.value ? "on" : "off");
    else
      out.line("{} = {};", output_text(frame.places, place), initial.value);
  }
}

/// Which events have a routine: periods of those that time raises, by the hundreds of their pointers, and edges of inputs.
void write_interrupts(const Frame &frame, Writer &out) {
  std::uint32_t periods[3] = {}, inputs = 0;
  for (const ir::Routine &routine : frame.module.routines) {
    if (routine.kind != ir::RoutineKind::Interrupt)
      continue;
    if (routine.label >= 600 && routine.label < 900)
      periods[routine.label / 100 - 6] = routine.label % 100;
    else if (routine.label < 600 && routine.label % 100 < 2)
      inputs |= 1U << (2 * (routine.label / 100) + routine.label % 100);
  }
  out.line("{{{}, {}, {}}},  // periods of timer interrupts, milliseconds", periods[0], periods[1], periods[2]);
  out.line("0x{:04X},  // input interrupts that have a routine: X0 falling, X0 rising, X1 falling, ...", inputs);
}

/// The special register that tells the allocated points of each class, as the family numbers them.
void write_parameters(const Frame &frame, Writer &out) {
  const Parameters &p = frame.program.parameters;
  const Block block = out.block(fmt::format("constexpr {}::Parameters kParameters =", frame.program.family->ns.str()), "};");
  if (frame.program.family->clears_on_stop) {
    write_interrupts(frame, out);
    return;
  }
  out.line("{},  // program name in the error information", quoted(fmt::format("{:<8.8}", p.program_name)));
  out.line("{}, {},  // low-speed and high-speed timer unit, microseconds", p.low_speed_unit_us, p.high_speed_unit_us);
  out.line("{}, {},  // constant scan and watchdog, microseconds; 0: none", p.constant_scan_us, p.watchdog_us);
  int first = INT32_MAX, last = -1;
  for (const DeviceInfo &d : frame.program.family->devices)
    if (d.points_register >= 0) {
      first = std::min(first, d.points_register);
      last = std::max(last, d.points_register);
    }
  std::vector<std::int32_t> points(last >= first ? static_cast<std::size_t>(last - first + 1) : 0, 0);
  for (std::size_t id = 0; id < frame.program.family->devices.size(); ++id)
    if (const DeviceInfo &d = frame.program.family->devices[id]; d.points_register >= 0)
      points[static_cast<std::size_t>(d.points_register - first)] = static_cast<std::int16_t>(p.points[id]);
  out.line("{{{}}},  // allocated points, SD{} on", fmt::join(points, ", "), first);
}

void write_scan(const Frame &frame, Writer &out) {
  const Block body = out.block(fmt::format("void {}::scan(ladder::Micros now) noexcept", frame.class_name));
  out.line("if (!sys.begin_scan(now)) return;  // in STOP, or stopped by an error");
  write_events(frame, out);
  if (frame.main_in_scan()) {
    const auto &chunks = frame.layout.routines.front().chunks;
    const bool rungs_here = llvm::any_of(chunks, [](const Chunk &c) { return !c.own_function; });
    if (rungs_here)
      out.blank();
    write_body(frame, out, 0, frame.stem + ".cpp");
    if (rungs_here)
      out.blank();
  } else {
    out.line("main_program();");
  }
  const auto &devices = frame.program.family->devices;
  std::string annunciators;
  for (std::size_t id = 0; id < devices.size(); ++id) {
    if (frame.layout.count[id] && devices[id].image == "F")
      annunciators = "F";
    if (!devices[id].end_hook.empty() && frame.layout.count[id])
      out.line("sys.{}({});", devices[id].end_hook.str(), devices[id].image.str());
  }
  if (frame.program.family->clears_on_stop) {
    out.line("if (sys.clears_unlatched()) clear_unlatched();");
    out.line("if (sys.clears_latched()) clear_latched();");
  }
  out.line("sys.end_scan({});", annunciators);
}

/// RUN to STOP clears what is not latched, unless the program has asked to keep it; the program starts anew with each RUN.
void write_set_mode(const Frame &frame, Writer &out) {
  const Block body = out.block(fmt::format("void {}::set_mode(ladder::Mode mode) noexcept", frame.class_name));
  const bool clears = frame.program.family->clears_on_stop, initial = !frame.program.parameters.initial_values.empty();
  if (clears || initial)
    out.line("const bool was_running = sys.running();");
  out.line("sys.set_mode(mode);");
  if (clears) {
    out.line("if (was_running && !sys.running() && !sys.holds_memory()) clear_unlatched();");
    out.line("if (!was_running && sys.running()) restart();");
  }
  if (!initial)
    return;
  out.line("if (was_running || !sys.running()) return;");
  write_initial_values(frame, out);
}

/// What the family's STOP and the program's own switches clear.
void write_clear_functions(const Frame &frame, Writer &out) {
  for (const bool latched : {false, true}) {
    out.blank();
    const Block body = out.block(fmt::format("void {}::clear_{}() noexcept", frame.class_name, latched ? "latched" : "unlatched"));
    write_clear_images(frame, out, latched);
  }
  out.blank();
  const Block body = out.block(fmt::format("void {}::restart() noexcept", frame.class_name));
  write_clear_memories(frame, out);
}

/// An input that changes between scans: interrupt routines and high-speed counters do not wait.
void write_input(const Frame &frame, Writer &out) {
  const Block body = out.block(fmt::format("void {}::input(unsigned number, ladder::bit state) noexcept", frame.class_name));
  out.line("sys.input(number, state);");
  if (has_interrupts(frame.module))
    out.line("if (sys.running()) run_interrupts();");
}

void write_frame_functions(const Frame &frame, Writer &out) {
  out.text("namespace {");
  out.blank();
  write_parameters(frame, out);
  out.blank();
  out.text("}  // namespace");
  out.blank();
  {
    const Block body = out.block(fmt::format("void {}::power_on() noexcept", frame.class_name));
    write_clear(frame, out);
    out.line("sys.power_on(kParameters);");
    write_initial_values(frame, out);
  }
  out.blank();
  write_set_mode(frame, out);
  if (frame.program.family->clears_on_stop)
    write_clear_functions(frame, out);
  if (has_events(frame.module)) {
    out.blank();
    write_input(frame, out);
  }
  out.blank();
  write_scan(frame, out);
}

}  // namespace

std::string Frame::list_name() const {
  return llvm::sys::path::filename(list().name()).str();
}

std::string Frame::head_line(llvm::StringRef file) const {
  return fmt::format("{}: written by ladderc from {} ({}, {}, -O{}). Edit the list, not this file.", file.str(), list_name(),
                     program.family->id.str(), program.model.str(), options.level);
}

bool Frame::in_system(DeviceId device) const {
  return program.family->devices[device].image.starts_with("sys.");
}
bool Frame::own_image(DeviceId device) const {
  return layout.count[device] != 0 && !in_system(device);
}

std::string Frame::system_type() const {
  std::string counts;
  for (std::size_t id = 0; id < layout.count.size(); ++id) {
    // A system whose special devices have numbers of their own has always all of them.
    const DeviceInfo &device = program.family->devices[id];
    if (!in_system(static_cast<DeviceId>(id)) || device.first)
      continue;
    // Every special device that the manual lists, and what the program uses beyond.
    std::uint32_t count = layout.count[id];
    for (const SpecialInfo &special : program.family->specials) {
      const llvm::StringRef last = special.device.rsplit('-').second.empty() ? special.device : special.device.rsplit('-').second;
      std::uint32_t number;
      if (last.starts_with(device.prefix) && !last.drop_front(device.prefix.size()).getAsInteger(10, number))
        count = std::max(count, number + 1);
    }
    counts += fmt::format("{}{}", counts.empty() ? "" : ", ", count);
  }
  return fmt::format("{}::System{}", program.family->ns.str(), counts.empty() ? "" : "<" + counts + ">");
}

std::string Frame::chunk_name(std::size_t routine, const Chunk &chunk) const {
  return fmt::format("rungs_{}_to_{}", module.routines[routine].rungs[chunk.first].number,
                     module.routines[routine].rungs[chunk.last].number);
}

Frame make_frame(const CheckedProgram &program, const ir::Module &module, const SourceSet &sources, const EmitOptions &options) {
  const std::string list = sources[program.list.file].name().str();
  return {program,
          module,
          sources,
          options,
          make_layout(module, program.parameters, options.limits),
          options.class_name.empty() ? class_name(list) : options.class_name,
          options.stem.empty() ? file_stem(list) : options.stem,
          {*program.family, program.parameters, module.texts}};
}

std::string write_header(const Frame &frame) {
  Writer out;
  out.comment(frame.head_line(frame.stem + ".h"));
  out.left("#pragma once");
  out.blank();
  out.line("#include <{}>", frame.program.family->header.str());
  out.blank();
  out.line("namespace {} {{", frame.options.name_space);
  out.blank();
  out.line("/// {}: {}, {}.", frame.list_name(), counted(frame.program.rungs, "rung"), counted(frame.program.steps, "step"));
  out.line("/// One object is one controller: it owns its devices (its sizeof is its RAM) and does no input or output of its own.");
  out.line("/// Not thread-safe: power_on(), set_mode() and scan() belong to one thread.");
  {
    const Block body = out.block(fmt::format("class {} final", frame.class_name), "};");
    out.left("public:", 1);
    write_members(frame, out);
    out.blank();
    out.line("/// Power-on or reset, with the switch at RUN: clears what is not latched.");
    out.line("void power_on() noexcept;");
    out.blank();
    out.line("/// The RUN/STOP switch.");
    out.line("void set_mode(ladder::Mode mode) noexcept;");
    out.blank();
    out.line("/// One scan. The host writes the inputs before it and takes the outputs after it. `now` is the host's clock in");
    out.line("/// microseconds; it may wrap around.");
    out.line("void scan(ladder::Micros now) noexcept;");
    if (has_events(frame.module)) {
      out.blank();
      out.line("/// An input terminal changes between scans: high-speed counters count and interrupt routines run at once.");
      out.line("void input(unsigned number, ladder::bit state) noexcept;");
    }
    write_private(frame, out);
  }
  out.blank();
  out.line("}}  // namespace {}", frame.options.name_space);
  return out.take();
}

std::string write_source(const Frame &frame, unsigned file) {
  const std::string name = file == 0 ? frame.stem + ".cpp" : fmt::format("{}_{}.cpp", frame.stem, file + 1);
  Writer out;
  out.comment(frame.head_line(name));
  out.line("#include \"{}.h\"", frame.stem);
  out.blank();
  out.line("namespace {} {{", frame.options.name_space);
  out.blank();
  out.line("using namespace ladder;");
  if (file == 0) {
    out.blank();
    write_frame_functions(frame, out);
  }
  write_routines(frame, out, file, name);
  out.blank();
  out.line("}}  // namespace {}", frame.options.name_space);
  return out.take();
}

std::vector<OutputFile> emit_program(const CheckedProgram &program, const ir::Module &module, const SourceSet &sources,
                                     const EmitOptions &options) {
  const Frame frame = make_frame(program, module, sources, options);
  std::vector<OutputFile> files;
  files.push_back({frame.stem + ".h", write_header(frame)});
  for (unsigned file = 0; file < frame.layout.files; ++file)
    files.push_back({file == 0 ? frame.stem + ".cpp" : fmt::format("{}_{}.cpp", frame.stem, file + 1), write_source(frame, file)});
  files.push_back({frame.stem + ".symbols.cpp", write_symbols(frame)});
  return files;
}

std::string emit_rungs(const CheckedProgram &program, const ir::Module &module, const SourceSet &sources,
                       const EmitOptions &options) {
  const Frame frame = make_frame(program, module, sources, options);
  Writer out;
  for (std::size_t routine = 0; routine < module.routines.size(); ++routine) {
    if (module.routines.size() > 1)
      out.line("{}{}:", routine ? "\n" : "", routine_name(module.routines[routine]));
    bool first = true;
    RungEmitter emitter = begin_function(frame, out, routine);
    for (const Chunk &chunk : frame.layout.routines[routine].chunks) {
      if (!first)
        out.blank();
      first = false;
      write_rungs(frame, out, emitter, routine, chunk, frame.stem + ".cpp");
    }
  }
  return out.take();
}

}  // namespace ladderc::emit
