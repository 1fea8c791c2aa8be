// Moves a triangulation's inner nodes to where its triangles are best shaped.
#pragma once

#include <array>
#include <vector>

#include "compiler/curve/vec2.hpp"

namespace toile {

/// Nodes from `fixed` on move; every sweep ends with flips back to a Delaunay triangulation, but for the edges of
/// `kept` lines, given by their nodes. Each move lessens the sum over the node's triangles of the squared inverse mean
/// ratio (edge lengths squared over area), which is convex in the place of one node and infinite at a flat triangle, so
/// no triangle turns over and the mesh's own grading stays.
void improve(std::vector<Vec2>& points, std::vector<std::array<int, 3>>& triangles, int fixed,
             const std::vector<std::vector<int>>& kept);

}  // namespace toile
