#include "runtime/drape/levels.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "runtime/drape/carry_over.hpp"

namespace toile {
namespace {

constexpr double coarse_accuracy = 1e-2;  // of every level but the last
// Of the forces of elongation and shear, a level: folds of a coarse mesh lock in dimples with all of them
// (docs/mechanics.md).
constexpr double coarse_membrane = 0.1;
constexpr double coarse_gap = 0.15;     // of the mean edge: a finer mesh fits between layers that far apart
constexpr int coarse_iterations = 400;  // a start for the next level need not be at rest
constexpr int iterations_near_rest = 200;
constexpr int coarsest_triangles = 250;
constexpr int ratio = 4;  // of the triangles of neighbouring levels

std::vector<Worn> worn_lines(const SewnMesh& mesh, const std::vector<Wear>& wears) {
  std::vector<Worn> worn;
  for (const SMesh::WornLine& line : mesh.s.worn) {
    const Wear& wear = wears[static_cast<std::size_t>(line.wear)];
    worn.push_back({&line, wear.line, wear.held, wear.from});
  }
  return worn;
}

double mean_edge(const Cloth& cloth) {
  return std::sqrt(4 / std::sqrt(3.0) * cloth.area /
                   static_cast<double>(std::max<std::size_t>(cloth.triangles.size(), 1)));
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Another form for the placed cloth; held vertices stay where they were placed.
void move_to(std::vector<Vec3> form, Placed& placed) {
  for (const int held : placed.held) {
    form[static_cast<std::size_t>(held)] = placed.positions[static_cast<std::size_t>(held)];
  }
  placed.positions = std::move(form);
}

}  // namespace

std::vector<double> level_edges(double finest_edge, int triangles) {
  std::vector<double> edges;
  // Halving the edge makes four triangles of one.
  for (int left = triangles / ratio; left >= coarsest_triangles; left /= ratio) {
    edges.push_back((edges.empty() ? finest_edge : edges.back()) * 2);
  }
  std::reverse(edges.begin(), edges.end());
  return edges;
}

DrapedLevels drape_levels(const std::vector<DrapeLevel>& meshes, const std::vector<Wear>& wears,
                          const std::vector<ArrangedPiece>& arranged, const std::vector<FabricSheet>& fabrics,
                          const Body* body, const DrapeOptions& options, const Job& job) {
  std::vector<DrapeLevel> levels = meshes;
  // Pieces that are arranged start far from rest: a mesh without a coarser one goes first as its own, softened.
  if (levels.size() == 1 && !arranged.empty()) levels.push_back(levels.front());
  DrapedLevels result;
  int iterations = 0, factorisations = 0;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const DrapeLevel& at = levels[level];
    const double started = seconds();
    Placed placed = place(*at.mesh, *at.cloth, worn_lines(*at.mesh, wears), arranged, body);
    result.error = placed.error;
    if (!result.error.empty()) return result;
    DrapeOptions own = options;
    own.carried_over = level > 0;
    if (level > 0) move_to(carry_over(*levels[level - 1].mesh, result.drape.positions, *at.mesh), placed);
    // What is held somewhere is shaken free of accidental creases first: friction would keep them.
    own.friction = options.friction && (level + 1 == levels.size() || placed.held.empty());
    if (level + 1 < levels.size()) {
      own.accuracy = std::max(options.accuracy, coarse_accuracy);
      own.membrane = std::pow(coarse_membrane, static_cast<double>(levels.size() - 1 - level));
      own.max_iterations = std::min(options.max_iterations, coarse_iterations);
      own.least_gap = coarse_gap * mean_edge(*at.cloth);
    }
    const double ready = seconds();
    result.drape = drape(*at.cloth, fabrics, body, placed, own, job);
    result.place_seconds += ready - started;
    result.solve_seconds += seconds() - ready;
    iterations += result.drape.iterations;
    factorisations += result.drape.factorisations;
    if (result.drape.cancelled && level + 1 < levels.size()) {
      // A usable partial result: the form so far on the mesh that was asked for.
      const DrapeLevel& last = levels.back();
      const Placed start{carry_over(*at.mesh, result.drape.positions, *last.mesh), {}, {}};
      result.drape = drape(*last.cloth, fabrics, body, start, own, job);
      break;
    }
  }
  result.drape.iterations = iterations;
  result.drape.factorisations = factorisations;
  return result;
}

DrapedLevels drape_from(const std::vector<Vec3>& start, const DrapeLevel& mesh, const std::vector<Wear>& wears,
                        const std::vector<ArrangedPiece>& arranged, const std::vector<FabricSheet>& fabrics,
                        const Body* body, const DrapeOptions& options, const Job& job) {
  DrapedLevels result;
  const double started = seconds();
  Placed placed = place(*mesh.mesh, *mesh.cloth, worn_lines(*mesh.mesh, wears), arranged, body);
  result.error = placed.error;
  if (!result.error.empty()) return result;
  move_to(start, placed);
  DrapeOptions own = options;
  own.carried_over = true;
  own.max_iterations = std::min(options.max_iterations, iterations_near_rest);
  const double ready = seconds();
  result.drape = drape(*mesh.cloth, fabrics, body, placed, own, job);
  result.place_seconds = ready - started;
  result.solve_seconds = seconds() - ready;
  return result;
}

}  // namespace toile
