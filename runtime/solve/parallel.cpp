#include "runtime/solve/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#if defined(__SANITIZE_THREAD__)
// oneTBB's library is not built with the thread sanitizer, which so does not see that it hands work over and waits for
// it; what is left of oneTBB in its headers stands in cmake/tsan.supp.
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace toile {
namespace {

#if defined(__SANITIZE_THREAD__)
char handed_over;
void hand_over() {
  __tsan_release(&handed_over);
}
void take_over() {
  __tsan_acquire(&handed_over);
}
#else
void hand_over() {}
void take_over() {}
#endif

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body) {
  constexpr std::size_t grain = 64;
  hand_over();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      take_over();
                      body(range.begin(), range.end());
                      hand_over();
                    });
  take_over();
}

}  // namespace toile
