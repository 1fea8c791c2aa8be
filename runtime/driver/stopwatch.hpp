// Where the time went, for `--profile`. No other output may depend on a clock.
#pragma once

#include <chrono>

#include "runtime/report/report.hpp"

namespace toile {

/// Adds the seconds of its own life to a total.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

/// Fills in what the process as a whole has used so far: processor time and peak memory.
void add_process_usage(Profile& profile);

}  // namespace toile
