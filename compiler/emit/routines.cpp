// Routines as functions: the main program where scan() cannot hold it, subroutines, interrupt routines, states.
#include "emit/frame.h"

#include "llvm/ADT/STLExtras.h"

namespace ladderc::emit {

namespace {

const char *result_type(const Chunk &chunk) {
  return chunk.can_stop ? "bool" : "void";
}

bool is_function(const Frame &frame, std::size_t routine) {
  return routine != 0 || !frame.main_in_scan();
}

std::string signature(const Frame &frame, const ir::Routine &routine, llvm::StringRef scope) {
  const char *parameter = routine.kind == ir::RoutineKind::State ? scope.empty() ? "ladder::bit active" : "bit active" : "";
  (void)frame;
  return fmt::format("void {}{}({}) noexcept", scope.str(), routine_name(routine), parameter);
}

bool uses_active(const ir::Routine &routine) {
  return llvm::any_of(routine.rungs, [](const ir::Rung &rung) {
    return llvm::any_of(rung.operations, [](const ir::Operation &o) { return o.op == ir::Op::Active; });
  });
}

/// Calls with an indexed label: CALL P10Z1.
bool has_indexed_calls(const ir::Module &module) {
  return llvm::any_of(module.routines, [](const ir::Routine &routine) {
    return llvm::any_of(routine.rungs, [](const ir::Rung &rung) {
      return llvm::any_of(rung.operations, [](const ir::Operation &o) { return o.op == ir::Op::Gosub && o.place.is_indexed(); });
    });
  });
}

std::string states_on(const Frame &frame, const ir::Routine &routine) {
  std::string text;
  for (const ir::Place &state : routine.states)
    text += (text.empty() ? "" : " & ") + bit_text(frame.places, state);
  return text;
}

void write_leave_states(const Frame &frame, Writer &out) {
  const Block body = out.block(fmt::format("void {}::leave_states() noexcept", frame.class_name));
  out.line("if (!states.take_left()) return;");
  for (const ir::Routine &routine : frame.module.routines)
    if (routine.kind == ir::RoutineKind::State)
      out.statement(fmt::format("if ({}::left({}, {})) {}(off);", frame.program.family->ns.str(),
                                bit_text(frame.places, routine.memory), states_on(frame, routine), routine_name(routine)));
}

/// `switch` over the routines of one kind.
void write_dispatch(const Frame &frame, Writer &out, ir::RoutineKind kind, llvm::StringRef selector, llvm::StringRef otherwise) {
  const Block table = out.block(fmt::format("switch ({})", selector.str()));
  for (const ir::Routine &routine : frame.module.routines)
    if (routine.kind == kind)
      out.line("case {}: {}(); break;", routine.label, routine_name(routine));
  if (!otherwise.empty())
    out.line("default: {}", otherwise.str());
}

void write_run_interrupts(const Frame &frame, Writer &out) {
  const Block body = out.block(fmt::format("void {}::run_interrupts() noexcept", frame.class_name));
  out.line("if (sys.routine_running()) return;  // they do not nest");
  const Block loop = out.block("for (int pointer = sys.next_interrupt(); pointer >= 0; pointer = sys.next_interrupt())");
  write_dispatch(frame, out, ir::RoutineKind::Interrupt, "pointer", "");
}

void write_calls(const Frame &frame, Writer &out) {
  const Block body =
      out.block(fmt::format("void {}::call(unsigned label, std::uint32_t step) noexcept", frame.class_name));
  write_dispatch(frame, out, ir::RoutineKind::Subroutine, "label", "sys.no_such_label(step);");
}

}  // namespace

bool Frame::has_states() const {
  return llvm::any_of(module.routines, [](const ir::Routine &r) { return r.kind == ir::RoutineKind::State; });
}

DeviceId Frame::states_class() const {
  for (const ir::Routine &routine : module.routines)
    if (!routine.states.empty())
      return routine.states.front().device;
  return kNoDevice;
}

void write_routine_members(const Frame &frame, Writer &out) {
  for (std::size_t routine = 0; routine < frame.module.routines.size(); ++routine) {
    if (is_function(frame, routine))
      out.line("{};", signature(frame, frame.module.routines[routine], ""));
    for (const Chunk &chunk : frame.layout.routines[routine].chunks)
      if (chunk.own_function)
        out.line("{} {}({}) noexcept;", result_type(chunk), frame.chunk_name(routine, chunk),
                 frame.module.routines[routine].kind == ir::RoutineKind::State ? "ladder::bit active" : "");
  }
  if (frame.has_states())
    out.line("void leave_states() noexcept;  ///< switches off what the states drove that a transfer has left");
  if (has_interrupts(frame.module))
    out.line("void run_interrupts() noexcept;");
  if (has_indexed_calls(frame.module))
    out.line("void call(unsigned label, std::uint32_t step) noexcept;");
  const std::string ns = "ladder::" + frame.program.family->ns.str();
  if (frame.has_states())
    out.line("{:<30} ///< transfers between states", fmt::format("{}::States<{}> states;", ns, frame.layout.count[frame.states_class()]));
  if (frame.module.loops)
    out.line("{:<30} ///< passes left in each FOR-NEXT", fmt::format("ladder::word passes[{}] = {{}};", frame.module.loops));
  for (const MemoryObject &memory : frame.layout.memories)
    out.line("{:<30} ///< of the instruction at step {}", fmt::format("{}::{} {};", ns, memory.type, memory.name), memory.step);
}

void write_events(const Frame &frame, Writer &out) {
  const auto &devices = frame.program.family->devices;
  for (std::size_t id = 0; id < devices.size(); ++id)
    if (!devices[id].begin_hook.empty() && frame.layout.count[id] && (!devices[id].watched || has_events(frame.module)))
      out.line("sys.{}({});", devices[id].begin_hook.str(), devices[id].image.str());
  if (frame.has_states())
    out.line("states.begin_scan({});", devices[frame.states_class()].image.str());
  if (has_interrupts(frame.module))
    out.line("run_interrupts();");
}

void write_body(const Frame &frame, Writer &out, std::size_t routine, llvm::StringRef file_name) {
  const RoutineLayout &layout = frame.layout.routines[routine];
  const bool state = frame.module.routines[routine].kind == ir::RoutineKind::State;
  RungEmitter emitter = begin_function(frame, out, routine);
  bool first = true;
  for (const Chunk &chunk : layout.chunks) {
    if (!first)
      out.blank();
    first = false;
    if (!chunk.own_function) {
      write_rungs(frame, out, emitter, routine, chunk, file_name);
      continue;
    }
    const std::string call = fmt::format("{}({})", frame.chunk_name(routine, chunk), state ? "active" : "");
    out.text(chunk.can_stop ? fmt::format("if (!{}) return;", call) : call + ";");
  }
}

void write_routines(const Frame &frame, Writer &out, unsigned file, llvm::StringRef file_name) {
  const std::string scope = frame.class_name + "::";
  for (std::size_t index = 0; index < frame.module.routines.size(); ++index) {
    const ir::Routine &routine = frame.module.routines[index];
    const RoutineLayout &layout = frame.layout.routines[index];
    if (is_function(frame, index) && layout.file == file) {
      out.blank();
      const Block body = out.block(signature(frame, routine, scope));
      if (routine.kind == ir::RoutineKind::State && !uses_active(routine))
        out.line("(void)active;");
      write_body(frame, out, index, file_name);
    }
    for (const Chunk &chunk : layout.chunks) {
      if (!chunk.own_function || chunk.file != file)
        continue;
      out.blank();
      const Block body = out.block(fmt::format("{} {}{}({}) noexcept", result_type(chunk), scope, frame.chunk_name(index, chunk),
                                               routine.kind == ir::RoutineKind::State ? "[[maybe_unused]] bit active" : ""));
      RungEmitter emitter = begin_function(frame, out, index);
      write_rungs(frame, out, emitter, index, chunk, file_name);
      if (chunk.can_stop) {
        out.blank();
        out.line("return true;");
      }
    }
  }
  if (file != 0)
    return;
  if (frame.has_states()) {
    out.blank();
    write_leave_states(frame, out);
  }
  if (has_interrupts(frame.module)) {
    out.blank();
    write_run_interrupts(frame, out);
  }
  if (has_indexed_calls(frame.module)) {
    out.blank();
    write_calls(frame, out);
  }
}

}  // namespace ladderc::emit
