// Constant contacts.  LD SM400 / MOV K1 D0: the relay is always on, so the move has no condition.
//
// Which relays are constant is a field of the special device table. A program that writes such a relay (sema warns) has taken it
// away from the system for the rest of the scan, so its contacts stay loads. Linear in the number of operations.
#include "ir/extent.h"
#include "opt/pipeline.h"

#include "llvm/ADT/DenseMap.h"

namespace ladderc::opt {

namespace {

using Key = std::uint64_t;
Key key(DeviceId device, std::uint32_t number) {
  return (Key{device} << 32) | number;
}

/// The constant relays of the family that the program nowhere writes.
llvm::DenseMap<Key, bool> constant_relays(const ir::Module &module) {
  llvm::DenseMap<Key, bool> relays;
  for (const SpecialInfo &special : module.family->specials) {
    if (special.constant < 0)
      continue;
    const llvm::StringRef prefix = special.device.take_until([](char c) { return c >= '0' && c <= '9'; });
    std::uint32_t number;
    if (!special.device.drop_front(prefix.size()).getAsInteger(10, number))
      relays[key(find_device(*module.family, prefix), number)] = special.constant != 0;
  }
  for (const ir::Routine &routine : module.routines)
    for (const ir::Rung &rung : routine.rungs)
      for (const ir::Operation &o : rung.operations)
        ir::for_each_write(module, o, [&](const ir::Extent &e) {
          if (e.none || e.space != ir::PlaceKind::Bit)
            return;
          llvm::SmallVector<Key> written;
          for (const auto &entry : relays)
            if (e.all || (DeviceId(entry.first >> 32) == e.device && std::uint32_t(entry.first) >= e.first &&
                          std::uint32_t(entry.first) <= e.last))
              written.push_back(entry.first);
          for (Key k : written)
            relays.erase(k);
        });
  return relays;
}

}  // namespace

void run_const_contact(ir::Module &module, Context &context) {
  const llvm::DenseMap<Key, bool> relays = constant_relays(module);
  if (relays.empty())
    return;
  for (ir::Routine &routine : module.routines)
    for (ir::Rung &rung : routine.rungs)
      for (ir::Operation &o : rung.operations) {
        if (o.op != ir::Op::Load || o.place.kind != ir::PlaceKind::Bit)
          continue;
        const auto found = relays.find(key(o.place.device, o.place.number));
        if (found == relays.end() || !context.may_rewrite("const-contact", "folded"))
          continue;
        o.op = ir::Op::Constant;
        o.constant = found->second;
        o.place = {};
      }
}

}  // namespace ladderc::opt
