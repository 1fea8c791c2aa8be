#include "runtime/laboratory/kes.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "runtime/laboratory/rig.hpp"

namespace toile {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double tensile_force = 490.3325;  // [N/m], 500 gf/cm
constexpr double shear_tension = 9.80665;   // [N/m], 10 gf/cm
constexpr double largest_shear = 8 * degree;
constexpr double largest_curvature = 250;  // [1/m]
constexpr double right_angle = std::numbers::pi / 2;

/// Tensile and shear specimens: 20 cm along the jaws, 5 cm between them.
constexpr double jaw_length = 0.2, jaw_distance = 0.05;
constexpr double bending_gauge = 0.01, bending_width = 0.01;

/// The jaws' rows are held, and since the cloth is under tension all heights. The sides go as the cloth beyond them
/// would: a free side carries no shear, and the threads beside it go slack where it is drawn down, which lowers what is
/// read by up to 1 %.
HeldCoordinates held_flat_between_jaws() {
  return [](Vec2 p) {
    const bool at_rim = p.y == 0 || p.y == jaw_distance || p.x == 0 || p.x == jaw_length;
    return std::array<bool, 3>{at_rim, at_rim, true};
  };
}

/// A sheet whose threads along y are drawn out, or leaned over, by its upper jaw.
class Strip {
 public:
  Strip(const FabricLaw& law, bool weft)
      : specimen_(toile::rectangle(jaw_length, jaw_distance, {24, 6, 0.2}, weft ? 0 : right_angle)),
        rig_(specimen_, law, held_flat_between_jaws(), Loops::Remembered) {}

  /// The upper jaw goes there, and the cloth after it.
  bool pull(Vec2 upper) {
    const Vec2 step = upper - upper_;
    upper_ = upper;
    for (std::size_t v = 0; v < specimen_.points.size(); ++v) {
      const double share = specimen_.points[v].y / jaw_distance;
      rig_.put(static_cast<int>(v), rig_.at(static_cast<int>(v)) + share * Vector3(step.x, step.y, 0));
    }
    return rig_.solve(tensile_force * rig_.mean_edge(), 1e-9);
  }

  /// The upper jaw's force on the cloth per width, but at its corners.
  Vec2 force() {
    const Vector forces = rig_.forces();
    Vec2 sum;
    int count = 0;
    for (std::size_t v = 0; v < specimen_.points.size(); ++v) {
      const Vec2 p = specimen_.points[v];
      if (p.y != jaw_distance || p.x == 0 || p.x == jaw_length) continue;
      const auto at = static_cast<Eigen::Index>(3 * v);
      sum = sum + Vec2{forces[at], forces[at + 1]};
      ++count;
    }
    return sum / (count * jaw_length / columns);
  }

  double distance_between_jaws() const { return upper_.y; }

 private:
  static constexpr int columns = 24;
  Specimen specimen_;
  Rig rig_;
  Vec2 upper_{0, jaw_distance};
};

/// The distance of the jaws at which the threads carry that force, from a distance at which they carry less: doubling,
/// then the secant within the bracket.
std::optional<double> stretched_to(Strip& strip, double force) {
  double low = strip.distance_between_jaws(), low_force = strip.force().y;
  double high = low, high_force = low_force;
  for (double strain = 1e-4; high_force < force; strain *= 2) {
    if (strain > 10) return std::nullopt;
    low = high;
    low_force = high_force;
    high = jaw_distance * (1 + strain);
    if (!strip.pull({0, high})) return std::nullopt;
    high_force = strip.force().y;
  }
  for (int i = 0; i < 60 && std::abs(high_force - low_force) > 1e-9 * force; ++i) {
    double middle = low + (force - low_force) / (high_force - low_force) * (high - low);
    if (i % 3 == 2) middle = 0.5 * (low + high);
    if (!strip.pull({0, middle})) return std::nullopt;
    const double found = strip.force().y;
    if (std::abs(found - force) < 1e-9 * force) return middle;
    (found < force ? low : high) = middle;
    (found < force ? low_force : high_force) = found;
  }
  return high;
}

struct Tensile {
  KesCurve curve;
  double emt = 0, lt = 0, wt = 0;
};

std::optional<Tensile> tensile_test(const FabricLaw& law, bool weft) {
  Tensile test;
  double distance = 0;
  {
    Strip strip(law, weft);
    const std::optional<double> found = stretched_to(strip, tensile_force);
    if (!found) return std::nullopt;
    distance = *found;
  }
  Strip strip(law, weft);
  constexpr int steps = 100;
  test.emt = distance / jaw_distance - 1;
  for (int i = 0; i <= steps; ++i) {
    const double strain = test.emt * i / steps;
    if (!strip.pull({0, jaw_distance * (1 + strain)})) return std::nullopt;
    test.curve.push_back({strain, strip.force().y});
    const double weight = (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / 3;  // Simpson
    test.wt += weight * test.curve.back().y * test.emt / steps;
  }
  test.lt = test.wt / (tensile_force * test.emt / 2);
  return test;
}

/// There and back and there again: 0 … largest … -largest … largest.
std::vector<double> cycle(double largest, int steps) {
  std::vector<double> values;
  for (int i = 0; i <= steps; ++i) values.push_back(largest * i / steps);
  for (int i = steps - 1; i >= -steps; --i) values.push_back(largest * i / steps);
  for (int i = 1 - steps; i <= steps; ++i) values.push_back(largest * i / steps);
  return values;
}

/// What a curve over a cycle has at that deformation, going down and then up.
struct Loop {
  const KesCurve& curve;
  int steps;

  double down(double x) const { return at(x, steps, 3 * steps); }
  double up(double x) const { return at(x, 3 * steps, 5 * steps); }
  double width(double x) const { return 0.5 * (up(x) - down(x) + up(-x) - down(-x)); }
  /// Mean slope between two deformations where the load grows, either way.
  double slope(double from, double to) const {
    return (up(to) - up(from) + down(-from) - down(-to)) / (2 * (to - from));
  }

 private:
  double at(double x, int begin, int end) const {
    for (int i = begin; i < end; ++i) {
      const Vec2 a = curve[static_cast<std::size_t>(i)], b = curve[static_cast<std::size_t>(i) + 1];
      if ((x - a.x) * (x - b.x) <= 0 && a.x != b.x) return a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y);
    }
    return 0;
  }
};

constexpr int shear_steps = 32;    // a quarter of a degree each
constexpr int bending_steps = 25;  // a tenth of 1/cm each

/// The threads between the jaws keep the length at which they carry 10 gf/cm, so the upper jaw goes on a circle; the
/// force across them, times their length, is what works against the angle.
std::optional<KesCurve> shear_test(const FabricLaw& law, bool weft, const Job& job) {
  Strip strip(law, weft);
  const std::optional<double> length = stretched_to(strip, shear_tension);
  if (!length || !strip.pull({0, *length})) return std::nullopt;
  KesCurve curve;
  for (const double angle : cycle(largest_shear, shear_steps)) {
    const Vec2 along{std::sin(angle), std::cos(angle)};
    if (job.is_cancelled() || !strip.pull(*length * along)) return std::nullopt;
    curve.push_back({angle, cross(strip.force(), along) * *length / jaw_distance});
  }
  return curve;
}

std::optional<KesCurve> bending_test(const FabricLaw& law, bool weft, const Job& job) {
  const Specimen specimen = toile::rectangle(bending_gauge, bending_width, {20, 10, 0.2}, weft ? right_angle : 0);
  Rig rig(
      specimen, law,
      [](Vec2 p) {
        return std::array<bool, 3>{p.x == 0, p.x == 0, p.x == 0};
      },
      Loops::Remembered);
  rig.clamp([](Vec2 p) { return p.x == 0; }, {-1, 0, 0});
  const std::vector<int> far = rig.clamp([](Vec2 p) { return p.x == bending_gauge; }, {1, 0, 0});
  const double typical = std::max(law.bend_warp.rigidity, law.bend_weft.rigidity) * largest_curvature;
  KesCurve curve;
  for (const double curvature : cycle(largest_curvature, bending_steps)) {
    const double turn = curvature * bending_gauge;
    for (const int hold : far) rig.jaws.turn(hold, {std::cos(turn), 0, -std::sin(turn)});
    for (std::size_t v = 0; v < specimen.points.size(); ++v) {
      const Vec2 p = specimen.points[v];
      const double half = p.x * curvature / 2;
      const double chord = p.x * (half == 0 ? 1 : std::sin(half) / half);
      rig.put(static_cast<int>(v), {chord * std::cos(half), p.y, -chord * std::sin(half)});
    }
    if (job.is_cancelled() || !rig.solve(typical, 1e-7)) return std::nullopt;
    double moment = 0;
    for (const int hold : far) moment += rig.jaws.moment(hold, rig.q);
    curve.push_back({curvature, moment / bending_width});
  }
  return curve;
}

}  // namespace

KesReading kes_reading(const FabricSheet& fabric, const Job& job) {
  const FabricLaw law = make_law(fabric);
  KesReading reading;
  std::array<double, 2> emt{}, lt{}, wt{}, g{}, hg{}, hg5{}, b{}, hb{};
  for (const std::size_t thread : {std::size_t{0}, std::size_t{1}}) {
    const bool weft = thread == 1;
    const std::string name = weft ? "weft" : "warp";
    if (job.report) job.report({"testing the " + name, 0.5 * static_cast<double>(thread), 0, 0});
    if (const auto test = tensile_test(law, weft)) {
      reading.tensile[thread] = test->curve;
      emt[thread] = test->emt;
      lt[thread] = test->lt;
      wt[thread] = test->wt;
    } else {
      reading.trouble = "the tensile test of the " + name;
    }
    if (auto curve = shear_test(law, weft, job)) {
      const Loop loop{reading.shear[thread] = *std::move(curve), shear_steps};
      g[thread] = loop.slope(0.5 * degree, 2.5 * degree);
      hg[thread] = loop.width(0.5 * degree);
      hg5[thread] = loop.width(5 * degree);
    } else {
      reading.trouble = "the shear test of the " + name;
    }
    if (auto curve = bending_test(law, weft, job)) {
      const Loop loop{reading.bending[thread] = *std::move(curve), bending_steps};
      b[thread] = loop.slope(50, 150);
      hb[thread] = loop.width(100);
    } else {
      reading.trouble = "the bending test of the " + name;
    }
  }
  const auto both = [](const std::array<double, 2>& row) { return WarpWeft{row[0], row[1]}; };
  reading.sheet.emt = both(emt);
  reading.sheet.lt = both(lt);
  reading.sheet.wt = both(wt);
  reading.sheet.g = both(g);
  reading.sheet.hg = both(hg);
  reading.sheet.hg5 = both(hg5);
  reading.sheet.b = both(b);
  reading.sheet.hb = both(hb);
  return reading;
}

}  // namespace toile
