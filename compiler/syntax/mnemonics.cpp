// All spellings of a family in one hash table, made once a list; a lookup is what most words of a list cost.
#include "syntax/mnemonics.h"

#include "llvm/ADT/SmallString.h"
#include "llvm/ADT/edit_distance.h"

namespace ladderc {

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
    }
    if (llvm::StringRef second = spelling.split(' ').second; !second.empty())
      begins_second_word_[static_cast<unsigned char>(second.front())] = true;
  };
  for (const InstructionInfo &entry : family.instructions) {
    enter(entry.spelling);
    for (llvm::StringRef alias : entry.aliases)
      enter(alias);
  }
}

const Mnemonic *Mnemonics::find(llvm::StringRef spelling) const {
  auto place = by_spelling_.find(spelling);
  return place == by_spelling_.end() ? nullptr : &place->second;
}

MnemonicMatch Mnemonics::match(llvm::ArrayRef<Word> words) const {
  if (words.size() >= 2 && !words[1].text.empty() && begins_second_word_[static_cast<unsigned char>(words[1].text.front())]) {
    llvm::SmallString<32> joined(words[0].text);
    joined += ' ';
    joined += words[1].text;
    if (const Mnemonic *mnemonic = find(joined))
      return {mnemonic, 2};
  }
  if (const Mnemonic *mnemonic = find(words[0].text))
    return {mnemonic, 1};
  return {};
}

std::optional<llvm::StringRef> Mnemonics::nearest(llvm::StringRef word) {
  constexpr std::size_t kLongest = 32;
  if (guesses_left_ == 0 || word.size() > kLongest)
    return std::nullopt;
  --guesses_left_;
  unsigned best = word.size() <= 3 ? 1 : 2;
  std::optional<llvm::StringRef> result;
  for (const InstructionInfo &entry : family_.instructions) {
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
