// Random legal lists, for tests that compare two ways of running the same program.
//
// Everything comes from the instruction tables: which instructions there are, where in a rung they stand, what their operands take.
// What the tables cannot say is the shape of rungs, which rung_maker.cpp knows. Same options, same list, on every machine.
#pragma once

#include "sema/parameters.h"
#include "tables/tables.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace ladderc {

enum class GenerateProfile : std::uint8_t {
  Contacts,  ///< contacts, blocks, OUT
  Mixed,     ///< everything that neither stops the CPU nor calls its system
  All,       ///< the whole instruction set; what may stop the CPU does so seldom
};

/// "contacts", "mixed", "all".
std::optional<GenerateProfile> find_generate_profile(llvm::StringRef name);
llvm::StringRef name(GenerateProfile profile);

struct GenerateOptions {
  const FamilyInfo *family = nullptr;
  llvm::StringRef model;  ///< empty: the family's first
  Parameters parameters;  ///< the allocation that device numbers stay in; begin with default_parameters()
  GenerateProfile profile = GenerateProfile::All;
  std::uint64_t seed = 1;
  unsigned rungs = 20;                                   ///< at least so many
  std::function<bool(const InstructionInfo &)> accepts;  ///< of the profile's instructions only these; empty: all
  DeviceSet without = 0;                                 ///< classes that no operand names
};

/// A plain list that the check accepts without an error. There may be warnings: double coils and the like are worth testing.
std::string generate_list(const GenerateOptions &options);

}  // namespace ladderc
