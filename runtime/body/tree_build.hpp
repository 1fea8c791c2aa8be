// Building a TriangleTree.
#pragma once

#include <vector>

#include "runtime/body/triangle_tree.hpp"

namespace toile {

struct TreeItem {
  BoundingBox box;
  Vec3 centre;
  int triangle = 0;
};

/// Sorts the items into the order of the leaves; at least one item.
std::vector<TriangleTree::Node> build_tree(std::vector<TreeItem>& items);

}  // namespace toile
