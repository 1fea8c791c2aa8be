#include "runtime/cli/threads.hpp"

#include <tbb/global_control.h>

namespace toile {

struct ThreadLimit::Control {
  tbb::global_control parallelism;
};

ThreadLimit::ThreadLimit(int threads) {
  if (threads <= 0) return;
  // NOLINTNEXTLINE(modernize-make-unique): an aggregate, which make_unique cannot brace before clang 16
  control_.reset(new Control{{tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)}});
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace toile
