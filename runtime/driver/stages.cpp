// The stages of the compiler shown as text, and the check that stops before anything is solved.
#include <fmt/format.h>

#include <array>

#include "compiler/smesh/cells.hpp"
#include "runtime/driver/choice.hpp"
#include "runtime/driver/run.hpp"
#include "runtime/export/export.hpp"

namespace toile {
namespace {

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

std::optional<Stage> stage_named(const std::string& name) {
  constexpr std::array<std::pair<const char*, Stage>, 5> stages{{{"ast", Stage::Ast},
                                                                 {"pattern", Stage::Pattern},
                                                                 {"pmesh", Stage::PMesh},
                                                                 {"smesh", Stage::SMesh},
                                                                 {"sewing", Stage::Sewing}}};
  for (const auto& [known, stage] : stages) {
    if (name == known) return stage;
  }
  return std::nullopt;
}

std::optional<std::string> emit_stage(Workroom& workroom, Stage stage, const std::string& garment) {
  if (stage == Stage::Ast) return emit_ast(workroom.script(), workroom.text());
  if (stage == Stage::Pattern) return emit_pattern(workroom.program());
  const std::optional<int> chosen = choose_garment(workroom, garment);
  if (!chosen) return std::nullopt;
  if (stage == Stage::Sewing) return sewing_text(workroom.program().garments()[static_cast<std::size_t>(*chosen)]);
  const std::shared_ptr<const MadeGarment> made = workroom.make(*chosen);
  if (!made) return std::nullopt;
  return stage == Stage::PMesh ? emit(made->mesh.p, made->garment) : emit(made->mesh.s, made->garment);
}

namespace {

/// A garment that is drawn on a body has to lie on it, which only its meshes tell.
bool lies_on_its_body(Workroom& workroom, int number) {
  const Garment& garment = workroom.program().garments()[static_cast<std::size_t>(number)];
  if (garment.drawn_on.empty()) return true;
  const std::shared_ptr<const MadeGarment> made = workroom.make(number);
  if (!made) return false;
  const auto body = workroom.body_called(garment.drawn_on, garment.written);
  return !body || workroom.target(*made, *body);
}

}  // namespace

void check_meshes(Workroom& workroom) {
  for (const int number : workroom.program().own_garments()) {
    if (!lies_on_its_body(workroom, number)) continue;
    if (workroom.interrupted()) return;
    const Garment& garment = workroom.program().garments()[static_cast<std::size_t>(number)];
    const Topology topology = sewn_topology(garment);
    workroom.listener().noted(
        fmt::format("{}: {}, {}; sewn: components {}, boundary loops {}, Euler characteristic {}, {}{}", garment.name,
                    counted(garment.pieces.size(), "piece"), counted(garment.seams.size(), "seam"), topology.components,
                    topology.boundary_loops, topology.euler, topology.orientable ? "orientable" : "not orientable",
                    topology.manifold ? "" : ", not a manifold"));
  }
}

}  // namespace toile
