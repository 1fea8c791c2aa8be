#include "compiler/pmesh/pmesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/pmesh/mesher.hpp"

namespace toile {
namespace {

constexpr double kAreaPerTriangle = 0.414;  // over the squared edge; measured on large pieces
constexpr int kTries = 3, kTriesWhenSmall = 6, kSmall = 2000;
constexpr double kNearEnough = 0.04;

}  // namespace

PMesh make_pmesh(const Garment& garment, const PMeshOptions& options) {
  return GarmentMesher(garment, options).mesh();
}

double edge_for_triangles(const Garment& garment, int triangles) {
  double area = 0;
  for (const Piece& piece : garment.pieces) area += area_of(piece);
  const double wanted = std::max(1, triangles);
  if (!(area > 0)) return PMeshOptions{}.target_edge;
  double edge = std::sqrt(area / (kAreaPerTriangle * wanted)), best = edge, least_miss = 1e300;
  double slope = -2;  // of log(triangles) over log(edge); less steep where outlines ask for more than the target does
  double edge_before = 0, miss_before = 0;
  for (int attempt = 0; attempt < (triangles < kSmall ? kTriesWhenSmall : kTries); ++attempt) {
    PMeshOptions options;
    options.target_edge = edge;
    const double miss = std::log(std::max(1, GarmentMesher(garment, options).count()) / wanted);
    if (std::abs(miss) < least_miss) {
      least_miss = std::abs(miss);
      best = edge;
    }
    if (std::abs(miss) < kNearEnough) break;
    if (attempt > 0) slope = std::clamp((miss - miss_before) / std::log(edge / edge_before), -2.5, -0.8);
    edge_before = std::exchange(edge, edge * std::exp(-miss / slope));
    miss_before = miss;
  }
  return best;
}

}  // namespace toile
