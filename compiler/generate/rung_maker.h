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

  void rung();
  /// The contacts of a rung of which the outputs are to follow.
  void condition(unsigned depth);
  /// Something that changes the result so far; depth 0: one contact.
  void more(unsigned depth);
  void output();
  void line(const InstructionInfo &info, llvm::ArrayRef<std::string> operands);
  /// Many contacts in series: what follows happens seldom.
  void guard();
  /// False where the allocation has no operands for it.
  bool instruction(const InstructionInfo *info, bool tame = true);

  const GenerateOptions &options() const { return options_; }
  Random &random() { return random_; }
  const Catalogue &catalogue() const { return catalogue_; }
  OperandMaker &operands() { return operands_; }
  unsigned rungs() const { return rungs_; }
  std::string &text() { return text_; }

private:
  void block(unsigned depth);
  void outputs(unsigned depth);
  void seldom_output(const InstructionInfo &info);
  void filler(Placement placement);
  bool instruction_on_fresh_number(const InstructionInfo &info);

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
