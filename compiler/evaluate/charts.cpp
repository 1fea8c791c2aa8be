#include "compiler/evaluate/charts.hpp"

#include "compiler/evaluate/bodies.hpp"

namespace toile {

ChartValue chart_meant(const Value& value) {
  if (const auto* chart = value.as<ChartValue>()) return *chart;
  ChartSpec spec;
  if (const auto* line = value.as<BodyLineValue>()) {
    spec.line = line->line;
    return {line->body, std::make_shared<const ChartSpec>(std::move(spec))};
  }
  const auto* body = value.as<BodyValue>();
  return {body != nullptr ? body->body : nullptr, std::make_shared<const ChartSpec>()};
}

std::optional<ChartSpec> chart_of(Session& session, const Value& value, Location at, GarmentInstance& garment) {
  if (value.unknown()) return std::nullopt;
  const ChartValue meant = chart_meant(value);
  const std::shared_ptr<BodyInstance> body = meant.body != nullptr ? meant.body : as_body(session, value, at);
  if (body == nullptr) return std::nullopt;
  ChartSpec spec = meant.body != nullptr ? *meant.spec : ChartSpec{};
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
