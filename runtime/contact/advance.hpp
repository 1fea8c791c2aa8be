// How far a pair of primitives may move before it meets.
#pragma once

#include "runtime/contact/neighbours.hpp"
#include "runtime/contact/proximity.hpp"

namespace toile {

/// Where the pair's four vertices are.
Quad places(const Pair& pair, const Vector& q);
Proximity proximity(Pair::Kind kind, const Quad& x);
/// How far apart the two primitives are along the axis that parts them best [m]: never more than their distance, and
/// quick; negative where their boxes overlap.
double apart(Pair::Kind kind, const Quad& x);

/// The fraction of `step` (0 … `most`) that the pair can go while a tenth of its distance remains, by additive
/// conservative advancement (Li, Kaufman and Jiang, Codimensional Incremental Potential Contact, 2021, section 5):
/// never too long.
double free_fraction(const Pair& pair, const Vector& q, const Vector& step, double most);

}  // namespace toile
