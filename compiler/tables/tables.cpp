// The tables of all families, and looking things up in them.
//
// The arrays are constants written by grammar/tblgen. A family's mnemonics and prefixes are entered in hash tables once, at the
// first look-up, because the parser asks a million times.
#include "tables/tables.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringMap.h"

#include <algorithm>
#include <vector>

#include "melsec-qs.inc"

namespace ladderc {
namespace {

// Alphabetical by id. A new family is its file in grammar/, its name in grammar/CMakeLists.txt, and a line here and above.
constexpr FamilyInfo kFamilies[] = {
    melsec_qs_tables::kFamily,
};

struct FamilyIndex {
  explicit FamilyIndex(const FamilyInfo &family) {
    for (const auto &[id, device] : llvm::enumerate(family.devices))
      devices[device.prefix] = static_cast<DeviceId>(id);
    for (const InstructionInfo &info : family.instructions) {
      instructions[info.spelling].push_back(&info);
      for (llvm::StringRef alias : info.aliases)
        instructions[alias].push_back(&info);
    }
  }

  llvm::StringMap<DeviceId> devices;
  llvm::StringMap<llvm::SmallVector<const InstructionInfo *, 4>> instructions;
};

std::vector<FamilyIndex> build_indexes() {
  std::vector<FamilyIndex> indexes;
  for (const FamilyInfo &family : kFamilies)
    indexes.emplace_back(family);
  return indexes;
}

/// The index of one of `families()`; a copy of a family is found by its id.
const FamilyIndex *index_of(const FamilyInfo &family) {
  static const std::vector<FamilyIndex> indexes = build_indexes();
  for (const auto &[place, known] : llvm::enumerate(kFamilies))
    if (&known == &family || known.id == family.id)
      return &indexes[place];
  return nullptr;
}

}  // namespace

llvm::ArrayRef<FamilyInfo> families() {
  return kFamilies;
}

const FamilyInfo *find_family(llvm::StringRef id) {
  const FamilyInfo *found = llvm::find_if(kFamilies, [&](const FamilyInfo &family) { return family.id == id; });
  return found == std::end(kFamilies) ? nullptr : found;
}

DeviceId find_device(const FamilyInfo &family, llvm::StringRef prefix) {
  const FamilyIndex *index = index_of(family);
  if (!index)
    return kNoDevice;
  auto found = index->devices.find(prefix);
  return found == index->devices.end() ? kNoDevice : found->second;
}

llvm::ArrayRef<const InstructionInfo *> find_instructions(const FamilyInfo &family, llvm::StringRef spelling) {
  const FamilyIndex *index = index_of(family);
  if (!index)
    return {};
  auto found = index->instructions.find(spelling);
  if (found == index->instructions.end())
    return {};
  return found->second;
}

const ErrorInfo *find_error(const FamilyInfo &family, std::uint16_t code) {
  const ErrorInfo *found =
      llvm::lower_bound(family.errors, code, [](const ErrorInfo &error, std::uint16_t c) { return error.code < c; });
  return found != family.errors.end() && found->code == code ? found : nullptr;
}

std::uint32_t points_of(const DeviceInfo &device, llvm::StringRef model) {
  for (const ModelPoints &entry : device.model_points)
    if (entry.model == model)
      return entry.points;
  return device.points;
}

}  // namespace ladderc
