// Plain lists: one or more instructions a line.
#pragma once

#include "source/list_reader.h"

namespace ladderc {

void read_plain(const SourceBuffer &buffer, unsigned file, llvm::StringSaver &saver, Diagnostics &diagnostics,
                llvm::function_ref<void(const ListLine &)> on_line);

}  // namespace ladderc
