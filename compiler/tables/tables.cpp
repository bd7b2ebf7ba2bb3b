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

#include "melsec-fx.inc"
#include "melsec-qs.inc"
#include "tp03.inc"

namespace ladderc {
namespace {

// Alphabetical by id. A new family is its file in grammar/, its name in grammar/CMakeLists.txt, and a line here and above.
constexpr FamilyInfo kFamilies[] = {
    melsec_fx_tables::kFamily,
    melsec_qs_tables::kFamily,
    tp03_tables::kFamily,
};

struct FamilyIndex {
  explicit FamilyIndex(const FamilyInfo &family) {
    for (const auto &[id, device] : llvm::enumerate(family.devices))
      devices[device.prefix].push_back(static_cast<DeviceId>(id));
    for (auto &entry : devices)
      llvm::sort(entry.second, [&](DeviceId a, DeviceId b) { return family.devices[a].first < family.devices[b].first; });
    for (const InstructionInfo &info : family.instructions) {
      instructions[info.spelling].push_back(&info);
      for (llvm::StringRef alias : info.aliases)
        instructions[alias].push_back(&info);
    }
  }

  llvm::StringMap<llvm::SmallVector<DeviceId, 1>> devices;  ///< ascending by their first numbers
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
  return found == index->devices.end() ? kNoDevice : found->second.front();
}

DeviceId find_device(const FamilyInfo &family, llvm::StringRef prefix, std::uint64_t number) {
  const FamilyIndex *index = index_of(family);
  if (!index)
    return kNoDevice;
  auto found = index->devices.find(prefix);
  if (found == index->devices.end())
    return kNoDevice;
  DeviceId device = found->second.front();
  for (DeviceId later : llvm::drop_begin(found->second))
    if (family.devices[later].first <= number)
      device = later;
  return device;
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

llvm::SmallVector<ModelNumbers, 4> existing_numbers(const DeviceInfo &device, llvm::StringRef model, std::uint32_t points) {
  llvm::SmallVector<ModelNumbers, 4> gaps, result;
  for (const ModelNumbers &gap : device.missing)
    if (gap.model.empty() || gap.model == model)
      gaps.push_back(gap);
  llvm::sort(gaps, [](const ModelNumbers &a, const ModelNumbers &b) { return a.first < b.first; });
  std::uint32_t next = device.first;
  const std::uint32_t end = device.first + points;
  for (const ModelNumbers &gap : gaps) {
    if (gap.first > next && next < end)
      result.push_back({model, next, std::min(gap.first, end) - 1});
    next = std::max(next, gap.last + 1);
  }
  if (next < end)
    result.push_back({model, next, end - 1});
  return result;
}

bool number_exists(const DeviceInfo &device, llvm::StringRef model, std::uint32_t points, std::uint64_t number) {
  return number >= device.first && number - device.first < points && llvm::none_of(device.missing, [&](const ModelNumbers &gap) {
           return (gap.model.empty() || gap.model == model) && number >= gap.first && number <= gap.last;
         });
}

llvm::SmallVector<ModelNumbers, 4> latched_numbers(const DeviceInfo &device, llvm::StringRef model) {
  const bool own = llvm::any_of(device.latched, [&](const ModelNumbers &run) { return !run.model.empty() && run.model == model; });
  const std::uint32_t end = device.first + points_of(device, model);
  llvm::SmallVector<ModelNumbers, 4> result;
  for (const ModelNumbers &run : device.latched)
    if (own ? run.model == model : run.model.empty())
      if (run.first < end)
        result.push_back({model, run.first, std::min(run.last, end - 1)});
  return result;
}

bool is_index_register(const FamilyInfo &family, DeviceId device) {
  if (device >= family.devices.size())
    return false;
  const DeviceInfo &info = family.devices[device];
  return info.kind == DeviceKind::Index || info.high_words != kNoDevice ||
         llvm::any_of(family.devices, [&](const DeviceInfo &low) { return low.high_words == device; });
}

llvm::StringRef cited_family(const FamilyInfo &family) {
  return family.base.empty() ? family.id : family.base;
}

}  // namespace ladderc
