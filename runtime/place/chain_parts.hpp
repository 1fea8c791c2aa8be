// What the worn chains divide a garment into: a bodice and its sleeves, two trouser legs.
#pragma once

#include <vector>

#include "runtime/place/hanging_chain.hpp"
#include "runtime/place/rest_mesh.hpp"

namespace toile {

struct ChainPart {
  std::vector<int> vertices;  // chains not included
  std::vector<int> bounds;    // the lines whose chains it touches, ascending
};

/// Vertices that lie on any chain.
std::vector<bool> on_any_chain(const std::vector<HungLine>& hung, std::size_t vertex_count);

/// Whether a triangle at the vertex has a marked corner.
bool touches(const RestMesh& rest, int vertex, const std::vector<bool>& marked);

/// Parts of one component's cloth that its chains cut asunder.
std::vector<ChainPart> parts_between_chains(const RestMesh& rest, const std::vector<int>& members,
                                            const std::vector<HungLine>& hung);

}  // namespace toile
