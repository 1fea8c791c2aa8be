#include "runtime/develop/develop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr double finest_turn = 0.03;  // [rad] of a free grain

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

/// Every point where its piece is drawn.
std::vector<Vec2> drawn(const PMesh& mesh, const std::vector<Vec2>& warp_of_piece, const std::vector<Vec2>& uv) {
  std::vector<Vec2> points;
  for (std::size_t p = 0; p < uv.size(); ++p) {
    points.push_back(Frame{warp_of_piece[index(mesh.piece_of_point[p])]}.back(uv[p]));
  }
  return points;
}

class Developing {
 public:
  Developing(const Garment& garment, const SewnMesh& mesh, Target target) : garment_(garment), mesh_(mesh) {
    development_.target = std::move(target);
  }

  Development run(const FlattenOptions& options, const Job& job) {
    find_scales();
    fill_input();
    for (int piece = 0; piece < piece_count(); ++piece) input_.grain.push_back(grain_of(piece));
    match_seams();
    for (const Frame& frame : frames_) development_.warp_of_piece.push_back(frame.warp);
    const FabricLaw law = make_law(garment_.fabric);
    turn_free_grains(law, job);
    development_.flat = flatten(input_, law, options, job);
    development_.points = drawn(mesh_.p, development_.warp_of_piece, development_.flat.uv);
    development_.plane = std::move(input_);
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

  /// Pieces whose grain is free are tried at turns of 45 degrees, and then in ever smaller parts of such a turn about
  /// the best, one after the other.
  void turn_free_grains(const FabricLaw& law, const Job& job) {
    FlattenOptions roughly;
    roughly.tolerance = 1e-4;
    roughly.length_tolerance = 1e-3;
    roughly.max_iterations = 60;
    const auto energy = [&] {
      const Flattened flat = flatten(input_, law, roughly, job);
      return flat.energy.warp + flat.energy.weft + flat.energy.shear;
    };
    for (int piece = 0; piece < piece_count(); ++piece) {
      if (!garment_.pieces[index(piece)].free_grain) continue;
      double best = 0, least = energy(), turned = 0;
      const auto consider = [&](double angle) {
        turn_piece(piece, angle - turned);
        turned = angle;
        const double now = energy();
        if (now >= least) return;
        least = now;
        best = angle;
      };
      constexpr double eighth = std::numbers::pi / 4;
      for (const int eighths : {1, 2, 3}) consider(eighths * eighth);
      for (double step = eighth / 2; step > finest_turn; step /= 2) {
        const double middle = best;
        consider(middle - step);
        consider(middle + step);
      }
      turn_piece(piece, best - turned);
    }
  }

  void turn_piece(int number, double angle) {
    const Vec2 along = direction(angle);
    for (std::size_t p = 0; p < input_.start.size(); ++p) {
      if (mesh_.p.piece_of_point[p] != number) continue;
      const Vec2 place = input_.start[p];
      input_.start[p] = place.x * along + place.y * perpendicular(along);
    }
    input_.grain[index(number)] = grain_of(number);
  }

  void fill_input() {
    input_.triangles = mesh_.p.triangles;
    for (std::size_t p = 0; p < mesh_.p.points.size(); ++p) {
      const std::size_t piece = index(mesh_.p.piece_of_point[p]);
      input_.target.push_back(target(static_cast<int>(p)));
      input_.start.push_back(frames_[piece].into(scales_[piece](chart()[p])));
    }
  }

  FlatteningInput::GrainLine grain_of(int number) const {
    std::vector<int> outline;
    for (const PMesh::EdgeNodes& edge : mesh_.p.edge_nodes[index(number)]) {
      outline.insert(outline.end(), edge.points.begin(), edge.points.end() - 1);
    }
    const Piece& piece = garment_.pieces[index(number)];
    if (piece.free_grain || !piece.fold || std::abs(cross(piece.fold->to - piece.fold->from, piece.warp)) > 1e-6) {
      return grain_line(input_.start, outline);
    }
    const auto nearest = [&](Vec2 place) {
      return *std::min_element(outline.begin(), outline.end(), [&](int a, int b) {
        return distance(mesh_.p.points[index(a)], place) < distance(mesh_.p.points[index(b)], place);
      });
    };
    return {nearest(piece.fold->from), nearest(piece.fold->to)};  // the fold stays straight
  }

  /// [m] on the form, where both of its sides are one line.
  double length_of(std::size_t seam) const {
    double length = 0;
    for (const PMesh::SewnRun& run : mesh_.p.sewn[seam]) {
      for (std::size_t i = 0; i + 1 < run.first.size(); ++i) {
        length += distance(target(run.first[i]), target(run.first[i + 1]));
      }
    }
    return length;
  }

  /// Where one side is eased, gathered or stretched onto the other, the one named first is so much longer.
  void match_seams() {
    for (std::size_t s = 0; s < garment_.seams.size(); ++s) {
      const Seam& seam = garment_.seams[s];
      const bool matched = seam.fullness == Seam::Fullness::None || seam.stated > 0;
      const double longer = seam.fullness == Seam::Fullness::None ? 0 : seam.stated / std::max(length_of(s), 1e-6);
      for (const PMesh::SewnRun& run : mesh_.p.sewn[s]) {
        for (std::size_t i = 0; i + 1 < run.first.size(); ++i) {
          LengthMatch match{{run.first[i], run.first[i + 1]}, {run.second[i], run.second[i + 1]}};
          match.length = std::max(distance(target(match.first[0]), target(match.first[1])), 1e-6);
          match.longer = longer * match.length;
          match.seam = static_cast<int>(s);
          const bool same = match.first == match.second;
          if (!same && matched) input_.matches.push_back(match);
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

Development develop(const Garment& garment, const SewnMesh& mesh, Target target, const FlattenOptions& options,
                    const Job& job) {
  return Developing(garment, mesh, std::move(target)).run(options, job);
}

Development with_pattern(const SewnMesh& mesh, const FabricLaw& law, Development development, std::vector<Vec2> uv) {
  const Flattened solved = std::move(development.flat);
  development.flat = measured(development.plane, law, std::move(uv));
  development.flat.converged = solved.converged;
  development.flat.iterations = solved.iterations;
  development.flat.factorisations = solved.factorisations;
  development.flat.residual_N = solved.residual_N;
  development.flat.residual_relative = solved.residual_relative;
  development.points = drawn(mesh.p, development.warp_of_piece, development.flat.uv);
  return development;
}

OpenedDart opened_dart(const PMesh& mesh, int piece, const Dart& dart, const Development& development) {
  const auto& edges = mesh.edge_nodes[index(piece)];
  const std::vector<int>&left = edges[index(dart.left_leg)].points, &right = edges[index(dart.right_leg)].points;
  const auto at = [&](int point) { return development.points[index(point)]; };
  OpenedDart opened;
  // One leg is walked to the tip and the other from it.
  const bool left_first = left.back() == right.front();
  opened.width =
      left_first ? distance(at(left.front()), at(right.back())) : distance(at(left.back()), at(right.front()));
  for (std::size_t i = 1; i < left.size(); ++i) opened.leg += distance(at(left[i - 1]), at(left[i]));
  return opened;
}

SewnMesh developed_mesh(const SewnMesh& mesh, const Development& development) {
  SewnMesh developed = mesh;
  developed.p.points = development.points;
  developed.p.warp_of_piece = development.warp_of_piece;
  return developed;
}

}  // namespace toile
