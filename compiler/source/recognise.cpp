// The entry of this folder: which format a text has, and the reader for it.
#include "source/csv_reader.h"
#include "source/csv_table.h"
#include "source/list_reader.h"
#include "source/plain_reader.h"
#include "source/utf8.h"
#include "source/words.h"

namespace ladderc {

ListFormat recognise_format(llvm::StringRef text) {
  return csv_shape(text) ? ListFormat::GxCsv : ListFormat::Plain;
}

void read_list(const SourceBuffer &buffer, unsigned file, ListFormat format, llvm::StringSaver &saver, Diagnostics &diagnostics,
               llvm::function_ref<void(const ListLine &)> on_line) {
  llvm::StringRef text = buffer.text();
  if (const std::size_t damage = text.find(kReplacement); damage != llvm::StringRef::npos)
    diagnostics.report(DiagId::DamagedText, range_of(buffer, file, text.substr(damage, sizeof(kReplacement) - 1)))
        .arg("count", static_cast<long long>(text.count(kReplacement)));
  if (format == ListFormat::Auto)
    format = recognise_format(text);
  if (format == ListFormat::GxCsv)
    read_csv(buffer, file, saver, diagnostics, on_line);
  else
    read_plain(buffer, file, saver, diagnostics, on_line);
}

}  // namespace ladderc
