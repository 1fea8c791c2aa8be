#include "runtime/contact/flaps.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "runtime/contact/piercing.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

/// An edge through a triangle, of one of the lines.
struct Through {
  int edge = 0, triangle = 0;
  Piercing piercing;
};

int root(std::vector<int>& parents, int i) {
  while (parents[index(i)] != i) i = parents[index(i)] = parents[index(parents[index(i)])];
  return i;
}

bool shares_vertex(const std::array<int, 3>& triangle, const std::array<int, 2>& edge) {
  return std::ranges::any_of(edge, [&](int v) { return std::ranges::find(triangle, v) != triangle.end(); });
}

/// The vertices that each vertex is joined to by an edge, and by which.
std::vector<std::vector<std::array<int, 2>>> neighbours_of(const Cloth& cloth) {
  std::vector<std::vector<std::array<int, 2>>> neighbours(index(cloth.vertex_count));
  for (int e = 0; e < cloth.edge_count; ++e) {
    const auto& [a, b] = cloth.edges[index(e)].vertices;
    neighbours[index(a)].push_back({b, e});
    neighbours[index(b)].push_back({a, e});
  }
  return neighbours;
}

class Flaps {
 public:
  Flaps(const Cloth& cloth, const Vector& q, const std::vector<std::array<int, 2>>& pairs)
      : cloth_(cloth), q_(q), pairs_(pairs), neighbours_(neighbours_of(cloth)), line_of_(pairs.size()) {
    std::iota(line_of_.begin(), line_of_.end(), 0);
  }

  FlapPull pull() {
    FlapPull pull{Vector::Zero(q_.size()), std::vector<bool>(pairs_.size(), false)};
    find_lines();
    for (const auto& [line, passages] : lines_) {
      if (!cut_off(passages, ends_of(line), pull.force)) continue;
      for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (root(line_of_, static_cast<int>(i)) == line) pull.of_flap[i] = true;
      }
    }
    return pull;
  }

 private:
  /// Pairs of triangles are of one line where the same edge goes through the same triangle.
  void find_lines() {
    std::map<std::pair<int, int>, std::pair<int, Through>> found;  // by edge and triangle
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      for (const auto& [own, other] : {std::pair{pairs_[i][0], pairs_[i][1]}, {pairs_[i][1], pairs_[i][0]}}) {
        const std::array<int, 3>& through = cloth_.triangles[index(other)].vertices;
        for (const int edge : cloth_.triangles[index(own)].edges) {
          const std::array<int, 2>& ends = cloth_.edges[index(edge)].vertices;
          if (shares_vertex(through, ends)) continue;
          const std::optional<Piercing> piercing = pierce(q_, ends[0], ends[1], through);
          if (!piercing) continue;
          const auto [at, is_new] =
              found.try_emplace({edge, other}, std::pair{static_cast<int>(i), Through{edge, other, *piercing}});
          if (!is_new) line_of_[index(root(line_of_, static_cast<int>(i)))] = root(line_of_, at->second.first);
        }
      }
    }
    for (const auto& [key, passage] : found) lines_[root(line_of_, passage.first)].push_back(passage.second);
  }

  /// Vertices in which a line ends: of pairs of triangles that have one in common.
  std::set<int> ends_of(int line) {
    std::set<int> ends;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (root(line_of_, static_cast<int>(i)) != line) continue;
      const std::array<int, 3>& other = cloth_.triangles[index(pairs_[i][1])].vertices;
      for (const int v : cloth_.triangles[index(pairs_[i][0])].vertices) {
        if (std::ranges::find(other, v) != other.end()) ends.insert(v);
      }
    }
    return ends;
  }

  /// The area of the cloth that can be reached from a vertex without going along the cut edges or through the
  /// ends of the line, given up where it is more than `most`; the vertices are then in `reached`.
  double reach(int from, const std::set<int>& cut, const std::set<int>& ends, double most,
               std::set<int>& reached) const {
    std::vector<int> next{from};
    reached = {from};
    double area = 0;
    while (!next.empty() && area <= most) {
      const int v = next.back();
      next.pop_back();
      area += cloth_.area_of_vertex[index(v)];
      for (const auto& [w, edge] : neighbours_[index(v)]) {
        if (!cut.contains(edge) && !ends.contains(w) && reached.insert(w).second) next.push_back(w);
      }
    }
    return area;
  }

  /// Pulls the smaller part back that a line cuts off; false when it cuts nothing off.
  bool cut_off(const std::vector<Through>& passages, const std::set<int>& ends, Vector& force) const {
    std::set<int> cut;
    for (const Through& each : passages) cut.insert(each.edge);
    std::set<int> flap;
    double smallest = 0.4 * cloth_.area;
    for (const Through& each : passages) {
      for (const int end : cloth_.edges[index(each.edge)].vertices) {
        if (flap.contains(end) || ends.contains(end)) continue;
        std::set<int> reached;
        const double area = reach(end, cut, ends, smallest, reached);
        if (area >= smallest) continue;
        smallest = area;
        flap = std::move(reached);
      }
    }
    bool pulls = false;
    for (const Through& each : passages) {
      const auto& [a, b] = cloth_.edges[index(each.edge)].vertices;
      if (flap.contains(a) == flap.contains(b)) continue;
      const Vector3 normal = each.piercing.normal.normalized();
      const Vector3 back = (flap.contains(a) ? 1 : -1) * (vertex_at(q_, b) - vertex_at(q_, a));
      const Vector3 pull = back.dot(normal) > 0 ? normal : Vector3(-normal);
      for (std::size_t k = 0; k < 2; ++k) {
        force.segment<3>(3 * each.piercing.edge_vertices[k]) += each.piercing.edge_weights[k] * pull;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        force.segment<3>(3 * each.piercing.triangle_vertices[k]) -= each.piercing.triangle_weights[k] * pull;
      }
      pulls = true;
    }
    return pulls;
  }

  const Cloth& cloth_;
  const Vector& q_;
  const std::vector<std::array<int, 2>>& pairs_;
  std::vector<std::vector<std::array<int, 2>>> neighbours_;
  std::vector<int> line_of_;  // of each pair, as a forest
  std::map<int, std::vector<Through>> lines_;
};

}  // namespace

FlapPull pull_flaps(const Cloth& cloth, const Vector& q, const std::vector<std::array<int, 2>>& pairs) {
  return Flaps(cloth, q, pairs).pull();
}

}  // namespace toile
