// Random rungs: which instruction may follow which.
#pragma once

#include "generate/catalogue.h"
#include "generate/operand_maker.h"

#include <string>

namespace ladderc::generate {

class RungMaker {
public:
  explicit RungMaker(const GenerateOptions &options)
      : options_(options), random_(options.seed), catalogue_(options), operands_(options, random_) {}

  std::string list();

private:
  void rung();
  unsigned region(unsigned first_level, unsigned depth);
  void block(unsigned depth);
  void more(unsigned depth);
  void outputs(unsigned depth);
  void output();
  void seldom_output(const InstructionInfo &info);
  void filler(Placement placement);
  bool instruction(const InstructionInfo *info, bool tame = true);
  bool instruction_on_fresh_number(const InstructionInfo &info);
  void line(const InstructionInfo &info, llvm::ArrayRef<std::string> operands);

  const GenerateOptions &options_;
  Random random_;
  Catalogue catalogue_;
  OperandMaker operands_;
  std::string text_;
  unsigned rungs_ = 0;
  unsigned open_branches_ = 0;
  bool edge_relay_ = false;     ///< the rung has one: its result must not become a parallel branch
  bool behind_output_ = false;  ///< an output stands directly before
};

}  // namespace ladderc::generate
