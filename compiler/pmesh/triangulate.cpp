#include "compiler/pmesh/triangulate.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <tuple>

#include "compiler/pmesh/refinement_rules.hpp"
#include "compiler/pmesh/sides.hpp"

namespace toile {
namespace {

struct NodeInfo {
  int id = -1;
};

struct FaceInfo {
  bool inside = false;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<NodeInfo, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using VertexHandle = Cdt::Vertex_handle;
using FaceHandle = Cdt::Face_handle;
using Point = Kernel::Point_2;

Vec2 vec(const Point& p) {
  return {p.x(), p.y()};
}

class Refinement {
 public:
  Refinement(const PlaneDomain& domain, const TriangulationSize& size, Outline outline)
      : domain_(domain), rules_(domain, size), outline_(outline) {}

  Triangulation run() {
    insert_outline();
    if (wanted_.empty() && cdt_.dimension() == 2) {
      insert_pins();
      mark_inside();
      refine();
    }
    return result();
  }

 private:
  struct Candidate {
    double urgency = 0;  // see RefinementRules
    long born = 0;
    std::array<VertexHandle, 3> corners;

    bool operator<(const Candidate& other) const {
      return std::tie(urgency, other.born) < std::tie(other.urgency, born);
    }
  };

  VertexHandle insert_node(Vec2 p, FaceHandle hint) {
    const VertexHandle v = cdt_.insert(Point(p.x, p.y), hint);
    if (v->info().id < 0) {
      v->info().id = static_cast<int>(nodes_.size());
      nodes_.push_back(v);
    }
    return v;
  }

  void insert_outline() {
    FaceHandle hint;
    for (const Vec2 p : nodes_of(domain_)) {
      const VertexHandle v = insert_node(p, hint);
      hint = v->face();
      node_of_outline_.push_back(v->info().id);
    }
    for (const DomainSide& side : sides_of(domain_)) insert_side(side);
  }

  void insert_side(const DomainSide& side) {
    const int a = node_of_outline_[side.a], b = node_of_outline_[side.b];
    if (a == b) return;
    try {
      cdt_.insert_constraint(nodes_[a], nodes_[b]);
      sides_.add(a, b, {side.loop, side.from, a});
    } catch (const Cdt::Intersection_of_constraints_exception&) {
      if (outline_ == Outline::Frozen) return;
      const auto splits = crossing_sides(domain_, side);
      wanted_.insert(wanted_.end(), splits.begin(), splits.end());
    }
  }

  /// Of what lies between two nodes.
  const DividedSides::Part* side_between(VertexHandle a, VertexHandle b) const {
    return sides_.between(a->info().id, b->info().id);
  }
  bool is_line(const DividedSides::Part& side) const { return side.loop >= static_cast<int>(domain_.loops.size()); }

  void insert_pins() {
    for (const Vec2 pin : domain_.pins) node_of_pin_.push_back(insert_node(pin, {})->info().id);
  }

  void mark_inside() {
    std::vector<FaceHandle> open{cdt_.infinite_face()}, next;
    CGAL::Unique_hash_map<FaceHandle, bool> visited(false);
    visited[open.front()] = true;
    for (bool inside = false; !open.empty(); inside = !inside) {
      next.clear();
      while (!open.empty()) {
        const FaceHandle f = open.back();
        open.pop_back();
        f->info().inside = inside && !cdt_.is_infinite(f);
        for (int i = 0; i < 3; ++i) {
          const FaceHandle g = f->neighbor(i);
          if (visited[g]) continue;
          if (f->is_constrained(i) && bounds_cloth(f, i)) {
            next.push_back(g);
          } else {
            visited[g] = true;
            open.push_back(g);
          }
        }
      }
      for (const FaceHandle f : next) {
        if (visited[f]) continue;
        visited[f] = true;
        open.push_back(f);
      }
    }
  }

  bool bounds_cloth(FaceHandle f, int i) const {
    const DividedSides::Part* side = side_between(f->vertex(Cdt::ccw(i)), f->vertex(Cdt::cw(i)));
    return side == nullptr || !is_line(*side);
  }

  // --- refinement -----------------------------------------------------------------------------------------------

  void consider(FaceHandle f) {
    if (cdt_.is_infinite(f) || !f->info().inside) return;
    const double urgency =
        rules_.urgency({vec(f->vertex(0)->point()), vec(f->vertex(1)->point()), vec(f->vertex(2)->point())});
    if (urgency > 0) queue_.push({urgency, born_++, {f->vertex(0), f->vertex(1), f->vertex(2)}});
  }

  void consider_star(VertexHandle v) {
    auto f = cdt_.incident_faces(v);
    const auto first = f;
    do {
      consider(f);
    } while (++f != first);
  }

  void refine() {
    double area = 0;
    for (const FaceHandle f : cdt_.finite_face_handles()) {
      if (f->info().inside) area += std::abs(cdt_.triangle(f).area());
    }
    for (const FaceHandle f : cdt_.finite_face_handles()) consider(f);
    long budget = rules_.most_nodes(area, nodes_.size());
    while (!queue_.empty() && --budget > 0) {
      const Candidate worst = queue_.top();
      queue_.pop();
      FaceHandle f;
      if (cdt_.is_face(worst.corners[0], worst.corners[1], worst.corners[2], f) && f->info().inside) attack(f, worst);
    }
  }

  void attack(FaceHandle f, const Candidate& candidate) {
    const Point centre = cdt_.circumcenter(f);
    if (!std::isfinite(centre.x()) || !std::isfinite(centre.y())) return;
    std::vector<Cdt::Edge> encroached;
    FaceHandle home = f;
    if (const auto wall = walk(f, centre, home)) {
      encroached.push_back(*wall);
    } else if (!holds(home, centre)) {
      return;  // rounding led the walk astray: the conflict zone must be sought from the face that holds the point
    } else {
      std::vector<Cdt::Edge> rim;
      cdt_.get_boundary_of_conflicts(centre, std::back_inserter(rim), home);
      for (const Cdt::Edge& e : rim) {
        const Vec2 a = vec(e.first->vertex(Cdt::ccw(e.second))->point());
        const Vec2 b = vec(e.first->vertex(Cdt::cw(e.second))->point());
        if (e.first->is_constrained(e.second) && RefinementRules::encroaches(vec(centre), a, b))
          encroached.push_back(e);
      }
    }
    if (encroached.empty()) {
      const VertexHandle v = insert_node(vec(centre), home);
      mark_star(v);
      consider_star(v);
      return;
    }
    split_sides(encroached, candidate);
  }

  void split_sides(const std::vector<Cdt::Edge>& sides, const Candidate& candidate) {
    if (outline_ == Outline::Frozen) return;
    std::vector<std::array<VertexHandle, 2>> ends;
    for (const Cdt::Edge& e : sides) {
      ends.push_back({e.first->vertex(Cdt::ccw(e.second)), e.first->vertex(Cdt::cw(e.second))});
    }
    bool any = false;
    for (const auto& [a, b] : ends) {
      FaceHandle f;
      int i = 0;
      if (cdt_.is_edge(a, b, f, i)) any |= split_side(a, b);
    }
    if (any) queue_.push(candidate);
  }

  /// The face that holds p, or the constrained edge that hides p from the face.
  std::optional<Cdt::Edge> walk(FaceHandle f, const Point& p, FaceHandle& home) const {
    const Point from = CGAL::centroid(cdt_.triangle(f));
    FaceHandle previous;
    for (std::size_t steps = cdt_.number_of_faces() + 8; steps > 0; --steps) {
      int leave = -1;
      for (int i = 0; i < 3 && leave < 0; ++i) {
        const Point &a = f->vertex(Cdt::ccw(i))->point(), &b = f->vertex(Cdt::cw(i))->point();
        if (f->neighbor(i) != previous && CGAL::orientation(a, b, p) == CGAL::RIGHT_TURN &&
            CGAL::orientation(from, p, a) != CGAL::LEFT_TURN && CGAL::orientation(from, p, b) != CGAL::RIGHT_TURN) {
          leave = i;
        }
      }
      if (leave < 0) break;
      if (f->is_constrained(leave)) return Cdt::Edge(f, leave);
      previous = f;
      f = f->neighbor(leave);
    }
    home = f;
    return std::nullopt;
  }

  bool holds(FaceHandle f, const Point& p) const {
    if (cdt_.is_infinite(f) || !f->info().inside) return false;
    for (int i = 0; i < 3; ++i) {
      const Point &a = f->vertex(Cdt::ccw(i))->point(), &b = f->vertex(Cdt::cw(i))->point();
      if (CGAL::orientation(a, b, p) == CGAL::RIGHT_TURN) return false;
    }
    return true;
  }

  /// An inner node's star lies inside; that of a node on the outline is inside to the left of its sides.
  void mark_star(VertexHandle v) {
    auto f = cdt_.incident_faces(v);
    const auto first = f;
    do {
      f->info().inside = true;
    } while (++f != first);
  }

  void mark_star_on_side(VertexHandle v, VertexHandle before, VertexHandle after) {
    auto f = cdt_.incident_faces(v);  // counter-clockwise
    for (int guard = 0; f->vertex(Cdt::ccw(f->index(v))) != after && guard < 1000000; ++guard) ++f;
    bool inside = true;
    const auto first = f;
    do {
      if (f->vertex(Cdt::ccw(f->index(v))) == before) inside = false;
      f->info().inside = inside && !cdt_.is_infinite(f);
    } while (++f != first);
  }

  bool split_side(VertexHandle a, VertexHandle b) {
    const DividedSides::Part* known = side_between(a, b);
    if (known == nullptr) return false;
    const DividedSides::Part side = *known;
    if (side.first != a->info().id) std::swap(a, b);  // now in its loop's direction
    const Vec2 p = vec(a->point()), q = vec(b->point());
    const auto lambda = rules_.place_of_split(p, q);
    if (!lambda) return false;
    FaceHandle f;
    int i = 0;
    cdt_.is_edge(a, b, f, i);
    const VertexHandle v = insert_on_side(p + *lambda * (q - p), a, b, f);
    wanted_.push_back({side.loop, side.from, sides_.divide(a->info().id, b->info().id, v->info().id, *lambda)});
    if (is_line(side)) {
      mark_star(v);
    } else {
      mark_star_on_side(v, a, b);
    }
    consider_star(v);
    return true;
  }

  /// Rounding puts the node a hair off the side, so the constraint is renewed through it.
  VertexHandle insert_on_side(Vec2 p, VertexHandle a, VertexHandle b, FaceHandle f) {
    cdt_.remove_constrained_edge(f, f->index(third(f, a, b)));
    FaceHandle g;
    int i = 0;
    if (cdt_.is_edge(a, b, g, i)) f = g;
    const VertexHandle v = insert_node(p, f);
    cdt_.insert_constraint(a, v);
    cdt_.insert_constraint(v, b);
    return v;
  }

  static VertexHandle third(FaceHandle f, VertexHandle a, VertexHandle b) {
    for (int i = 0; i < 3; ++i) {
      if (f->vertex(i) != a && f->vertex(i) != b) return f->vertex(i);
    }
    return {};
  }

  // --- output ---------------------------------------------------------------------------------------------------

  std::vector<bool> nodes_of_inner_faces() const {
    std::vector<bool> used(nodes_.size(), false);
    for (const FaceHandle f : cdt_.finite_face_handles()) {
      for (int i = 0; i < 3 && f->info().inside; ++i) used[f->vertex(i)->info().id] = true;
    }
    return used;
  }

  Triangulation result() const {
    Triangulation out;
    out.wanted = wanted_;
    std::sort(out.wanted.begin(), out.wanted.end(), [](const OutlineSplit& a, const OutlineSplit& b) {
      return std::tie(a.loop, a.from, a.fraction) < std::tie(b.loop, b.from, b.fraction);
    });
    out.wanted.erase(std::unique(out.wanted.begin(), out.wanted.end()), out.wanted.end());
    out.points = nodes_of(domain_);
    out.fixed = static_cast<int>(out.points.size());
    if (!out.wanted.empty() || cdt_.dimension() < 2) return out;

    std::vector<int> final_id(nodes_.size(), -1);
    for (int i = static_cast<int>(node_of_outline_.size()) - 1; i >= 0; --i) final_id[node_of_outline_[i]] = i;
    const std::vector<bool> used = nodes_of_inner_faces();
    for (std::size_t i = 0; i < domain_.pins.size(); ++i) {
      int& id = final_id[node_of_pin_[i]];
      if (id >= 0 || !used[node_of_pin_[i]]) continue;
      id = out.fixed++;
      out.points.push_back(domain_.pins[i]);
    }
    std::vector<int> inner;
    for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) {
      if (final_id[i] < 0 && used[i]) inner.push_back(i);
    }
    std::sort(inner.begin(), inner.end(), [&](int a, int b) { return nodes_[a]->point() < nodes_[b]->point(); });
    for (const int i : inner) {
      final_id[i] = static_cast<int>(out.points.size());
      out.points.push_back(vec(nodes_[i]->point()));
    }
    for (const FaceHandle f : cdt_.finite_face_handles()) {
      if (!f->info().inside) continue;
      std::array<int, 3> t{};
      for (int i = 0; i < 3; ++i) t[i] = final_id[f->vertex(i)->info().id];
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      out.triangles.push_back(t);
    }
    std::sort(out.triangles.begin(), out.triangles.end());
    return out;
  }

  const PlaneDomain& domain_;
  RefinementRules rules_;
  Outline outline_;
  Cdt cdt_;
  DividedSides sides_;
  std::vector<VertexHandle> nodes_;   // by id
  std::vector<int> node_of_outline_;  // the nodes of loops and lines, to ids
  std::vector<int> node_of_pin_;
  std::vector<OutlineSplit> wanted_;
  std::priority_queue<Candidate> queue_;
  long born_ = 0;
};

}  // namespace

Triangulation triangulate(const PlaneDomain& domain, const TriangulationSize& size, Outline outline) {
  return Refinement(domain, size, outline).run();
}

}  // namespace toile
