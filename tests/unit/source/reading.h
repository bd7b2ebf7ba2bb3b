// Reads a list in a test and writes down what the reader handed out, one line of text for each line.
//
//   3 LD X0 ; comment        words with the line number of the first one
//   4 + K10                  a row that continues the instruction before
//   5 [text]                 a line statement
//   6 {text}                 a note
//   7 ! LD X0                a row whose instruction cell is filled
#pragma once

#include "source/list_reader.h"

#include <string>

namespace ladderc {

struct Reading {
  std::string text;
  std::string messages;  ///< "LINE id", one a line
};

inline Reading read_text(std::string list, ListFormat format = ListFormat::Auto) {
  SourceSet sources;
  const unsigned file = sources.add("list", std::move(list));
  const SourceBuffer &buffer = sources[file];
  Diagnostics diagnostics(sources);
  llvm::BumpPtrAllocator memory;
  llvm::StringSaver saver(memory);
  Reading reading;
  llvm::raw_string_ostream out(reading.text);
  read_list(buffer, file, format, saver, diagnostics, [&](const ListLine &line) {
    if (line.statement.length != 0)
      out << buffer.line_of(line.statement.begin) << " [" << buffer.slice(line.statement) << "]\n";
    if (!line.words.empty()) {
      out << buffer.line_of(line.words.front().range.begin) << (line.continues ? " +" : line.starts_instruction ? " !" : "");
      for (const Word &word : line.words)
        out << ' ' << word.text;
    }
    if (line.comment.length != 0)
      out << (line.words.empty() ? std::to_string(buffer.line_of(line.comment.begin)) : "") << " ; " << buffer.slice(line.comment);
    if (!line.words.empty() || line.comment.length != 0)
      out << '\n';
    if (line.note.length != 0)
      out << buffer.line_of(line.note.begin) << " {" << buffer.slice(line.note) << "}\n";
  });
  for (const Diagnostic &diagnostic : diagnostics.sorted())
    reading.messages += std::to_string(sources.position(diagnostic.range).line) + " " + info(diagnostic.id).id.str() + "\n";
  return reading;
}

}  // namespace ladderc
