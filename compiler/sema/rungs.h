// Rungs, blocks and branches.
#pragma once

#include "sema/context.h"

#include "llvm/ADT/SmallVector.h"

namespace ladderc::sema {

/// Walks the list once with the block stack and the branch stack of the controller, numbers the rungs and reports what does not
/// pair.
class Rungs {
public:
  explicit Rungs(const Context &context) : context_(context) {}

  /// Sets the rung of the instruction. To be called in list order; an instruction without `info` is an unknown one.
  void visit(InstructionIndex index);
  /// The list ends, with or without END.
  void finish();
  std::uint32_t count() const { return rung_; }

private:
  struct Block {
    InstructionIndex opened_by;
    bool after_output;  ///< an output stands directly before, so that this may be the next rung behind a branch that was left open
    InstructionIndex edge_relay = kNoInstruction;  ///< the last EGP or EGF that its result has gone through
  };
  struct Branch {
    InstructionIndex opened_by;
    std::size_t depth;                             ///< blocks that were open
    InstructionIndex edge_relay = kNoInstruction;  ///< of the block whose result is kept
  };
  /// The end of the rung before, while this rung has no output and may yet turn out to go on from there.
  struct Continuation {
    InstructionIndex block = kNoInstruction;      ///< opened the block of the rung before; kNoInstruction: cannot go on
    InstructionIndex begin = kNoInstruction;      ///< of this rung
    InstructionIndex page_feed = kNoInstruction;  ///< NOPLF between the two
    unsigned contacts = 0;                        ///< instructions of this rung that change the result
  };
  /// What the current rung ends with so far. NOPs don't count.
  enum class Last { Nothing, Contact, Output, Unknown };

  void place(InstructionIndex index, Placement placement);
  void start(InstructionIndex index);
  void join(InstructionIndex index);
  void check_edge_relay(InstructionIndex index, Placement placement);
  bool goes_on_from_rung_before(InstructionIndex index) const;
  void go_on_from_rung_before(InstructionIndex index);
  void push_branch(InstructionIndex index);
  void read_branch(InstructionIndex index, bool pop);
  void output(InstructionIndex index);
  void stand_alone(InstructionIndex index);
  void between_rungs(InstructionIndex index);
  void unknown(InstructionIndex index);

  void begin_rung(InstructionIndex index);
  void end_rung(InstructionIndex before);
  void continue_rung(InstructionIndex index);
  void need_block(InstructionIndex index, DiagId id);
  void leave_result(InstructionIndex index);
  void report_open_block(InstructionIndex block, InstructionIndex user);
  void split_behind_open_branch(InstructionIndex index);
  std::optional<DiagBuilder> fail(DiagId id, InstructionIndex index);
  DiagBuilder report(DiagId id, InstructionIndex index) const;

  const Context &context_;
  std::uint32_t rung_ = 0;
  bool open_ = false;  ///< a rung has begun and is not closed by MCR or END
  llvm::SmallVector<Block, 16> blocks_;
  llvm::SmallVector<Branch, 16> branches_;
  Last last_ = Last::Nothing;
  InstructionIndex unused_ = kNoInstruction;     ///< first instruction whose result no output has used yet
  InstructionIndex failed_ = kNoInstruction;     ///< the rung has an error here, and its further ones are consequences
  InstructionIndex last_pop_ = kNoInstruction;   ///< MPP of this rung
  InstructionIndex page_feed_ = kNoInstruction;  ///< NOPLF behind an output: between rungs if a rung follows
  Continuation before_;
  InstructionIndex range_head_ = kNoInstruction;  ///< SMCS or JCS that ends the rung: no result goes on behind it
  bool state_head_ = false;                       ///< behind STL, before the first contact: outputs are driven by the state
  bool after_unknown_ = false;                    ///< the rung began behind an unknown instruction, perhaps wrongly
};

}  // namespace ladderc::sema
