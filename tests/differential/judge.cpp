// Which interpreter judges which family.
#include "judge.h"

#include "interpreter.h"
#include "tp03_interpreter.h"

#include <fmt/format.h>

namespace ladderc::differential {

namespace {

template <class T> std::unique_ptr<Judge> make(const CheckedProgram &program) {
  return T::knows(program) ? std::make_unique<T>(program) : nullptr;
}

struct JudgeOf {
  llvm::StringLiteral family;
  std::unique_ptr<Judge> (*make)(const CheckedProgram &);
  bool (*knows)(const InstructionInfo &);  ///< of a partial judge
};
const JudgeOf kJudges[] = {{"melsec-qs", make<Interpreter>, nullptr},
                           {"tp03", make<Tp03Interpreter>, Tp03Interpreter::knows_instruction}};

const JudgeOf *judge_of(const FamilyInfo &family) {
  for (const JudgeOf &judge : kJudges)
    if (judge.family == family.id)
      return &judge;
  return nullptr;
}

}  // namespace

std::unique_ptr<Judge> make_judge(const CheckedProgram &program) {
  const JudgeOf *judge = judge_of(*program.family);
  return judge ? judge->make(program) : nullptr;
}

bool has_partial_judge(const FamilyInfo &family) {
  const JudgeOf *judge = judge_of(family);
  return judge && judge->knows;
}

bool is_judged(const FamilyInfo &family, const InstructionInfo &info) {
  return judge_of(family)->knows(info);
}

DeviceSet not_judged(const FamilyInfo &family) {
  DeviceSet set = 0;
  for (DeviceId id = 0; id < family.devices.size(); ++id)
    if (is_system_class(family, id))
      set |= DeviceSet(1) << id;
  return set;
}

std::string state_text(bool running, unsigned error, std::uint32_t step) {
  return fmt::format("{} with error {} at step {}", running ? "runs" : "stands", error, step);
}

}  // namespace ladderc::differential
