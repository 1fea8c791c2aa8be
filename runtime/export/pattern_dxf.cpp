// The flat pattern for cutters and other pattern programs: DXF of AutoCAD R12, a block a piece, on the layers of the
// apparel standards (AAMA-292, ASTM D6673): 1 what is cut, 2 its corners, 3 its curve points, 4 notches, 7 grain, 8
// lines inside, 11 openings, 13 drill holes, 14 what is sewn, 15 writing. Millimetres, y up.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "runtime/export/cut_line.hpp"
#include "runtime/export/export.hpp"
#include "runtime/export/pattern_layout.hpp"

namespace toile {
namespace {

enum class Layer {
  Cut = 1,
  Corner = 2,
  CurvePoint = 3,
  Notch = 4,
  Grain = 7,
  Inside = 8,
  Opening = 11,
  Drill = 13,
  Sewn = 14,
  Writing = 15
};

constexpr double dxf_chord_error = 2e-5, longest_chord = 0.05;  // [m]
constexpr double between_blocks = 0.025;                        // [m] between pieces on the sheet
constexpr double letters = 0.006, text_line = 0.009;            // [m]
constexpr double corner_turn = 0.35;                            // [rad] of the cut line at a corner

std::string number(double metres) {
  const double mm = std::round(1e7 * metres) / 1e4;
  return fmt::format("{}", mm == 0 ? 0.0 : mm);
}

/// A line of its own, in ASCII: other characters as DXF writes them, by their code point.
std::string plain(const std::string& text) {
  std::string line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char>(text[i]);
    if (first < 0x80) {
      line += first < 0x20 ? ' ' : text[i];
      continue;
    }
    const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
    unsigned code = first & (0x3fU >> more);
    for (int k = 0; k < more && i + 1 < text.size(); ++k)
      code = code << 6 | (static_cast<unsigned char>(text[++i]) & 0x3fU);
    line += fmt::format("\\U+{:04X}", code);
  }
  return line;
}

/// Group codes and their values, a line each.
class Dxf {
 public:
  void group(int code, const std::string& value) { text_ += fmt::format("{:3}\n{}\n", code, value); }
  void group(int code, int value) { group(code, fmt::format("{}", value)); }
  void at(Vec2 p, int axis = 0) {
    group(10 + axis, number(p.x));
    group(20 + axis, number(p.y));
  }
  void begin(const char* entity, Layer layer) {
    group(0, entity);
    group(8, static_cast<int>(layer));
  }
  void polyline(Layer layer, const std::vector<Vec2>& points, bool closed) {
    begin("POLYLINE", layer);
    group(66, 1);
    at({0, 0});
    group(30, "0.0");
    group(70, closed ? 1 : 0);
    for (const Vec2 p : points) {
      begin("VERTEX", layer);
      at(p);
    }
    begin("SEQEND", layer);
  }
  void line(Layer layer, Vec2 from, Vec2 to) {
    begin("LINE", layer);
    at(from);
    at(to, 1);
  }
  void point(Layer layer, Vec2 p) {
    begin("POINT", layer);
    at(p);
  }
  void text(Layer layer, Vec2 p, const std::string& content) {
    begin("TEXT", layer);
    at(p);
    group(40, number(letters));
    group(1, plain(content));
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::vector<Vec2> points_of(const Curve& curve) {
  std::vector<Vec2> points;
  for (const double s : curve.divide(dxf_chord_error, longest_chord)) points.push_back(curve.at(s));
  return points;
}

/// Letters, digits and what R12 allows in a name besides, and one name a block.
std::string block_name(const std::string& piece, std::size_t number) {
  std::string name;
  for (const char c : piece) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return fmt::format("{}_{}", name, number + 1);
}

void draw_corners(const std::vector<Vec2>& outline, Dxf& dxf) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = outline[i] - outline[(i + n - 1) % n], out = outline[(i + 1) % n] - outline[i];
    const double turn = std::abs(std::atan2(cross(in, out), dot(in, out)));
    dxf.point(turn > corner_turn ? Layer::Corner : Layer::CurvePoint, outline[i]);
  }
}

void draw_edges(const std::vector<PieceEdge>& edges, Dxf& dxf) {
  for (const PieceEdge& edge : edges) {
    dxf.polyline(edge.is_dart_leg ? Layer::Inside : Layer::Sewn, points_of(edge.curve), false);
  }
}

void draw_marks(const Piece& piece, Dxf& dxf) {
  for (const Notch& notch : piece.notches) {
    const PieceEdge& edge = piece.edge(notch.edge);
    const Vec2 outwards = -perpendicular(edge.curve.tangent(notch.at));
    dxf.point(Layer::Notch, edge.curve.at(notch.at) + edge.allowance * outwards);
  }
  if (piece.fold) dxf.line(Layer::Inside, piece.fold->from, piece.fold->to);
  for (const LineMark& mark : piece.marks) dxf.polyline(Layer::Inside, points_of(mark.curve), false);
  for (const Dart& dart : piece.darts) {
    dxf.point(Layer::Drill, dart.tip);
    if (dart.other_tip) dxf.point(Layer::Drill, *dart.other_tip);
  }
  for (const PointMark& mark : piece.spots) {
    const Vec2 half = 0.5 * mark.length * direction(mark.angle);
    if (mark.kind == PointMark::Kind::Buttonhole) dxf.line(Layer::Inside, mark.at - half, mark.at + half);
    if (mark.kind != PointMark::Kind::Buttonhole) dxf.point(Layer::Drill, mark.at);
  }
}

void draw_writing(const Piece& piece, Dxf& dxf) {
  const Spot name = free_spot(piece, {}), grain = free_spot(piece, {name});
  const double half = std::clamp(0.75 * grain.clearance, 0.01, 0.09);
  dxf.line(Layer::Grain, grain.at - half * piece.warp, grain.at + half * piece.warp);
  std::vector<std::string> lines{"Piece Name: " + piece.name, fmt::format("Quantity: {}", piece.quantity)};
  if (piece.has_own_cloth()) lines.push_back("Material: " + piece.own_cloth());
  if (!piece.label.empty()) lines.push_back("Annotation: " + piece.label);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    dxf.text(Layer::Cut, name.at - Vec2{0, text_line * static_cast<double>(i)}, lines[i]);
  }
}

void draw_piece(const Piece& piece, Dxf& dxf) {
  const std::vector<Vec2> outline = cut_line(piece.edges);
  dxf.polyline(Layer::Cut, outline, true);
  draw_corners(outline, dxf);
  draw_edges(piece.edges, dxf);
  for (const std::vector<PieceEdge>& hole : piece.holes) {
    const bool is_dart = std::all_of(hole.begin(), hole.end(), [](const PieceEdge& edge) { return edge.is_dart_leg; });
    if (!is_dart) dxf.polyline(Layer::Opening, cut_line(hole), true);
    draw_edges(hole, dxf);
  }
  for (const std::vector<PieceEdge>& line : piece.lines) draw_edges(line, dxf);
  draw_marks(piece, dxf);
  draw_writing(piece, dxf);
}

void begin_section(const char* name, Dxf& dxf) {
  dxf.group(0, "SECTION");
  dxf.group(2, name);
}

void write_layers(Dxf& dxf) {
  begin_section("TABLES", dxf);
  dxf.group(0, "TABLE");
  dxf.group(2, "LAYER");
  constexpr std::array layers{Layer::Cut,    Layer::Corner,  Layer::CurvePoint, Layer::Notch, Layer::Grain,
                              Layer::Inside, Layer::Opening, Layer::Drill,      Layer::Sewn,  Layer::Writing};
  dxf.group(70, static_cast<int>(layers.size()));
  for (const Layer layer : layers) {
    dxf.group(0, "LAYER");
    dxf.group(2, static_cast<int>(layer));
    dxf.group(70, 0);
    dxf.group(62, 1 + static_cast<int>(layer) % 7);  // one of the seven plain colours
    dxf.group(6, "CONTINUOUS");
  }
  dxf.group(0, "ENDTAB");
  dxf.group(0, "ENDSEC");
}

}  // namespace

std::string pattern_dxf(const Garment& garment) {
  Vec2 size;
  const std::vector<Vec2> shifts = on_shelves(garment, between_blocks, size);

  Dxf dxf;
  begin_section("HEADER", dxf);
  dxf.group(9, "$ACADVER");
  dxf.group(1, "AC1009");
  dxf.group(9, "$EXTMIN");
  dxf.at({0, -size.y});
  dxf.group(9, "$EXTMAX");
  dxf.at({size.x, 0});
  dxf.group(0, "ENDSEC");
  write_layers(dxf);
  begin_section("BLOCKS", dxf);
  for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
    const std::string name = block_name(garment.pieces[i].name, i);
    dxf.begin("BLOCK", Layer::Cut);
    dxf.group(2, name);
    dxf.group(70, 0);
    dxf.at({0, 0});
    dxf.group(30, "0.0");
    dxf.group(3, name);
    draw_piece(garment.pieces[i], dxf);
    dxf.begin("ENDBLK", Layer::Cut);
  }
  dxf.group(0, "ENDSEC");
  begin_section("ENTITIES", dxf);
  const std::string cloth = garment.fabric.name.empty() ? "" : "Material: " + garment.fabric.name;
  double y = 4 * text_line;
  for (const std::string& line : {"Style Name: " + garment.name, std::string("Units: METRIC"), cloth}) {
    if (!line.empty()) dxf.text(Layer::Writing, {0, y -= text_line}, line);
  }
  for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
    dxf.begin("INSERT", Layer::Cut);
    dxf.group(2, block_name(garment.pieces[i].name, i));
    dxf.at(shifts[i]);
  }
  dxf.group(0, "ENDSEC");
  dxf.group(0, "EOF");
  return dxf.take();
}

}  // namespace toile
