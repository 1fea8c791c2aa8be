// The evaluated patterns as stable text: what `toile compile --emit pattern` prints and golden files hold.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "compiler/evaluate/program.hpp"
#include "compiler/units/format.hpp"

namespace toile {
namespace {

/// Millimetres to a nanometre: below that nothing is promised.
std::string mm(double metres) {
  const std::string text = fmt::format("{:.6f}", metres * 1e3);
  return text == "-0.000000" ? "0.000000" : text;
}

std::string point(Vec2 p) {
  return "(" + mm(p.x) + ", " + mm(p.y) + ")";
}

std::string shape(const Segment& segment) {
  if (const auto* line = std::get_if<LineSegment>(&segment)) {
    return "line " + point(line->from) + " " + point(line->to);
  }
  if (const auto* arc = std::get_if<ArcSegment>(&segment)) {
    constexpr double degrees = 57.29577951308232;
    return fmt::format("arc about {} radius {} from {:.6f} deg through {:.6f} deg", point(arc->centre), mm(arc->radius),
                       arc->start * degrees, arc->sweep * degrees);
  }
  const auto& cubic = std::get<BezierSegment>(segment);
  return "bezier " + point(cubic.p0) + " " + point(cubic.p1) + " " + point(cubic.p2) + " " + point(cubic.p3);
}

std::string edge_name(const PieceEdge& edge) {
  std::string name = edge.name;
  if (edge.part > 0) name += fmt::format("[{}]", edge.part);
  if (edge.side == Side::Mirrored) name += ".mirrored";
  return name;
}

void emit_edges(std::string& out, const std::vector<PieceEdge>& edges, int first, const char* indent) {
  for (const PieceEdge& edge : edges) {
    out += fmt::format("{}edge {} {} length {} allowance {}\n", indent, first++, edge_name(edge),
                       mm(edge.curve.length()), mm(edge.allowance));
    for (const Segment& segment : edge.curve.segments()) out += fmt::format("{}  {}\n", indent, shape(segment));
  }
}

void emit_marks(std::string& out, const Piece& piece) {
  constexpr const char* lines[] = {"line", "crease", "fold", "inner fold", "placement"};
  for (const LineMark& mark : piece.marks) {
    const bool crease = mark.kind == LineMark::Kind::Crease;
    out += fmt::format("    mark {}{}\n", lines[static_cast<int>(mark.kind)],
                       crease ? fmt::format(" angle {:.6f} rad", mark.angle) : "");
    for (const Segment& segment : mark.curve.segments()) out += fmt::format("      {}\n", shape(segment));
  }
  constexpr const char* points[] = {"drill", "button", "buttonhole"};
  for (const PointMark& mark : piece.spots) {
    out += fmt::format("    {} at {} length {} angle {:.6f} rad\n", points[static_cast<int>(mark.kind)], point(mark.at),
                       mm(mark.length), mark.angle);
  }
}

void emit_piece(std::string& out, const Piece& piece) {
  out += fmt::format("  piece {} quantity {} warp ({}, {}){}\n", piece.name, piece.quantity,
                     format_number(piece.warp.x, 9), format_number(piece.warp.y, 9),
                     piece.has_own_cloth() ? " cloth " + piece.own_cloth() : "");
  emit_edges(out, piece.edges, 0, "    ");
  int first = static_cast<int>(piece.edges.size());
  for (std::size_t i = 0; i < piece.holes.size(); ++i) {
    out += fmt::format("    hole {}\n", i);
    emit_edges(out, piece.holes[i], first, "      ");
    first += static_cast<int>(piece.holes[i].size());
  }
  for (std::size_t i = 0; i < piece.lines.size(); ++i) {
    out += fmt::format("    inner line {}\n", i);
    emit_edges(out, piece.lines[i], first, "      ");
    first += static_cast<int>(piece.lines[i].size());
  }
  if (piece.fold) out += fmt::format("    fold {} {}\n", point(piece.fold->from), point(piece.fold->to));
  for (const Dart& dart : piece.darts) {
    out += fmt::format("    dart {} legs {} {} tip {} width {} depth {}{}\n", dart.name, dart.left_leg, dart.right_leg,
                       point(dart.tip), mm(dart.width), mm(dart.depth),
                       dart.other_tip ? " other tip " + point(*dart.other_tip) : "");
  }
  for (const Pleat& pleat : piece.pleats) {
    out += fmt::format("    pleat {} face {} under {} back {}\n", pleat.name, pleat.face, pleat.under, pleat.back);
  }
  emit_marks(out, piece);
  for (const Notch& notch : piece.notches) out += fmt::format("    notch edge {} at {}\n", notch.edge, mm(notch.at));
}

std::string chain(const Chain& links, const Garment& garment) {
  std::string text;
  for (const ChainLink& link : links) {
    const Piece& piece = garment.pieces[static_cast<std::size_t>(link.edge.piece)];
    text += (text.empty() ? "" : " + ") + piece.name + "." + edge_name(piece.edge(link.edge.edge)) +
            (link.forward ? "" : " backwards");
  }
  return text;
}

std::string_view word(Seam::Fullness fullness) {
  switch (fullness) {
    case Seam::Fullness::Ease:
      return " ease ";
    case Seam::Fullness::Gather:
      return " gather ";
    case Seam::Fullness::Stretch:
      return " stretch ";
    case Seam::Fullness::None:
      break;
  }
  return "";
}

std::string options(const Seam& seam) {
  std::string text;
  if (seam.is_layer) text += " as a further layer";
  if (seam.closure == Seam::Closure::Zipped) text += " zipped";
  if (seam.closure == Seam::Closure::Buttoned) text += " buttoned";
  if (seam.open) text += " open";
  if (seam.step) text += fmt::format(" step {}", *seam.step);
  for (const auto& tie : seam.ties) text += fmt::format(" tie {} {}", mm(tie[0]), mm(tie[1]));
  return text;
}

void emit_garment(std::string& out, const Garment& garment) {
  out += fmt::format("garment {}\n", garment.name);
  if (!garment.fabric.name.empty()) out += fmt::format("  fabric {}\n", garment.fabric.name);
  if (!garment.textile.name.empty()) out += fmt::format("  textile {}\n", garment.textile.name);
  for (const Piece& piece : garment.pieces) emit_piece(out, piece);
  for (const Seam& seam : garment.seams) {
    const std::string_view fullness = word(seam.fullness);
    const char* verb = seam.is_dart ? "close" : seam.is_pleat ? "layer" : "sew";
    out += fmt::format("  {} {} to {}{}{}{}\n", verb, chain(seam.first, garment), chain(seam.second, garment), fullness,
                       fullness.empty() ? "" : mm(seam.stated), options(seam));
  }
  for (const Wear& wear : garment.wears) {
    out += fmt::format("  wear {} at {} {} from {}\n", chain(wear.chain, garment), wear.line,
                       wear.held ? "held" : "placed", format_number(wear.from, 9));
  }
  // Sines and cosines that should be 0 are not quite.
  const auto plain = [](double value) { return format_number(std::round(value * 1e9) / 1e9 + 0.0, 6); };
  const auto triple = [&](const std::array<double, 3>& v, double scale) {
    return fmt::format("({}, {}, {})", plain(scale * v[0]), plain(scale * v[1]), plain(scale * v[2]));
  };
  for (const Arrangement& at : garment.arrangements) {
    out += fmt::format("  arrange {} at {} across {} up {}\n", garment.pieces[static_cast<std::size_t>(at.piece)].name,
                       triple(at.origin, 1000), triple(at.across, 1), triple(at.up, 1));
  }
}

}  // namespace

std::string emit_pattern(const Program& program) {
  std::string out = "pattern 1 (lengths in mm)\n";
  for (const Garment& garment : program.garments()) emit_garment(out, garment);
  return out;
}

}  // namespace toile
