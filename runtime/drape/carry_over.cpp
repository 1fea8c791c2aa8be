#include "runtime/drape/carry_over.hpp"

#include "runtime/place/piece_grid.hpp"
#include "runtime/solve/parallel.hpp"

namespace toile {
using std::size_t;

std::vector<Vec3> carry_over(const SewnMesh& from, const std::vector<Vec3>& positions, const SewnMesh& to) {
  std::vector<PieceGrid> grids;
  for (size_t piece = 0; piece < from.p.warp_of_piece.size(); ++piece) {
    grids.emplace_back(from.p, static_cast<PieceId>(piece));
  }
  std::vector<Vec3> carried(static_cast<size_t>(to.s.vertex_count));
  parallel_for(carried.size(), [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      Vec3 sum;
      double copies = 0;
      for (const int copy : to.s.p_of_s[v]) {
        const auto point = static_cast<size_t>(copy);
        PieceGrid::Barycentric weights{};
        const int triangle = grids[static_cast<size_t>(to.p.piece_of_point[point])].locate(to.p.points[point], weights);
        if (triangle < 0) continue;
        for (size_t k = 0; k < 3; ++k) {
          sum += weights[k] * positions[static_cast<size_t>(from.s.triangles[static_cast<size_t>(triangle)][k])];
        }
        copies += 1;
      }
      carried[v] = copies > 0 ? sum / copies : Vec3{};
    }
  });
  return carried;
}

}  // namespace toile
