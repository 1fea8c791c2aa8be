// A picture's rows, computed in parallel.
#pragma once

#include <functional>

namespace toile {

/// Calls `row` once for each of 0 … count-1, from several threads; rows must not share what they write.
void for_each_row(int count, const std::function<void(int)>& row);

}  // namespace toile
