// The third judge of a program: an interpreter of lists, where one knows the family and all that the program uses.
#pragma once

#include "memory.h"
#include "sema/check.h"

#include <memory>
#include <optional>
#include <string>

namespace ladderc::differential {

class Judge {
public:
  virtual ~Judge() = default;

  virtual void power_on() = 0;
  virtual void set_run(bool run) = 0;
  virtual void scan(std::uint32_t now_us) = 0;
  virtual DeviceArray &array(DeviceId id) = 0;
  /// False for a class that this judge says nothing of.
  virtual bool keeps(DeviceId) const { return true; }
  /// In the words of Trial::state(); nothing where this judge does not know.
  virtual std::optional<std::string> state() const { return std::nullopt; }
};

/// Null where nobody knows some instruction or device of the program.
std::unique_ptr<Judge> make_judge(const CheckedProgram &program);

/// True where the family has a judge that knows a part of it only, so that programs have to be made for it.
bool has_partial_judge(const FamilyInfo &family);
/// Whether that judge knows an instruction, and the classes that it does not know.
bool is_judged(const FamilyInfo &family, const InstructionInfo &info);
DeviceSet not_judged(const FamilyInfo &family);

std::string state_text(bool running, unsigned error, std::uint32_t step);

}  // namespace ladderc::differential
