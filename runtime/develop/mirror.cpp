#include "runtime/develop/mirror.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr double straight = 1e-6;  // sine of an angle

/// The piece that holds the other half, and the line that mirrors the one into the other.
struct OtherHalf {
  int piece = -1;
  Vec2 on, along{0, 1};
};

OtherHalf other_half(const Garment& garment, int number) {
  const Piece& piece = garment.pieces[index(number)];
  if (piece.fold) {
    const Vec2 way = piece.fold->to - piece.fold->from;
    return {number, piece.fold->from, way / norm(way)};
  }
  for (int other = 0; other < static_cast<int>(garment.pieces.size()); ++other) {
    const Piece& copy = garment.pieces[index(other)];
    if (other != number && copy.drawn_name == piece.drawn_name && copy.side != piece.side) return {other, {}, {0, 1}};
  }
  return {};
}

Vec2 reflected(Vec2 way, Vec2 along) {
  return 2 * dot(way, along) * along - way;
}

/// The shares of the corners in the point; negative ones where it lies outside.
std::array<double, 3> shares_of(Vec2 p, const std::array<Vec2, 3>& corners) {
  const double area = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double second = cross(p - corners[0], corners[2] - corners[0]) / area;
  const double third = cross(corners[1] - corners[0], p - corners[0]) / area;
  return {1 - second - third, second, third};
}

}  // namespace

Mirror::Mirror(const Garment& garment, const PMesh& mesh) : images_(mesh.points.size()) {
  std::vector<OtherHalf> halves;
  for (int piece = 0; piece < static_cast<int>(garment.pieces.size()); ++piece) {
    halves.push_back(other_half(garment, piece));
  }
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    const int piece = mesh.piece_of_point[p];
    const OtherHalf& half = halves[index(piece)];
    if (half.piece < 0) continue;
    const Vec2 warp = mesh.warp_of_piece[index(piece)], image = reflected(warp, half.along);
    const double along = dot(image, mesh.warp_of_piece[index(half.piece)]);
    if (std::abs(std::abs(along) - 1) > straight) continue;  // a half on the bias has another warp
    const Vec2 at = half.on + reflected(mesh.points[p] - half.on, half.along);
    double best = -1e300;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.piece_of_triangle[t] != half.piece) continue;
      const std::array<int, 3>& corners = mesh.triangles[t];
      const std::array<double, 3> shares = shares_of(
          at, {mesh.points[index(corners[0])], mesh.points[index(corners[1])], mesh.points[index(corners[2])]});
      const double least = *std::min_element(shares.begin(), shares.end());
      if (least <= best) continue;
      best = least;
      images_[p] = {corners, shares, -along, along};
    }
  }
}

std::vector<Vec2> Mirror::evened(const std::vector<Vec2>& change) const {
  std::vector<Vec2> even = change;
  for (std::size_t p = 0; p < change.size(); ++p) {
    const Image& image = images_[p];
    if (image.along == 0) continue;
    Vec2 there;
    for (std::size_t i = 0; i < 3; ++i) there = there + image.shares[i] * change[index(image.points[i])];
    even[p] = 0.5 * (change[p] + Vec2{image.along * there.x, image.across * there.y});
  }
  return even;
}

}  // namespace toile
