#include "runtime/report/folds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "runtime/mesh/index.hpp"

namespace toile {

namespace {

constexpr std::size_t kSamples = 512;
constexpr std::size_t kHarmonics = 32;
constexpr double kProminence = 0.05;
constexpr int kOval = 2;

/// Points at equal distances along a closed line; empty for a line without length.
std::vector<Vec3> resampled(const std::vector<Vec3>& loop) {
  std::vector<double> end(loop.size());  // arc length at the end of each side
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) end[i] = length += distance(loop[i], loop[(i + 1) % loop.size()]);
  if (!(length > 0) || !std::isfinite(length)) return {};
  std::vector<Vec3> samples;
  samples.reserve(kSamples);
  std::size_t side = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const double s = length * static_cast<double>(k) / kSamples;
    while (side + 1 < loop.size() && end[side] <= s) ++side;
    const double begin = side == 0 ? 0 : end[side - 1];
    const double along = end[side] > begin ? (s - begin) / (end[side] - begin) : 0;
    samples.push_back(loop[side] + along * (loop[(side + 1) % loop.size()] - loop[side]));
  }
  return samples;
}

std::vector<double> distances_from_axis(const std::vector<Vec3>& samples) {
  Vec3 centre;
  for (const Vec3& p : samples) centre += p / static_cast<double>(samples.size());
  std::vector<double> radius;
  radius.reserve(samples.size());
  for (const Vec3& p : samples) radius.push_back(std::hypot(p.x - centre.x, p.y - centre.y));
  return radius;
}

/// The first harmonics of a periodic sequence of kSamples.
std::vector<double> smoothed(const std::vector<double>& values) {
  std::vector<double> result(values.size(), 0.0);
  const double step = 2 * std::numbers::pi / static_cast<double>(values.size());
  for (std::size_t harmonic = 0; harmonic <= kHarmonics; ++harmonic) {
    double even = 0;
    double odd = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double angle = step * static_cast<double>(harmonic * i % values.size());
      even += values[i] * std::cos(angle);
      odd += values[i] * std::sin(angle);
    }
    const double scale = (harmonic == 0 ? 1.0 : 2.0) / static_cast<double>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double angle = step * static_cast<double>(harmonic * i % values.size());
      result[i] += scale * (even * std::cos(angle) + odd * std::sin(angle));
    }
  }
  return result;
}

/// The lowest value met from `peak` in steps of `stride` round the sequence until something higher (or, on one side, as
/// high) is met.
double valley(const std::vector<double>& values, std::size_t peak, std::size_t stride, bool stop_at_equal) {
  double lowest = values[peak];
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double value = values[(peak + i * stride) % values.size()];
    if (value > values[peak] || (stop_at_equal && value == values[peak])) break;
    lowest = std::min(lowest, value);
  }
  return lowest;
}

/// The boundary as a graph: the ends of free edges at each vertex, ascending.
std::vector<std::vector<int>> boundary_neighbours(const SMesh& mesh) {
  std::vector<std::vector<int>> neighbours(index(mesh.vertex_count));
  for (const SMesh::Edge& edge : mesh.edges) {
    if (edge.wings.size() != 1) continue;
    neighbours[index(edge.vertices[0])].push_back(edge.vertices[1]);
    neighbours[index(edge.vertices[1])].push_back(edge.vertices[0]);
  }
  for (std::vector<int>& ends : neighbours) std::sort(ends.begin(), ends.end());
  return neighbours;
}

/// Takes the edge from `from` to its smallest neighbour out of the graph and returns that neighbour, or -1.
int take_edge(std::vector<std::vector<int>>& neighbours, int from) {
  std::vector<int>& ends = neighbours[index(from)];
  if (ends.empty()) return -1;
  const int to = ends.front();
  ends.erase(ends.begin());
  std::vector<int>& back = neighbours[index(to)];
  back.erase(std::find(back.begin(), back.end(), from));
  return to;
}

double mean_height(const std::vector<int>& loop, const std::vector<Vec3>& positions) {
  double sum = 0;
  for (const int vertex : loop) sum += positions[index(vertex)].z;
  return sum / static_cast<double>(loop.size());
}

}  // namespace

std::vector<std::vector<int>> boundary_loops(const SMesh& mesh) {
  std::vector<std::vector<int>> neighbours = boundary_neighbours(mesh);
  std::vector<std::vector<int>> loops;
  for (int start = 0; start < mesh.vertex_count; ++start) {
    while (!neighbours[index(start)].empty()) {
      std::vector<int> loop{start};
      int at = take_edge(neighbours, start);
      while (at >= 0 && at != start) {
        loop.push_back(at);
        at = take_edge(neighbours, at);
      }
      if (at == start) loops.push_back(std::move(loop));
    }
  }
  return loops;
}

std::optional<std::vector<int>> lowest_free_loop(const SMesh& mesh, const std::vector<Vec3>& positions,
                                                 const std::vector<bool>& held) {
  std::optional<std::vector<int>> lowest;
  double height = std::numeric_limits<double>::infinity();
  for (std::vector<int>& loop : boundary_loops(mesh)) {
    if (std::all_of(loop.begin(), loop.end(), [&](int vertex) { return held[index(vertex)]; })) continue;
    const double mean = mean_height(loop, positions);
    if (!(mean < height)) continue;
    height = mean;
    lowest = std::move(loop);
  }
  return lowest;
}

int count_folds(const std::vector<Vec3>& loop) {
  const std::vector<Vec3> samples = resampled(loop);
  if (samples.empty()) return 0;
  const std::vector<double> radius = smoothed(distances_from_axis(samples));
  const double mean = std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(radius.size());
  int folds = 0;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double before = radius[(i + radius.size() - 1) % radius.size()];
    const double after = radius[(i + 1) % radius.size()];
    if (!(radius[i] > before && radius[i] >= after)) continue;
    const double valleys = std::max(valley(radius, i, 1, false), valley(radius, i, radius.size() - 1, true));
    if (radius[i] - valleys > kProminence * mean) ++folds;
  }
  return folds > kOval ? folds : 0;
}

}  // namespace toile
