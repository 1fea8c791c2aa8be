// Random star-shaped pieces with random seams: always a sound, strict, bounded mesh.
#include <gtest/gtest.h>

#include <random>

#include "tests/compiler/mesh/checks.hpp"

namespace toile {
namespace {

using namespace test;  // NOLINT

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
}

/// Corners at rising angles about the origin, now and then very near or very far.
Piece star(const std::string& name, std::mt19937& random) {
  const int n = 3 + static_cast<int>(random() % 7);
  std::vector<Vec2> corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * (i + uniform(random, -0.4, 0.4)) / n;
    const double radius = random() % 5 == 0 ? uniform(random, 0.02, 0.05) : uniform(random, 0.1, 0.3);
    corners.push_back(radius * direction(angle));
  }
  std::vector<PieceEdge> edges, straight;
  for (int i = 0; i < n; ++i) {
    const Vec2 a = corners[i], b = corners[(i + 1) % n], across = perpendicular(b - a);
    straight.push_back(edge(std::to_string(i), line(a, b)));
    const double bulge = random() % 2 == 0 ? 0 : uniform(random, -0.03, 0.0);
    edges.push_back(edge(
        std::to_string(i),
        bulge == 0 ? line(a, b) : bezier(a, a + (b - a) / 3 + bulge * across, b - (b - a) / 3 + bulge * across, b)));
  }
  bool crossed = false;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) crossed |= !crossings(edges[i].curve, edges[j].curve).empty();
  }
  return piece(name, crossed ? straight : edges);
}

Garment random_garment(unsigned seed) {
  std::mt19937 random(seed);
  Garment g = garment("random", {});
  const int pieces = 1 + static_cast<int>(random() % 4);
  std::vector<EdgeRef> free;
  for (int p = 0; p < pieces; ++p) {
    g.pieces.push_back(star(std::to_string(p), random));
    for (int e = 0; e < static_cast<int>(g.pieces[p].edges.size()); ++e) free.push_back({p, e});
  }
  const auto take = [&] {
    const std::size_t at = random() % free.size();
    const EdgeRef ref = free[at];
    free.erase(free.begin() + static_cast<std::ptrdiff_t>(at));
    return ChainLink{ref, random() % 2 == 0};
  };
  for (int seams = static_cast<int>(random() % 6); seams > 0 && free.size() >= 4; --seams) {
    Chain first{take()}, second{take()};
    if (random() % 3 == 0) first.push_back(take());
    if (random() % 3 == 0 && !free.empty()) second.push_back(take());
    sew_chains(g, first, second);
  }
  return g;
}

TEST(RandomGarments, AreMeshedStrictlyWhateverIsSewn) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Garment g = random_garment(seed);
    PMeshOptions options;
    options.target_edge = seed % 3 == 0 ? 0.2 : 0.03;
    const SewnMesh mesh = sew(g, options);
    expect_cells_agree(g, mesh);
    expect_sound(mesh.p, g);
    expect_strict(mesh);
    expect_consistent(mesh);
    for (const auto& runs : mesh.p.sewn) EXPECT_FALSE(runs.empty());
    EXPECT_LT(mesh.p.triangles.size(), 20000U);
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace toile
