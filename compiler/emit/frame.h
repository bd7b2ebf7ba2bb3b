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
  std::string chunk_name(const Chunk &chunk) const;
  /// True where all rungs stand in scan() itself.
  bool single_function() const { return layout.chunks.size() <= 1 && (layout.chunks.empty() || !layout.chunks.front().can_stop); }
};

Frame make_frame(const CheckedProgram &program, const ir::Module &module, const SourceSet &sources, const EmitOptions &options);

std::string write_header(const Frame &frame);
std::string write_source(const Frame &frame, unsigned file);
std::string write_symbols(const Frame &frame);
/// The rungs of one chunk with their comments.
void write_rungs(const Frame &frame, Writer &out, const Chunk &chunk, llvm::StringRef file_name);

}  // namespace ladderc::emit
