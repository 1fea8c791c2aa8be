#include "runtime/develop/develop.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

/// How much longer than in the chart a piece is on the body, along x and along y of the chart, in the mean.
struct Scale {
  double x = 1, y = 1;
  Vec2 operator()(Vec2 p) const { return {x * p.x, y * p.y}; }
};

/// A frame of warp and weft in the drawing of a piece.
struct Frame {
  Vec2 warp;
  Vec2 into(Vec2 p) const { return {dot(p, warp), dot(p, perpendicular(warp))}; }
  Vec2 back(Vec2 uv) const { return uv.x * warp + uv.y * perpendicular(warp); }
};

class Developing {
 public:
  Developing(const Garment& garment, const SewnMesh& mesh, Target target) : garment_(garment), mesh_(mesh) {
    development_.target = std::move(target);
  }

  Development run(const FlattenOptions& options, const Job& job) {
    find_scales();
    fill_input();
    for (int piece = 0; piece < piece_count(); ++piece) input_.grain.push_back(grain_line(piece));
    match_seams();
    const FabricLaw law = make_law(garment_.fabric);
    development_.flat = flatten(input_, law, options, job);
    for (std::size_t p = 0; p < mesh_.p.points.size(); ++p) {
      development_.points.push_back(frames_[index(mesh_.p.piece_of_point[p])].back(development_.flat.uv[p]));
    }
    for (const Frame& frame : frames_) development_.warp_of_piece.push_back(frame.warp);
    return std::move(development_);
  }

 private:
  int piece_count() const { return static_cast<int>(garment_.pieces.size()); }
  const std::vector<Vec2>& chart() const { return development_.target.chart; }
  Vec3 target(int point) const { return development_.target.positions[index(mesh_.s.s_of_p[index(point)])]; }

  void find_scales() {
    std::vector<std::array<double, 3>> sums(garment_.pieces.size(), {0, 0, 0});
    for (std::size_t t = 0; t < mesh_.p.triangles.size(); ++t) {
      const std::array<int, 3>& corners = mesh_.p.triangles[t];
      const MembraneShape shape =
          membrane_shape({chart()[index(corners[0])], chart()[index(corners[1])], chart()[index(corners[2])]});
      Vec3 fx, fy;
      for (std::size_t i = 0; i < 3; ++i) {
        fx += shape.du[i] * target(corners[i]);
        fy += shape.dv[i] * target(corners[i]);
      }
      std::array<double, 3>& sum = sums[index(mesh_.p.piece_of_triangle[t])];
      sum = {sum[0] + shape.area * norm(fx), sum[1] + shape.area * norm(fy), sum[2] + shape.area};
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
      scales_.push_back({sums[i][0] / sums[i][2], sums[i][1] / sums[i][2]});
      const Vec2 warp = scales_.back()(mesh_.p.warp_of_piece[i]);
      frames_.push_back({warp / norm(warp)});
    }
  }

  void fill_input() {
    input_.triangles = mesh_.p.triangles;
    for (std::size_t p = 0; p < mesh_.p.points.size(); ++p) {
      const std::size_t piece = index(mesh_.p.piece_of_point[p]);
      input_.target.push_back(target(static_cast<int>(p)));
      input_.start.push_back(frames_[piece].into(scales_[piece](chart()[p])));
    }
  }

  /// Along the fold where the piece has one, else the two points of the outline that lie most nearly along the warp and
  /// far apart.
  FlatteningInput::GrainLine grain_line(int piece) const {
    std::vector<int> outline;
    for (const PMesh::EdgeNodes& edge : mesh_.p.edge_nodes[index(piece)]) {
      outline.insert(outline.end(), edge.points.begin(), edge.points.end() - 1);
    }
    double low = 1e300, high = -1e300;
    for (const int point : outline) {
      low = std::min(low, input_.start[index(point)].x);
      high = std::max(high, input_.start[index(point)].x);
    }
    FlatteningInput::GrainLine best{outline.front(), outline.back()};
    double least = 1e300;
    for (const int a : outline) {
      for (const int b : outline) {
        const Vec2 way = input_.start[index(b)] - input_.start[index(a)];
        if (way.x < 0.7 * (high - low)) continue;
        const Vec2 middle = 0.5 * (input_.start[index(a)] + input_.start[index(b)]);
        // Of lines equally straight the one through the middle of the piece.
        const double crooked = std::abs(way.y) / way.x + 1e-3 * std::abs(middle.y) / (high - low);
        if (crooked < least) {
          least = crooked;
          best = {a, b};
        }
      }
    }
    return best;
  }

  void match_seams() {
    for (std::size_t s = 0; s < garment_.seams.size(); ++s) {
      const Seam& seam = garment_.seams[s];
      for (const PMesh::SewnRun& run : mesh_.p.sewn[s]) {
        for (std::size_t i = 0; i + 1 < run.first.size(); ++i) {
          LengthMatch match{{run.first[i], run.first[i + 1]}, {run.second[i], run.second[i + 1]}};
          match.length = std::max(distance(target(match.first[0]), target(match.first[1])), 1e-6);
          match.seam = static_cast<int>(s);
          const bool same = match.first == match.second;
          if (!same && seam.fullness == Seam::Fullness::None) input_.matches.push_back(match);
        }
      }
    }
  }

  const Garment& garment_;
  const SewnMesh& mesh_;
  std::vector<Scale> scales_;
  std::vector<Frame> frames_;
  FlatteningInput input_;
  Development development_;
};

}  // namespace

Development develop(const Garment& garment, const SewnMesh& mesh, const Body& body, const FlattenOptions& options,
                    const Job& job) {
  Target target = find_target(garment, mesh, body);
  if (!target.troubles.empty()) return {std::move(target), {}, {}, {}};
  return Developing(garment, mesh, std::move(target)).run(options, job);
}

SewnMesh developed_mesh(const SewnMesh& mesh, const Development& development) {
  SewnMesh developed = mesh;
  developed.p.points = development.points;
  developed.p.warp_of_piece = development.warp_of_piece;
  return developed;
}

}  // namespace toile
