// With e = x1 - x0 and n1, n2 the (long) normals of the two triangles, the gradient by the opposite points is
// g2 = -|e| n1 / |n1|^2 and g3 = -|e| n2 / |n2|^2; the points of the edge take their parts against it by the feet of
// the two heights (Bridson et al. 2003). Second derivatives are those of these expressions.
#include "runtime/energy/dihedral.hpp"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

using Matrix3x12 = Eigen::Matrix<double, 3, 12>;
using Row12 = Eigen::Matrix<double, 1, 12>;

constexpr double least_area_ratio = 1e-12;  // of |n|^2 to |e|^4: keeps derivatives of a collapsed triangle finite

Matrix3 skew(const Vector3& v) {
  Matrix3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// One wing of the hinge: the triangle over the edge with its opposite point at index `apex`.
struct Wing {
  int apex;
  Vector3 normal;    // not unit
  double square;     // |normal|^2
  double foot;       // where the height meets the edge, 0 at x0, 1 at x1
  Vector3 gradient;  // of the angle by the opposite point
};

struct Frame {
  Vector3 edge;
  double length;
  Wing first, second;
};

Wing wing(const Hinge& x, const Vector3& edge, double length, int apex, double sign) {
  const Vector3 arm = x[static_cast<std::size_t>(apex)] - x[0];
  Wing s;
  s.apex = apex;
  s.normal = sign * edge.cross(arm);
  s.square = std::max(s.normal.squaredNorm(), least_area_ratio * length * length * length * length);
  s.foot = arm.dot(edge) / (length * length);
  s.gradient = -length / s.square * s.normal;
  return s;
}

Frame frame(const Hinge& x) {
  Frame f;
  f.edge = x[1] - x[0];
  f.length = std::max(f.edge.norm(), 1e-12);
  f.first = wing(x, f.edge, f.length, 2, 1);
  f.second = wing(x, f.edge, f.length, 3, -1);
  return f;
}

/// Derivatives of a side's gradient and foot by all twelve coordinates.
struct WingDerivative {
  Matrix3x12 gradient = Matrix3x12::Zero();
  Row12 foot = Row12::Zero();
};

WingDerivative differentiate(const Hinge& x, const Frame& f, const Wing& s, double sign) {
  const Vector3 arm = x[static_cast<std::size_t>(s.apex)] - x[0];
  // d normal = sign (d edge x arm + edge x d arm), with d edge = dx1 - dx0 and d arm = dx_apex - dx0.
  const Matrix3 by_edge = -sign * skew(arm), by_arm = sign * skew(f.edge);
  Matrix3x12 normal = Matrix3x12::Zero();
  normal.block<3, 3>(0, 0) = -by_edge - by_arm;
  normal.block<3, 3>(0, 3) = by_edge;
  normal.block<3, 3>(0, 3 * s.apex) += by_arm;
  Row12 length = Row12::Zero();
  length.segment<3>(0) = -f.edge.transpose() / f.length;
  length.segment<3>(3) = f.edge.transpose() / f.length;
  WingDerivative d;
  const Matrix3 reflect = Matrix3::Identity() - 2 / s.square * s.normal * s.normal.transpose();
  d.gradient = -f.length / s.square * reflect * normal - s.normal / s.square * length;
  const double square = f.length * f.length;
  d.foot.segment<3>(0) = (-f.edge - arm).transpose() / square + 2 * s.foot / square * f.edge.transpose();
  d.foot.segment<3>(3) = arm.transpose() / square - 2 * s.foot / square * f.edge.transpose();
  d.foot.segment<3>(3 * s.apex) += f.edge.transpose() / square;
  return d;
}

}  // namespace

double dihedral(const Hinge& x) {
  const Frame f = frame(x);
  return std::atan2(f.first.normal.cross(f.second.normal).dot(f.edge) / f.length, f.first.normal.dot(f.second.normal));
}

Vector12 dihedral_gradient(const Hinge& x) {
  const Frame f = frame(x);
  Vector12 g;
  g.segment<3>(0) = -(1 - f.first.foot) * f.first.gradient - (1 - f.second.foot) * f.second.gradient;
  g.segment<3>(3) = -f.first.foot * f.first.gradient - f.second.foot * f.second.gradient;
  g.segment<3>(6) = f.first.gradient;
  g.segment<3>(9) = f.second.gradient;
  return g;
}

Matrix12 dihedral_hessian(const Hinge& x) {
  const Frame f = frame(x);
  const WingDerivative first = differentiate(x, f, f.first, 1), second = differentiate(x, f, f.second, -1);
  Matrix12 h;
  h.middleRows<3>(0) = -(1 - f.first.foot) * first.gradient + f.first.gradient * first.foot -
                       (1 - f.second.foot) * second.gradient + f.second.gradient * second.foot;
  h.middleRows<3>(3) = -f.first.foot * first.gradient - f.first.gradient * first.foot -
                       f.second.foot * second.gradient - f.second.gradient * second.foot;
  h.middleRows<3>(6) = first.gradient;
  h.middleRows<3>(9) = second.gradient;
  return 0.5 * (h + h.transpose());
}

}  // namespace toile
