// Image sizes, functions and files.
#include "emit/layout.h"

#include "emit/places.h"
#include "emit/rung.h"
#include "ir/extent.h"

#include <algorithm>

namespace ladderc::emit {

namespace {

/// Grows the images so that every point of the place has memory.
void reach(const ir::Module &module, const Parameters &parameters, const ir::Place &place, std::vector<std::uint32_t> &count) {
  const ir::Extent e = ir::extent(module, place);
  if (e.none || e.space != ir::PlaceKind::Bit)
    return;
  auto grow = [&](DevicePoint p) {
    if (p.device != kNoDevice)
      count[p.device] = std::max(count[p.device], p.number + 1);
  };
  if (place.type == OperandType::WordBlock) {
    count[e.device] = std::max(count[e.device], parameters.points[e.device]);
    return;
  }
  if (!crosses_end(*module.family, parameters, e.device, e.first, e.last - e.first + 1))
    return grow({e.device, e.last});
  for (std::uint32_t i = 0; i <= e.last - e.first; ++i)
    grow(point_behind(*module.family, parameters, {e.device, e.first}, i));
}

}  // namespace

Layout make_layout(const ir::Module &module, const Parameters &parameters, const LayoutLimits &limits) {
  Layout layout;
  layout.count.assign(module.family->devices.size(), 0);
  const std::vector<ir::Rung> &rungs = module.routines.front().rungs;
  for (const ir::Rung &rung : rungs)
    for (const ir::Operation &o : rung.operations) {
      if (o.op == ir::Op::Load || !ir::is_value(o.op) || o.op == ir::Op::Rising || o.op == ir::Op::Falling)
        if (o.op != ir::Op::Call && o.op != ir::Op::Run)
          reach(module, parameters, o.place, layout.count);
      for (const ir::Place &p : o.inputs)
        reach(module, parameters, p, layout.count);
      for (const ir::Place &p : o.outputs)
        reach(module, parameters, p, layout.count);
    }
  for (const std::vector<InitialValue> *values : {&parameters.initial_values, &parameters.latched_values})
    for (const InitialValue &value : *values)
      reach(module, parameters, place_of(*module.family, value), layout.count);
  std::size_t total = 0;
  for (const ir::Rung &rung : rungs)
    total += rung.operations.size();
  // Files of equal size: compilers that run side by side end together.
  const std::size_t per_file = total / (total / limits.operations_per_file + 1) + 1;
  std::size_t operations = 0, in_file = 0;
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    const bool full = !layout.chunks.empty() && (i - layout.chunks.back().first >= limits.rungs_per_function ||
                                                 operations + rungs[i].operations.size() > limits.operations_per_function);
    if (layout.chunks.empty() || full) {
      if (in_file >= per_file) {
        ++layout.files;
        in_file = 0;
      }
      layout.chunks.push_back({i, i, false, layout.files - 1});
      operations = 0;
    }
    operations += rungs[i].operations.size();
    in_file += rungs[i].operations.size();
    layout.chunks.back().last = i;
    layout.chunks.back().can_stop |= can_stop(rungs[i]);
  }
  return layout;
}

}  // namespace ladderc::emit
