// Any bytes at all as a script: evaluation comes to an end, and says something about whatever it does not accept.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "compiler/evaluate/program.hpp"
#include "stdlib/stdlib.hpp"

namespace {

using namespace toile;

/// No files, and bodies as they state themselves.
struct BareWorld final : World {
  std::optional<std::string> read(const std::string&, const std::string&) override { return std::nullopt; }
  std::optional<std::string> module(const std::string& name) override {
    for (const Module& each : stdlib_modules()) {
      if (each.name == name) return std::string(each.text);
    }
    return std::nullopt;
  }
  std::vector<std::string> module_names() override { return {"blocks", "bodies", "fabrics", "prints", "sizing"}; }
  std::variant<ChartAnswer, std::string> charted(const BodySpec&, const ChartSpec&, const ChartQuestion&) override {
    return std::string("no bodies here");
  }
  std::variant<std::vector<BodyLineFacts>, std::string> measure(const BodySpec&) override {
    return std::vector<BodyLineFacts>{{"left_armhole", 0.4, 1.3}, {"right_armhole", 0.4, 1.3}};
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  BareWorld world;
  const auto program = load("fuzz.toile", std::string(reinterpret_cast<const char*>(data), size), {}, world);
  for (int i = 0; program->ok() && i < 1000; ++i) {
    const std::optional<Command> command = program->next();
    if (!command) break;
    program->give({});
  }
  for (const Diagnostic& diagnostic : program->diagnostics()) {
    if (!diagnostic.labels.empty()) continue;
    std::fprintf(stderr, "%s is told of no place\n", diagnostic.code.c_str());
    std::abort();
  }
  if (program->ok()) (void)emit_pattern(*program);
  return 0;
}
