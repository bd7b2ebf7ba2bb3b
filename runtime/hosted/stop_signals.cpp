// The flag is global because a signal handler has no argument of ours.
#include "hosted/stop_signals.h"

#include <atomic>
#include <csignal>

namespace ladder::hosted {
namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a handler may touch nothing else");

extern "C" void on_stop_signal(int signal) {
  stop_asked.store(true, std::memory_order_relaxed);
  std::signal(signal, SIG_DFL);
}

}  // namespace

StopSignals::StopSignals() {
  stop_asked.store(false, std::memory_order_relaxed);
  former_interrupt_ = std::signal(SIGINT, on_stop_signal);
  former_terminate_ = std::signal(SIGTERM, on_stop_signal);
}

StopSignals::~StopSignals() {
  std::signal(SIGINT, former_interrupt_);
  std::signal(SIGTERM, former_terminate_);
}

bool StopSignals::asked() const {
  return stop_asked.load(std::memory_order_relaxed);
}

}  // namespace ladder::hosted
