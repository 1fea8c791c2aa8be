#include "runtime/develop/grain_study.hpp"

#include <cmath>
#include <numbers>

#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr std::size_t turn_count = GrainStudy::turns.size();
constexpr double roughly_at_rest = 1e-5;

/// Places seen in a frame that is turned by so much.
std::vector<Vec2> seen_turned(const std::vector<Vec2>& places, double angle) {
  const Vec2 along = direction(angle);
  std::vector<Vec2> seen;
  for (const Vec2 p : places) seen.push_back({dot(p, along), dot(p, perpendicular(along))});
  return seen;
}

FlatteningInput turned_input(const SewnMesh& mesh, const Development& development, double angle) {
  FlatteningInput input = development.plane;
  input.start = seen_turned(development.flat.uv, angle);
  for (std::size_t piece = 0; piece < input.grain.size(); ++piece) {
    std::vector<int> outline;
    for (const PMesh::EdgeNodes& edge : mesh.p.edge_nodes[piece]) {
      outline.insert(outline.end(), edge.points.begin(), edge.points.end() - 1);
    }
    input.grain[piece] = grain_line(input.start, outline);
  }
  return input;
}

/// Piece by piece the pattern is shifted and turned so that it lies on the other as well as can be.
double root_mean_square_apart(const PMesh& mesh, const std::vector<Vec2>& places, const std::vector<Vec2>& others) {
  double sum = 0;
  for (std::size_t piece = 0; piece < mesh.edge_nodes.size(); ++piece) {
    Vec2 middle, other_middle;
    double count = 0;
    const auto each = [&](auto visit) {
      for (std::size_t p = 0; p < places.size(); ++p) {
        if (mesh.piece_of_point[p] == static_cast<int>(piece)) visit(places[p], others[p]);
      }
    };
    each([&](Vec2 a, Vec2 b) {
      middle = middle + a;
      other_middle = other_middle + b;
      ++count;
    });
    if (count == 0) continue;
    double along = 0, across = 0;
    each([&](Vec2 a, Vec2 b) {
      along += dot(a - middle / count, b - other_middle / count);
      across += cross(a - middle / count, b - other_middle / count);
    });
    const Vec2 way = direction(std::atan2(across, along));
    each([&](Vec2 a, Vec2 b) {
      const Vec2 from = a - middle / count;
      const Vec2 off = from.x * way + from.y * perpendicular(way) - (b - other_middle / count);
      sum += dot(off, off);
    });
  }
  return std::sqrt(sum / static_cast<double>(places.size()));
}

}  // namespace

GrainStudy study_grain(const SewnMesh& mesh, const FabricLaw& law, const Development& development, const Job& job) {
  constexpr double degree = std::numbers::pi / 180;
  GrainStudy study;
  std::array<std::vector<Vec2>, turn_count> patterns;  // each in the frame of its own grain
  std::array<FlatteningInput, turn_count> inputs;
  for (std::size_t i = 0; i < turn_count; ++i) {
    if (i == 0) {
      inputs[i] = development.plane;
      patterns[i] = development.flat.uv;
      continue;
    }
    inputs[i] = turned_input(mesh, development, GrainStudy::turns[i] * degree);
    FlattenOptions options;
    options.tolerance = roughly_at_rest;
    patterns[i] = flatten(inputs[i], law, options, job).uv;
  }
  for (std::size_t i = 0; i < turn_count; ++i) {
    for (std::size_t j = 0; j < turn_count; ++j) {
      const double angle = (GrainStudy::turns[i] - GrainStudy::turns[j]) * degree;
      const MembraneEnergy energy = measured(inputs[i], law, seen_turned(patterns[j], angle)).energy;
      study.energy[i][j] = energy.warp + energy.weft + energy.shear;
    }
    study.apart[i] = root_mean_square_apart(mesh.p, patterns[i], patterns[0]);
  }
  return study;
}

}  // namespace toile
