// Which values of a rung become part of a larger expression and which get a name, and how expressions are printed.
//
// A value is inlined at its only use where moving it there changes nothing: no operation in between may write what it reads (or,
// for an edge, touch its memory). A plain contact may be inlined at several uses: reading it again is as good as a name. Everything
// else becomes `const bit line_STEP = ...;` where it stands: the state of the line at that step. Expressions are cut at a size that
// a person can read and a C++ compiler parses quickly.
#pragma once

#include "emit/places.h"
#include "ir/ir.h"

#include <string>
#include <vector>

namespace ladderc::emit {

/// The decisions for one rung.
class RungPlan {
public:
  /// `group_calls`: neighbouring calls with one condition share one `if`, and count as one use of the condition.
  RungPlan(const ir::Module &module, const ir::Rung &rung, bool group_calls);

  /// True where the operation is printed as part of its user.
  bool inlined(std::size_t index) const { return inlined_[index]; }
  /// Index of the operation that defines the value.
  std::size_t definition(ir::ValueId v) const { return definition_[v]; }
  unsigned uses(ir::ValueId v) const { return uses_[v]; }
  /// True where the call at `index` continues the `if` of the call before it.
  bool continues_group(std::size_t index) const { return continues_[index]; }

private:
  void count_uses(bool group_calls);
  void decide(const ir::Module &module);
  bool may_move(const ir::Module &module, std::size_t from, std::size_t to) const;

  const ir::Rung &rung_;
  std::vector<bool> inlined_, continues_;
  std::vector<std::size_t> definition_;
  std::vector<unsigned> uses_;
  std::vector<std::size_t> effects_;  ///< indexes of operations that write something, ascending
};

/// Binding strength, loosest first.
enum class Precedence : std::uint8_t { Or, Xor, And, Not, Primary };

struct Expression {
  std::string text;
  Precedence precedence = Precedence::Primary;
};

/// `text`, in parentheses where it binds looser than `at_least`.
std::string operand_of(const Expression &expression, Precedence at_least);

/// What a function of the runtime gets: images, inputs, outputs that it writes itself, the system.
std::string arguments_text(const PlaceContext &context, const ir::Operation &operation);
/// Text of `ops::f(a, b)`; for a nameless function the place, and without a place 0.
std::string call_text(const PlaceContext &context, const ir::Operation &operation);

}  // namespace ladderc::emit
