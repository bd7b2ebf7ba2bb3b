// All spellings of a family in one hash table, made once a list; a lookup is what most words of a list cost.
//
// A family that prints blanks inside of operands prints them inside of mnemonics too, and calls its application instructions by
// number as well:
//
//   mnemonic  = [ "D" ] name [ sign ] [ "P" ] | [ "D" ] number [ name-of-that-number ] [ "P" ]
//   number    = ( "F" | "FNC" ) [ "D" ] digits [ "D" ] [ "P" ]         F12, FNC12, FD12, F12P, F 12
//   name      = a spelling, behind a number also in brackets: `F00(CJ)`, `FNC01 (CALL)`
//
// D means 32 bits and P the rising edge, wherever they stand: `D MOV P`, `F12 DMOVP` and `FD12P` are one instruction.
#include "syntax/mnemonics.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SmallString.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/edit_distance.h"

namespace ladderc {
namespace {

bool is_sign(llvm::StringRef word) {
  return !word.empty() && llvm::all_of(word, [](char c) { return c == '<' || c == '=' || c == '>'; });
}

unsigned number_key(unsigned number, bool wide, bool pulse) {
  return number << 2 | static_cast<unsigned>(wide) << 1 | static_cast<unsigned>(pulse);
}

/// A function number as it is written.
struct FunctionNumber {
  unsigned number = 0;
  bool wide = false, pulse = false;
  std::size_t words = 1;
  llvm::StringRef bracketed;  ///< what stands in brackets behind it: "(CJ)"
};

std::optional<FunctionNumber> read_number(llvm::ArrayRef<Word> words) {
  FunctionNumber result;
  llvm::StringRef rest = words.front().text;
  if (!rest.consume_front("F"))
    return std::nullopt;
  (void)rest.consume_front("NC");
  result.wide = rest.consume_front("D");
  if (rest.empty() && words.size() >= 2) {
    rest = words[1].text;
    result.words = 2;
  }
  llvm::StringRef digits = rest.take_while(llvm::isDigit);
  constexpr std::size_t kMostDigits = 4;
  if (digits.empty() || digits.size() > kMostDigits || digits.getAsInteger(10, result.number))
    return std::nullopt;
  rest = rest.drop_front(digits.size());
  result.wide |= rest.consume_front("D");
  result.pulse = rest.consume_front("P");
  if (!rest.empty() && !rest.starts_with("("))
    return std::nullopt;
  result.bracketed = rest;
  if (rest.empty() && words.size() > result.words && words[result.words].text.starts_with("("))
    result.bracketed = words[result.words++].text;
  return result;
}

}  // namespace

Mnemonics::Mnemonics(const FamilyInfo &family) : family_(family) {
  auto enter = [&](llvm::StringRef spelling) {
    auto [place, is_new] = by_spelling_.try_emplace(spelling);
    if (!is_new)
      return;
    Mnemonic &mnemonic = place->second;
    mnemonic.entries = find_instructions(family, spelling);
    for (const InstructionInfo *entry : mnemonic.entries) {
      const auto count = static_cast<unsigned>(entry->operands.size());
      mnemonic.counts |= count < 64 ? std::uint64_t(1) << count : 0;
      mnemonic.max_operands = std::max(mnemonic.max_operands, count);
      for (unsigned k = 0; k < count && k < 64; ++k)
        mnemonic.texts |= entry->operands[k].type == OperandType::String ? std::uint64_t(1) << k : 0;
    }
    if (llvm::StringRef second = spelling.split(' ').second; !second.empty())
      begins_second_word_[static_cast<unsigned char>(second.front())] = true;
    dash_comments_ = dash_comments_ && !spelling.starts_with("-");
  };
  for (const InstructionInfo &entry : family.instructions) {
    enter(entry.spelling);
    for (llvm::StringRef alias : entry.aliases)
      enter(alias);
    if (entry.number >= 0)
      by_number_.try_emplace(number_key(static_cast<unsigned>(entry.number), entry.wide, entry.execution == Execution::RisingEdge),
                             entry.spelling);
  }
}

const Mnemonic *Mnemonics::find(llvm::StringRef spelling) const {
  auto place = by_spelling_.find(spelling);
  return place == by_spelling_.end() ? nullptr : &place->second;
}

const Mnemonic *Mnemonics::label(llvm::StringRef prefix) const {
  const Mnemonic *mnemonic = find(prefix);
  return mnemonic && mnemonic->is_label() ? mnemonic : nullptr;
}

MnemonicMatch Mnemonics::match(llvm::ArrayRef<Word> words) const {
  if (words.size() >= 2 && !words[1].text.empty() && begins_second_word_[static_cast<unsigned char>(words[1].text.front())]) {
    llvm::SmallString<32> joined(words[0].text);
    joined += ' ';
    joined += words[1].text;
    if (const Mnemonic *mnemonic = find(joined))
      return {mnemonic, 2};
  }
  if (family_.spaced_operands && words.size() >= 2 && (words[0].text == "D" || words[1].text == "P" || is_sign(words[1].text)))
    if (MnemonicMatch match = match_parts(words))
      return match;
  if (const Mnemonic *mnemonic = find(words[0].text); mnemonic && !mnemonic->is_label())
    return {mnemonic, 1};
  return by_number_.empty() ? MnemonicMatch() : match_number(words);
}

/// `D MOV P`: the parts of a mnemonic as words of their own.
MnemonicMatch Mnemonics::match_parts(llvm::ArrayRef<Word> words) const {
  llvm::SmallString<32> joined;
  std::size_t place = 0;
  if (words[0].text == "D" && words.size() > 1)
    joined += words[place++].text;
  joined += words[place++].text;
  if (place < words.size() && is_sign(words[place].text))
    joined += words[place++].text;
  const std::size_t without_suffix = joined.size();
  if (is_pulse_suffix(words, place)) {
    joined += 'P';
    if (const Mnemonic *mnemonic = find(joined); mnemonic && !mnemonic->is_label())
      return {mnemonic, place + 1};
    joined.truncate(without_suffix);
  }
  if (const Mnemonic *mnemonic = find(joined); mnemonic && place > 1 && !mnemonic->is_label())
    return {mnemonic, place};
  return {};
}

/// A P of its own behind the mnemonic; `CALL P 10` names a label.
bool Mnemonics::is_pulse_suffix(llvm::ArrayRef<Word> words, std::size_t place) const {
  return place < words.size() && words[place].text == "P" &&
         !(place + 1 < words.size() && llvm::isDigit(words[place + 1].text.front()));
}

MnemonicMatch Mnemonics::match_number(llvm::ArrayRef<Word> words) const {
  std::size_t place = 0;
  bool wide = false;
  llvm::SmallVector<Word, 8> rest(words.begin(), words.end());
  if (words[0].text == "D" && words.size() > 1) {
    wide = true;
    place = 1;
  } else if (words[0].text.starts_with("DF")) {
    wide = true;
    rest[0].text = rest[0].text.drop_front();
  }
  std::optional<FunctionNumber> number = read_number(llvm::ArrayRef(rest).drop_front(place));
  if (!number)
    return {};
  place += number->words;
  wide |= number->wide;
  bool pulse = number->pulse;
  auto take_name = [&](llvm::ArrayRef<Word> name) {
    MnemonicMatch match = family_.spaced_operands && name.size() > 1 ? match_parts(name) : MnemonicMatch();
    if (!match)
      if (const Mnemonic *found = find(name.front().text))
        match = {found, 1};
    if (!match)
      return std::size_t(0);
    const InstructionInfo &entry = *match.mnemonic->entries.front();
    if (entry.number != static_cast<int>(number->number))
      return std::size_t(0);
    wide |= entry.wide;
    pulse |= entry.execution == Execution::RisingEdge;
    return match.words;
  };
  if (llvm::StringRef name = number->bracketed; name.consume_front("(")) {
    name.consume_back(")");
    if (name.empty() || take_name(Word{name, {}}) == 0)
      return {};
  } else if (place < rest.size()) {
    place += take_name(llvm::ArrayRef(rest).drop_front(place));
  }
  if (!pulse && is_pulse_suffix(rest, place)) {
    pulse = true;
    ++place;
  }
  return {numbered(number->number, wide, pulse), place};
}

/// The mnemonic of a number. An instruction that exists in 32 bits only needs no D.
const Mnemonic *Mnemonics::numbered(unsigned number, bool wide, bool pulse) const {
  auto place = by_number_.find(number_key(number, wide, pulse));
  if (place == by_number_.end())
    place = by_number_.find(number_key(number, true, pulse));
  return place == by_number_.end() ? nullptr : find(place->second);
}

std::optional<llvm::StringRef> Mnemonics::nearest(llvm::StringRef word) {
  constexpr std::size_t kLongest = 32;
  if (guesses_left_ == 0 || word.size() > kLongest)
    return std::nullopt;
  --guesses_left_;
  unsigned best = word.size() <= 3 ? 1 : 2;
  std::optional<llvm::StringRef> result;
  for (const InstructionInfo &entry : family_.instructions) {
    if (entry.placement == Placement::Label)
      continue;
    const unsigned distance =
        llvm::ComputeEditDistance(llvm::ArrayRef(word.data(), word.size()),
                                  llvm::ArrayRef(entry.spelling.data(), entry.spelling.size()), /*AllowReplacements=*/true, best);
    // The first of equals stands: tables begin with the common instructions.
    if (distance < word.size() && (distance < best || (distance == best && !result))) {
      best = distance;
      result = entry.spelling;
    }
  }
  return result;
}

}  // namespace ladderc
