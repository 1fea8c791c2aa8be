#include "compiler/evaluate/charts.hpp"

#include "compiler/evaluate/bodies.hpp"

namespace toile {

std::optional<ChartSpec> chart_of(Session& session, const Value& value, Location at, GarmentInstance& garment) {
  if (value.unknown()) return std::nullopt;
  ChartSpec spec;
  std::shared_ptr<BodyInstance> body;
  if (const auto* line = value.as<BodyLineValue>()) {
    body = line->body;
    spec.line = line->line;
  } else if (const auto* chart = value.as<ChartValue>()) {
    body = chart->body;
    spec = *chart->spec;
  } else {
    body = as_body(session, value, at);
  }
  if (body == nullptr) return std::nullopt;
  spec.written = at;
  if (garment.drawn_on == nullptr) garment.drawn_on = body;
  garment.draft.drawn_on = garment.drawn_on->spec.name;
  if (garment.drawn_on == body) return spec;
  session.report.add(Problem("E0510", "the pieces of a garment are drawn on one body, and this is another")
                         .at(at, "on `" + body->spec.name + "`")
                         .also(garment.draft.written, "others are on `" + garment.drawn_on->spec.name + "`"));
  return std::nullopt;
}

}  // namespace toile
