// From words to instructions.
//
//   list        = { line }
//   line        = { instruction }                  several on a line
//               | operand { operand } { instruction }   operands of the instruction before, on a line of their own
//   instruction = mnemonic { operand }
//   mnemonic    = a spelling of the tables, or two words that the tables join by one blank (`LD =`)
//
// Some words are both, as BCD, which is an instruction and the link relay B0CD:
//   * at the beginning of a line a mnemonic wins;
//   * behind it, a mnemonic wins once the instruction before has as many operands as one of its table entries takes; until then the
//     word is an operand if it reads as one;
//   * behind an unknown instruction, whose operands nobody knows, an operand wins;
//   * in a table the cell decides, and nothing is guessed.
// A word that is neither is a misspelt mnemonic where an instruction may begin, that is at the beginning of a line, or where the
// operands suffice and it has no digit; elsewhere it is a misspelt operand.
#include "syntax/parser.h"

#include "syntax/mnemonics.h"
#include "syntax/operand.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

namespace ladderc {
namespace {

llvm::StringRef radix_name(unsigned radix) {
  return radix == 8 ? "octal" : radix == 16 ? "hexadecimal" : "decimal";
}

class Parser {
public:
  Parser(const FamilyInfo &family, const SourceBuffer &buffer, unsigned file, Diagnostics &diagnostics)
      : family_(family), buffer_(buffer), diagnostics_(diagnostics), mnemonics_(family), operands_(family) {
    program_.family = &family;
    program_.file = file;
    program_.end_of_text = SourceRange(static_cast<std::uint32_t>(buffer.text().size()), 0, file);
    program_.instructions.reserve(buffer.line_count());
    program_.operands.reserve(buffer.line_count());
  }

  void take(const ListLine &line);
  ListProgram finish() {
    take_statements();
    return std::move(program_);
  }

private:
  /// What the next operand word is for.
  enum class Target {
    Nothing,  ///< no instruction yet
    Known,    ///< an instruction of the tables
    Unknown,  ///< an instruction that has been reported; its operands are taken as they come
    Dropped,  ///< something that has been reported; words are passed over up to the next mnemonic
  };

  void take_words(const ListLine &line);
  std::size_t begin_line(const ListLine &line);
  std::size_t take_inner(llvm::ArrayRef<Word> words);
  void take_operand(const Word &word);
  void begin_known(llvm::ArrayRef<Word> words, const MnemonicMatch &match);
  void begin_unknown(const Word &word);
  void add_operand(const Operand &operand);
  void report_operand(const Word &word, const OperandProblem &problem);
  void report_stray(const Word &word);
  void comment(CommentKind kind, SourceRange range);
  void take_statements();
  void begin(Instruction instruction);

  unsigned count() const { return program_.instructions.back().operand_count; }
  bool has_room() const { return target_ == Target::Unknown || (target_ == Target::Known && count() < current_->max_operands); }
  /// The instruction has as many operands as one of its entries takes, or more than all do.
  bool satisfied() const { return target_ != Target::Known || current_->takes(count()) || !has_room(); }

  const FamilyInfo &family_;
  const SourceBuffer &buffer_;
  Diagnostics &diagnostics_;
  Mnemonics mnemonics_;
  OperandReader operands_;
  ListProgram program_;
  /// Statements wait for the instruction that they stand above: rows between may still belong to the one before.
  llvm::SmallVector<SourceRange, 4> statements_;
  Target target_ = Target::Nothing;
  const Mnemonic *current_ = nullptr;  ///< of the last instruction, while target_ is Known
};

void Parser::take(const ListLine &line) {
  if (line.statement.length != 0)
    statements_.push_back(line.statement);
  if (!line.words.empty()) {
    take_words(line);
    comment(CommentKind::Line, line.comment);
  } else if (line.comment.length != 0) {
    statements_.push_back(line.comment);
  }
  comment(CommentKind::Note, line.note);
}

/// A comment of the last instruction, or of the first one to come.
void Parser::comment(CommentKind kind, SourceRange range) {
  if (range.length != 0)
    program_.comments.push_back(
        {static_cast<std::uint32_t>(std::max<std::size_t>(program_.instructions.size(), 1) - 1), kind, range});
}

void Parser::take_statements() {
  for (SourceRange range : statements_)
    program_.comments.push_back({static_cast<std::uint32_t>(program_.instructions.size()), CommentKind::Statement, range});
  statements_.clear();
}

void Parser::take_words(const ListLine &line) {
  llvm::ArrayRef<Word> words = line.words;
  const bool cells = line.continues || line.starts_instruction;
  std::size_t i = line.continues ? 0 : begin_line(line);
  while (i < words.size()) {
    if (cells) {
      take_operand(words[i]);
      ++i;
    } else {
      i += take_inner(words.drop_front(i));
    }
  }
}

/// Decides what a line begins with; returns the number of words used.
std::size_t Parser::begin_line(const ListLine &line) {
  const Word &word = line.words.front();
  if (MnemonicMatch match = mnemonics_.match(line.words)) {
    begin_known(line.words, match);
    return match.words;
  }
  OperandProblem problem;
  const bool readable = !line.starts_instruction && operands_.read(word.text, word.range, &problem).kind != OperandKind::Invalid;
  const bool misspelt = !readable && !line.starts_instruction && problem.looks_like_operand() && !satisfied();
  if ((readable || misspelt) && has_room())
    return 0;
  if (readable && target_ == Target::Dropped)
    return 1;
  if (readable) {
    report_stray(word);
    return 1;
  }
  begin_unknown(word);
  return 1;
}

/// A word behind the first one of a line.
std::size_t Parser::take_inner(llvm::ArrayRef<Word> words) {
  const Word &word = words.front();
  if (target_ == Target::Known && !satisfied()) {
    // The usual case first: an operand is due and one stands here.
    if (Operand operand = operands_.read(word.text, word.range); operand.kind != OperandKind::Invalid) {
      add_operand(operand);
      return 1;
    }
  }
  if (MnemonicMatch match = mnemonics_.match(words)) {
    const bool operand_wins = target_ == Target::Unknown && operands_.read(word.text, word.range).kind != OperandKind::Invalid;
    if (!operand_wins) {
      begin_known(words, match);
      return match.words;
    }
  }
  const bool wordlike = word.text.front() != '"' && llvm::none_of(word.text, llvm::isDigit);
  // HFF has no digit, but reads as an operand that there is room for.
  const bool fits = has_room() && operands_.read(word.text, word.range).kind != OperandKind::Invalid;
  if (target_ == Target::Known && satisfied() && wordlike && !fits) {
    begin_unknown(word);
    return 1;
  }
  take_operand(word);
  return 1;
}

void Parser::take_operand(const Word &word) {
  switch (target_) {
  case Target::Nothing:
    report_stray(word);
    return;
  case Target::Dropped:
    return;
  case Target::Known:
  case Target::Unknown:
    break;
  }
  if (count() == kMaxOperands) {
    report_stray(word);
    return;
  }
  OperandProblem problem;
  const Operand operand = operands_.read(word.text, word.range, &problem);
  if (operand.kind == OperandKind::Invalid && target_ == Target::Known)
    report_operand(word, problem);
  add_operand(operand);
}

void Parser::add_operand(const Operand &operand) {
  program_.operands.push_back(operand);
  ++program_.instructions.back().operand_count;
}

void Parser::begin(Instruction instruction) {
  take_statements();
  instruction.first_operand = static_cast<std::uint32_t>(program_.operands.size());
  program_.instructions.push_back(instruction);
}

void Parser::begin_known(llvm::ArrayRef<Word> words, const MnemonicMatch &match) {
  Instruction instruction;
  instruction.candidates = match.mnemonic->entries;
  instruction.range = words.front().range;
  if (match.words == 2)
    instruction.range.length = words[1].range.end() - instruction.range.begin;
  begin(instruction);
  current_ = match.mnemonic;
  target_ = Target::Known;
}

void Parser::begin_unknown(const Word &word) {
  DiagBuilder builder = diagnostics_.report(DiagId::UnknownMnemonic, word.range);
  builder.arg("word", buffer_.slice(word.range)).arg("family", family_.title);
  if (std::optional<llvm::StringRef> nearest = mnemonics_.nearest(word.text))
    builder.note(DiagId::NearestMnemonic, word.range).arg("name", *nearest);
  for (const FamilyInfo &other : families())
    if (other.id != family_.id && !find_instructions(other, word.text).empty())
      builder.note(DiagId::OtherFamily, word.range).arg("family", other.title);

  Instruction instruction;
  instruction.range = word.range;
  begin(instruction);
  target_ = Target::Unknown;
}

void Parser::report_operand(const Word &word, const OperandProblem &problem) {
  llvm::StringRef written = buffer_.slice(word.range);
  SourceRange range = word.range;
  llvm::StringRef part = word.text.substr(problem.begin, problem.length);
  // The part has a place of its own only where the word stands in the file as it was compared, apart from its case.
  if (!part.empty() && written.equals_insensitive(word.text)) {
    range.begin += static_cast<std::uint32_t>(problem.begin);
    range.length = static_cast<std::uint32_t>(part.size());
  }
  DiagBuilder builder = diagnostics_.report(problem.id, range);
  builder.arg("word", written);
  if (problem.id == DiagId::OperandUnreadable || problem.id == DiagId::UnsupportedConstant)
    builder.arg("family", family_.title);
  if (problem.id == DiagId::UnsupportedConstant)
    builder.arg("kind", problem.kind);
  if (problem.id == DiagId::DeviceNumberMissing || problem.id == DiagId::DigitNotInRadix)
    builder.arg("device", problem.device);
  if (problem.id == DiagId::DigitNotInRadix)
    builder.arg("digit", part).arg("radix", radix_name(problem.radix));
  if (problem.id == DiagId::BitNumber)
    builder.arg("bit", part);
}

void Parser::report_stray(const Word &word) {
  diagnostics_.report(DiagId::StrayOperand, word.range).arg("word", buffer_.slice(word.range));
  target_ = Target::Dropped;
}

}  // namespace

ListProgram parse_list(const FamilyInfo &family, const SourceSet &sources, unsigned file, ListFormat format,
                       Diagnostics &diagnostics) {
  llvm::BumpPtrAllocator memory;
  llvm::StringSaver saver(memory);
  Parser parser(family, sources[file], file, diagnostics);
  read_list(sources[file], file, format, saver, diagnostics, [&](const ListLine &line) { parser.take(line); });
  return parser.finish();
}

}  // namespace ladderc
