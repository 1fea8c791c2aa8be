#include "runtime/contact/body_contact.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/solve/parallel.hpp"

namespace toile {
namespace {

constexpr double body_reach = 0.03;     // [m] how far away the body is looked for
constexpr double least_approach = 0.8;  // of its clearance a point may move before it is measured again

constexpr double least_share = 0.5, greatest_share = 2;  // of its area at rest that a triangle is taken with

/// Corners of all triangles, middles of edges, middles of triangles, in this order; without areas yet.
std::vector<ContactPoint> contact_points(const Cloth& cloth, const std::vector<double>& gaps,
                                         const std::vector<double>& frictions) {
  std::vector<ContactPoint> points;
  const auto edges = static_cast<std::size_t>(cloth.vertex_count);
  const std::size_t triangles = edges + static_cast<std::size_t>(cloth.edge_count);
  points.reserve(triangles + cloth.triangles.size());
  for (int v = 0; v < cloth.vertex_count; ++v) points.push_back({.vertices = {v}, .count = 1});
  for (const SMesh::Edge& edge : cloth.edges) {
    points.push_back({.vertices = {edge.vertices[0], edge.vertices[1]}, .count = 2});
  }
  for (const ClothTriangle& triangle : cloth.triangles) points.push_back({.vertices = triangle.vertices, .count = 3});
  const auto made_of = [&](std::size_t point, int fabric) {
    points[point].gap = std::max(points[point].gap, gaps[static_cast<std::size_t>(fabric)]);
    points[point].friction = std::max(points[point].friction, frictions[static_cast<std::size_t>(fabric)]);
  };
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    const ClothTriangle& triangle = cloth.triangles[t];
    for (const int v : triangle.vertices) made_of(static_cast<std::size_t>(v), triangle.fabric);
    for (const int e : triangle.edges) made_of(edges + static_cast<std::size_t>(e), triangle.fabric);
    made_of(triangles + t, triangle.fabric);
  }
  return points;
}

double area_at_rest(const ClothTriangle& triangle) {
  return 0.5 * std::abs(cross(triangle.uv[1] - triangle.uv[0], triangle.uv[2] - triangle.uv[0]));
}

}  // namespace

BodyContact::BodyContact(const Cloth& cloth, const Body& body, double gap, double friction)
    : BodyContact(cloth, body, std::vector<double>(static_cast<std::size_t>(cloth.fabric_count()), gap),
                  std::vector<double>(static_cast<std::size_t>(cloth.fabric_count()), friction)) {}

BodyContact::BodyContact(const Cloth& cloth, const Body& body, const std::vector<double>& gaps,
                         const std::vector<double>& frictions)
    : cloth_(cloth),
      body_(body),
      vertices_(cloth.vertex_count),
      rubs_(std::ranges::max(frictions) > 0),
      points_(contact_points(cloth, gaps, frictions)),
      grips_(points_.size()),
      touches_(points_.size()),
      leeway_(points_.size()) {
  share_out_areas([](const ClothTriangle& triangle) { return area_at_rest(triangle); });
}

// A third of each triangle's area to its corners, a third to the middles of its edges and a third to its own. (Exact
// for cubics would be 3/20, 8/20 and 9/20; but a fold may touch with one corner alone, which then has to carry.)
template <class AreaOf>
void BodyContact::share_out_areas(const AreaOf& area_of) {
  for (ContactPoint& point : points_) point.area = 0;
  const auto edges = static_cast<std::size_t>(vertices_);
  const std::size_t triangles = edges + static_cast<std::size_t>(cloth_.edge_count);
  for (std::size_t t = 0; t < cloth_.triangles.size(); ++t) {
    const ClothTriangle& triangle = cloth_.triangles[t];
    const double area = area_of(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      points_[static_cast<std::size_t>(triangle.vertices[k])].area += area / 9;
      points_[edges + static_cast<std::size_t>(triangle.edges[k])].area += area / 9;
    }
    points_[triangles + t].area = area / 3;
  }
}

// The body presses on the cloth as it lies, stretched or not.
void BodyContact::measure_areas(const Vector& q) {
  share_out_areas([&q](const ClothTriangle& triangle) {
    const Vector3 first = q.segment<3>(3 * triangle.vertices[0]);
    const Vector3 one = q.segment<3>(3 * triangle.vertices[1]) - first;
    const Vector3 two = q.segment<3>(3 * triangle.vertices[2]) - first;
    const double rest = area_at_rest(triangle);
    return std::clamp(0.5 * one.cross(two).norm(), least_share * rest, greatest_share * rest);
  });
}

Vector3 BodyContact::place(const ContactPoint& point, const Vector& q) const {
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < point.count; ++k) sum += q.segment<3>(3 * point.vertices[static_cast<std::size_t>(k)]);
  return sum / point.count;
}

const std::vector<BodyContact::Touch>& BodyContact::touches(const Vector& q) const {
  const Eigen::Index coordinates = 3 * vertices_;
  if (measured_at_.size() == coordinates && measured_at_ == q.head(coordinates)) return touches_;
  measured_at_ = q.head(coordinates);
  parallel_for(points_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector3 at = place(points_[i], q);
      touches_[i] = {};
      Leeway& leeway = leeway_[i];
      if ((at - leeway.at).norm() < leeway.free) continue;
      const std::optional<Clearance> clear = body_.clearance(to_vec3(at), body_reach);
      const double gap = points_[i].gap;
      leeway = {at, least_approach * ((clear ? clear->distance : body_reach) - gap)};
      if (!clear || clear->distance >= gap) continue;
      Matrix3 curvature;
      for (int k = 0; k < 3; ++k) curvature.row(k) = to_eigen(clear->hessian[static_cast<std::size_t>(k)]);
      touches_[i] = {true, gap - clear->distance, to_eigen(clear->gradient), curvature};
    }
  });
  return touches_;
}

double BodyContact::energy(const Vector& q, Vector* gradient) const {
  const std::vector<Touch>& touches = this->touches(q);
  double energy = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Vector3 derivative = Vector3::Zero();
    if (touches[i].in) {
      energy += 0.5 * stiffness_ * touches[i].depth * touches[i].depth * points_[i].area;
      derivative -= stiffness_ * touches[i].depth * points_[i].area * touches[i].normal;
    }
    if (grips_[i]) {
      const Vector3 at = place(points_[i], q);
      energy += grips_[i]->work(at);
      derivative += grips_[i]->pull(at);
    }
    if (gradient == nullptr || !(touches[i].in || grips_[i])) continue;
    for (int k = 0; k < points_[i].count; ++k) {
      gradient->segment<3>(3 * points_[i].vertices[static_cast<std::size_t>(k)]) += derivative / points_[i].count;
    }
  }
  return energy;
}

void BodyContact::add_block(const ContactPoint& point, const Matrix3& block, SparseMatrix& matrix) const {
  const auto add = [&](int a, int b, double factor) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < (a == b ? i + 1 : 3); ++j) matrix.add(3 * a + i, 3 * b + j, factor * block(i, j));
    }
  };
  const double share = 1.0 / (point.count * point.count);
  for (int k = 0; k < point.count; ++k) {
    for (int l = 0; l <= k; ++l)
      add(point.vertices[static_cast<std::size_t>(k)], point.vertices[static_cast<std::size_t>(l)], share);
  }
}

Matrix3 BodyContact::normal_block(const Touch& touch, double area, Curvature curvature) const {
  const Matrix3 true_bend = -touch.depth * touch.curvature;
  const Matrix3 bend = curvature == Curvature::Full ? true_bend : positive_part(true_bend);
  return stiffness_ * area * (touch.normal * touch.normal.transpose() + bend);
}

void BodyContact::add_hessian(const Vector& q, Curvature curvature, SparseMatrix& matrix) const {
  const std::vector<Touch>& touches = this->touches(q);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!touches[i].in && !grips_[i]) continue;
    Matrix3 block = Matrix3::Zero();
    if (touches[i].in) block += normal_block(touches[i], points_[i].area, curvature);
    if (grips_[i]) block += grips_[i]->stiffness(place(points_[i], q));
    add_block(points_[i], block, matrix);
  }
}

void BodyContact::accept(const Vector& q) {
  measure_areas(q);
  if (!rubs_) return;
  const std::vector<Touch>& touches = this->touches(q);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    std::optional<Grip>& grip = grips_[i];
    if (!touches[i].in) {
      grip.reset();
      continue;
    }
    const Vector3 at = place(points_[i], q);
    grip = grip_on(grip ? grip->pull(at) : Vector3::Zero(), at, touches[i].normal.normalized(),
                   points_[i].friction * stiffness_ * touches[i].depth * points_[i].area);
  }
}

ContactForces BodyContact::forces(const Vector& q) const {
  const std::vector<Touch>& touches = this->touches(q);
  ContactForces sum;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (touches[i].in) {
      sum.normal += stiffness_ * touches[i].depth * points_[i].area * touches[i].normal;
      sum.normal_energy += 0.5 * stiffness_ * touches[i].depth * touches[i].depth * points_[i].area;
      sum.area += points_[i].area;
      sum.max_depth = std::max(sum.max_depth, touches[i].depth);
      sum.max_pressure = stiffness_ * sum.max_depth;
    }
    if (grips_[i]) {
      const Vector3 at = place(points_[i], q);
      sum.friction -= grips_[i]->pull(at);
      sum.friction_energy += grips_[i]->work(at);
    }
  }
  return sum;
}

std::vector<double> BodyContact::pressures(const Vector& q) const {
  const std::vector<Touch>& touches = this->touches(q);
  std::vector<double> forces(static_cast<std::size_t>(vertices_), 0.0), areas(forces.size(), 0.0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    for (int k = 0; k < points_[i].count; ++k) {
      const auto v = static_cast<std::size_t>(points_[i].vertices[static_cast<std::size_t>(k)]);
      const double area = points_[i].area / points_[i].count;
      forces[v] += stiffness_ * touches[i].depth * area;
      areas[v] += area;
    }
  }
  for (std::size_t v = 0; v < forces.size(); ++v) forces[v] /= std::max(areas[v], 1e-300);
  return forces;
}

}  // namespace toile
