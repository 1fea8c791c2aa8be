// Random curves for properties.
#pragma once

#include <rapidcheck.h>

#include "compiler/curve/curve.hpp"

namespace toile::test {

/// A place within two metres, on whole millimetres.
inline rc::Gen<Vec2> any_place() {
  const auto coordinate = [] {
    return rc::gen::map(rc::gen::inRange(-1000, 1001), [](int mm) { return mm / 1000.0; });
  };
  return rc::gen::construct<Vec2>(coordinate(), coordinate());
}

/// Loops, cusps and folds included.
inline rc::Gen<Curve> any_bezier() {
  return rc::gen::apply([](Vec2 a, Vec2 b, Vec2 c, Vec2 d) { return bezier(a, b, c, d); }, any_place(), any_place(),
                        any_place(), any_place());
}

/// As one is drawn: the control points at thirds of the chord, give or take a fifth of a metre.
inline rc::Gen<Curve> any_drawn_bezier() {
  return rc::gen::apply([](Vec2 a, Vec2 b, Vec2 c,
                           Vec2 d) { return bezier(a, a + (d - a) / 3 + 0.2 * b, a + 2 * (d - a) / 3 + 0.2 * c, d); },
                        any_place(), any_place(), any_place(), any_place());
}

/// An arc, a Bézier and a line, one behind the other.
inline rc::Gen<Curve> any_curve() {
  return rc::gen::apply(
      [](Vec2 a, Vec2 b, Vec2 c, Vec2 d, Vec2 e, int percent) {
        const double radius = (0.51 + percent / 50.0) * distance(a, b) + 0.01;
        return join({arc_of_radius(a, b, radius, percent % 2 == 0), bezier(b, c, d, e), line(e, a + Vec2{0.001, 0})});
      },
      any_place(), any_place(), any_place(), any_place(), any_place(), rc::gen::inRange(0, 100));
}

}  // namespace toile::test
