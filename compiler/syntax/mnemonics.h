// The spellings of one family: looking words up, and guessing what a misspelt one meant.
#pragma once

#include "source/list_reader.h"
#include "tables/tables.h"

#include "llvm/ADT/StringMap.h"

#include <array>
#include <optional>

namespace ladderc {

/// The table entries of one spelling and the operand counts that they take.
struct Mnemonic {
  llvm::ArrayRef<const InstructionInfo *> entries;
  std::uint64_t counts = 0;  ///< bit n: some entry takes n operands
  unsigned max_operands = 0;

  bool takes(unsigned count) const { return count < 64 && ((counts >> count) & 1) != 0; }
};

struct MnemonicMatch {
  const Mnemonic *mnemonic = nullptr;
  std::size_t words = 0;  ///< 1 or 2
  explicit operator bool() const { return mnemonic != nullptr; }
};

class Mnemonics {
public:
  explicit Mnemonics(const FamilyInfo &family);

  /// The mnemonic that the words begin with; two words win over one.
  MnemonicMatch match(llvm::ArrayRef<Word> words) const;

  /// The spelling that differs least from a word, if it differs little. Gives up after some hundred words: a file that is no list
  /// must not take minutes.
  std::optional<llvm::StringRef> nearest(llvm::StringRef word);

private:
  const Mnemonic *find(llvm::StringRef spelling) const;

  const FamilyInfo &family_;
  llvm::StringMap<Mnemonic> by_spelling_;
  std::array<bool, 256> begins_second_word_{};  ///< characters that the second words of spellings with a blank begin with
  unsigned guesses_left_ = 200;
};

}  // namespace ladderc
