// develop: which garment's pieces are taken from their body to the plane.
#include <fmt/format.h>

#include "compiler/evaluate/bodies.hpp"
#include "compiler/evaluate/commands.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/garments.hpp"

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
  DevelopCommand made;
  made.garment = garment->index;
  made.body = index_of(session_, *garment->drawn_on);
  made.name = planned.drape->name;
  made.written = module().at(develop);
  planned.command = made;
}

}  // namespace toile
