// The spellings of one family: looking words up, and guessing what a misspelt one meant.
#pragma once

#include "source/list_reader.h"
#include "tables/tables.h"

#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/StringMap.h"

#include <array>
#include <optional>

namespace ladderc {

/// The table entries of one spelling and the operand counts that they take.
struct Mnemonic {
  llvm::ArrayRef<const InstructionInfo *> entries;
  std::uint64_t counts = 0;  ///< bit n: some entry takes n operands
  std::uint64_t texts = 0;   ///< bit n: some entry takes a text as operand n
  unsigned max_operands = 0;

  bool takes(unsigned count) const { return count < 64 && ((counts >> count) & 1) != 0; }
  bool takes_text(unsigned position) const { return position < 64 && ((texts >> position) & 1) != 0; }
  /// A label is written as the word of its operand (`P8`), which is no mnemonic.
  bool is_label() const { return !entries.empty() && entries.front()->placement == Placement::Label; }
};

struct MnemonicMatch {
  const Mnemonic *mnemonic = nullptr;
  std::size_t words = 0;
  explicit operator bool() const { return mnemonic != nullptr; }
};

class Mnemonics {
public:
  explicit Mnemonics(const FamilyInfo &family);

  /// The mnemonic that the words begin with; more words win over fewer.
  MnemonicMatch match(llvm::ArrayRef<Word> words) const;
  /// The mnemonic of labels with that prefix, or null.
  const Mnemonic *label(llvm::StringRef prefix) const;
  /// True where words that begin with a dash are comments, because no mnemonic does.
  bool has_dash_comments() const { return dash_comments_; }

  /// The spelling that differs least from a word, if it differs little. Gives up after some hundred words: a file that is no list
  /// must not take minutes.
  std::optional<llvm::StringRef> nearest(llvm::StringRef word);

private:
  const Mnemonic *find(llvm::StringRef spelling) const;
  MnemonicMatch match_parts(llvm::ArrayRef<Word> words) const;
  MnemonicMatch match_number(llvm::ArrayRef<Word> words) const;
  const Mnemonic *numbered(unsigned number, bool wide, bool pulse) const;
  bool is_pulse_suffix(llvm::ArrayRef<Word> words, std::size_t place) const;

  const FamilyInfo &family_;
  llvm::StringMap<Mnemonic> by_spelling_;
  std::array<bool, 256> begins_second_word_{};  ///< characters that the second words of spellings with a blank begin with
  bool dash_comments_ = true;
  llvm::DenseMap<unsigned, llvm::StringRef> by_number_;  ///< spellings of function numbers, by number_key()
  unsigned guesses_left_ = 200;
};

}  // namespace ladderc
