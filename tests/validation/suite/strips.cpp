// Strips that bend: the heavy elastica, end loads and moments, and where strips buckle.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "runtime/laboratory/rig.hpp"
#include "tests/validation/suite/figures.hpp"
#include "tests/validation/suite/meshes.hpp"

namespace toile::validation {
namespace {

constexpr double strip_length = 0.1;
constexpr double bending_rigidity = 1e-5;  // [N m]
constexpr double standard = 9.80665;       // [m/s2]

/// A strip along x, clamped at its left end.
struct Clamped {
  Specimen specimen;
  Rig rig;

  Clamped(Specimen of, const FabricLaw& law, bool in_its_plane = false)
      : specimen(std::move(of)), rig(specimen, law, [in_its_plane](Vec2 p) {
          const bool held = near_to(p.x, 0);
          return std::array<bool, 3>{held, held || in_its_plane, held};
        }) {
    rig.clamp([](Vec2 p) { return near_to(p.x, 0); }, {-1, 0, 0});
  }

  double force_of_a_vertex(double weight) const {
    return weight * standard * specimen.cloth.area / specimen.cloth.vertex_count;
  }
  std::vector<int> end() const {
    std::vector<int> vertices;
    for (std::size_t v = 0; v < specimen.points.size(); ++v) {
      if (near_to(specimen.points[v].x, strip_length)) vertices.push_back(static_cast<int>(v));
    }
    return vertices;
  }
  Vector3 tip() const {
    Vector3 sum = Vector3::Zero();
    const std::vector<int> vertices = end();
    for (const int v : vertices) sum += rig.at(v);
    return sum / static_cast<double>(vertices.size());
  }
};

/// [kg/m2] for gamma = w L^3 / B.
double weight_of(double gamma, double rigidity) {
  return gamma * rigidity / (strip_length * strip_length * strip_length) / standard;
}

struct Elastica {
  double gamma, x, y;
};
constexpr std::array<Elastica, 4> tips{
    {{1, 0.991246, 0.123471}, {5, 0.846657, 0.495905}, {20, 0.445232, 0.829881}, {100, 0.159223, 0.937524}}};

struct ElasticaCase {
  Mesh mesh;
  double grain;  // [rad]
  WarpWeft rigidity;
  std::string cloth;
};

/// The form of a strip of which one end droops.
Clamped& droop(Clamped& strip, double weight) {
  for (const double share : {0.1, 0.3, 1.0}) {
    strip.rig.weigh(share);
    strip.rig.solve(strip.force_of_a_vertex(weight), share < 1 ? 1e-3 : 1e-7, 500);
  }
  return strip;
}

void add_elastica(const ElasticaCase& of, const Elastica& tip, Chapter& chapter) {
  const double along = near_to(of.grain, 0) ? of.rigidity.warp : of.rigidity.weft;
  const double weight = weight_of(tip.gamma, along);
  const double twist = 0.5 * std::sqrt(of.rigidity.warp * of.rigidity.weft);
  Clamped strip(sheet(of.mesh, strip_length, strip_length / 8, strip_length / 40, of.grain),
                bending_cloth(of.rigidity, twist, weight, 500 * along / bending_rigidity));
  const Vector3 at = droop(strip, weight).tip() / strip_length;
  const std::string subject =
      fmt::format("Γ = {}, {} cloth, grain at {:.0f}°, {}", tip.gamma, of.cloth, of.grain / degree, name(of.mesh));
  chapter.figures.push_back(within(subject, "x / L", tip.x, at.x(), 0.002));
  chapter.figures.push_back(within(subject, "y / L", tip.y, -at.z(), 0.002));
}

PlotPanel elastica_forms() {
  PlotPanel panel{"Heavy elastica", "x / L", "y / L", {}, true};
  for (const Elastica& tip : tips) {
    const double weight = weight_of(tip.gamma, bending_rigidity);
    Clamped strip(sheet(Mesh::OneWay, strip_length, strip_length / 8, strip_length / 40),
                  bending_cloth({bending_rigidity, bending_rigidity}, bending_rigidity / 2, weight, 500));
    droop(strip, weight);
    PlotSeries line{fmt::format("Γ = {}", tip.gamma), {}};
    for (std::size_t v = 0; v < strip.specimen.points.size(); ++v) {
      if (!near_to(strip.specimen.points[v].y, 0)) continue;
      const Vector3 at = strip.rig.at(static_cast<int>(v)) / strip_length;
      line.points.push_back({at.x(), at.z()});
    }
    panel.series.push_back(line);
  }
  PlotSeries closed{"integrated", {}, true};
  for (const Elastica& tip : tips) closed.points.push_back({tip.x, -tip.y});
  panel.series.push_back(closed);
  return panel;
}

/// Load P at the end, P L^2 / EI.
void add_end_loads(Mesh mesh, Chapter& chapter) {
  struct Load {
    double p, w;
  };
  for (const Load& load : {Load{1, 0.301721}, Load{2, 0.493457}, Load{4, 0.669964}, Load{10, 0.810609}}) {
    const double width = strip_length / 8;
    Clamped strip(sheet(mesh, strip_length, width, strip_length / 40),
                  bending_cloth({bending_rigidity, bending_rigidity}, bending_rigidity / 2, 0, 500));
    const double force = load.p * bending_rigidity * width / (strip_length * strip_length);
    // Along the end as its parts of the width are.
    std::vector<int> end = strip.end();
    std::sort(end.begin(), end.end(), [&](int a, int b) {
      return strip.specimen.points[static_cast<std::size_t>(a)].y <
             strip.specimen.points[static_cast<std::size_t>(b)].y;
    });
    for (std::size_t i = 0; i + 1 < end.size(); ++i) {
      const double part = distance(strip.specimen.points[static_cast<std::size_t>(end[i])],
                                   strip.specimen.points[static_cast<std::size_t>(end[i + 1])]) /
                          width;
      for (const int v : {end[i], end[i + 1]}) strip.rig.load.forces[3 * v + 2] -= force * part / 2;
    }
    strip.rig.solve(force / 10, 1e-7, 500);
    chapter.figures.push_back(near(fmt::format("cantilever, P L²/EI = {}, {}", load.p, name(mesh)), "w / L", load.w,
                                   -strip.tip().z() / strip_length, 0.01));
  }
}

/// In its plane: a strip whose end may go anywhere turns out of it from 290 degrees on.
void add_ring(Mesh mesh, Chapter& chapter) {
  const double width = strip_length / 8;
  Clamped strip(sheet(mesh, strip_length, width, strip_length / 40),
                bending_cloth({bending_rigidity, bending_rigidity}, bending_rigidity / 2, 0, 500), true);
  const std::vector<int> far = strip.rig.clamp([](Vec2 p) { return near_to(p.x, strip_length); }, {1, 0, 0});
  constexpr int steps = 24;
  for (int i = 1; i <= steps; ++i) {
    const double turn = 2 * std::numbers::pi * i / steps, curvature = turn / strip_length;
    for (const int hold : far) strip.rig.jaws.turn(hold, {std::cos(turn), 0, -std::sin(turn)});
    for (std::size_t v = 0; v < strip.specimen.points.size(); ++v) {
      const Vec2 p = strip.specimen.points[v];
      strip.rig.put(static_cast<int>(v),
                    {std::sin(p.x * curvature) / curvature, p.y, (std::cos(p.x * curvature) - 1) / curvature});
    }
    strip.rig.solve(bending_rigidity / strip_length, i < steps ? 1e-4 : 1e-7, 500);
  }
  double moment = 0;
  for (const int hold : far) moment += strip.rig.jaws.moment(hold, strip.rig.q);
  chapter.figures.push_back(near(fmt::format("ring of one full turn, {}", name(mesh)), "M L / 2π EI", 1,
                                 moment / width * strip_length / (2 * std::numbers::pi * bending_rigidity), 0.01));
  chapter.figures.push_back(within(fmt::format("ring of one full turn, {}", name(mesh)), "gap / L", 0,
                                   std::hypot(strip.tip().x(), strip.tip().z()) / strip_length, 0.01));
}

/// The greatest gamma at which a strip loaded in its own plane, along `way`, stays in it; within 40 % of `about`.
double critical_gamma(const Specimen& specimen, double twist, const Vector3& way, double about) {
  double low = 0.6 * about, high = 1.4 * about;
  Clamped strip(specimen, bending_cloth({bending_rigidity, bending_rigidity}, twist, 0, 1e4));
  for (int i = 0; i < 10; ++i) {
    const double gamma = 0.5 * (low + high), weight = weight_of(gamma, bending_rigidity);
    for (std::size_t v = 0; v < specimen.points.size(); ++v) {
      strip.rig.load.forces.segment<3>(static_cast<Eigen::Index>(3 * v)) =
          weight * standard * specimen.cloth.area_of_vertex[v] * way;
    }
    strip.rig.solve(strip.force_of_a_vertex(weight), 1e-8, 100);
    (strip.rig.stable() ? low : high) = gamma;
  }
  return 0.5 * (low + high);
}

void add_buckling(Mesh mesh, const std::vector<double>& ratios, Chapter& chapter) {
  const double upright = critical_gamma(sheet(mesh, strip_length, strip_length / 8, strip_length / 40),
                                        bending_rigidity / 2, {-1, 0, 0}, 7.837);
  chapter.figures.push_back(near(fmt::format("strip standing up, {}", name(mesh)), "Γ", 7.837, upright, 0.01));
  for (const double ratio : ratios) {
    // Width to zero: what two widths say together.
    std::array<double, 2> found{};
    const std::array<double, 2> widths{strip_length / 10, strip_length / 20};
    const double reference = 25.71 * std::sqrt(ratio);
    for (std::size_t i = 0; i < 2; ++i) {
      found[i] = critical_gamma(sheet(mesh, strip_length, widths[i], strip_length / 80), ratio * bending_rigidity,
                                {0, -1, 0}, reference);
    }
    const double thin = found[1] + (found[1] - found[0]) * widths[1] / (widths[0] - widths[1]);
    const std::string subject = fmt::format("strip on edge, D66/B = {}, {}", ratio, name(mesh));
    chapter.figures.push_back(near(subject, "Γ, width to zero", reference, thin, 0.02));
  }
}

}  // namespace

Chapter heavy_elastica(Effort effort) {
  Chapter chapter{"Heavy elastica",
                  "A strip clamped level droops under its weight; tips integrated to 1e-10. h = L/40.",
                  {},
                  {},
                  {}};
  const WarpWeft alike{bending_rigidity, bending_rigidity}, unlike{4 * bending_rigidity, bending_rigidity};
  std::vector<ElasticaCase> wanted{{Mesh::Irregular, 0, alike, "isotropic"},
                                   {Mesh::Pieces, 30 * degree, alike, "isotropic"},
                                   {Mesh::Irregular, 90 * degree, unlike, "orthotropic"}};
  if (effort == Effort::Full) {
    wanted.clear();
    for (const Mesh mesh : all_meshes) {
      for (const double grain : {0.0, 15.0, 30.0, 45.0, 75.0}) {
        wanted.push_back({mesh, grain * degree, alike, "isotropic"});
      }
      for (const double grain : {0.0, 90.0}) wanted.push_back({mesh, grain * degree, unlike, "orthotropic"});
    }
    chapter.pictures.push_back(
        {"elastica", "Strips of one cloth, heavier and heavier; dots are the tips as integrated.", {elastica_forms()}});
  }
  for (const ElasticaCase& of : wanted) {
    for (const Elastica& tip : tips) add_elastica(of, tip, chapter);
  }
  return chapter;
}

Chapter strips(Effort effort) {
  Chapter chapter{"Strips: end load, full circle, buckling",
                  "Closed forms of the inextensible rod; protocols after Romero, Ly, Rasheed, Charrondière, Lazarus, "
                  "Neukirch and Bertails-Descoubes, Physical validation of simulators in computer graphics (2021).",
                  {},
                  {},
                  {}};
  for (const Mesh mesh : all_meshes) {
    if (effort == Effort::Quick && mesh != Mesh::Irregular) continue;
    add_end_loads(mesh, chapter);
    add_ring(mesh, chapter);
    add_buckling(mesh, effort == Effort::Full ? std::vector{0.5, 0.25} : std::vector{0.5}, chapter);
  }
  return chapter;
}

}  // namespace toile::validation
