// SIGINT and SIGTERM ask a running program to end after the current scan. A second one ends the process at once, so that a scan
// that never returns can be left.
#pragma once

namespace ladder::hosted {

/// Watches while it lives and restores the former handlers. A process has one set of signals: one of these at a time.
class StopSignals {
public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals &) = delete;
  StopSignals &operator=(const StopSignals &) = delete;

  bool asked() const;

private:
  using Handler = void (*)(int);
  Handler former_interrupt_, former_terminate_;
};

}  // namespace ladder::hosted
