#include "runtime/render/rows.hpp"

#include <tbb/parallel_for.h>

namespace toile {

void for_each_row(int count, const std::function<void(int)>& row) {
  tbb::parallel_for(0, count, row);
}

}  // namespace toile
