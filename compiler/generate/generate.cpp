// The profiles by name, and the entry point.
#include "generate/generate.h"

#include "generate/program_maker.h"

namespace ladderc {

namespace {

struct ProfileName {
  GenerateProfile profile;
  llvm::StringLiteral name;
};
constexpr ProfileName kProfiles[] = {
    {GenerateProfile::Contacts, "contacts"}, {GenerateProfile::Mixed, "mixed"}, {GenerateProfile::All, "all"}};

}  // namespace

std::optional<GenerateProfile> find_generate_profile(llvm::StringRef name) {
  for (const ProfileName &p : kProfiles)
    if (p.name == name)
      return p.profile;
  return std::nullopt;
}

llvm::StringRef name(GenerateProfile profile) {
  for (const ProfileName &p : kProfiles)
    if (p.profile == profile)
      return p.name;
  return {};
}

std::string generate_list(const GenerateOptions &options) {
  return generate::ProgramMaker(options).list();
}

}  // namespace ladderc
