// The rungs of one function with the list above them.
//
//     // rung 3, step 9        LD T0 · OUT C0 K3
//
// Statements of the list stand on lines of their own above, comments of its lines and notes behind the instructions' text. A
// comment of three semicolons belongs to the file (a rule, a heading, the expectation of a test) and stays there.
#include "emit/frame.h"
#include "emit/list_text.h"
#include "emit/names.h"

namespace ladderc::emit {

namespace {

/// Comments of the list, found by instruction index.
class CommentFinder {
public:
  explicit CommentFinder(const Frame &frame, std::uint32_t from) : frame_(frame), comments_(frame.program.list.comments) {
    while (next_ < comments_.size() && comments_[next_].instruction < from)
      ++next_;
  }
  /// Statements above, and the other comments of instructions up to `last` with their instruction's index, in the list's order.
  void take(std::uint32_t last, std::vector<std::string> &statements, std::vector<std::pair<std::uint32_t, std::string>> &notes) {
    for (; next_ < comments_.size() && comments_[next_].instruction <= last; ++next_) {
      if (belongs_to_file(frame_.sources, comments_[next_].range))
        continue;
      std::string text = comment_text(frame_.sources, comments_[next_].range);
      if (comments_[next_].kind == CommentKind::Statement)
        statements.push_back(std::move(text));
      else
        notes.emplace_back(comments_[next_].instruction, std::move(text));
    }
  }

private:
  const Frame &frame_;
  llvm::ArrayRef<Comment> comments_;
  std::size_t next_ = 0;
};

std::string rung_text(const Frame &frame, const ir::Rung &rung) {
  std::string text;
  for (std::uint32_t i = 0; i < rung.instruction_count; ++i) {
    text += i ? " · " : "";
    text += list_text(frame.program, frame.program.list.instructions[rung.first_instruction + i]);
  }
  return text;
}

/// Line of the list on which the instruction with that step stands. Steps ascend in the list.
unsigned line_of_step(const Frame &frame, std::uint32_t step) {
  const std::vector<Instruction> &list = frame.program.list.instructions;
  const auto found = llvm::partition_point(list, [&](const Instruction &i) { return i.step < step; });
  return found == list.end() ? 1 : frame.sources.position(found->range).line;
}

/// One comment stands behind the rung's text. Several stand below it, each with the operand that it explains: `X0 start · X1 stop`.
void write_rung_comment(const Frame &frame, Writer &out, const ir::Rung &rung,
                        const std::vector<std::pair<std::uint32_t, std::string>> &notes) {
  std::string text = fmt::format("{:<24} {}", fmt::format("rung {}, step {}", rung.number, rung.step), rung_text(frame, rung));
  if (notes.size() == 1)
    text += "    " + notes.front().second;
  out.comment(text, 25);
  if (notes.size() < 2)
    return;
  std::string explained(25, ' ');
  for (const auto &[index, note] : notes) {
    const std::string words = list_text(frame.program, frame.program.list.instructions[index]);
    const std::size_t blank = words.find(' ');
    explained +=
        (explained.size() > 25 ? " · " : "") + (blank == std::string::npos ? words : words.substr(blank + 1)) + ": " + note;
  }
  out.comment(explained, 25);
}

}  // namespace

RungEmitter begin_function(const Frame &frame, Writer &out, std::size_t routine) {
  RungEmitter emitter(frame.module, frame.places, out, frame.options.level > 0);
  emitter.begin_function(frame.module.routines[routine]);
  if (frame.options.line_directives)
    emitter.set_before_statement([&frame, &out](std::uint32_t step) {
      out.left(fmt::format("#line {} {}", line_of_step(frame, step), quoted(frame.list().name())));
    });
  return emitter;
}

void write_rungs(const Frame &frame, Writer &out, RungEmitter &emitter, std::size_t routine, const Chunk &chunk,
                 llvm::StringRef file_name) {
  const std::vector<ir::Rung> &rungs = frame.module.routines[routine].rungs;
  CommentFinder comments(frame, rungs[chunk.first].first_instruction);
  for (std::size_t i = chunk.first; i <= chunk.last; ++i) {
    const ir::Rung &rung = rungs[i];
    if (i > chunk.first)
      out.blank();
    std::vector<std::string> statements;
    std::vector<std::pair<std::uint32_t, std::string>> notes;
    comments.take(rung.first_instruction + std::max(rung.instruction_count, 1U) - 1, statements, notes);
    for (const std::string &statement : statements)
      out.comment(statement);
    write_rung_comment(frame, out, rung, notes);
    emitter.emit(rung);
    if (frame.options.line_directives && !rung.operations.empty())
      out.left(fmt::format("#line {} {}", out.lines() + 2, quoted(file_name)));
  }
}

}  // namespace ladderc::emit
