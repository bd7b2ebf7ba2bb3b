// One controller: the memory of one program object, its clock, and the inputs that a host holds.
//
// Instances share nothing: two of them, of one program or of several, run side by side at their own speed. An input that was set
// stays as set: it is written into the image again before each scan, because a terminal does not care what the program wrote there.
#pragma once

#include "ladder/hosted/clock.h"
#include "ladder/hosted/device_access.h"
#include "ladder/io.h"
#include "ladder/symbols.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace ladder::hosted {

class Instance {
public:
  /// Makes the program object. `symbols` outlives this. Nothing runs before power_on.
  Instance(const ProgramSymbols &symbols, Clock clock);

  /// Power-on or reset. The clock goes on and inputs stay held; the side store is cleared, as the program latches nothing in it.
  void power_on();
  void set_mode(Mode mode) { symbols_->set_mode(object(), mode); }
  void set_calendar(const Calendar &calendar) { symbols_->set_calendar(object(), calendar); }
  /// Serial ports and whatever else there is beside terminals; `io` outlives this or the next connect. False: the controller has
  /// nothing of the kind.
  bool connect(Io *io);
  /// An input terminal goes to the other state and back `count` times between two scans; the image does not see it. Throws
  /// DeviceError where `ref` is no terminal, or the program looks at its terminals in scans only.
  void pulse(const DeviceRef &ref, std::uint64_t count);
  /// Requests the routine of an interrupt pointer. Throws DeviceError where the program has no interrupt routines.
  void interrupt(unsigned pointer);
  /// Writes the held inputs, runs one scan at the clock's time, moves a virtual clock on.
  void scan();
  /// The host measured a scan longer than ProgramSymbols::watchdog_us.
  void watchdog() { symbols_->watchdog(object()); }

  Value get(const DeviceRef &ref) const { return devices_.read(ref); }
  /// Writes once; an input is held from now on.
  void set(const DeviceRef &ref, const Value &value);

  Status status() const { return symbols_->status(object()); }
  /// True while the switch is in RUN and the CPU does not run.
  bool stopped_by_itself() const;
  std::uint64_t scans() const { return scans_; }  ///< calls of scan, whether the CPU ran or not
  std::uint64_t now() const { return clock_.now(); }
  const ProgramSymbols &symbols() const { return *symbols_; }
  const DeviceAccess &devices() const { return devices_; }

private:
  struct Release {
    std::size_t alignment;
    void operator()(void *memory) const;
  };

  void *object() const { return memory_.get(); }

  const ProgramSymbols *symbols_;
  std::unique_ptr<void, Release> memory_;
  DeviceAccess devices_;
  Clock clock_;
  std::vector<std::pair<DeviceRef, Value>> held_;  ///< in the order of setting: a later one wins where they overlap
  std::uint64_t scans_ = 0;
};

}  // namespace ladder::hosted
