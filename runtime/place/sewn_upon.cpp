#include "runtime/place/sewn_upon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "runtime/place/piece_grid.hpp"

namespace toile {
namespace {

using std::size_t;

constexpr double off = 0.002;       // [m] the other piece
constexpr double reaches = -0.05;   // barycentric: so far a place may lie outside of the other piece
constexpr double same_line = 1e-9;  // [m2]

/// A piece and the one that it is sewn upon, with the points that meet.
struct Upon {
  PieceId piece = 0, base = 0;
  std::vector<std::array<int, 2>> points;
};

/// How many triangles of its own piece a side of the mesh has: two on a line inside.
class SideCount {
 public:
  explicit SideCount(const PMesh& mesh) {
    for (const auto& t : mesh.triangles) {
      for (size_t k = 0; k < 3; ++k) ++count_[std::minmax(t[k], t[(k + 1) % 3])];
    }
  }
  bool is_inside(int a, int b) const {
    const auto found = count_.find(std::minmax(a, b));
    return found != count_.end() && found->second == 2;
  }

 private:
  std::map<std::pair<int, int>, int> count_;
};

std::vector<Upon> find_all(const PMesh& mesh) {
  const SideCount sides(mesh);
  std::map<PieceId, Upon> found;
  const auto add = [&](const std::vector<int>& own, const std::vector<int>& line) {
    const PieceId piece = mesh.piece_of_point[static_cast<size_t>(own.front())];
    const PieceId base = mesh.piece_of_point[static_cast<size_t>(line.front())];
    if (piece == base) return;
    Upon& upon = found.try_emplace(piece, Upon{piece, base, {}}).first->second;
    if (upon.base != base) return;  // the one named first carries it
    for (size_t i = 0; i < own.size(); ++i) upon.points.push_back({own[i], line[i]});
  };
  for (const auto& runs : mesh.sewn) {
    for (const PMesh::SewnRun& run : runs) {
      const bool first = sides.is_inside(run.first[0], run.first[1]);
      const bool second = sides.is_inside(run.second[0], run.second[1]);
      if (first && !second) add(run.second, run.first);
      if (second && !first) add(run.first, run.second);
    }
  }
  // One that carries others comes before them.
  std::vector<Upon> all;
  std::vector<bool> laid(mesh.warp_of_piece.size(), true);
  for (const auto& [piece, upon] : found) laid[static_cast<size_t>(piece)] = false;
  for (size_t pass = 0; pass < found.size(); ++pass) {
    for (const auto& [piece, upon] : found) {
      if (laid[static_cast<size_t>(piece)] || !laid[static_cast<size_t>(upon.base)]) continue;
      laid[static_cast<size_t>(piece)] = true;
      all.push_back(upon);
    }
  }
  return all;
}

/// The motion in the plane that takes the piece's sewn points nearest to those of the other.
class OntoBase {
 public:
  OntoBase(const Upon& upon, const PMesh& mesh) {
    const auto at = [&](int p) { return mesh.points[static_cast<size_t>(p)]; };
    for (const auto& [own, base] : upon.points) {
      from_ = from_ + at(own);
      to_ = to_ + at(base);
    }
    const double n = static_cast<double>(upon.points.size());
    from_ = from_ / n;
    to_ = to_ / n;
    double cosine = 0, sine = 0;
    for (const auto& [own, base] : upon.points) {
      const Vec2 a = at(own) - from_, b = at(base) - to_;
      cosine += dot(a, b);
      sine += cross(a, b);
    }
    const double size = std::hypot(cosine, sine);
    if (size < same_line) return;
    cosine_ = cosine / size;
    sine_ = sine / size;
  }
  Vec2 operator()(Vec2 p) const {
    const Vec2 d = p - from_;
    return to_ + Vec2{cosine_ * d.x - sine_ * d.y, sine_ * d.x + cosine_ * d.y};
  }

 private:
  Vec2 from_, to_;
  double cosine_ = 1, sine_ = 0;
};

/// Normals of a piece's own triangles at the vertices, towards its right side.
std::vector<Vec3> normals_of(const SewnMesh& mesh, PieceId piece, const std::vector<Vec3>& positions) {
  std::vector<Vec3> normals(positions.size());
  for (size_t t = 0; t < mesh.s.triangles.size(); ++t) {
    if (mesh.p.piece_of_triangle[t] != piece) continue;
    const auto& [a, b, c] = mesh.s.triangles[t];
    const Vec3 n = cross(positions[static_cast<size_t>(b)] - positions[static_cast<size_t>(a)],
                         positions[static_cast<size_t>(c)] - positions[static_cast<size_t>(a)]);
    for (const int v : {a, b, c}) normals[static_cast<size_t>(v)] += n;
  }
  for (Vec3& n : normals) {
    const double length = norm(n);
    n = length > 0 ? n / length : Vec3{};
  }
  return normals;
}

/// Vertices of that piece alone.
std::vector<int> own_vertices(const SewnMesh& mesh, PieceId piece) {
  std::vector<int> own;
  for (int v = 0; v < mesh.s.vertex_count; ++v) {
    const auto& points = mesh.s.p_of_s[static_cast<size_t>(v)];
    const bool all = std::all_of(points.begin(), points.end(),
                                 [&](int p) { return mesh.p.piece_of_point[static_cast<size_t>(p)] == piece; });
    if (all) own.push_back(v);
  }
  return own;
}

void lay(const SewnMesh& mesh, const Upon& upon, std::vector<Vec3>& positions) {
  const std::vector<Vec3> normals = normals_of(mesh, upon.base, positions);
  const std::vector<int> own = own_vertices(mesh, upon.piece);
  const PieceGrid grid(mesh.p, upon.base);
  const OntoBase onto(upon, mesh.p);
  std::vector<Vec3> laid, step;
  bool covers = true;
  for (const int v : own) {
    const int point = mesh.s.p_of_s[static_cast<size_t>(v)].front();
    PieceGrid::Barycentric weights{};
    const int triangle = grid.locate(onto(mesh.p.points[static_cast<size_t>(point)]), weights);
    if (triangle < 0) return;
    covers = covers && std::min({weights[0], weights[1], weights[2]}) > reaches;
    Vec3 at, normal;
    for (size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<size_t>(mesh.s.triangles[static_cast<size_t>(triangle)][k]);
      at += weights[k] * positions[corner];
      normal += weights[k] * normals[corner];
    }
    step.push_back(off / std::max(norm(normal), 0.1) * normal);
    laid.push_back(at + step.back());
  }
  for (size_t i = 0; i < own.size(); ++i) {
    Vec3& position = positions[static_cast<size_t>(own[i])];
    position = covers ? laid[i] : position + step[i];
  }
}

}  // namespace

void lay_upon(const SewnMesh& mesh, std::vector<Vec3>& positions) {
  const bool any = std::any_of(mesh.s.edges.begin(), mesh.s.edges.end(),
                               [](const SMesh::Edge& edge) { return edge.wings.size() > 2; });
  if (!any) return;
  for (const Upon& upon : find_all(mesh.p)) lay(mesh, upon, positions);
}

}  // namespace toile
