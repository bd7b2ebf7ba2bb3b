// What lies inside of what: routines, loops, states of the step ladder, and the ranges that a condition switches or skips.
#pragma once

#include "sema/labels.h"

#include "llvm/ADT/SmallVector.h"

#include <vector>

namespace ladderc::sema {

/// A part of the program that is entered as a whole.
enum class ScopeKind : std::uint8_t {
  Main,
  Apart,  ///< behind a routine and not one itself
  Subroutine,
  Interrupt,
  Loop,
  State,  ///< of the step ladder, up to the next STL or RET
};

using ScopeIndex = std::uint32_t;
constexpr ScopeIndex kMainScope = 0;

struct Scope {
  ScopeKind kind;
  ScopeIndex parent;                           ///< of kMainScope: itself
  InstructionIndex opened_by;                  ///< label, FOR or the first STL
  InstructionIndex last_stl = kNoInstruction;  ///< of a state: the last STL in succession
};

class Ranges {
public:
  Ranges(const Context &context, const Labels &labels, InstructionIndex behind);

  /// To be called for every instruction in list order.
  void visit(InstructionIndex index);
  /// The end of the program: reports what is still open.
  void finish();

  const Scope &scope(ScopeIndex index) const { return scopes_[index]; }
  /// The innermost scope that an instruction lies in; a label at the head of a routine lies inside.
  ScopeIndex scope_of(InstructionIndex index) const { return scope_of_[index]; }
  /// The state around an instruction, or kMainScope.
  ScopeIndex state_of(InstructionIndex index) const;
  /// The routine around a scope: a scope that is no loop and no state.
  ScopeIndex routine_of(ScopeIndex index) const;
  /// The numbers of the states of a scope: several where it is a merge.
  llvm::SmallVector<std::int64_t, 2> states(ScopeIndex index) const;
  /// The MC or SMCS whose region an instruction lies in, or kNoInstruction.
  InstructionIndex master_of(InstructionIndex index) const { return master_of_[index]; }
  /// "the loop", "the state S20", "the routine P1".
  std::string scope_name(ScopeIndex index) const;
  /// "MC N0", "SMCS".
  std::string region_name(InstructionIndex opener) const;

private:
  /// MC, SMCS or JCS up to its end.
  struct Range {
    Lowering kind;
    std::int64_t level;  ///< of MC
    InstructionIndex opened_by;
    ScopeIndex scope;
  };

  void note_unreachable(InstructionIndex index);
  void place_label(InstructionIndex index);
  void place_interrupt(InstructionIndex index);
  void open_routine(InstructionIndex index, ScopeKind kind);
  void end_routine(InstructionIndex index, ScopeKind kind);
  void end_main(InstructionIndex index);
  void open_state(InstructionIndex index);
  void count_merge(InstructionIndex index);
  void close_state(InstructionIndex index);
  void open_loop(InstructionIndex index);
  void close_loop(InstructionIndex index);
  void open_range(InstructionIndex index);
  void close_ranges(InstructionIndex index, Lowering kind);

  /// Where X cannot stand inside of what is around, reports it.
  struct Forbidden {
    bool in_loop = true, in_state = true, in_routine = true;
  };
  bool is_forbidden(InstructionIndex index, Forbidden where);
  DiagId misplaced(InstructionIndex index, ScopeKind around) const;
  void push_scope(ScopeKind kind, InstructionIndex index);
  void pop_scope();
  void unwind(ScopeIndex to);
  void report_open(ScopeIndex index);
  bool goes_on(InstructionIndex index, Lowering end, llvm::ArrayRef<Lowering> stops) const;
  std::string text(InstructionIndex index) const;
  const Operand &operand(InstructionIndex index) const { return context_.operands(index).front(); }
  Lowering lowering(InstructionIndex index) const;
  ScopeKind kind() const { return scopes_[scope_].kind; }

  const Context &context_;
  const Labels &labels_;
  InstructionIndex behind_;
  std::vector<Scope> scopes_;
  std::vector<ScopeIndex> scope_of_;
  std::vector<InstructionIndex> master_of_;
  llvm::SmallVector<Range, 16> ranges_;
  ScopeIndex scope_ = kMainScope;
  bool ended_ = false;        ///< behind FEND, SRET, IRET: a label begins what follows
  bool main_ended_ = false;   ///< a FEND stands before
  bool unreachable_ = false;  ///< reported for this part
  InstructionIndex first_routine_ = kNoInstruction;
  InstructionIndex last_ = kNoInstruction;  ///< the instruction before, without NOPs
  unsigned merge_ = 0;                      ///< STL in succession
  /// Ends whose beginning was wrong and has been reported.
  unsigned excused_returns_ = 0, excused_states_ = 0, excused_loops_ = 0;
};

}  // namespace ladderc::sema
