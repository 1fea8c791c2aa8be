#include "runtime/driver/stopwatch.hpp"

#include <sys/resource.h>

namespace toile {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

void add_process_usage(Profile& profile) {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return;
  profile.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  profile.peak_memory_bytes = usage.ru_maxrss * 1024;  // Linux counts it in KiB
}

}  // namespace toile
