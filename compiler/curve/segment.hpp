// One segment of a curve, parametrised by its own t in [0, 1]. Arc length belongs to Curve; here is what it rests on.
#pragma once

#include "compiler/curve/curve.hpp"

namespace toile {

Vec2 point(const Segment& segment, double t);
/// d(point)/dt [m].
Vec2 derivative(const Segment& segment, double t);
/// The unit tangent; where the derivative vanishes (control points that coincide, a cusp), its limit from inside.
Vec2 unit_tangent(const Segment& segment, double t);
/// 1 / radius [1/m], positive where the segment turns to the left; infinite at a cusp.
double curvature(const Segment& segment, double t);
/// Arc length from t0 to t1 >= t0 [m].
double length_between(const Segment& segment, double t0, double t1);
/// The t at which the arc length from t = 0 comes to `s`, given the segment's whole `length`.
double parameter_at(const Segment& segment, double s, double length);

Segment part(const Segment& segment, double t0, double t1);
Segment reversed(const Segment& segment);
Segment mirrored(const Segment& segment, Vec2 point, Vec2 axis);
Segment moved(const Segment& segment, Vec2 shift);
Segment rotated(const Segment& segment, double angle, Vec2 about);

/// How far a segment strays at most from its own chord [m]. An upper bound, sharp for arcs up to a half circle.
double stray(const Segment& segment);

/// The t in (0, 1), ascending, that cut a segment into parts which turn by less than a right angle in x and y: no part
/// can cross itself.
std::vector<double> monotone_cuts(const Segment& segment);

/// Distance from a point to a straight line segment [m].
double distance_to_segment(Vec2 point, Vec2 from, Vec2 to);

/// Arc length of a cubic by adaptive Gauss-Legendre quadrature.
double bezier_length(const BezierSegment& bezier, double t0, double t1);

}  // namespace toile
