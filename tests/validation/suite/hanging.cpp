// What hangs: a catenary, and rectangles as the paper's standard experiment has them.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "runtime/drape/drape.hpp"
#include "runtime/laboratory/rig.hpp"
#include "tests/validation/suite/figures.hpp"
#include "tests/validation/suite/meshes.hpp"

namespace toile::validation {
namespace {

constexpr double chain_length = 0.5, chain_span = 0.35;

/// Sag of an inextensible chain of that length over that span.
double catenary_sag() {
  double low = 1e-3, high = 100;  // a in 2 a sinh(span / 2 a) = length
  for (int i = 0; i < 200; ++i) {
    const double a = std::sqrt(low * high);
    (2 * a * std::sinh(chain_span / (2 * a)) > chain_length ? low : high) = a;
  }
  return low * (std::cosh(chain_span / (2 * low)) - 1);
}

double sag_of_strip(int divisions) {
  const Specimen specimen = rectangle(chain_length, 0.02, {divisions, 2, 0});
  const FabricLaw law = bending_cloth({1e-10, 1e-10}, 5e-11, 0.2, 1e5);
  Rig rig(specimen, law, [](Vec2 p) {
    const bool end = near_to(p.x, 0) || near_to(p.x, chain_length);
    return std::array<bool, 3>{end, end, end};
  });
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    const Vec2 p = specimen.points[v];
    const double t = p.x / chain_length;
    rig.put(static_cast<int>(v), {chain_span * t, p.y, -4 * 0.15 * t * (1 - t)});
  }
  rig.weigh();
  rig.solve(law.weight * 9.80665 * specimen.cloth.area / specimen.cloth.vertex_count, 1e-6, 1000);
  double lowest = 0;
  for (std::size_t v = 0; v < specimen.points.size(); ++v) lowest = std::min(lowest, rig.at(static_cast<int>(v)).z());
  return -lowest;
}

FabricSheet wool() {
  FabricSheet sheet;
  sheet.emt = WarpWeft{0.04, 0.06};
  sheet.lt = WarpWeft{0.6, 0.6};
  sheet.g = WarpWeft{33.7, 33.7};
  sheet.hg = WarpWeft{0.686, 0.686};
  sheet.hg5 = WarpWeft{1.471, 1.471};
  sheet.b = WarpWeft{6.9e-6, 5.9e-6};
  sheet.hb = WarpWeft{2.45e-4, 2.16e-4};
  sheet.weight = 0.192;
  return sheet;
}

/// What does not change when the cloth turns about the vertical.
struct Hung {
  double drop = 0;    // [m] from the highest to the lowest
  double spread = 0;  // [m] mean distance from the vertical axis through its middle
};

Hung measured(const Cloth& cloth, const std::vector<Vec3>& positions) {
  double high = -1, low = 1;
  Vec3 middle;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    middle += cloth.area_of_vertex[v] / cloth.area * positions[v];
    high = std::max(high, positions[v].z);
    low = std::min(low, positions[v].z);
  }
  Hung hung{high - low, 0};
  for (std::size_t v = 0; v < positions.size(); ++v) {
    hung.spread +=
        cloth.area_of_vertex[v] / cloth.area * std::hypot(positions[v].x - middle.x, positions[v].y - middle.y);
  }
  return hung;
}

struct Way {
  const char* name;
  std::function<bool(Vec2)> held;
  double lean;  // [rad] that the specimen is turned by in its plane
};

/// From a start that is a little off the plane.
Hung hung(const Way& way, double edge) {
  const Specimen specimen = sheet(Mesh::Pieces, 0.3, 0.2, edge);
  Placed start;
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    const Vec2 p = specimen.points[v];
    start.positions.push_back({p.x * std::cos(way.lean) + p.y * std::sin(way.lean),
                               0.002 * std::sin(20 * p.x + 9 * p.y),
                               -p.x * std::sin(way.lean) + p.y * std::cos(way.lean)});
    if (way.held(p)) start.held.push_back(static_cast<int>(v));
  }
  return measured(specimen.cloth, drape(specimen.cloth, wool(), nullptr, start, {.accuracy = 1e-4}, {}).positions);
}

/// The longer side across a round bar of 2 cm.
Hung over_bar(double edge) {
  const Specimen specimen = sheet(Mesh::Pieces, 0.2, 0.3, edge);
  BodySpec spec;
  spec.shape = CylinderSpec{0.01, 1, 0, false};
  std::string error;
  const auto bar = Body::make(spec, &error);
  Placed start;
  for (const Vec2 p : specimen.points) start.positions.push_back({p.x - 0.1, p.y - 0.15, 0.011});
  return measured(specimen.cloth, drape(specimen.cloth, wool(), bar.get(), start, {.accuracy = 1e-4}, {}).positions);
}

}  // namespace

Chapter catenary(Effort effort) {
  Chapter chapter{
      "Catenary", "A strip hung by both ends, hardly bending, hardly stretching: the sag of the chain.", {}, {}, {}};
  const double exact = catenary_sag();
  const double coarse = sag_of_strip(20), middle = sag_of_strip(40), fine = sag_of_strip(80);
  chapter.figures.push_back(near("n = 80", "sag / length", exact / chain_length, fine / chain_length, 0.001));
  const double order = std::log2((coarse - exact) / (middle - exact));
  chapter.figures.push_back(within("n = 20 to 40", "order", 2, order, 0.3));
  if (effort == Effort::Full) {
    const double finer = std::log2((middle - exact) / (fine - exact));
    chapter.figures.push_back(within("n = 40 to 80", "order", 2, finer, 0.3));
  }
  return chapter;
}

Chapter hung_specimens(Effort effort) {
  Chapter chapter{
      "Hung specimens",
      "Rectangles of 30 by 20 cm of a wool serge, against a mesh of half the edge; held to 1 % of the longer "
      "side, 3 mm.",
      {},
      {},
      {}};
  const std::vector<Way> ways{
      {"by its upper edge", [](Vec2 p) { return near_to(p.y, 0.2); }, 0},
      {"by a corner", [](Vec2 p) { return near_to(p.x, 0) && near_to(p.y, 0.2); }, std::atan2(0.3, 0.2)},
      {"by two corners", [](Vec2 p) { return near_to(p.y, 0.2) && (near_to(p.x, 0) || near_to(p.x, 0.3)); }, 0}};
  const double coarse = effort == Effort::Full ? 0.008 : 0.02;
  const auto add = [&](const char* name, const Hung& reference, const Hung& found) {
    const std::string subject = fmt::format("{}, edge {:g} mm against {:g} mm", name, 1000 * coarse, 500 * coarse);
    chapter.figures.push_back(within(subject, "drop [mm]", 1000 * reference.drop, 1000 * found.drop, 3));
    chapter.figures.push_back(within(subject, "spread [mm]", 1000 * reference.spread, 1000 * found.spread, 3));
  };
  for (const Way& way : ways) {
    if (effort == Effort::Full || way.lean == 0) add(way.name, hung(way, coarse / 2), hung(way, coarse));
  }
  if (effort == Effort::Full) add("over a bar", over_bar(coarse / 2), over_bar(coarse));
  return chapter;
}

}  // namespace toile::validation
