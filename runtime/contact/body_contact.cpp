#include "runtime/contact/body_contact.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/solve/parallel.hpp"

namespace toile {
namespace {

constexpr double reach = 0.03;         // [m] how far away the body is looked for
constexpr double elastic_slip = 1e-4;  // [m] how far a sticking point gives before it slips

std::vector<ContactPoint> contact_points(const Cloth& cloth) {
  // A quarter of each triangle's area to its corners, three quarters to the middles of its edges.
  std::vector<ContactPoint> points;
  for (int v = 0; v < cloth.vertex_count; ++v) {
    points.push_back({v, v, cloth.area_of_vertex[static_cast<std::size_t>(v)] / 4});
  }
  std::vector<double> area(static_cast<std::size_t>(cloth.edge_count), 0.0);
  for (const ClothTriangle& triangle : cloth.triangles) {
    const double own = 0.5 * std::abs(cross(triangle.uv[1] - triangle.uv[0], triangle.uv[2] - triangle.uv[0]));
    for (const int edge : triangle.edges) area[static_cast<std::size_t>(edge)] += own / 4;
  }
  for (std::size_t e = 0; e < area.size(); ++e) {
    points.push_back({cloth.edges[e].vertices[0], cloth.edges[e].vertices[1], area[e]});
  }
  return points;
}

}  // namespace

BodyContact::BodyContact(const Cloth& cloth, const Body& body, double gap, double friction)
    : body_(body),
      vertices_(cloth.vertex_count),
      gap_(gap),
      friction_(friction),
      points_(contact_points(cloth)),
      grips_(points_.size()),
      touches_(points_.size()),
      clearance_(points_.size()) {}

Vector3 BodyContact::place(const ContactPoint& point, const Vector& q) const {
  return 0.5 * (q.segment<3>(3 * point.first) + q.segment<3>(3 * point.second));
}

const std::vector<BodyContact::Touch>& BodyContact::touches(const Vector& q) const {
  const Eigen::Index coordinates = 3 * vertices_;
  if (measured_at_.size() == coordinates && measured_at_ == q.head(coordinates)) return touches_;
  measured_at_ = q.head(coordinates);
  parallel_for(points_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector3 at = place(points_[i], q);
      touches_[i] = {};
      Clearance& clearance = clearance_[i];
      if ((at - clearance.at).norm() < clearance.free) continue;
      const std::optional<SurfacePoint> nearest = body_.nearest(to_vec3(at), reach);
      clearance = {at, (nearest ? nearest->distance : reach) - gap_};
      if (nearest && nearest->distance < gap_)
        touches_[i] = {true, to_eigen(nearest->normal), gap_ - nearest->distance};
    }
  });
  return touches_;
}

Vector3 BodyContact::slip(const Grip& grip, const Vector3& at) const {
  const Vector3 away = at - grip.anchor;
  return away - away.dot(grip.normal) * grip.normal;
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
    if (grips_[i].holds) {
      const Vector3 slid = slip(grips_[i], place(points_[i], q));
      const double length = slid.norm();
      const bool sticks = length < elastic_slip;
      energy += grips_[i].limit * (sticks ? 0.5 * length * length / elastic_slip : length - 0.5 * elastic_slip);
      derivative += grips_[i].limit / std::max(length, elastic_slip) * slid;
    }
    if (gradient == nullptr || !(touches[i].in || grips_[i].holds)) continue;
    gradient->segment<3>(3 * points_[i].first) += 0.5 * derivative;
    gradient->segment<3>(3 * points_[i].second) += 0.5 * derivative;
  }
  return energy;
}

void BodyContact::add_block(const ContactPoint& point, const Matrix3& block, SparseMatrix& matrix) const {
  const auto add = [&](int a, int b, double factor) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < (a == b ? i + 1 : 3); ++j) matrix.add(3 * a + i, 3 * b + j, factor * block(i, j));
    }
  };
  if (point.first == point.second) {
    add(point.first, point.first, 1);
    return;
  }
  add(point.first, point.first, 0.25);
  add(point.second, point.second, 0.25);
  add(point.first, point.second, 0.25);
}

void BodyContact::add_hessian(const Vector& q, Curvature, SparseMatrix& matrix) const {
  const std::vector<Touch>& touches = this->touches(q);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!touches[i].in && !grips_[i].holds) continue;
    Matrix3 block = Matrix3::Zero();
    if (touches[i].in) block += stiffness_ * points_[i].area * touches[i].normal * touches[i].normal.transpose();
    if (grips_[i].holds) {
      const Grip& grip = grips_[i];
      const Vector3 slid = slip(grip, place(points_[i], q));
      const double length = slid.norm();
      Matrix3 tangent = Matrix3::Identity() - grip.normal * grip.normal.transpose();
      // A point at the cone is taken to go on slipping: its spring no longer resists along the way.
      if (length > 0.99 * elastic_slip) tangent -= slid * slid.transpose() / (length * length);
      block += grip.limit / std::max(length, elastic_slip) * tangent;
    }
    add_block(points_[i], block, matrix);
  }
}

void BodyContact::accept(const Vector& q) {
  if (friction_ == 0) return;
  const std::vector<Touch>& touches = this->touches(q);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Grip& grip = grips_[i];
    if (!touches[i].in) {
      grip.holds = false;
      continue;
    }
    const Vector3 at = place(points_[i], q);
    if (!grip.holds) grip.anchor = at;
    grip.holds = true;
    grip.normal = touches[i].normal;
    grip.limit = friction_ * stiffness_ * touches[i].depth * points_[i].area;
    const Vector3 slid = slip(grip, at);
    const double length = slid.norm();
    if (length > elastic_slip) grip.anchor += (1 - elastic_slip / length) * slid;
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
    }
    if (grips_[i].holds) {
      const Vector3 slid = slip(grips_[i], place(points_[i], q));
      const double length = slid.norm();
      sum.friction -= grips_[i].limit / std::max(length, elastic_slip) * slid;
      sum.friction_energy += grips_[i].limit * (length < elastic_slip ? 0.5 * length * length / elastic_slip
                                                                      : length - 0.5 * elastic_slip);
    }
  }
  return sum;
}

std::vector<double> BodyContact::pressures(const Vector& q) const {
  const std::vector<Touch>& touches = this->touches(q);
  std::vector<double> pressures(static_cast<std::size_t>(vertices_));
  for (std::size_t v = 0; v < pressures.size(); ++v) pressures[v] = stiffness_ * touches[v].depth;
  return pressures;
}

}  // namespace toile
