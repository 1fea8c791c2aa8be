// Numbers as scripts have them.
#pragma once

#include <string>

namespace toile {

/// With at most so many decimals, none that is superfluous, and no -0.
std::string decimal(double value, int decimals);

}  // namespace toile
