// What the parts of a solver's iteration cost, by the number of triangles.
#include <benchmark/benchmark.h>

#include "runtime/energy/elastic.hpp"
#include "runtime/solve/sparse.hpp"
#include "tests/support/sheet.hpp"

namespace toile {
namespace {

FabricLaw wool() {
  FabricSheet sheet;
  sheet.weight = 0.19;
  sheet.b = WarpWeft{7e-6, 5e-6};
  sheet.hb = WarpWeft{2e-4, 2e-4};
  return make_law(sheet);
}

/// A waving sheet of about `triangles` triangles with its matrix.
struct Waving {
  explicit Waving(int triangles)
      : sheet(test::rectangle(0.6, 0.6, side(triangles), side(triangles))),
        form(sheet.cloth, wool()),
        matrix(free_unknowns(), form.couplings()),
        q(Vector::Zero(form.unknowns().count())) {
    form.prepare(matrix);
    for (std::size_t v = 0; v < sheet.points.size(); ++v) {
      const Vec2 p = sheet.points[v];
      q.segment<3>(static_cast<Eigen::Index>(3 * v)) = Vector3(p.x, p.y, 0.01 * std::sin(20 * p.x + 9 * p.y));
    }
  }
  static int side(int triangles) { return static_cast<int>(std::lround(std::sqrt(triangles / 2.0))); }
  std::vector<int> free_unknowns() const {
    std::vector<int> reduced(static_cast<std::size_t>(form.unknowns().count()));
    for (std::size_t i = 0; i < reduced.size(); ++i) reduced[i] = static_cast<int>(i);
    return reduced;
  }
  void assemble(Curvature curvature) {
    matrix.set_zero();
    form.add_hessian(q, curvature, matrix);
    const std::vector<double> shift(static_cast<std::size_t>(q.size()), 1e-3);
    matrix.add_diagonal(shift, 1);
  }

  test::Sheet sheet;
  ElasticForm form;
  SparseMatrix matrix;
  Vector q;
};

void energy_and_gradient(benchmark::State& state) {
  const Waving cloth(static_cast<int>(state.range(0)));
  Vector gradient = Vector::Zero(cloth.q.size());
  for (auto _ : state) benchmark::DoNotOptimize(cloth.form.energy(cloth.q, &gradient));
}

void assembly(benchmark::State& state) {
  Waving cloth(static_cast<int>(state.range(0)));
  for (auto _ : state) cloth.assemble(Curvature::Full);
}

void factorisation(benchmark::State& state) {
  Waving cloth(static_cast<int>(state.range(0)));
  cloth.assemble(Curvature::PositiveDefinite);
  Cholesky cholesky;
  cholesky.analyse(cloth.matrix);
  for (auto _ : state) benchmark::DoNotOptimize(cholesky.factorise(cloth.matrix));
}

BENCHMARK(energy_and_gradient)->Arg(1500)->Arg(4000)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK(assembly)->Arg(1500)->Arg(4000)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK(factorisation)->Arg(1500)->Arg(4000)->Arg(20000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace toile
