// Master control: the regions between MC and MCR.
#pragma once

#include "sema/context.h"
#include "sema/resolve.h"

#include "llvm/ADT/SmallVector.h"

namespace ladderc::sema {

class MasterRegions {
public:
  explicit MasterRegions(const Context &context) : context_(context) {}

  /// To be called for every instruction in list order.
  void visit(InstructionIndex index, const Resolved &resolved);
  /// The end of the program: reports what is still open.
  void finish();

private:
  struct Region {
    InstructionIndex opened_by;
    std::int64_t level;
    bool misplaced = false;  ///< its level is not higher than that of the region around
  };

  void open(InstructionIndex index, const Resolved &resolved);
  void close(InstructionIndex index, const Resolved &resolved);
  void visit_unknown(InstructionIndex index);
  bool level_in_range(InstructionIndex index, unsigned operand) const;
  void report_range(InstructionIndex index, unsigned operand);
  std::string level_name(InstructionIndex index, unsigned operand) const;

  const Context &context_;
  llvm::SmallVector<Region, 16> open_;
  /// MCRs (regions) without a partner that follow from a mistake reported already.
  unsigned excused_closings_ = 0, excused_regions_ = 0;
};

}  // namespace ladderc::sema
