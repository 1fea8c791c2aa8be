// Pieces laid on the fold, and mirrored pairs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

constexpr double kStraight = 1e-6;  // [m] by which a fold may stray from a straight line, and cloth reach over it

Vec2 reflected(Vec2 p, Vec2 point, Vec2 axis) {
  const Vec2 d = p - point;
  return point + 2 * dot(d, axis) * axis - d;
}

PieceEdge mirrored_edge(const PieceEdge& edge, Vec2 point, Vec2 axis) {
  PieceEdge copy = edge;
  copy.side = Side::Mirrored;
  copy.curve = edge.curve.reversed().mirrored(point, axis);
  copy.against_drawing = !edge.against_drawing;
  return copy;
}

std::vector<PieceEdge> mirrored_loop(const std::vector<PieceEdge>& edges, Vec2 point, Vec2 axis) {
  std::vector<PieceEdge> loop(edges.size());
  std::transform(edges.rbegin(), edges.rend(), loop.begin(),
                 [&](const PieceEdge& edge) { return mirrored_edge(edge, point, axis); });
  return loop;
}

int edges_of(const std::vector<std::vector<PieceEdge>>& walks) {
  int count = 0;
  for (const auto& walk : walks) count += static_cast<int>(walk.size());
  return count;
}

// The number that an edge of a piece has in the mirrored copy whose loops and lines begin at those numbers: they keep
// their order and are walked the other way round.
class MirroredNumbers {
 public:
  MirroredNumbers(const Piece& from, int outline_begin, int holes_begin, int lines_begin) {
    add(static_cast<int>(from.edges.size()), outline_begin);
    for (const auto& hole : from.holes) {
      add(static_cast<int>(hole.size()), holes_begin);
      holes_begin += static_cast<int>(hole.size());
    }
    for (const auto& line : from.lines) {
      add(static_cast<int>(line.size()), lines_begin);
      lines_begin += static_cast<int>(line.size());
    }
  }
  int operator()(int edge) const { return numbers_[edge]; }

 private:
  void add(int count, int begin) {
    for (int i = 0; i < count; ++i) numbers_.push_back(begin + count - 1 - i);
  }
  std::vector<int> numbers_;
};

// Notches, darts and marks of a mirrored copy. It is walked the other way round, so the leg that came first now comes
// second.
void add_mirrored_marks(const Piece& from, const MirroredNumbers& number, Vec2 point, Vec2 axis, Piece& to) {
  for (const Notch& notch : from.notches) {
    to.notches.push_back({number(notch.edge), from.edge(notch.edge).curve.length() - notch.at, notch.written});
  }
  for (Dart dart : from.darts) {
    dart.tip = reflected(dart.tip, point, axis);
    if (dart.other_tip) dart.other_tip = reflected(*dart.other_tip, point, axis);
    const int left = dart.left_leg;
    dart.left_leg = number(dart.right_leg);
    dart.right_leg = number(left);
    std::swap(to.edge(dart.left_leg).name, to.edge(dart.right_leg).name);
    to.darts.push_back(dart);
  }
  for (const Pleat& pleat : from.pleats) {
    to.pleats.push_back({pleat.name, number(pleat.face), number(pleat.under), number(pleat.back), pleat.written});
  }
  for (LineMark mark : from.marks) {
    mark.curve = mark.curve.mirrored(point, axis);
    to.marks.push_back(std::move(mark));
  }
  for (PointMark spot : from.spots) {
    const Vec2 way = reflected(point + direction(spot.angle), point, axis) - point;
    spot.at = reflected(spot.at, point, axis);
    spot.angle = std::atan2(way.y, way.x);
    to.spots.push_back(spot);
  }
}

// Whether all that a curve is drawn by, its ends and control points, lies to the left of the line: then so does it.
bool lies_left(const Curve& curve, Vec2 point, Vec2 axis) {
  const auto left = [&](Vec2 place) { return cross(axis, place - point) >= 0; };
  return std::all_of(curve.segments().begin(), curve.segments().end(), [&](const Segment& segment) {
    if (const auto* line = std::get_if<LineSegment>(&segment)) return left(line->from) && left(line->to);
    const auto* cubic = std::get_if<BezierSegment>(&segment);
    return cubic != nullptr && left(cubic->p0) && left(cubic->p1) && left(cubic->p2) && left(cubic->p3);
  });
}

// The farthest that the rest of the outline reaches over the fold line, and which edge does.
std::pair<double, const PieceEdge*> reach_over(const Piece& piece, const std::string& fold, Vec2 point, Vec2 axis) {
  std::pair<double, const PieceEdge*> worst{0, nullptr};
  for (const PieceEdge& edge : piece.edges) {
    if (edge.name == fold || lies_left(edge.curve, point, axis)) continue;
    for (const Vec2 place : edge.curve.polygon(1e-5)) {
      const double over = -cross(axis, place - point);
      if (over > worst.first) worst = {over, &edge};
    }
  }
  return worst;
}

}  // namespace

bool check_fold(const DraftPiece& draft, const DrawnPiece& drawn, Findings& findings) {
  const DraftEdge* drafted = find_edge(draft, *draft.fold, draft.fold_written, findings);
  if (drafted == nullptr) return false;
  if (draft.mirrored) {
    findings.error("E0323", fmt::format("piece {} is both on the fold and cut in mirrored pairs", quoted(draft.name)),
                   {{draft.fold_written, "its other half is its mirror image already"}, {draft.written, "the piece"}},
                   "leave out `fold` for two separate pieces, or `mirrored` for one unfolded piece");
    return false;
  }
  const DraftEdge& edge = *drafted;
  const PieceEdge& fold = *std::find_if(drawn.piece.edges.begin(), drawn.piece.edges.end(),
                                        [&](const PieceEdge& e) { return e.name == *draft.fold; });
  const Vec2 from = fold.curve.start(), to = fold.curve.end();
  const double chord = distance(from, to), length = fold.curve.length();
  double stray = length - chord;
  for (const Vec2 place : fold.curve.polygon(1e-6)) {
    stray = std::max(stray, std::abs(cross(to - from, place - from)) / std::max(chord, kStraight));
  }
  if (stray > kStraight) {
    findings.error(
        "E0306",
        fmt::format("piece {} cannot be folded at {}, which is not straight", quoted(draft.name), quoted(edge.name)),
        {{draft.fold_written, "the fold"}, {edge.written, "strays from a straight line by " + in_cm(stray)}},
        "cloth folds along straight lines: draw the edge by `line to`");
    return false;
  }
  const auto [over, culprit] = reach_over(drawn.piece, *draft.fold, from, (to - from) / chord);
  if (over > kStraight) {
    findings.error("E0307",
                   fmt::format("edge {} of piece {} reaches {} over the fold line", quoted(culprit->name),
                               quoted(draft.name), in_cm(over)),
                   {{culprit->written, "crosses the fold line"}, {draft.fold_written, "the fold"}},
                   "of a piece on the fold one half is drawn, which lies on one side of the fold");
    return false;
  }
  return true;
}

Piece unfolded(const Piece& half, const std::string& fold) {
  const auto is_fold = [&](const PieceEdge& edge) { return edge.name == fold && !edge.is_dart_leg; };
  const int fold_index =
      static_cast<int>(std::find_if(half.edges.begin(), half.edges.end(), is_fold) - half.edges.begin());
  const int n = static_cast<int>(half.edges.size()) - 1;
  // Without the fold, and beginning behind it; the edges of holes move up by one.
  const auto moved = [&](int edge) { return edge > n ? edge - 1 : (edge - fold_index - 1 + n + 1) % (n + 1); };

  const LineSegment line{half.edges[fold_index].curve.start(), half.edges[fold_index].curve.end()};
  const Vec2 axis = (line.to - line.from) / distance(line.from, line.to);
  Piece drawn = half;
  drawn.edges.clear();
  for (int i = 1; i <= n; ++i) drawn.edges.push_back(half.edges[(fold_index + i) % (n + 1)]);
  for (Notch& notch : drawn.notches) notch.edge = moved(notch.edge);
  for (Dart& dart : drawn.darts) {
    dart.left_leg = moved(dart.left_leg);
    dart.right_leg = moved(dart.right_leg);
  }
  for (Pleat& pleat : drawn.pleats) {
    pleat = {pleat.name, moved(pleat.face), moved(pleat.under), moved(pleat.back), pleat.written};
  }

  Piece whole = drawn;
  whole.fold = line;
  for (const PieceEdge& edge : mirrored_loop(drawn.edges, line.from, axis)) whole.edges.push_back(edge);
  // The holes' edges come behind those of both halves, and the lines' behind those of all holes.
  const int hole_edges = edges_of(drawn.holes), line_edges = edges_of(drawn.lines);
  const auto behind = [&](int edge) {
    return edge < n ? edge : edge < n + hole_edges ? edge + n : edge + n + hole_edges;
  };
  for (Notch& notch : whole.notches) notch.edge = behind(notch.edge);
  for (Dart& dart : whole.darts) {
    dart.left_leg = behind(dart.left_leg);
    dart.right_leg = behind(dart.right_leg);
  }
  for (Pleat& pleat : whole.pleats) {
    pleat = {pleat.name, behind(pleat.face), behind(pleat.under), behind(pleat.back), pleat.written};
  }
  for (const auto& hole : drawn.holes) whole.holes.push_back(mirrored_loop(hole, line.from, axis));
  for (const auto& inner : drawn.lines) whole.lines.push_back(mirrored_loop(inner, line.from, axis));
  const MirroredNumbers numbers(drawn, n, 2 * n + hole_edges, 2 * n + 2 * hole_edges + line_edges);
  add_mirrored_marks(drawn, numbers, line.from, axis, whole);
  return whole;
}

Piece mirrored_copy(const Piece& piece) {
  const Vec2 origin{0, 0}, axis{0, 1};
  Piece copy = piece;
  copy.name = piece.drawn_name + ".mirrored";
  copy.side = Side::Mirrored;
  copy.edges = mirrored_loop(piece.edges, origin, axis);
  for (auto& hole : copy.holes) hole = mirrored_loop(hole, origin, axis);
  for (auto& line : copy.lines) line = mirrored_loop(line, origin, axis);
  copy.warp = reflected(piece.warp, origin, axis);
  copy.notches.clear();
  copy.darts.clear();
  copy.pleats.clear();
  copy.marks.clear();
  copy.spots.clear();
  const int outline = static_cast<int>(piece.edges.size());
  add_mirrored_marks(piece, {piece, 0, outline, outline + edges_of(piece.holes)}, origin, axis, copy);
  return copy;
}

}  // namespace toile
