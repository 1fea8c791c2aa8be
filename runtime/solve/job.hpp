// What a long job shows and obeys: progress out, cancellation in.
#pragma once

#include <atomic>
#include <functional>
#include <string>

namespace toile {

struct Progress {
  std::string phase;    // "placing", "draping", …
  double fraction = 0;  // 0 … 1, never falling; an estimate
  int iteration = 0;
  double residual = 0;  // relative
};

struct Job {
  std::function<void(const Progress&)> report;   // may be empty
  const std::atomic<bool>* cancelled = nullptr;  // may be null; polled at least ten times a second
  bool is_cancelled() const { return cancelled != nullptr && cancelled->load(std::memory_order_relaxed); }
};

}  // namespace toile
