// The flat pattern as JSON: exact curves, seams and worn lines. Keys carry their units.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "compiler/pattern/region.hpp"
#include "runtime/export/export.hpp"
#include "runtime/export/json_layout.hpp"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

// Rounds to the picometre: what lies below is noise of the arithmetic, "1.2e-17" where a person would write 0.
double tidy(double value) {
  return std::round(value * 1e12) / 1e12 + 0.0;
}

Json json(Vec2 point) {
  return Json::array({tidy(point.x), tidy(point.y)});
}

Json json(const LineSegment& line) {
  return {{"kind", "line"}, {"from_m", json(line.from)}, {"to_m", json(line.to)}};
}
Json json(const ArcSegment& arc) {
  return {{"kind", "arc"},
          {"centre_m", json(arc.centre)},
          {"radius_m", tidy(arc.radius)},
          {"start_rad", tidy(arc.start)},
          {"sweep_rad", tidy(arc.sweep)}};
}
Json json(const BezierSegment& bezier) {
  return {{"kind", "bezier"},
          {"points_m", Json::array({json(bezier.p0), json(bezier.p1), json(bezier.p2), json(bezier.p3)})}};
}

Json json(const PieceEdge& edge) {
  Json segments = Json::array();
  for (const Segment& segment : edge.curve.segments()) {
    segments.push_back(std::visit([](const auto& s) { return json(s); }, segment));
  }
  return {{"name", edge.name},
          {"mirrored", edge.side == Side::Mirrored},
          {"part", edge.part},
          {"dart_leg", edge.is_dart_leg},
          {"length_m", tidy(edge.curve.length())},
          {"allowance_m", tidy(edge.allowance)},
          {"segments", segments}};
}

Json json(const std::vector<PieceEdge>& edges) {
  Json list = Json::array();
  for (const PieceEdge& edge : edges) list.push_back(json(edge));
  return list;
}

Json marks(const Piece& piece) {
  Json notches = Json::array(), darts = Json::array();
  for (const Notch& notch : piece.notches) {
    notches.push_back({{"edge", notch.edge},
                       {"at_m", tidy(notch.at)},
                       {"point_m", json(piece.edges[static_cast<std::size_t>(notch.edge)].curve.at(notch.at))}});
  }
  for (const Dart& dart : piece.darts) {
    darts.push_back({{"name", dart.name},
                     {"left_leg", dart.left_leg},
                     {"right_leg", dart.right_leg},
                     {"tip_m", json(dart.tip)},
                     {"width_m", tidy(dart.width)},
                     {"depth_m", tidy(dart.depth)}});
  }
  return {{"notches", notches}, {"darts", darts}};
}

Json json(const Piece& piece) {
  double area = signed_area(whole_outline(piece.edges));
  Json holes = Json::array();
  for (const auto& hole : piece.holes) {
    area += signed_area(whole_outline(hole));  // holes run clockwise
    holes.push_back(json(hole));
  }
  Json object{
      {"name", piece.name},         {"drawn_name", piece.drawn_name}, {"mirrored", piece.side == Side::Mirrored},
      {"quantity", piece.quantity}, {"area_m2", tidy(area)},          {"warp", json(piece.warp)}};
  object["fold_m"] = piece.fold ? Json::array({json(piece.fold->from), json(piece.fold->to)}) : Json();
  object["edges"] = json(piece.edges);
  object["holes"] = holes;
  object.update(marks(piece));
  return object;
}

Json json(const Garment& garment, const Chain& chain) {
  double length = 0;
  Json links = Json::array();
  for (const ChainLink& link : chain) {
    length += garment.pieces[static_cast<std::size_t>(link.edge.piece)].edge(link.edge.edge).curve.length();
    links.push_back({{"piece", link.edge.piece}, {"edge", link.edge.edge}, {"forward", link.forward}});
  }
  return {{"length_m", tidy(length)}, {"links", links}};
}

const char* word(Seam::Fullness fullness) {
  switch (fullness) {
    case Seam::Fullness::Ease:
      return "ease";
    case Seam::Fullness::Gather:
      return "gather";
    case Seam::Fullness::Stretch:
      return "stretch";
    case Seam::Fullness::None:
      break;
  }
  return "none";
}

}  // namespace

std::string pattern_json(const Garment& garment) {
  Json pieces = Json::array(), seams = Json::array(), wears = Json::array();
  for (const Piece& piece : garment.pieces) pieces.push_back(json(piece));
  for (const Seam& seam : garment.seams) {
    seams.push_back({{"name", seam.name},
                     {"dart", seam.is_dart},
                     {"fullness", word(seam.fullness)},
                     {"stated_m", tidy(seam.stated)},
                     {"first", json(garment, seam.first)},
                     {"second", json(garment, seam.second)}});
  }
  for (const Wear& wear : garment.wears) {
    wears.push_back(
        {{"line", wear.line}, {"held", wear.held}, {"from", tidy(wear.from)}, {"chain", json(garment, wear.chain)}});
  }
  const Json document{{"garment", garment.name},
                      {"fabric", garment.fabric.name},
                      {"textile", garment.textile.name},
                      {"pieces", pieces},
                      {"seams", seams},
                      {"wears", wears}};
  return laid_out(document.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace toile
