// develop: which garment's pieces are taken from their body to the plane.
#include <fmt/format.h>

#include "compiler/evaluate/bodies.hpp"
#include "compiler/evaluate/commands.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/garments.hpp"
#include "compiler/evaluate/want.hpp"

namespace toile {

void Commands::check_develop(Planned& planned, const syntax::Develop& develop) {
  planned.drape->reached = true;
  const auto expr = develop.garment();
  const GarmentInstance* garment =
      expr ? as_garment(session_, evaluate(session_, scope(), expr), module().at(*expr)) : nullptr;
  if (garment == nullptr || garment->index < 0) return;
  const std::string& name = garment->draft.name;
  if (!garment->has_fabric) {
    session_.report.add(
        Problem("E0409", fmt::format("garment `{}` is developed, but not told what it is made of", name))
            .at(module().at(*expr), "developed here")
            .also(garment->draft.written, "no fabric here")
            .help(fmt::format("garment {} in fabrics.wool_serge {{ ... }}", name)));
    return;
  }
  for (const DraftPiece& piece : garment->draft.pieces) {
    if (piece.chart) continue;
    session_.report.add(
        Problem("E0510", fmt::format("piece `{}` is not drawn on a body, so it cannot be developed", piece.name))
            .at(module().at(*expr), "developed here")
            .also(piece.written, "drawn flat")
            .help(fmt::format("piece {} on form {{ ... }}", piece.name)));
    return;
  }
  planned.drape->garment = garment;
  DevelopCommand made;
  if (const auto strain = develop.strain()) {
    made.strain = Wanted{session_, scope()}.positive(strain, dimension::number, "the strain after `darts to`");
    if (!made.strain) return;
  }
  if (const auto within = develop.within()) {
    made.within = Wanted{session_, scope()}.positive(within, dimension::length, "the distance after `within`");
    if (!made.within) return;
  }
  made.garment = garment->index;
  made.body = index_of(session_, *garment->drawn_on);
  made.name = planned.drape->name;
  made.written = module().at(develop);
  planned.command = made;
}

void Commands::check_drape_of_development(Planned& planned, const syntax::Drape& drape, DrapeCommand made) {
  const DrapeRecord& development = *planned.drape->developed;
  const GarmentInstance* garment = development.garment;
  if (garment == nullptr || garment->drawn_on == nullptr) return;  // told of where it is developed
  if (const auto body_expr = drape.body()) {
    const auto body = as_body(session_, evaluate(session_, scope(), body_expr), module().at(*body_expr));
    if (body == nullptr) return;
    if (body != garment->drawn_on) {
      session_.report.add(Problem("E0505", fmt::format("`{}` was developed for `{}`, but is draped on `{}`",
                                                       development.name, garment->drawn_on->spec.name, body->spec.name))
                              .at(module().at(*body_expr), "draped on this body")
                              .also(development.written, "developed here")
                              .help(fmt::format("drape {} on {}", development.name, garment->drawn_on->spec.name)));
      return;
    }
  }
  made.garment = garment->index;
  made.developed = development.name;
  made.body = index_of(session_, *garment->drawn_on);
  planned.command = made;
}

}  // namespace toile
