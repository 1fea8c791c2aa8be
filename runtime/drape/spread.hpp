// Values over an area, summed up in four numbers.
#pragma once

#include <vector>

#include "runtime/drape/drape.hpp"

namespace toile {

Spread spread(const std::vector<double>& values, const std::vector<double>& areas);

}  // namespace toile
