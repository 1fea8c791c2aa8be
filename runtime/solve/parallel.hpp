// Loops over many threads whose results do not depend on how many there are: every index writes to places of its own.
#pragma once

#include <cstddef>
#include <functional>

namespace toile {

/// Calls body(begin, end) for disjoint ranges that cover 0 … count.
void parallel_for(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace toile
