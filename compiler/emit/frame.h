// What the files of one program share while they are written.
#pragma once

#include "emit/program.h"
#include "emit/rung.h"
#include "emit/writer.h"

namespace ladderc::emit {

struct Frame {
  const CheckedProgram &program;
  const ir::Module &module;
  const SourceSet &sources;
  const EmitOptions &options;
  Layout layout;
  std::string class_name, stem;
  PlaceContext places;

  const SourceBuffer &list() const { return sources[program.list.file]; }
  /// The list's file name without its folders: outputs do not depend on where it was compiled.
  std::string list_name() const;
  std::string head_line(llvm::StringRef file) const;
  /// True where the class is memory of the generated class itself (not of `sys`).
  bool own_image(DeviceId device) const;
  bool in_system(DeviceId device) const;
  /// `melsec_qs::System<1300, 1300>`.
  std::string system_type() const;
  std::string chunk_name(std::size_t routine, const Chunk &chunk) const;
  /// True where the body of the main program stands in scan() itself.
  bool main_in_scan() const { return !layout.routines.front().returns; }
  bool has_states() const;      ///< a step ladder
  DeviceId states_class() const;  ///< of the states, or kNoDevice
};

Frame make_frame(const CheckedProgram &program, const ir::Module &module, const SourceSet &sources, const EmitOptions &options);

std::string write_header(const Frame &frame);
std::string write_source(const Frame &frame, unsigned file);
std::string write_symbols(const Frame &frame);
/// The body of a routine: its rungs with their comments, and the calls of the functions that hold the others.
void write_body(const Frame &frame, Writer &out, std::size_t routine, llvm::StringRef file_name);
/// The emitter for the rungs of one function; it is used for all of them.
RungEmitter begin_function(const Frame &frame, Writer &out, std::size_t routine);
/// The rungs of one chunk with their comments.
void write_rungs(const Frame &frame, Writer &out, RungEmitter &emitter, std::size_t routine, const Chunk &chunk,
                 llvm::StringRef file_name);

/// Declarations of the functions that the routines become, and of what they keep from scan to scan.
void write_routine_members(const Frame &frame, Writer &out);
/// Definitions of the functions of one file.
void write_routines(const Frame &frame, Writer &out, unsigned file, llvm::StringRef file_name);
/// What scan() does for states and interrupts before the main program.
void write_events(const Frame &frame, Writer &out);

}  // namespace ladderc::emit
