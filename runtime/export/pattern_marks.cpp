#include "runtime/export/pattern_marks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/export/svg.hpp"

namespace toile {

namespace {

constexpr double kArrow = 0.004;   // [m] from a dart's centre to the tip of the arrow that says where it is pressed
constexpr double kButton = 0.005;  // [m] radius of a button's sign

std::string dot_at(Vec2 at, const char* radius) {
  return fmt::format("<circle class=\"ink\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", svg::mm(at.x), svg::mm(-at.y), radius);
}

std::string arrow_to(Vec2 from, Vec2 way) {
  const Vec2 tip = from + way, base = from + 0.5 * way, side = 0.3 * perpendicular(way);
  return svg::line("centre", from - way, base) + svg::path("head", svg::polygon_data({tip, base + side, base - side}));
}

std::string dart(const Piece& piece, const Dart& dart) {
  const PieceEdge &left = piece.edge(dart.left_leg), &right = piece.edge(dart.right_leg);
  const Vec2 mouth = dart.other_tip.value_or(0.5 * (left.curve.start() + right.curve.end()));
  std::string drawing = svg::path("dart", svg::path_data({&left.curve, &right.curve}, dart.other_tip.has_value()));
  drawing += svg::line("centre", mouth, dart.tip) + dot_at(dart.tip, "0.9");
  if (dart.other_tip) drawing += dot_at(*dart.other_tip, "0.9");
  if (left.pressed_onto || right.pressed_onto) {
    const Vec2 axis = dart.tip - mouth;
    const Vec2 across = kArrow / norm(axis) * perpendicular(axis);
    drawing += arrow_to(mouth + 0.4 * axis, left.pressed_onto ? across : -across);
  }
  return drawing;
}

const char* css_class(LineMark::Kind kind) {
  switch (kind) {
    case LineMark::Kind::Crease:
    case LineMark::Kind::Fold:
      return "crease";
    case LineMark::Kind::InnerFold:
      return "under";
    case LineMark::Kind::Placement:
      return "placement";
    case LineMark::Kind::Line:
      break;
  }
  return "inner";
}

std::string spot(const PointMark& mark) {
  const Vec2 way = direction(mark.angle);
  switch (mark.kind) {
    case PointMark::Kind::Drill:
      return dot_at(mark.at, "1") + fmt::format("<circle class=\"ring\" cx=\"{}\" cy=\"{}\" r=\"2.2\"/>\n",
                                                svg::mm(mark.at.x), svg::mm(-mark.at.y));
    case PointMark::Kind::Button:
      return fmt::format("<circle class=\"ring\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", svg::mm(mark.at.x),
                         svg::mm(-mark.at.y), svg::mm(kButton)) +
             svg::line("notch", mark.at - 0.4 * kButton * way, mark.at + 0.4 * kButton * way) +
             svg::line("notch", mark.at - 0.4 * kButton * perpendicular(way),
                       mark.at + 0.4 * kButton * perpendicular(way));
    case PointMark::Kind::Buttonhole:
      break;
  }
  const Vec2 half = 0.5 * mark.length * way, bar = 0.0015 * perpendicular(way);
  std::string drawing = svg::line("notch", mark.at - half, mark.at + half);
  for (const Vec2 end : {mark.at - half, mark.at + half}) drawing += svg::line("notch", end - bar, end + bar);
  return drawing;
}

}  // namespace

std::string marks_style() {
  return ".dart { stroke-width: .45 }\n"
         ".centre { stroke: #5b6270; stroke-width: .3; stroke-dasharray: 2.5 1.5 }\n"
         ".fold { stroke: #5b6270; stroke-width: .45; stroke-dasharray: 9 2.5 1.2 2.5 }\n"
         ".notch { stroke-width: .7 }\n"
         ".inner { stroke-width: .4 }\n"
         ".crease { stroke-width: .5; stroke-dasharray: 7 2 }\n"
         ".under { stroke: #5b6270; stroke-width: .4; stroke-dasharray: 1.2 1.6 }\n"
         ".placement { stroke: #5b6270; stroke-width: .4; stroke-dasharray: 4 1.5 1 1.5 }\n"
         ".ring { fill: none; stroke: #22252b; stroke-width: .4 }\n";
}

std::string marks_svg(const Piece& piece) {
  std::string drawing;
  if (piece.fold) drawing += svg::line("fold", piece.fold->from, piece.fold->to);
  for (const LineMark& mark : piece.marks) {
    drawing += svg::path(css_class(mark.kind), svg::path_data({&mark.curve}, false));
  }
  for (const Dart& each : piece.darts) drawing += dart(piece, each);
  for (const PointMark& mark : piece.spots) drawing += spot(mark);
  for (const Notch& notch : piece.notches) {
    const PieceEdge& edge = piece.edge(notch.edge);
    const Vec2 at = edge.curve.at(notch.at), outwards = -perpendicular(edge.curve.tangent(notch.at));
    drawing += svg::line("notch", at - 0.003 * outwards, at + std::max(0.003, edge.allowance) * outwards);
  }
  return drawing;
}

}  // namespace toile
