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

std::vector<Upon> find_all(const PMesh& mesh, const SideCount& sides) {
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
    const auto n = static_cast<double>(upon.points.size());
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
  Vec2 back(Vec2 p) const {
    const Vec2 d = p - to_;
    return from_ + Vec2{cosine_ * d.x + sine_ * d.y, -sine_ * d.x + cosine_ * d.y};
  }

 private:
  Vec2 from_, to_;
  double cosine_ = 1, sine_ = 0;
};

/// Normals of a piece's own triangles at the vertices, towards its right side; without those of `but` alone.
std::vector<Vec3> normals_of(const SewnMesh& mesh, PieceId piece, const std::vector<bool>& but,
                             const std::vector<Vec3>& positions) {
  std::vector<Vec3> normals(positions.size());
  for (size_t t = 0; t < mesh.s.triangles.size(); ++t) {
    const auto& points = mesh.p.triangles[t];
    const bool left_out =
        !but.empty() && std::any_of(points.begin(), points.end(), [&](int p) { return but[static_cast<size_t>(p)]; });
    if (mesh.p.piece_of_triangle[t] != piece || left_out) continue;
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

/// A piece lying on its base: raised where it would dip into it.
class Lying {
 public:
  Lying(const SewnMesh& mesh, const Upon& upon, std::vector<Vec3>& positions)
      : mesh_(mesh),
        upon_(upon),
        positions_(positions),
        normals_(normals_of(mesh, upon.base, {}, positions)),
        base_(mesh.p, upon.base),
        own_(mesh.p, upon.piece),
        onto_(upon, mesh.p) {}

  void lay() {
    const std::vector<int> own = own_vertices(mesh_, upon_.piece);
    free_.assign(positions_.size(), false);
    for (const int v : own) free_[static_cast<size_t>(v)] = true;
    std::vector<Vec3> laid, step;
    bool covers = true;
    for (const int v : own) {
      const auto below = on_base(onto_(place(mesh_.s.p_of_s[static_cast<size_t>(v)].front())));
      if (!below) return;
      covers = covers && below->inside;
      step.push_back(off * below->normal);
      laid.push_back(below->at + step.back());
    }
    for (size_t i = 0; i < own.size(); ++i) {
      Vec3& position = positions_[static_cast<size_t>(own[i])];
      position = covers ? laid[i] : position + step[i];
    }
    if (covers) raise();
  }

 private:
  struct Below {
    Vec3 at, normal;
    bool inside = false;
  };
  /// A place where the two surfaces are compared: a triangle of the piece, and what lies below.
  struct Sample {
    std::array<size_t, 3> vertices{};
    std::array<double, 3> weights{};
    Below below;
  };

  Vec2 place(int point) const { return mesh_.p.points[static_cast<size_t>(point)]; }

  std::optional<Below> on_base(Vec2 p) const {
    PieceGrid::Barycentric weights{};
    const int triangle = base_.locate(p, weights);
    if (triangle < 0) return std::nullopt;
    Below below;
    for (size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<size_t>(mesh_.s.triangles[static_cast<size_t>(triangle)][k]);
      below.at += weights[k] * positions_[corner];
      below.normal += weights[k] * normals_[corner];
    }
    below.normal = below.normal / std::max(norm(below.normal), 0.1);
    below.inside = std::min({weights[0], weights[1], weights[2]}) > reaches;
    return below;
  }

  /// `p` in the drawing of the piece; nothing beyond its rim.
  void add_sample(Vec2 p) {
    PieceGrid::Barycentric weights{};
    const int triangle = own_.locate(p, weights);
    const auto below = on_base(onto_(p));
    if (triangle < 0 || !below || std::min({weights[0], weights[1], weights[2]}) < -1e-6) return;
    Sample sample{{}, weights, *below};
    for (size_t k = 0; k < 3; ++k) {
      sample.vertices[k] = static_cast<size_t>(mesh_.s.triangles[static_cast<size_t>(triangle)][k]);
    }
    samples_.push_back(sample);
  }

  std::vector<std::array<Vec2, 2>> sides_of(PieceId piece, bool moved) const {
    std::map<std::pair<int, int>, bool> known;
    std::vector<std::array<Vec2, 2>> sides;
    for (size_t t = 0; t < mesh_.p.triangles.size(); ++t) {
      if (mesh_.p.piece_of_triangle[t] != piece) continue;
      for (size_t k = 0; k < 3; ++k) {
        const int a = mesh_.p.triangles[t][k], b = mesh_.p.triangles[t][(k + 1) % 3];
        if (!known.emplace(std::minmax(a, b), true).second) continue;
        sides.push_back({moved ? onto_.back(place(a)) : place(a), moved ? onto_.back(place(b)) : place(b)});
      }
    }
    return sides;
  }

  /// Where nodes of the base lie under the piece, and where edges of the two cross: between those both are plane.
  void take_samples() {
    for (size_t p = 0; p < mesh_.p.points.size(); ++p) {
      if (mesh_.p.piece_of_point[p] == upon_.base) add_sample(onto_.back(mesh_.p.points[p]));
    }
    const auto own = sides_of(upon_.piece, false), base = sides_of(upon_.base, true);
    for (const auto& [a, b] : own) {
      for (const auto& [c, d] : base) {
        if (std::max(c.x, d.x) < std::min(a.x, b.x) || std::min(c.x, d.x) > std::max(a.x, b.x)) continue;
        if (std::max(c.y, d.y) < std::min(a.y, b.y) || std::min(c.y, d.y) > std::max(a.y, b.y)) continue;
        const double det = cross(b - a, d - c);
        if (det == 0) continue;
        const double s = cross(c - a, d - c) / det, t = cross(c - a, b - a) / det;
        if (s > 1e-6 && s < 1 - 1e-6 && t > 0 && t < 1) add_sample(a + s * (b - a));
      }
    }
  }

  void raise() {
    constexpr int passes = 60;
    constexpr double least = 0.5 * off;  // off the base, where all corners of the triangle are free
    take_samples();
    for (int pass = 0; pass < passes; ++pass) {
      bool any = false;
      for (const Sample& sample : samples_) {
        Vec3 at;
        double share = 0, squares = 0;
        for (size_t k = 0; k < 3; ++k) {
          at += sample.weights[k] * positions_[sample.vertices[k]];
          if (!free_[sample.vertices[k]]) continue;
          share += sample.weights[k];
          squares += sample.weights[k] * sample.weights[k];
        }
        const double missing = least * share - dot(at - sample.below.at, sample.below.normal);
        if (missing <= 1e-3 * off || squares < 1e-4) continue;
        any = true;
        for (size_t k = 0; k < 3; ++k) {
          if (!free_[sample.vertices[k]]) continue;
          positions_[sample.vertices[k]] += missing * sample.weights[k] / squares * sample.below.normal;
        }
      }
      if (!any) return;
    }
  }

  const SewnMesh& mesh_;
  const Upon& upon_;
  std::vector<Vec3>& positions_;
  std::vector<Vec3> normals_;
  PieceGrid base_, own_;
  OntoBase onto_;
  std::vector<bool> free_;  // vertices of the piece alone
  std::vector<Sample> samples_;
};

bool encloses(const std::vector<Vec2>& polygon, Vec2 p) {
  bool inside = false;
  for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 a = polygon[i], b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/// The nearest place on a run of points: how far off, and between which two.
struct Foot {
  double distance = 1e300;
  size_t from = 0;
  double part = 0;
};

Foot foot_on(const PMesh& mesh, const std::vector<int>& run, Vec2 p) {
  Foot foot;
  for (size_t i = 0; i + 1 < run.size(); ++i) {
    const Vec2 a = mesh.points[static_cast<size_t>(run[i])], way = mesh.points[static_cast<size_t>(run[i + 1])] - a;
    const double part = std::clamp(dot(p - a, way) / std::max(dot(way, way), 1e-300), 0.0, 1.0);
    const double away = toile::distance(p, a + part * way);
    if (away < foot.distance) foot = {away, i, part};
  }
  return foot;
}

/// Folds the strip between two lines of a piece double, the fold off its right side.
void fold_tuck(const SewnMesh& mesh, const PMesh::SewnRun& run, std::vector<Vec3>& positions) {
  const auto place = [&](int p) { return mesh.p.points[static_cast<size_t>(p)]; };
  const PieceId piece = mesh.p.piece_of_point[static_cast<size_t>(run.first.front())];
  std::vector<Vec2> rim;
  for (const int p : run.first) rim.push_back(place(p));
  for (size_t i = run.second.size(); i-- > 0;) rim.push_back(place(run.second[i]));
  std::vector<bool> on_lines(mesh.p.points.size(), false), strip(mesh.p.points.size(), false);
  for (const auto* line : {&run.first, &run.second}) {
    for (const int p : *line) on_lines[static_cast<size_t>(p)] = true;
  }
  for (size_t p = 0; p < strip.size(); ++p) {
    strip[p] = mesh.p.piece_of_point[p] == piece && !on_lines[p] && encloses(rim, mesh.p.points[p]);
  }
  const std::vector<Vec3> normals = normals_of(mesh, piece, strip, positions);
  for (size_t p = 0; p < strip.size(); ++p) {
    if (!strip[p]) continue;
    const Foot first = foot_on(mesh.p, run.first, mesh.p.points[p]);
    const Foot second = foot_on(mesh.p, run.second, mesh.p.points[p]);
    const bool nearer_first = first.distance < second.distance;
    const Foot& foot = nearer_first ? first : second;
    const std::vector<int>& line = nearer_first ? run.first : run.second;
    const auto vertex = [&](size_t i) { return static_cast<size_t>(mesh.s.s_of_p[static_cast<size_t>(line[i])]); };
    const size_t a = vertex(foot.from), b = vertex(foot.from + 1);
    const Vec3 along = positions[b] - positions[a];
    const Vec3 normal = (1 - foot.part) * normals[a] + foot.part * normals[b];
    const Vec3 left = cross(normal, along);
    if (norm(normal) < 0.1 || norm(left) < 1e-12) continue;
    // Either layer keeps to the side of the cloth that it runs on from.
    const Vec2 way = place(line[foot.from + 1]) - place(line[foot.from]);
    const double side = cross(way, mesh.p.points[p] - place(line[foot.from])) > 0 ? -1 : 1;
    positions[static_cast<size_t>(mesh.s.s_of_p[p])] = positions[a] + foot.part * along +
                                                       (foot.distance + off) / norm(normal) * normal +
                                                       side * off / 2 / norm(left) * left;
  }
}

/// Beyond its ends a tuck runs out: the fold comes down to the cloth, and its width opens.
void run_out(const SewnMesh& mesh, const PMesh::SewnRun& run, bool at_end, std::vector<Vec3>& positions) {
  constexpr double length = 3;  // of the tuck's depth
  const auto place = [&](int p) { return mesh.p.points[static_cast<size_t>(p)]; };
  const PieceId piece = mesh.p.piece_of_point[static_cast<size_t>(run.first.front())];
  const size_t last = run.first.size() - 1, end = at_end ? last : 0, before = at_end ? last - 1 : 1;
  const Vec2 a = place(run.first[end]), b = place(run.second[end]), middle = 0.5 * (a + b);
  const double half = distance(a, b) / 2;
  const Vec2 way = middle - 0.5 * (place(run.first[before]) + place(run.second[before]));
  if (half < 1e-4 || norm(way) < 1e-9) return;
  const Vec2 on = way / norm(way), across = (b - a) / (2 * half);
  const std::vector<Vec3> normals = normals_of(mesh, piece, {}, positions);
  for (size_t p = 0; p < mesh.p.points.size(); ++p) {
    const auto v = static_cast<size_t>(mesh.s.s_of_p[p]);
    if (mesh.p.piece_of_point[p] != piece || mesh.s.p_of_s[v].size() > 1) continue;
    const double beyond = dot(mesh.p.points[p] - middle, on), aside = std::abs(dot(mesh.p.points[p] - middle, across));
    if (beyond <= 0 || beyond >= length * half || aside >= half) continue;
    positions[v] += (half - aside) * (1 - beyond / (length * half)) * normals[v];
  }
}

void fold_tucks(const SewnMesh& mesh, const SideCount& sides, std::vector<Vec3>& positions) {
  for (const auto& runs : mesh.p.sewn) {
    for (const PMesh::SewnRun& run : runs) {
      const bool one_piece = mesh.p.piece_of_point[static_cast<size_t>(run.first[0])] ==
                             mesh.p.piece_of_point[static_cast<size_t>(run.second[0])];
      if (one_piece && sides.is_inside(run.first[0], run.first[1]) && sides.is_inside(run.second[0], run.second[1])) {
        run_out(mesh, run, false, positions);
        run_out(mesh, run, true, positions);
        fold_tuck(mesh, run, positions);
      }
    }
  }
}

}  // namespace

void lay_upon(const SewnMesh& mesh, std::vector<Vec3>& positions) {
  const bool any = std::any_of(mesh.s.edges.begin(), mesh.s.edges.end(),
                               [](const SMesh::Edge& edge) { return edge.wings.size() > 2; });
  if (!any) return;
  const SideCount sides(mesh.p);
  fold_tucks(mesh, sides, positions);
  for (const Upon& upon : find_all(mesh.p, sides)) Lying(mesh, upon, positions).lay();
}

}  // namespace toile
