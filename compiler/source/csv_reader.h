// Program tables of GX Works2, GX Works3 and GX Developer.
#pragma once

#include "source/list_reader.h"

namespace ladderc {

void read_csv(const SourceBuffer &buffer, unsigned file, llvm::StringSaver &saver, Diagnostics &diagnostics,
              llvm::function_ref<void(const ListLine &)> on_line);

}  // namespace ladderc
