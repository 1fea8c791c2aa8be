// How long the chain takes on the flared skirt and the other examples, stage by stage and as a whole.
#include <benchmark/benchmark.h>

#include <string>

#include "runtime/driver/workroom.hpp"

namespace toile {
namespace {

/// Hears nothing; a benchmark asks the outcome.
struct Silence final : Listener {
  void diagnosed(const Diagnostic&, const Sources&) override {}
  void printed(const std::string&) override {}
  void noted(const std::string&) override {}
  void wrote(const std::string&) override {}
  void failed(const std::string&, const std::string&) override {}
};

std::filesystem::path example(const std::string& name) {
  return std::filesystem::path(TOILE_SOURCE_DIR) / "examples" / name / (name + ".toile");
}

/// The script's first drape, from its text on.
std::optional<Draped> drape_example(const std::string& name, const WorkroomOptions& options) {
  Silence silence;
  Workroom workroom(options, silence, {});
  if (!workroom.load(example(name))) return std::nullopt;
  while (const std::optional<Command> command = workroom.next()) {
    if (const auto* drape = std::get_if<DrapeCommand>(&*command)) return workroom.drape(*drape);
  }
  return std::nullopt;
}

void compile(benchmark::State& state) {
  for (auto _ : state) {
    Silence silence;
    Workroom workroom({}, silence, {});
    if (!workroom.load(example("flared_skirt"))) state.SkipWithError("does not compile");
  }
}
BENCHMARK(compile)->Unit(benchmark::kMillisecond);

void mesh_and_sew(benchmark::State& state) {
  WorkroomOptions options;
  options.triangles = static_cast<int>(state.range(0));
  for (auto _ : state) {
    state.PauseTiming();
    Silence silence;
    Workroom workroom(options, silence, {});
    workroom.load(example("flared_skirt"));
    state.ResumeTiming();
    benchmark::DoNotOptimize(workroom.make(0));
  }
}
BENCHMARK(mesh_and_sew)->Arg(1500)->Arg(4000)->Arg(20000)->Unit(benchmark::kMillisecond);

void drape(benchmark::State& state, const std::string& name, DrapeOptions::Solver solver) {
  WorkroomOptions options;
  options.triangles = static_cast<int>(state.range(0));
  options.solver = solver;
  std::optional<Draped> draped;
  for (auto _ : state) draped = drape_example(name, options);
  if (!draped) return state.SkipWithError("was not draped");
  state.counters["triangles"] = static_cast<double>(draped->made->cloth.triangles.size());
  state.counters["iterations"] = draped->drape.iterations;
  state.counters["factorisations"] = draped->drape.factorisations;
  state.counters["residual"] = draped->drape.residual_relative;
  state.counters["energy_J"] = draped->drape.energy.total();
}
constexpr auto newton = DrapeOptions::Solver::Newton;
constexpr auto okabe = DrapeOptions::Solver::Okabe;
BENCHMARK_CAPTURE(drape, flared_skirt, "flared_skirt", newton)->Arg(1500)->Arg(4000)->Iterations(1);
BENCHMARK_CAPTURE(drape, flared_skirt_okabe, "flared_skirt", okabe)->Arg(1500)->Iterations(1);
BENCHMARK_CAPTURE(drape, drape_test, "drape_test", newton)->Arg(1350)->Arg(3750)->Iterations(1);
BENCHMARK_CAPTURE(drape, cloth_on_sphere, "cloth_on_sphere", newton)->Arg(1458)->Arg(4050)->Iterations(1);

}  // namespace
}  // namespace toile
