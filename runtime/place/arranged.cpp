#include "runtime/place/arranged.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/place/relax.hpp"

namespace toile {
namespace {

constexpr double standing_off = 0.006;  // [m] from the body
constexpr int closing_passes = 400;

const ArrangedPiece* place_of(PieceId piece, const std::vector<ArrangedPiece>& arranged) {
  const auto found =
      std::find_if(arranged.begin(), arranged.end(), [&](const ArrangedPiece& at) { return at.piece == piece; });
  return found == arranged.end() ? nullptr : &*found;
}

/// By how much of its girth the chain must turn about its line to be nearest to where its pieces are.
double turn_towards(const HangingChain& chain, const std::vector<Vec3>& positions) {
  double sine = 0, cosine = 0;
  for (std::size_t i = 0; i < chain.vertices.size(); ++i) {
    const double angle =
        2 * std::numbers::pi * (chain.curve.fraction_near(positions[chain.vertices[i]]) - chain.fractions[i]);
    sine += std::sin(angle);
    cosine += std::cos(angle);
  }
  return std::atan2(sine, cosine) / (2 * std::numbers::pi);
}

void put_on_line(const HangingChain& chain, std::vector<bool>& free, std::vector<Vec3>& positions) {
  const double turn = turn_towards(chain, positions);
  for (std::size_t i = 0; i < chain.vertices.size(); ++i) {
    positions[chain.vertices[i]] = chain.curve.at(chain.fractions[i] + turn);
    free[chain.vertices[i]] = false;
  }
}

}  // namespace

bool is_arranged(const SewnMesh& mesh, const std::vector<int>& members, const std::vector<ArrangedPiece>& arranged) {
  if (arranged.empty()) return false;
  return std::all_of(members.begin(), members.end(), [&](int v) {
    const auto& copies = mesh.s.p_of_s[v];
    return std::all_of(copies.begin(), copies.end(),
                       [&](int p) { return place_of(mesh.p.piece_of_point[p], arranged) != nullptr; });
  });
}

void place_arranged(const SewnMesh& mesh, const RestMesh& rest, const std::vector<int>& members,
                    const std::vector<ArrangedPiece>& arranged, const std::vector<HungLine>& hung, const Body* body,
                    std::vector<Vec3>& positions) {
  std::vector<bool> free(positions.size(), false);
  for (const int v : members) {
    free[v] = true;
    Vec3 sum;
    for (const int p : mesh.s.p_of_s[v]) {
      const ArrangedPiece& at = *place_of(mesh.p.piece_of_point[p], arranged);
      sum += at.origin + mesh.p.points[p].x * at.across + mesh.p.points[p].y * at.up;
    }
    positions[v] = sum / static_cast<double>(mesh.s.p_of_s[v].size());
  }
  for (const HungLine& line : hung) put_on_line(line.chain, free, positions);
  // Seams close by centimetres a pass at first: no vertex may get to the other side of an arm meanwhile.
  relax(rest, free, closing_passes, body, standing_off, positions, 1);
  if (body != nullptr) push_out(rest, free, *body, standing_off, positions);
}

}  // namespace toile
