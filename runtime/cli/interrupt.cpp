#include "runtime/cli/interrupt.hpp"

#include <csignal>

namespace toile {
namespace {

std::atomic<bool> was_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the flag is raised inside a signal handler");

extern "C" void on_interrupt(int signal) {
  was_interrupted.store(true, std::memory_order_relaxed);
  std::signal(signal, SIG_DFL);
}

}  // namespace

const std::atomic<bool>& watch_for_interrupt() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  return was_interrupted;
}

}  // namespace toile
