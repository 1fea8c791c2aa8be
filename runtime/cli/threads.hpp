// How many threads a run may use.
#pragma once

#include <memory>

namespace toile {

/// Limits the threads of all parallel work while it lives; 0 leaves as many as there are.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace toile
