// From words to instructions.
//
//   list        = { line }
//   line        = { instruction }                  several on a line
//               | operand { operand } { instruction }   operands of the instruction before, on a line of their own
//   instruction = mnemonic { operand } | label [ ":" ]
//   mnemonic    = a spelling of the tables, or words that make one together (`LD =`, `D MOV P`: mnemonics.cpp)
//   operand     = a word, or the letter and the number of one as two words (`S 20`) in a family that prints blanks there
//
// A label (P8, I001) is an instruction whose operand is the word itself. Behind an instruction that has all its operands, a word
// that begins with a dash makes the rest of the line a comment, in families without mnemonics of that kind.
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
  Parser(const FamilyInfo &family, const SourceBuffer &buffer, unsigned file, llvm::StringSaver &saver, Diagnostics &diagnostics)
      : family_(family), buffer_(buffer), saver_(saver), diagnostics_(diagnostics), mnemonics_(family), operands_(family) {
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

  /// One operand as it is written: a word, or two words that make one.
  struct OperandWord {
    Word word;
    std::size_t words;
  };

  std::size_t take_words(const ListLine &line);
  std::size_t begin_line(const ListLine &line);
  std::size_t take_inner(llvm::ArrayRef<Word> words);
  std::size_t take_operand(llvm::ArrayRef<Word> words);
  std::size_t take_label(llvm::ArrayRef<Word> words);
  void take_text(const Word &word);
  OperandWord operand_word(llvm::ArrayRef<Word> words);
  bool begins_comment(const Word &word) const;
  SourceRange dash_comment(const ListLine &line, const Word &first) const;
  void begin_known(llvm::ArrayRef<Word> words, const Mnemonic &mnemonic, std::size_t count);
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

  /// A text is due, which is no operand by its letters.
  bool wants_text() const { return target_ == Target::Known && current_->takes_text(count()); }

  const FamilyInfo &family_;
  const SourceBuffer &buffer_;
  llvm::StringSaver &saver_;
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
  if (line.words.empty()) {
    if (line.comment.length != 0)
      statements_.push_back(line.comment);
  } else if (const std::size_t words = take_words(line); words == line.words.size()) {
    comment(CommentKind::Line, line.comment);
  } else if (const SourceRange range = dash_comment(line, line.words[words]); words != 0) {
    comment(CommentKind::Line, range);
  } else if (range.length != 0) {
    statements_.push_back(range);
  }
  comment(CommentKind::Note, line.note);
}

/// A dash before a digit may be a misspelt constant where an operand is due.
bool Parser::begins_comment(const Word &word) const {
  if (!word.text.starts_with("-") || !mnemonics_.has_dash_comments())
    return false;
  llvm::StringRef behind = word.text.drop_front();
  return satisfied() || behind.empty() || !llvm::isDigit(behind.front());
}

/// From behind the dashes of the first word to the end of the line.
SourceRange Parser::dash_comment(const ListLine &line, const Word &first) const {
  const std::uint32_t end = line.comment.length != 0 ? line.comment.end() : line.words.back().range.end();
  llvm::StringRef text = buffer_.text().slice(first.range.begin, end);
  for (bool dash = true; dash;) {
    dash = false;
    for (llvm::StringRef sign : {"-", " ", "\t", "\xE2\x80\x93", "\xE2\x80\x94", "\xE2\x88\x92", "\xEF\xBC\x8D"})
      dash |= text.consume_front(sign);
  }
  return SourceRange(end - static_cast<std::uint32_t>(text.size()), static_cast<std::uint32_t>(text.size()), first.range.file);
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

/// Takes the words of a line up to a comment in dashes; returns how many they are.
std::size_t Parser::take_words(const ListLine &line) {
  llvm::ArrayRef<Word> words = line.words;
  const bool cells = line.continues || line.starts_instruction;
  if (begins_comment(words.front()))
    return 0;
  std::size_t i = line.continues ? 0 : begin_line(line);
  while (i < words.size() && !begins_comment(words[i]))
    i += cells ? take_operand(words.drop_front(i)) : take_inner(words.drop_front(i));
  return i;
}

/// Decides what a line begins with; returns the number of words used.
std::size_t Parser::begin_line(const ListLine &line) {
  if (!line.starts_instruction && wants_text())
    return 0;
  if (MnemonicMatch match = mnemonics_.match(line.words)) {
    begin_known(line.words, *match.mnemonic, match.words);
    return match.words;
  }
  if (line.starts_instruction || satisfied())
    if (const std::size_t words = take_label(line.words))
      return words;
  const Word &word = line.words.front();
  OperandProblem problem;
  const OperandWord operand = operand_word(line.words);
  const bool readable =
      !line.starts_instruction && operands_.read(operand.word.text, operand.word.range, &problem).kind != OperandKind::Invalid;
  const bool misspelt = !readable && !line.starts_instruction && problem.looks_like_operand() && !satisfied();
  if ((readable || misspelt) && has_room())
    return 0;
  if (readable && target_ == Target::Dropped)
    return operand.words;
  if (readable) {
    report_stray(operand.word);
    return operand.words;
  }
  begin_unknown(word);
  return 1;
}

/// A word behind the first one of a line.
std::size_t Parser::take_inner(llvm::ArrayRef<Word> words) {
  const Word &word = words.front();
  if (wants_text())
    return take_operand(words);
  const OperandWord operand = operand_word(words);
  auto reads = [&] { return operands_.read(operand.word.text, operand.word.range); };
  if (target_ == Target::Known && !satisfied()) {
    // The usual case first: an operand is due and one stands here.
    if (Operand read = reads(); read.kind != OperandKind::Invalid) {
      add_operand(read);
      return operand.words;
    }
  }
  if (MnemonicMatch match = mnemonics_.match(words)) {
    const bool operand_wins = target_ == Target::Unknown && reads().kind != OperandKind::Invalid;
    if (!operand_wins) {
      begin_known(words, *match.mnemonic, match.words);
      return match.words;
    }
  }
  if (target_ != Target::Unknown)
    if (const std::size_t label = take_label(words))
      return label;
  const bool wordlike = word.text.front() != '"' && llvm::none_of(word.text, llvm::isDigit);
  // HFF has no digit, but reads as an operand that there is room for.
  const bool fits = has_room() && reads().kind != OperandKind::Invalid;
  if (target_ == Target::Known && satisfied() && wordlike && !fits && operand.words == 1) {
    begin_unknown(word);
    return 1;
  }
  return take_operand(words);
}

/// `P8`, `P8:`, `P 8`: an instruction whose operand is the word. Returns the number of words, 0 where no label stands.
std::size_t Parser::take_label(llvm::ArrayRef<Word> words) {
  OperandWord written = operand_word(words);
  (void)written.word.text.consume_back(":");
  const Operand operand = operands_.read(written.word.text, written.word.range);
  if (operand.kind != OperandKind::Device || family_.devices[operand.device].kind != DeviceKind::Label)
    return 0;
  const Mnemonic *label = mnemonics_.label(family_.devices[operand.device].prefix);
  if (!label)
    return 0;
  begin_known(words, *label, written.words);
  add_operand(operand);
  return written.words;
}

/// The word that an operand is written with: letters and number may stand apart, and a pair may name its second device in brackets,
/// `D4(D5)`, which says nothing.
Parser::OperandWord Parser::operand_word(llvm::ArrayRef<Word> words) {
  OperandWord result{words.front(), 1};
  if (words.size() >= 2 && operands_.goes_on(words[0].text, words[1].text)) {
    result.word.text = saver_.save(words[0].text + words[1].text);
    result.word.range.length = words[1].range.end() - words[0].range.begin;
    result.words = 2;
  }
  llvm::StringRef &text = result.word.text;
  if (family_.spaced_operands && text.ends_with(")") && text.front() != '(')
    text = text.take_until([](char c) { return c == '('; });
  return result;
}

std::size_t Parser::take_operand(llvm::ArrayRef<Word> words) {
  const OperandWord written = operand_word(words);
  switch (target_) {
  case Target::Nothing:
    report_stray(written.word);
    return written.words;
  case Target::Dropped:
    return written.words;
  case Target::Known:
  case Target::Unknown:
    break;
  }
  if (wants_text()) {
    take_text(words.front());
    return 1;
  }
  if (count() == kMaxOperands) {
    report_stray(written.word);
    return written.words;
  }
  OperandProblem problem;
  const Operand operand = operands_.read(written.word.text, written.word.range, &problem);
  if (operand.kind == OperandKind::Invalid && target_ == Target::Known)
    report_operand(written.word, problem);
  add_operand(operand);
  return written.words;
}

/// A text with or without quotes, in the letters that stand in the file.
void Parser::take_text(const Word &word) {
  llvm::StringRef written = word.text;
  std::string text;
  if (written.consume_front("\"")) {
    (void)written.consume_back("\"");
    for (std::size_t i = 0; i < written.size(); ++i) {
      text += written[i];
      if (written[i] == '"' && i + 1 < written.size() && written[i + 1] == '"')
        ++i;
    }
  } else {
    text = buffer_.slice(word.range).str();
  }
  Operand operand;
  operand.kind = OperandKind::Text;
  operand.value = static_cast<std::int64_t>(program_.texts.size());
  operand.range = word.range;
  program_.texts.push_back(std::move(text));
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

void Parser::begin_known(llvm::ArrayRef<Word> words, const Mnemonic &mnemonic, std::size_t count) {
  Instruction instruction;
  instruction.candidates = mnemonic.entries;
  instruction.range = words.front().range;
  if (count > 1)
    instruction.range.length = words[count - 1].range.end() - instruction.range.begin;
  begin(instruction);
  current_ = &mnemonic;
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
  Parser parser(family, sources[file], file, saver, diagnostics);
  read_list(sources[file], file, format, saver, diagnostics, [&](const ListLine &line) { parser.take(line); });
  return parser.finish();
}

}  // namespace ladderc
