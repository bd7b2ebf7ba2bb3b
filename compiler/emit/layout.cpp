// Image sizes, functions and files.
#include "emit/layout.h"

#include "emit/places.h"
#include "emit/rung.h"
#include "ir/extent.h"

#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

#include <fmt/format.h>

#include <algorithm>

namespace ladderc::emit {

namespace {

using ir::Op;

/// Grows the images so that every point that the program can reach has memory.
class Reach {
public:
  Reach(const ir::Module &module, const Parameters &parameters, std::vector<std::uint32_t> &count)
      : module_(module), parameters_(parameters), count_(count) {}

  void visit(const ir::Operation &o) {
    const bool to_label = o.op == Op::Jump || o.op == Op::Gosub;
    const bool has_place = (to_label && o.place.is_indexed()) || o.op == Op::Load || o.op == Op::Store || o.op == Op::Set || o.op == Op::Reset || o.op == Op::Transfer ||
                           ir::is_edge(o.op);
    if (has_place)
      visit(o.place);
    for (const ir::Place &p : o.inputs)
      visit(p);
    for (const ir::Place &p : o.outputs)
      visit(p);
    if (!o.info)
      return;
    for (llvm::StringRef image : o.info->images)
      whole(find_device(*module_.family, image));
  }

  void visit(const ir::Place &place) {
    if (place.is_indexed()) {
      for (const ir::Extent &e : ir::index_extents(module_, place))
        grow({e.device, e.last});
      if (!place.is_constant() && place.kind != ir::PlaceKind::Label)
        return whole_with_high_words(place.device);
    }
    const ir::Extent e = ir::extent(module_, place);
    if (e.none || e.space != ir::PlaceKind::Bit)
      return;
    if (e.last == ir::kEndOfClass)
      return whole(e.device);
    const DeviceId high = module_.family->devices[e.device].high_words;
    if (high != kNoDevice && e.all) {
      grow({e.device, (e.first + e.last) / 2});
      return grow({high, (e.first + e.last) / 2});
    }
    if (!crosses_end(*module_.family, parameters_, e.device, e.first, e.last - e.first + 1))
      return grow({e.device, e.last});
    for (std::uint32_t i = 0; i <= e.last - e.first; ++i)
      grow(point_behind(*module_.family, parameters_, {e.device, e.first}, i));
  }

  void whole(DeviceId device) {
    if (device != kNoDevice)
      count_[device] = std::max(count_[device], parameters_.points[device]);
  }

private:
  void grow(DevicePoint p) {
    if (p.device == kNoDevice)
      return;
    const std::uint32_t first = module_.family->devices[p.device].first;
    count_[p.device] = std::max(count_[p.device], p.number + 1 - first);
  }
  void whole_with_high_words(DeviceId device) {
    whole(device);
    if (const DeviceId high = module_.family->devices[device].high_words; high != kNoDevice)
      whole(high);
  }

  const ir::Module &module_;
  const Parameters &parameters_;
  std::vector<std::uint32_t> &count_;
};

/// What stands between the statements of its routine: labels and jumps, the heads and ends of loops. Such a rung cannot move into
/// another function.
bool directs_routine(const ir::Rung &rung) {
  return llvm::any_of(rung.operations, [](const ir::Operation &o) {
    return o.op == Op::Label || o.op == Op::Jump || o.op == Op::Loop || o.op == Op::Next || o.op == Op::Return || o.op == Op::EndScan;
  });
}

/// True where the routine may be left before its end: SRET or FEND in its midst, a jump to END, one backwards (which the watchdog may
/// end).
bool leaves_routine(const ir::Routine &routine) {
  llvm::DenseMap<std::uint32_t, std::uint32_t> labels;
  for (const ir::Rung &rung : routine.rungs)
    for (const ir::Operation &o : rung.operations)
      if (o.op == Op::Label)
        labels[o.place.number] = rung.number;
  return llvm::any_of(routine.rungs, [&](const ir::Rung &rung) {
    return llvm::any_of(rung.operations, [&](const ir::Operation &o) {
      if (o.op != Op::Jump)
        return o.op == Op::Return || o.op == Op::EndScan;
      const auto label = labels.find(o.place.number);
      return o.place.is_indexed() || label == labels.end() || label->second <= rung.number;
    });
  });
}

/// Hands out files: a new one where the last is full.
class Files {
public:
  Files(const ir::Module &module, const LayoutLimits &limits) {
    std::size_t total = 0;
    for (const ir::Routine &routine : module.routines)
      for (const ir::Rung &rung : routine.rungs)
        total += rung.operations.size();
    // Files of equal size: compilers that run side by side end together.
    per_file_ = total / (total / limits.operations_per_file + 1) + 1;
  }
  unsigned next() {
    if (in_file_ >= per_file_) {
      ++file_;
      in_file_ = 0;
    }
    return file_;
  }
  void add(std::size_t operations) { in_file_ += operations; }
  unsigned count() const { return file_ + 1; }

private:
  std::size_t per_file_, in_file_ = 0;
  unsigned file_ = 0;
};

/// Cuts a run of rungs without labels and jumps.
void cut(const std::vector<ir::Rung> &rungs, std::size_t first, std::size_t end, bool inline_if_one, const LayoutLimits &limits,
         Files &files, std::vector<Chunk> &chunks) {
  const std::size_t before = chunks.size();
  std::size_t operations = 0;
  for (std::size_t i = first; i < end; ++i) {
    const bool full = chunks.size() > before && (i - chunks.back().first >= limits.rungs_per_function ||
                                                 operations + rungs[i].operations.size() > limits.operations_per_function);
    if (chunks.size() == before || full) {
      chunks.push_back({i, i, false, files.next()});
      operations = 0;
    }
    operations += rungs[i].operations.size();
    files.add(rungs[i].operations.size());
    chunks.back().last = i;
    chunks.back().can_stop |= can_stop(rungs[i]);
  }
  if (inline_if_one && chunks.size() == before + 1 && !chunks.back().can_stop)
    chunks.back().own_function = false;
}

RoutineLayout lay_out(const ir::Routine &routine, const LayoutLimits &limits, Files &files) {
  RoutineLayout layout;
  layout.returns = leaves_routine(routine);
  layout.file = routine.kind == ir::RoutineKind::Main ? 0 : files.next();
  const std::vector<ir::Rung> &rungs = routine.rungs;
  for (std::size_t i = 0; i < rungs.size();) {
    std::size_t end = i;
    if (directs_routine(rungs[i])) {
      layout.chunks.push_back({i, i, false, layout.file, false});
      ++i;
      continue;
    }
    while (end < rungs.size() && !directs_routine(rungs[end]))
      ++end;
    cut(rungs, i, end, true, limits, files, layout.chunks);
    i = end;
  }
  return layout;
}

}  // namespace

bool has_events(const ir::Module &module) {
  return llvm::any_of(module.routines, [](const ir::Routine &routine) {
    return routine.kind == ir::RoutineKind::Interrupt || llvm::any_of(routine.rungs, [](const ir::Rung &rung) {
             return llvm::any_of(rung.operations, [](const ir::Operation &o) { return o.info && o.info->category == "high-speed"; });
           });
  });
}

std::string memory_name(const InstructionInfo &info, std::uint32_t step) {
  std::string name;
  for (char c : info.function) {
    if (llvm::isUpper(c) && !name.empty() && llvm::isLower(name.back()))
      name += '_';
    name += llvm::toLower(c);
  }
  return fmt::format("{}_{}", name, step);
}

Layout make_layout(const ir::Module &module, const Parameters &parameters, const LayoutLimits &limits) {
  Layout layout;
  layout.count.assign(module.family->devices.size(), 0);
  Reach reach(module, parameters, layout.count);
  Files files(module, limits);
  for (const ir::Routine &routine : module.routines) {
    for (const ir::Place &state : routine.states)
      reach.visit(state);
    for (const ir::Rung &rung : routine.rungs)
      for (const ir::Operation &o : rung.operations) {
        reach.visit(o);
        if (o.info && o.info->style == CallStyle::Memory)
          layout.memories.push_back({o.info->function.str(), memory_name(*o.info, o.step), o.step});
      }
    layout.routines.push_back(lay_out(routine, limits, files));
  }
  for (const std::vector<InitialValue> *values : {&parameters.initial_values, &parameters.latched_values})
    for (const InitialValue &value : *values)
      reach.visit(place_of(*module.family, value));
  if (has_events(module))
    for (const auto &[id, device] : llvm::enumerate(module.family->devices))
      layout.count[id] = std::max<std::uint32_t>(layout.count[id], device.watched);
  layout.files = files.count();
  return layout;
}

}  // namespace ladderc::emit
