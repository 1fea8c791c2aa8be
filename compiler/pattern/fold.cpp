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

/// The numbers that the edges of a piece have in another one, by their numbers in this one.
class Numbers {
 public:
  /// The next edges of this piece are those from `begin` on there, the other way round in a mirrored copy.
  void add(std::size_t count, int begin, bool mirrored) {
    for (int i = 0; i < static_cast<int>(count); ++i) {
      numbers_.push_back(mirrored ? begin + static_cast<int>(count) - 1 - i : begin + i);
    }
  }
  int operator()(int edge) const { return numbers_[static_cast<std::size_t>(edge)]; }

 private:
  std::vector<int> numbers_;
};

// Notches, darts and marks of a mirrored copy. It is walked the other way round, so the leg that came first now comes
// second.
void add_mirrored_marks(const Piece& from, const Numbers& number, Vec2 point, Vec2 axis, Piece& to) {
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

// The farthest that the rest of the outline reaches over the fold line, and which edge does. Where holes lie is told by
// check_holes().
std::pair<double, const PieceEdge*> reach_over(const DraftPiece& draft, const Piece& piece, const std::string& fold,
                                               Vec2 point, Vec2 axis) {
  const auto is_rim = [&](const PieceEdge& edge) {
    return std::none_of(draft.outline.begin(), draft.outline.end(),
                        [&](const DraftEdge& drawn) { return drawn.name == edge.name; });
  };
  std::pair<double, const PieceEdge*> worst{0, nullptr};
  for (const PieceEdge& edge : piece.edges) {
    if (edge.name == fold || is_rim(edge) || lies_left(edge.curve, point, axis)) continue;
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
  const auto [over, culprit] = reach_over(draft, drawn.piece, *draft.fold, from, (to - from) / chord);
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

namespace {

// The half's outline between the parts of its fold, first what the whole's outline is made of and then the rims of
// holes on the fold; each with the number of its first edge.
struct Run {
  int first = 0;
  std::vector<PieceEdge> edges;
};

std::vector<Run> runs_between(const Piece& half, const std::string& fold, Vec2 axis) {
  const auto is_fold = [&](const PieceEdge& edge) { return edge.name == fold && !edge.is_dart_leg; };
  const int n = static_cast<int>(half.edges.size());
  const auto begin = std::find_if(half.edges.begin(), half.edges.end(), is_fold) - half.edges.begin();
  std::vector<Run> runs;
  bool open = false;
  for (int i = 1; i < n; ++i) {
    const int number = static_cast<int>(begin + i) % n;
    const PieceEdge& edge = half.edges[static_cast<std::size_t>(number)];
    if (!is_fold(edge) && !open) runs.push_back({number, {}});
    open = !is_fold(edge);
    if (open) runs.back().edges.push_back(edge);
  }
  // Along the fold the outline runs backwards, from its end to its beginning, and the rims forwards.
  const auto outer = std::find_if(runs.begin(), runs.end(), [&](const Run& run) {
    return dot(run.edges.back().curve.end() - run.edges.front().curve.start(), axis) < 0;
  });
  std::rotate(runs.begin(), outer, outer == runs.end() ? outer : outer + 1);
  return runs;
}

}  // namespace

Piece unfolded(const Piece& half, const std::string& fold) {
  const PieceEdge& edge = *std::find_if(half.edges.begin(), half.edges.end(),
                                        [&](const PieceEdge& e) { return e.name == fold && !e.is_dart_leg; });
  const Vec2 point = edge.curve.start();
  const Vec2 axis = (edge.curve.end() - point) / distance(edge.curve.end(), point);
  const std::vector<Run> runs = runs_between(half, fold, axis);

  Piece whole = half;
  whole.fold = LineSegment{runs.front().edges.back().curve.end(), runs.front().edges.front().curve.start()};
  whole.edges.clear();
  whole.holes.clear();
  std::vector<int> drawn_number(half.edges.size()), mirrored_number(half.edges.size());
  int next = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::vector<PieceEdge>& edges = runs[r].edges;
    std::vector<PieceEdge> loop = edges;
    for (PieceEdge& copy : mirrored_loop(edges, point, axis)) loop.push_back(std::move(copy));
    const int count = static_cast<int>(edges.size());
    for (int i = 0; i < count; ++i) {
      const auto number = static_cast<std::size_t>((runs[r].first + i) % static_cast<int>(half.edges.size()));
      drawn_number[number] = next + i;
      mirrored_number[number] = next + 2 * count - 1 - i;
    }
    next += 2 * count;
    if (r == 0) {
      whole.edges = std::move(loop);
    } else {
      whole.holes.push_back(std::move(loop));
    }
  }
  // Behind those of the outline and of the holes on the fold come the holes of both halves, then the lines of both.
  Numbers drawn, mirrored;
  for (std::size_t i = 0; i < half.edges.size(); ++i) {
    drawn.add(1, drawn_number[i], false);
    mirrored.add(1, mirrored_number[i], false);
  }
  const auto add_copies = [&](const std::vector<std::vector<PieceEdge>>& walks, auto& into) {
    for (const auto& walk : walks) {
      drawn.add(walk.size(), next, false);
      next += static_cast<int>(walk.size());
    }
    for (const auto& walk : walks) {
      mirrored.add(walk.size(), next, true);
      next += static_cast<int>(walk.size());
    }
    into.insert(into.end(), walks.begin(), walks.end());
    for (const auto& walk : walks) into.push_back(mirrored_loop(walk, point, axis));
  };
  add_copies(half.holes, whole.holes);
  whole.lines.clear();
  add_copies(half.lines, whole.lines);
  for (Notch& notch : whole.notches) notch.edge = drawn(notch.edge);
  for (Dart& dart : whole.darts) {
    dart.left_leg = drawn(dart.left_leg);
    dart.right_leg = drawn(dart.right_leg);
  }
  for (Pleat& pleat : whole.pleats) {
    pleat = {pleat.name, drawn(pleat.face), drawn(pleat.under), drawn(pleat.back), pleat.written};
  }
  add_mirrored_marks(half, mirrored, point, axis, whole);
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
  Numbers numbers;
  int next = 0;
  const auto add = [&](const std::vector<PieceEdge>& walk) {
    numbers.add(walk.size(), next, true);
    next += static_cast<int>(walk.size());
  };
  add(piece.edges);
  for (const auto& hole : piece.holes) add(hole);
  for (const auto& inner : piece.lines) add(inner);
  add_mirrored_marks(piece, numbers, origin, axis, copy);
  return copy;
}

}  // namespace toile
