// How far a triangle's corners may go before it turns over.
#pragma once

#include "runtime/develop/flattening.hpp"

namespace toile {

/// The largest part of the step, up to infinity, that leaves at least a tenth of the triangle's area all the way.
double step_before_flip(const PlaneCorners& uv, const PlaneCorners& step);

}  // namespace toile
