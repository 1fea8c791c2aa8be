// Flattening a bust-like half ellipsoid and patches of a dress form: the development and CGAL's as-rigid-as-possible
// parameterisation (Liu et al. 2008) on the same meshes, and of hemispheres with darts its other parameterisations,
// too; energy_J is that of the real cloth, of CGAL's plane at the best turn. One thread each: ./dev bench, or
// bench_develop --benchmark_counters_tabular=true.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/iterator.h>
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "compiler/evaluate/program.hpp"
#include "compiler/pattern/draft.hpp"
#include "runtime/develop/chart.hpp"
#include "runtime/develop/flatten.hpp"
#include "runtime/develop/flattening.hpp"
#include "runtime/driver/world.hpp"
#include "tests/support/hemisphere.hpp"

namespace toile {
namespace {

using std::numbers::pi;

/// cotton_shirting of the standard library.
FabricLaw cotton() {
  FabricSheet sheet;
  sheet.lt = WarpWeft{0.80, 0.72};
  sheet.emt = WarpWeft{0.03, 0.06};
  sheet.g = WarpWeft{0.9 * 56.188, 0.9 * 56.188};
  sheet.hg = WarpWeft{1.8 * 0.980665, 1.8 * 0.980665};
  sheet.hg5 = WarpWeft{3.5 * 0.980665, 3.5 * 0.980665};
  return make_law(sheet);
}

/// A disc of six n^2 triangles in rings, in (warp, weft) about the origin with radius 1, warp running down.
struct Disc {
  std::vector<Vec2> points{{0, 0}};
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> outline;
};

Disc disc(int n) {
  Disc disc;
  const auto first = [](int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); };
  const auto at = [&](int ring, int i) { return ring == 0 ? 0 : first(ring) + i % (6 * ring); };
  for (int ring = 1; ring <= n; ++ring) {
    for (int i = 0; i < 6 * ring; ++i) {
      disc.points.push_back(static_cast<double>(ring) / n * direction(2 * pi * i / (6 * ring)));
      if (ring == n) disc.outline.push_back(at(ring, i));
    }
    for (int sector = 0; sector < 6; ++sector) {
      for (int i = 0; i < ring; ++i) {
        const int inner = sector * (ring - 1) + i, outer = sector * ring + i;
        disc.triangles.push_back({at(ring - 1, inner), at(ring, outer), at(ring, outer + 1)});
        if (i + 1 < ring) disc.triangles.push_back({at(ring - 1, inner), at(ring, outer + 1), at(ring - 1, inner + 1)});
      }
    }
  }
  return disc;
}

FlatteningInput half_ellipsoid(int n) {
  Disc plane = disc(n);
  FlatteningInput input;
  input.triangles = plane.triangles;
  for (const Vec2 p : plane.points) {
    const double off = norm(p) * pi / 2, shrink = norm(p) > 0 ? std::sin(off) / norm(p) : 1;
    input.target.push_back({0.075 * shrink * p.x, 0.065 * shrink * p.y, 0.055 * std::cos(off)});
    input.start.push_back({0.075 * pi / 2 * p.x, 0.065 * pi / 2 * p.y});
  }
  input.grain = {grain_line(input.start, plane.outline)};
  return input;
}

/// The dress form of the standard library, with its standard measures.
std::shared_ptr<const Body> dress_form() {
  FileWorld world({}, "bench.toile");
  const auto program = load("bench.toile", "import bodies\nbody form = bodies.dress_form()\n", {}, world);
  std::string error;
  return program->ok() ? world.body(program->bodies().front(), error) : nullptr;
}

/// A round patch of the dress form as a chart shows it, the warp down.
FlatteningInput on_form(const ChartSpec& spec, Vec2 centre, double radius, double widened, int n) {
  static const std::shared_ptr<const Body> form = dress_form();
  const Disc plane = disc(n);
  std::string error;
  const BodyChart chart(*form, spec, error);
  FlatteningInput input;
  input.triangles = plane.triangles;
  for (const Vec2 p : plane.points) {
    const Vec2 place = centre + radius * p;
    input.target.push_back(chart.at(place).point);
    input.start.push_back({-place.y, widened * place.x});
  }
  input.grain = {grain_line(input.start, plane.outline)};
  return input;
}

/// Over the shoulder no ray sees the form: the conformal map does.
ChartSpec over_the_shoulder() {
  ChartSpec spec;
  spec.map = ChartSpec::Map::Conformal;
  spec.centre = {0.11, -0.01, 1.40};
  spec.reach = 0.12;
  return spec;
}

FlatteningInput patch(int which, int n) {
  switch (which) {
    case 1:
      return on_form({}, {0.05, 1.19}, 0.07, 1.4, n);  // bust
    case 2:
      return on_form({}, {0.16, 0.86}, 0.07, 1.4, n);  // hip
    case 3:
      return on_form(over_the_shoulder(), {0, 0}, 0.07, 1, n);
    case 4:
      return test::hemisphere_with_darts(0.15, 8, n, n / 8, n / 4);
    case 5:
      return test::hemisphere_with_darts(0.15, 16, n, n / 16, n / 8);
    default:
      return half_ellipsoid(n);
  }
}

double energy_of(const FlatteningInput& input, const std::vector<Vec2>& uv, const FabricLaw& law) {
  double sum = 0;
  for (const auto& t : input.triangles) {
    const auto at = [&](const auto& all, std::size_t k) { return all[static_cast<std::size_t>(t[k])]; };
    const auto target = target_triangle({at(input.target, 0), at(input.target, 1), at(input.target, 2)});
    const PlaneCorners corners{at(uv, 0), at(uv, 1), at(uv, 2)};
    if (!target || !(turn(corners) > 0)) continue;
    const MembraneEnergy energy = FlatTriangle(law, *target, corners).energy();
    sum += energy.warp + energy.weft + energy.shear;
  }
  return sum;
}

int flips(const FlatteningInput& input, const std::vector<Vec2>& uv) {
  return static_cast<int>(std::count_if(input.triangles.begin(), input.triangles.end(), [&](const auto& t) {
    const auto at = [&](std::size_t k) { return uv[static_cast<std::size_t>(t[k])]; };
    return !(turn({at(0), at(1), at(2)}) > 0);
  }));
}

void label(benchmark::State& state) {
  constexpr std::array<const char*, 6> names{"half ellipsoid",      "bust", "hip", "shoulder", "hemisphere, 8 darts",
                                             "hemisphere, 16 darts"};
  state.SetLabel(names[static_cast<std::size_t>(state.range(0))]);
}

void develop(benchmark::State& state) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const FlatteningInput input = patch(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const FabricLaw law = cotton();
  Flattened flat;
  for (auto _ : state) flat = flatten(input, law, {}, {});
  state.counters["triangles"] = static_cast<double>(input.triangles.size());
  state.counters["energy_J"] = flat.energy.warp + flat.energy.weft + flat.energy.shear;
  state.counters["flips"] = flat.flipped;
  state.counters["iterations"] = flat.iterations;
  state.counters["factors"] = flat.factorisations;
  state.counters["residual"] = flat.residual_relative;
  label(state);
}

/// Scaled to the area that it has in space: a conformal map has any size.
void scale_to_area(const FlatteningInput& input, std::vector<Vec2>& plane) {
  double flat = 0, whole = 0;
  for (const auto& t : input.triangles) {
    const auto at = [&](const auto& all, std::size_t k) { return all[static_cast<std::size_t>(t[k])]; };
    flat += std::abs(turn({at(plane, 0), at(plane, 1), at(plane, 2)})) / 2;
    const auto target = target_triangle({at(input.target, 0), at(input.target, 1), at(input.target, 2)});
    if (target) whole += target->area;
  }
  for (Vec2& p : plane) p = std::sqrt(whole / flat) * p;
}

/// The least energy of the plane among its turns.
void count_energy(benchmark::State& state, const FlatteningInput& input, const std::vector<Vec2>& plane) {
  const FabricLaw law = cotton();
  double least = 1e300;
  for (int turn_by = 0; turn_by < 360; ++turn_by) {
    const Vec2 warp = direction(turn_by * pi / 180);
    std::vector<Vec2> turned;
    for (const Vec2 p : plane) turned.push_back({dot(p, warp), dot(p, perpendicular(warp))});
    least = std::min(least, energy_of(input, turned, law));
  }
  state.counters["triangles"] = static_cast<double>(input.triangles.size());
  state.counters["energy_J"] = least;
  state.counters["flips"] = flips(input, plane);
  label(state);
}

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace SMP = CGAL::Surface_mesh_parameterization;

template <class Parameterizer>
void by_cgal(benchmark::State& state) {
  const FlatteningInput input = patch(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  Mesh mesh;
  for (const Vec3 p : input.target) mesh.add_vertex({p.x, p.y, p.z});
  for (const auto& t : input.triangles) {
    mesh.add_face(Mesh::Vertex_index(static_cast<unsigned>(t[0])), Mesh::Vertex_index(static_cast<unsigned>(t[1])),
                  Mesh::Vertex_index(static_cast<unsigned>(t[2])));
  }
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  for (auto _ : state) {
    const auto border =
        *std::find_if(mesh.halfedges().begin(), mesh.halfedges().end(), [&](auto h) { return mesh.is_border(h); });
    Parameterizer parameterizer;
    benchmark::DoNotOptimize(SMP::parameterize(mesh, parameterizer, border, uv));
  }
  std::vector<Vec2> plane;
  for (const auto v : mesh.vertices()) plane.push_back({uv[v].x(), uv[v].y()});
  if (!std::is_same_v<Parameterizer, SMP::ARAP_parameterizer_3<Mesh>>) scale_to_area(input, plane);
  count_energy(state, input, plane);
}

void arap(benchmark::State& state) {
  by_cgal<SMP::ARAP_parameterizer_3<Mesh>>(state);
}
void least_squares_conformal(benchmark::State& state) {
  by_cgal<SMP::LSCM_parameterizer_3<Mesh>>(state);
}
void mean_values(benchmark::State& state) {
  by_cgal<SMP::Mean_value_coordinates_parameterizer_3<Mesh>>(state);
}
void authalic(benchmark::State& state) {
  by_cgal<SMP::Discrete_authalic_parameterizer_3<Mesh>>(state);
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const int which : {0, 1, 2, 3}) {
    for (const int n : {16, 26, 58, 129}) bench->Args({which, n});
  }
  bench->Args({4, 32})->Args({5, 48});
  bench->Unit(benchmark::kMillisecond);
}
BENCHMARK(develop)->Apply(sizes);
BENCHMARK(arap)->Apply(sizes);

void hemispheres(benchmark::internal::Benchmark* bench) {
  bench->Args({4, 32})->Args({5, 48})->Unit(benchmark::kMillisecond);
}
BENCHMARK(least_squares_conformal)->Apply(hemispheres);
BENCHMARK(mean_values)->Apply(hemispheres);
BENCHMARK(authalic)->Apply(hemispheres);

}  // namespace
}  // namespace toile
