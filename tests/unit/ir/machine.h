// Runs IR on bits.
//
// Cells are bits of devices, edge memories and master states, by their text ("M0", "edge1", "master0"). Calls are written into a
// trace with the bits that they read; MOV of a constant to digits and of nothing else changes cells. A call that can end the scan
// writes all cells into the trace: that is what a host would see if it did. Two programs are the same if they leave the same cells
// and the same trace from every state.
#pragma once

#include "emit/expressions.h"
#include "ir/ir.h"

#include <map>
#include <string>
#include <vector>

namespace ladderc::test {

using Cells = std::map<std::string, bool>;

struct Outcome {
  Cells cells;
  std::vector<std::string> trace;
  bool operator==(const Outcome &) const = default;
};
std::string to_text(const Outcome &outcome);

/// How a rung is run: operation by operation, or as the emitter prints it, with either order inside of expressions.
enum class Way { Direct, LeftFirst, RightFirst };

/// One scan. Cells that are not in `cells` are OFF, SM400 is ON.
Outcome run_scan(const ir::Module &module, const Cells &cells, Way way = Way::Direct, bool group_calls = true);

/// Calls `f` with every state of the named cells.
template <class F> void for_each_state(const std::vector<std::string> &names, F f) {
  for (unsigned bits = 0; bits < 1u << names.size(); ++bits) {
    Cells cells;
    for (std::size_t i = 0; i < names.size(); ++i)
      cells[names[i]] = (bits >> i & 1) != 0;
    f(cells);
  }
}

}  // namespace ladderc::test
