// The flat pattern as JSON: exact curves, seams and worn lines. Keys carry their units.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "compiler/pattern/region.hpp"
#include "runtime/export/export.hpp"
#include "runtime/export/json_layout.hpp"
#include "runtime/export/sewing_instructions.hpp"

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

Json json(const Curve& curve) {
  Json segments = Json::array();
  for (const Segment& segment : curve.segments()) {
    segments.push_back(std::visit([](const auto& s) { return json(s); }, segment));
  }
  return segments;
}

Json json(const PieceEdge& edge) {
  return {{"name", edge.name},
          {"mirrored", edge.side == Side::Mirrored},
          {"part", edge.part},
          {"dart_leg", edge.is_dart_leg},
          {"folded_under", edge.folded_under},
          {"length_m", tidy(edge.curve.length())},
          {"allowance_m", tidy(edge.allowance)},
          {"segments", json(edge.curve)}};
}

Json json(const std::vector<PieceEdge>& edges) {
  Json list = Json::array();
  for (const PieceEdge& edge : edges) list.push_back(json(edge));
  return list;
}

// The leg on whose side the dart lies once it is pressed.
const char* pressed(const Piece& piece, const Dart& dart) {
  if (piece.edge(dart.left_leg).pressed_onto) return "left";
  return piece.edge(dart.right_leg).pressed_onto ? "right" : "open";
}

Json line_marks(const Piece& piece) {
  Json list = Json::array();
  for (const LineMark& mark : piece.marks) {
    constexpr const char* kinds[] = {"line", "crease", "fold", "inner_fold", "placement"};
    list.push_back({{"kind", kinds[static_cast<int>(mark.kind)]}, {"segments", json(mark.curve)}});
    if (mark.kind == LineMark::Kind::Crease) list.back()["angle_rad"] = tidy(mark.angle);
  }
  return list;
}

Json point_marks(const Piece& piece) {
  Json list = Json::array();
  for (const PointMark& mark : piece.spots) {
    constexpr const char* kinds[] = {"drill", "button", "buttonhole"};
    list.push_back({{"kind", kinds[static_cast<int>(mark.kind)]},
                    {"at_m", json(mark.at)},
                    {"length_m", tidy(mark.length)},
                    {"angle_rad", tidy(mark.angle)}});
  }
  return list;
}

Json marks(const Piece& piece) {
  Json notches = Json::array(), darts = Json::array();
  for (const Notch& notch : piece.notches) {
    notches.push_back(
        {{"edge", notch.edge}, {"at_m", tidy(notch.at)}, {"point_m", json(piece.edge(notch.edge).curve.at(notch.at))}});
  }
  for (const Dart& dart : piece.darts) {
    darts.push_back({{"name", dart.name},
                     {"left_leg", dart.left_leg},
                     {"right_leg", dart.right_leg},
                     {"tip_m", json(dart.tip)},
                     {"width_m", tidy(dart.width)},
                     {"depth_m", tidy(dart.depth)},
                     {"other_tip_m", dart.other_tip ? json(*dart.other_tip) : Json()},
                     {"trued", dart.trued},
                     {"pressed", pressed(piece, dart)}});
  }
  Json pleats = Json::array();
  for (const Pleat& pleat : piece.pleats) {
    pleats.push_back({{"name", pleat.name}, {"face", pleat.face}, {"under", pleat.under}, {"back", pleat.back}});
  }
  return {{"notches", notches},
          {"darts", darts},
          {"pleats", pleats},
          {"marks", line_marks(piece)},
          {"spots", point_marks(piece)}};
}

Json json(const Piece& piece) {
  double area = signed_area(whole_outline(piece.edges));
  Json holes = Json::array();
  for (const auto& hole : piece.holes) {
    area += signed_area(whole_outline(hole));  // holes run clockwise
    holes.push_back(json(hole));
  }
  Json lines = Json::array();
  for (const auto& line : piece.lines) lines.push_back(json(line));
  Json object{
      {"name", piece.name},         {"drawn_name", piece.drawn_name}, {"mirrored", piece.side == Side::Mirrored},
      {"quantity", piece.quantity}, {"area_m2", tidy(area)},          {"warp", json(piece.warp)}};
  object["label"] = piece.label;
  if (piece.fabric) object["fabric"] = piece.fabric->name;
  if (piece.plies > 1) object["plies"] = piece.plies;
  object["fold_m"] = piece.fold ? Json::array({json(piece.fold->from), json(piece.fold->to)}) : Json();
  object["edges"] = json(piece.edges);
  object["holes"] = holes;
  object["lines"] = lines;
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

const char* closure(Seam::Closure closure) {
  if (closure == Seam::Closure::Zipped) return "zipped";
  return closure == Seam::Closure::Buttoned ? "buttoned" : "none";
}

Json ties(const Seam& seam) {
  Json list = Json::array();
  for (const auto& tie : seam.ties) list.push_back({tidy(tie[0]), tidy(tie[1])});
  return list;
}

Json json(const Garment& garment, const Seam& seam) {
  Json made{{"name", seam.name},
            {"dart", seam.is_dart},
            {"fullness", word(seam.fullness)},
            {"stated_m", tidy(seam.stated)},
            {"pleat", seam.is_pleat},
            {"layer", seam.is_layer},
            {"closure", closure(seam.closure)},
            {"open", seam.open},
            {"ties_m", ties(seam)},
            {"first", json(garment, seam.first)},
            {"second", json(garment, seam.second)}};
  if (seam.angle != 0) made["angle_rad"] = tidy(seam.angle);
  return made;
}

}  // namespace

std::string pattern_json(const Garment& garment) {
  Json pieces = Json::array(), seams = Json::array(), wears = Json::array();
  for (const Piece& piece : garment.pieces) pieces.push_back(json(piece));
  for (const Seam& seam : garment.seams) seams.push_back(json(garment, seam));
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

std::string sewing_json(const Garment& garment) {
  Json steps = Json::array();
  for (const SewingInstruction& each : sewing_instructions(garment)) {
    Json seams = Json::array(), edges = Json::array();
    for (const int seam : each.step.seams) seams.push_back(json(garment, garment.seams[seam]));
    for (const EdgeRef& ref : each.step.edges) {
      edges.push_back({{"piece", ref.piece}, {"edge", json(garment.pieces[ref.piece].edge(ref.edge))}});
    }
    steps.push_back({{"step", steps.size() + 1},
                     {"operation", each.operation},
                     {"of", each.of},
                     {"instructions", each.lines},
                     {"seams", seams},
                     {"edges", edges}});
  }
  Json pieces = Json::array();
  for (const Piece& piece : garment.pieces) pieces.push_back({{"name", piece.name}, {"quantity", piece.quantity}});
  const Json document{{"garment", garment.name}, {"fabric", garment.fabric.name}, {"pieces", pieces}, {"steps", steps}};
  return laid_out(document.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace toile
