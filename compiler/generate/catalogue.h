// Which instructions a list of a profile may use, in groups between which the generator chooses.
//
// A uniform choice among all entries would give a list of word instructions, of which there are a hundred, and hardly ever a coil.
// So a kind is chosen first, then a mnemonic, then one of its entries.
#pragma once

#include "generate/generate.h"
#include "generate/random.h"

#include <map>
#include <vector>

namespace ladderc::generate {

class Catalogue {
public:
  explicit Catalogue(const GenerateOptions &options);

  /// An instruction of that placement, chosen by kind, or null where the profile has none. Outputs are those that neither
  /// open a range nor name a label.
  const InstructionInfo *pick(Random &random, Placement placement) const;
  /// The first entry that becomes that, or null.
  const InstructionInfo *find(Lowering lowering) const;
  /// Any entry that becomes that, or null: CJ and CJP.
  const InstructionInfo *pick(Random &random, Lowering lowering) const;
  /// Any instruction without a condition that is no end of something, or null.
  const InstructionInfo *pick_alone(Random &random) const;
  /// Any plain contact in series.
  const InstructionInfo *pick_plain_series(Random &random) const;
  /// An assignment of a word whose width is that of `type`, or null.
  const InstructionInfo *find_assignment(OperandType type) const;

private:
  struct Kind {
    unsigned weight;
    std::vector<std::vector<const InstructionInfo *>> mnemonics;
  };
  void add(const InstructionInfo &info);

  std::map<Placement, std::map<unsigned, Kind>> placements_;
  std::map<Lowering, std::vector<const InstructionInfo *>> by_lowering_;
  std::vector<const InstructionInfo *> plain_series_, assignments_, alone_;
};

/// True where the instruction can stop the CPU.
inline bool may_stop(const InstructionInfo &info, const FamilyInfo &family) {
  return (info.error_code != 0 && family.errors_stop) || info.stops_scan;
}

}  // namespace ladderc::generate
