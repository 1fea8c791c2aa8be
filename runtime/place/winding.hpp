// How far round the limb each vertex of a hanging cloth lies.
#pragma once

#include <functional>
#include <vector>

#include "runtime/place/hanging_chain.hpp"
#include "runtime/place/rest_mesh.hpp"

namespace toile {

/// Fractions of a turn for every vertex of the chain's component (0 elsewhere), equal to the chain's on the chain: the
/// many-valued harmonic function on the cloth at rest that goes round with it. On a cone this is the polar angle, so
/// that straight lines of the pattern hang straight. `depth` is the distance from the chain, or whatever else orders
/// the vertices so that each layer winds as the one before it.
std::vector<double> winding(const RestMesh& rest, const HangingChain& chain, const std::vector<double>& depth,
                            const std::vector<bool>& in_component);

/// What has to be added at the unknown vertices, and zero elsewhere, to make a function on the cloth at rest harmonic;
/// `difference(v, w)` is its value at w less that at v, `source` what flows in at each vertex. Zero throughout where
/// nothing determines it.
std::vector<double> harmonic_correction(const Cloth& cloth, const std::vector<bool>& unknown,
                                        const std::vector<double>& source,
                                        const std::function<double(int, int)>& difference);

/// A difference of fractions, to the nearest turn.
double turn_between(double from, double to);

/// The rest length of a whole turn at given distances from the chain: `bins` values at (i + 1/2) `width`. Triangles
/// count where `counted`; empty bins take their neighbours' values.
std::vector<double> turn_lengths(const RestMesh& rest, const std::vector<double>& fraction,
                                 const std::vector<double>& depth, const std::vector<bool>& counted, double width,
                                 int bins, double at_chain);

}  // namespace toile
