// The sewn surface at rest: lengths, neighbourhoods and geodesic distances in the cloth's own metric.
#pragma once

#include <vector>

#include "runtime/mesh/cloth.hpp"

namespace toile {

class RestMesh {
 public:
  explicit RestMesh(const Cloth& cloth);

  const Cloth& cloth() const { return *cloth_; }
  int vertex_count() const { return cloth_->vertex_count; }
  const std::vector<double>& edge_length() const { return edge_length_; }  // [m] per edge, mean of both sides of a seam
  double mean_edge() const { return mean_edge_; }
  const std::vector<int>& triangles_at(int vertex) const { return triangles_at_[vertex]; }

  /// Distance within the cloth from the nearest of the sources [m]; infinite where none is connected. Fast marching
  /// over the triangles (Kimmel and Sethian 1998), along edges where a triangle is too obtuse for it.
  std::vector<double> distance_from(const std::vector<int>& sources) const;

 private:
  const Cloth* cloth_;
  std::vector<double> edge_length_;
  std::vector<std::vector<int>> triangles_at_;
  double mean_edge_ = 0;
};

}  // namespace toile
