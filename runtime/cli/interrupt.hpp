// Ctrl-C asks a running job to stop at its next safe point; a second one ends the process at once.
#pragma once

#include <atomic>

namespace toile {

/// Installs the handler (for SIGINT and SIGTERM) and returns the flag that it raises.
const std::atomic<bool>& watch_for_interrupt();

}  // namespace toile
