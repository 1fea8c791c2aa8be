// How long the front end takes: a T-shirt from its text to the checked pattern, and scripts of 100,000 lines.
#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "compiler/evaluate/program.hpp"
#include "grammar/parse.hpp"
#include "runtime/driver/world.hpp"

namespace toile {
namespace {

constexpr int lines = 100'000;

std::string example(const std::string& name) {
  std::ifstream file(std::string(TOILE_SOURCE_DIR) + "/examples/" + name + "/" + name + ".toile");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Each value from the one before it.
std::string definitions() {
  std::string text = "let x0 = 1cm\n";
  for (int i = 1; i < lines; ++i)
    text += fmt::format("let x{} = {} + {}um * 2\n", i, i % 50 == 0 ? "3cm" : fmt::format("x{}", i - 1), i % 97);
  return text;
}

/// Skirts of two pieces with darts, each twenty lines.
std::string garments() {
  std::string text;
  for (int i = 0; i < lines / 20; ++i) {
    text += fmt::format(R"(garment g{} {{
  piece front {{
    let w = {}cm
    outline from (0cm, 0cm) {{
      waist  = curve to (w, 1.2cm) leaving 0deg arriving 10deg
      side   = line to (w + 14cm, -60cm)
      hem    = curve to (0cm, -61cm) arriving 180deg
      centre = line to start
    }}
    fold  centre
    grain down
    dart  at 55% of waist {{ width 2.5cm, depth 9cm }}
    notch at 18cm of side
    allowance 1cm, hem 4cm
  }}
  piece back = front with {{
    dart at 50% of waist {{ width 2.5cm, depth 11cm }}
  }}
  sew front.side to back.side
}}
)",
                        i, 18 + i % 5);
  }
  return text;
}

void parse(benchmark::State& state, const std::string& text) {
  const Source source("bench.toile", text);
  for (auto _ : state) {
    const syntax::Parsed parsed = syntax::parse(source);
    if (!parsed.errors.empty()) state.SkipWithError("is no script");
  }
}

void check(benchmark::State& state, const std::string& text, const std::string& size = "") {
  for (auto _ : state) {
    FileWorld world({}, "bench.toile");
    const auto program = load("bench.toile", text, {}, world, size);
    if (!program->ok()) state.SkipWithError("does not compile");
  }
}

void all_sizes(benchmark::State& state) {
  const std::string text = example("t_shirt");
  for (auto _ : state) {
    for (const char* size : {"6", "8", "10", "12", "14", "16", "18", "20", "22", "24"}) {
      FileWorld world({}, "bench.toile");
      if (!load("bench.toile", text, {}, world, size)->ok()) state.SkipWithError("does not compile");
    }
  }
}

BENCHMARK_CAPTURE(parse, definitions, definitions())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(parse, garments, garments())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(check, definitions, definitions())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(check, garments, garments())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(check, t_shirt, example("t_shirt"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(check, blouse, example("blouse"))->Unit(benchmark::kMillisecond);
BENCHMARK(all_sizes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace toile
