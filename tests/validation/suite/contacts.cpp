// Cloth on bodies: a stretched tube, a strip over a post, a sheet on a slope.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "runtime/contact/body_contact.hpp"
#include "runtime/contact/self_contact.hpp"
#include "runtime/laboratory/rig.hpp"
#include "tests/validation/suite/figures.hpp"
#include "tests/validation/suite/meshes.hpp"

namespace toile::validation {
namespace {

using std::numbers::pi;

constexpr double half_thickness = 0.00025;
constexpr double gravity = 9.80665;

FabricLaw light_cloth(double membrane) {
  return bending_cloth({1e-8, 1e-8}, 5e-9, 0.1, membrane);
}

std::shared_ptr<const Body> body_of(
    std::variant<FormSpec, SphereSpec, CylinderSpec, DiscSpec, BoxSpec, PlaneSpec, MeshSpec> shape) {
  BodySpec spec;
  spec.shape = std::move(shape);
  std::string error;
  return Body::make(spec, &error);
}

/// A tube of which the girth at rest is smaller than the cylinder's by `strain`, without friction or weight.
void add_tube(Mesh mesh, double strain, Chapter& chapter) {
  constexpr double radius = 0.1, height = 0.05, membrane = 1000;
  const auto body = body_of(CylinderSpec{radius, 1, 0.5, true});
  const double middle = radius + half_thickness, rest = middle / (1 + strain);
  const Specimen specimen =
      tube(2 * pi * rest, height, {120, 10, mesh == Mesh::Irregular ? 0.25 : 0, mesh == Mesh::Irregular});
  Rig rig(specimen, light_cloth(membrane), [](Vec2 p) { return std::array<bool, 3>{false, near_to(p.x, 0), true}; });
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    const double turn = specimen.points[v].x / rest;
    rig.put(static_cast<int>(v), {middle * std::cos(turn), middle * std::sin(turn), 0.5 + specimen.points[v].y});
  }
  BodyContact contact(specimen.cloth, *body, half_thickness, 0);
  rig.also(contact);
  rig.solve(membrane * strain * rig.mean_edge(), 1e-8, 200);
  double reported = 0;
  const std::vector<double> pressures = contact.pressures(rig.q);
  for (std::size_t v = 0; v < pressures.size(); ++v) {
    reported += pressures[v] * specimen.cloth.area_of_vertex[v] / specimen.cloth.area;
  }
  double around = 0, away = 0;
  for (const MembraneStrain& each : rig.elastic.strains(rig.q)) {
    around += each.warp / static_cast<double>(specimen.cloth.triangles.size());
  }
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    const Vector3 at = rig.at(static_cast<int>(v));
    away += std::hypot(at.x(), at.y()) / static_cast<double>(specimen.points.size());
  }
  const std::string subject = fmt::format("tube stretched by {:g} %, {}", 100 * strain, name(mesh));
  chapter.figures.push_back(near(subject, "pressure k d [Pa]", membrane * around / away, reported, 0.005));
}

/// A strip over a lying cylinder by half a turn: held at one end, loaded at the other, drawn until it slides.
void add_capstan(double friction, Chapter& chapter) {
  constexpr double radius = 0.05, width = 0.02, hang = 0.05, weight = 0.2;  // [N] at the loose end
  const auto body = body_of(CylinderSpec{radius, 1, 0.5, false});
  const double middle = radius + half_thickness, length = pi * middle + 2 * hang;
  const Specimen specimen = sheet(Mesh::OneWay, length, width, 0.002);
  const auto is_held = [](Vec2 p) { return near_to(p.x, 0); };
  Rig rig(specimen, light_cloth(2e4), [&](Vec2 p) { return std::array<bool, 3>{true, is_held(p), is_held(p)}; });
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    const Vec2 p = specimen.points[v];
    const double turn = (p.x - hang) / middle;
    const Vector3 over{p.y, -middle * std::cos(turn), 0.5 + middle * std::sin(turn)};
    const Vector3 before{p.y, -middle, 0.5 + p.x - hang}, after{p.y, middle, 0.5 - (p.x - hang - pi * middle)};
    rig.put(static_cast<int>(v), turn < 0 ? before : turn > pi ? after : over);
  }
  std::vector<int> loose;
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    if (near_to(specimen.points[v].x, length)) loose.push_back(static_cast<int>(v));
  }
  for (const int v : loose) {
    const bool corner = near_to(specimen.points[static_cast<std::size_t>(v)].y, 0) ||
                        near_to(specimen.points[static_cast<std::size_t>(v)].y, width);
    rig.load.forces[3 * v + 2] = -weight / static_cast<double>(loose.size() - 1) * (corner ? 0.5 : 1);
  }
  BodyContact contact(specimen.cloth, *body, half_thickness, friction);
  rig.also(contact);
  double ratio = 1;
  for (int step = 0; step <= 30; ++step) {
    for (std::size_t v = 0; v < specimen.points.size(); ++v) {
      if (is_held(specimen.points[v])) rig.q[static_cast<Eigen::Index>(3 * v + 2)] -= step == 0 ? 0 : 0.0003;
    }
    rig.solve(weight / 10, 1e-5, 300);
    const Vector forces = rig.forces();
    double pull = 0;
    for (std::size_t v = 0; v < specimen.points.size(); ++v) {
      if (is_held(specimen.points[v])) pull -= forces[static_cast<Eigen::Index>(3 * v + 2)];
    }
    ratio = pull / weight;
  }
  chapter.figures.push_back(near(fmt::format("strip over a post by half a turn, μ = {}", friction),
                                 "ratio of the pulls", std::exp(friction * pi), ratio, 0.01));
}

/// Two sheets in one cloth, side by side: the left one is held and lies flat, the right one is laid upon it.
constexpr double plate_side = 0.16, sheet_side = 0.1, beside = 0.2;
Specimen plate_and_sheet() {
  const Specimen plate = sheet(Mesh::Irregular, plate_side, plate_side, 0.02);
  const Specimen upper = sheet(Mesh::Irregular, sheet_side, sheet_side, 0.013);
  std::vector<Vec2> points = plate.points;
  for (const Vec2 p : upper.points) points.push_back({p.x + beside, p.y});
  std::vector<std::array<int, 3>> triangles;
  for (const ClothTriangle& triangle : plate.cloth.triangles) triangles.push_back(triangle.vertices);
  const auto shift = static_cast<int>(plate.points.size());
  for (const ClothTriangle& triangle : upper.cloth.triangles) {
    const auto& v = triangle.vertices;
    triangles.push_back({v[0] + shift, v[1] + shift, v[2] + shift});
  }
  return {flat_cloth(points, triangles), points};
}

/// What lies level while gravity leans, by a tenth of a degree more each time, until it slides: the angle at which it
/// still holds. `watched` is a vertex of it.
double steepest_hold(Rig& rig, const Cloth& cloth, double weight, double limit, int watched) {
  double holds = 0;
  for (double angle = limit - 2; angle < limit + 2; angle += 0.1) {
    for (int v = 0; v < cloth.vertex_count; ++v) {
      rig.load.forces.segment<3>(3 * v) = weight * gravity * cloth.area_of_vertex[static_cast<std::size_t>(v)] *
                                          Vector3(std::sin(angle * degree), 0, -std::cos(angle * degree));
    }
    const Vector3 before = rig.at(watched);
    const bool rests = rig.solve(weight * gravity * cloth.area / cloth.vertex_count, 1e-4, 100);
    if (!rests || (rig.at(watched) - before).norm() > 0.002) break;
    holds = angle;
  }
  return holds;
}

void add_incline(double friction, Chapter& chapter) {
  const auto body = body_of(PlaneSpec{0});
  const Specimen specimen = sheet(Mesh::Irregular, 0.1, 0.1, 0.01);
  const FabricLaw law = bending_cloth({1e-5, 1e-5}, 5e-6, 0.2, 1000);
  const double limit = std::atan(friction) / degree;
  Rig rig(specimen, law, [](Vec2) { return std::array<bool, 3>{}; });
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    rig.q[static_cast<Eigen::Index>(3 * v + 2)] = half_thickness;
  }
  BodyContact contact(specimen.cloth, *body, half_thickness, friction);
  rig.also(contact);
  chapter.figures.push_back(within(fmt::format("sheet on a slope, μ = {}", friction), "angle at which it slides [°]",
                                   limit, steepest_hold(rig, specimen.cloth, law.weight, limit, 0), 0.5));
}

void add_incline_of_cloth(double friction, Chapter& chapter) {
  constexpr double gap = 2 * half_thickness, pressure = 5000;
  const Specimen specimen = plate_and_sheet();
  const FabricLaw law = bending_cloth({1e-5, 1e-5}, 5e-6, 0.2, 1000);
  const double limit = std::atan(friction) / degree;
  const auto is_plate = [](Vec2 p) { return p.x < beside; };
  Rig rig(specimen, law, [&](Vec2 p) { return std::array<bool, 3>{is_plate(p), is_plate(p), is_plate(p)}; });
  int watched = 0;
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    const Vec2 p = specimen.points[v];
    if (is_plate(p)) continue;
    watched = static_cast<int>(v);
    // Off the middle, so that the meshes do not match.
    rig.put(watched, {p.x - beside + 0.027, p.y + 0.031, 0.97 * gap});
  }
  SelfContact layers(specimen.cloth, gap, pressure);
  layers.set_friction({friction});
  rig.also(layers);
  chapter.figures.push_back(within(fmt::format("sheet on a sheet of cloth on a slope, μ = {}", friction),
                                   "angle at which it slides [°]", limit,
                                   steepest_hold(rig, specimen.cloth, law.weight, limit, watched), 0.5));
}

}  // namespace

Chapter contact(Effort effort) {
  Chapter chapter{"Contact and friction",
                  "A stretched tube presses with its tension over the radius; over a post the pulls are as e^(μβ); a "
                  "sheet slides where the slope is μ, on a body and on cloth.",
                  {},
                  {},
                  {}};
  for (const double strain : {0.002, 0.02}) {
    add_tube(Mesh::OneWay, strain, chapter);
    if (effort == Effort::Full) add_tube(Mesh::Irregular, strain, chapter);
  }
  for (const double friction : {0.2, 0.5}) {
    add_capstan(friction, chapter);
    add_incline(friction, chapter);
    add_incline_of_cloth(friction, chapter);
  }
  return chapter;
}

}  // namespace toile::validation
